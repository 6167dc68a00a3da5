#pragma once

#include <string_view>

#include "tests/reference/dual.hpp"
#include "tests/reference/suitability.hpp"

namespace asts::reference {

enum class Verdict { holds, violated, not_applicable };

/// "holds", "violated", "not-applicable".
const char* verdict_name(Verdict verdict);

/// The five properties of INTERFACE.md, decided from the definitions.
///
/// nested_patches is not applicable when no box of the mesh is in the class; on a mesh with boxes outside the class the
/// refinement tree consists of the boxes in the class and their ancestors. The last three are not applicable when
/// there is no active node, or when an active node has no index vector.
struct Verdicts {
  Verdict admissible, nested_patches, analysis_suitable, dual_compatible, dual_basis;
  bool operator==(const Verdicts&) const = default;
};

/// The one on a property, by its id of INTERFACE.md. REQUIRES: one of the five.
Verdict verdict_on(const Verdicts& verdicts, std::string_view property);

/// REQUIRES: the boxes tile the domain (see tiles_domain).
Verdicts decide(const Setting& setting, const Mesh& mesh);

/// The same with rational coordinates throughout, for the comparison of both arithmetics.
Verdicts decide_with_rationals(const Setting& setting, const Mesh& mesh);

/// Ordered pairs of active nodes whose supports' intersection has positive volume, and how many of them violate
/// lambda_v(B_w) = delta_vw. All other pairs satisfy it: then the supports' intersection has no volume, on some axis
/// the integrand of Proposition 6.1 is zero but for one point, and v differs from w.
struct DualCount {
  std::size_t pairs = 0, failures = 0;
};

/// With `until_first_failure` the count stops at the first failure.
template <class T>
DualCount count_dual_failures(const std::array<int, dimension>& degree, const std::vector<ActiveNode<T>>& splines,
                              bool until_first_failure);

}  // namespace asts::reference
