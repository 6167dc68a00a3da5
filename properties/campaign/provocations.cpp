#include "properties/campaign/provocations.hpp"

#include <array>

#include "properties/campaign/provoked_cases.hpp"

namespace asts {

namespace {

/// From this m on a case can violate distance-bound: properties/claims/distance_bound.hpp.
constexpr int kViolatingGrading = 1268;

/// Mostly small m, for which a case takes some 10 ms; one in three can violate, which takes 0.7 seconds; few are large.
Case large_grading(Draw& draw) {
  if (!draw.one_in(3)) return row_case(draw, draw.between(17, 400));
  return row_case(draw, draw.between(kViolatingGrading, draw.one_in(8) ? 4096 : 1500));
}

/// Three in four are short, of any m; the others are as long as is needed for m = 3, and take 5 seconds.
Case corner_experiment(Draw& draw) {
  if (draw.one_in(4)) return corner_case(draw, 3, {110, 130});
  const int m = draw.between(2, 5);
  return corner_case(draw, m, {1, 20});
}

/// Boxes violate more often; steps come to smaller cases, and boxes never become steps.
Case small_planar_case(Draw& draw) {
  return draw.one_in(4) ? small_planar_case_of_boxes(draw) : planar_case_of_steps(draw);
}

constexpr std::array kProvocations{
    Provocation{"frame-in-index-sets", "provoke-frame-in-index-sets", narrow_case, 4},
    Provocation{"frame-in-index-sets-repaired", "provoke-frame-in-index-sets-repaired", narrow_case, 8},
    Provocation{"planar-equals-classical", "provoke-planar-equals-classical", small_planar_case, 1, 6},
    Provocation{"planar-equals-classical-repaired", "provoke-planar-equals-classical-repaired",
                small_planar_case_of_boxes, 2},
    Provocation{"figure-proof-levels", "provoke-figure-proof-levels", figure_case, 2},
    Provocation{"admissible-implies-as", "provoke-admissible-implies-as", graded_case, 1},
    Provocation{"dc-implies-as", "provoke-dc-implies-as", small_interface_case, 1, 6},
    Provocation{"dc-implies-as-repaired", "provoke-dc-implies-as-repaired", small_interface_case, 2},
    Provocation{"case-table", "provoke-case-table", small_interface_case, 1},
    Provocation{"case-table-repaired", "provoke-case-table-repaired", small_interface_case, 2},
    Provocation{"distance-bound", "provoke-distance-bound", large_grading, 16},
    Provocation{"distance-bound-repaired", "provoke-distance-bound-repaired", large_grading, 32},
    Provocation{"experiment-constant", "provoke-experiment-constant", corner_experiment, 50},
};

}  // namespace

std::span<const Provocation> all_provocations() { return kProvocations; }

}  // namespace asts
