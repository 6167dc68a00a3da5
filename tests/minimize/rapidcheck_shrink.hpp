#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <functional>

#include "lib/mesh/case.hpp"

/// rapidcheck's own shrinker on the cases that the minimizer gets, for comparison.
namespace asts {

/// A case as rapidcheck has it: steps are left out in chunks (rc::shrink::removeChunks), marks likewise within each
/// step, domain, degrees and m go towards the least (rc::shrink::towards), coordinates of marks towards 0 and towards
/// small denominators. Marks beyond a smaller domain are moved onto its sides, so that every case is valid. An explicit
/// mesh keeps its boxes, since others would not tile the domain: of it degrees and m alone are shrunk.
rc::Shrinkable<Case> shrinkable_case(const Case& test_case);

/// Always the same case, with its shrinks.
rc::Gen<Case> same_case(const Case& test_case);

struct Shrunk {
  Case smallest;
  std::int64_t evaluations = 0;
  bool stopped = false;  ///< the cap was reached
};

/// rapidcheck's loop (rc::shrinkable::findLocalMin, the loop of rc::check): the first shrink that fails replaces the
/// case, until none does. After `cap` evaluations nothing fails any more. A case that cannot be decided does not fail.
Shrunk shrink_with_rapidcheck(const Case& start, const std::function<bool(const Case&)>& fails, std::int64_t cap);

}  // namespace asts
