#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "lib/minimize/path_search.hpp"

/// Faults planted into what is looked at, for the quality tests of the minimizer: statements that are true, decided by
/// code that is wrong in one place. What such code finds is minimized like a violation.
namespace asts {

struct PlantedFault {
  const char* name;
  const char* fault;  ///< the true statement, and what is wrong in how it is decided
  PathForm form;      ///< whether it is about the last mesh or about the steps
  /// How a case violates the statement, as the wrong code sees it; nothing when it does not. Explicit meshes do not.
  std::function<std::optional<std::string>(const Case&)> predicate;
  /// A large random case that violates it; the same for the same seed. As large as violating_start's.
  std::function<Case(std::uint64_t seed)> start;
};

/// Laws (tests/minimize/planted_faults_test.cpp): a start violates, and does not without the fault.
std::span<const PlantedFault> planted_faults();

/// The same decisions made rightly, by the name of the fault: nothing for every case.
std::optional<std::string> violation_without_fault(const PlantedFault& fault, const Case& test_case);

}  // namespace asts
