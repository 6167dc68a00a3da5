#include "tests/reference/refinement_checks.hpp"

namespace asts::reference {

namespace {

constexpr ClaimKind kinds[] = {
    {"example-table", "example-table", "the numbers are not those of the table", check_example_table},
    {"closure-least", "wrong-closure", "the closure is not the least closed superset of the marks",
     check_closure_not_least},
    {"closure-least", "wrong-closure", "the loop of Algorithm 2.8 gives another set in another order",
     check_closure_depends_on_loop},
    {"closure-least", "wrong-closure", "the closure depends on the order of the marks", check_closure_depends_on_marks},
    {"closure-least", "wrong-closure", "the closure of the closure is another set", check_closure_not_idempotent},
    {"closure-least", "wrong-closure", "the first half of the marks has a closure that is no subset",
     check_closure_not_monotone},
    {"closure-least", "wrong-closure", "the mirrored marks have another closure than the mirrored one",
     check_closure_not_mirrored},
    {"subdivision-commutes", "order-matters", "two orders of these subdivisions make different meshes",
     check_order_matters},
    {"patch-shrinks-with-grading", "environment", "U(K) begins elsewhere", check_environment_lower},
    {"patch-shrinks-with-grading", "environment", "U(K) ends elsewhere", check_environment_upper},
    {"patch-shrinks-with-grading", "patch-radius", "D(k) is not size * (p + 3/2)", check_radius_not_linear},
    {"patch-shrinks-with-grading", "patch-radius", "D(k) does not decrease from grading m - 1 to m",
     check_radius_not_decreasing},
    {"refine-admissible", "refined-mesh-not-admissible", "a subdivided element has a coarser one in its patch",
     check_refined_not_admissible},
    {"refine-admissible", "subdivision-not-admissible", "no order makes each subdivision of the closure admissible",
     check_subdivision_not_admissible},
    {"refine-generates-class", "refine-subdivides-others",
     "marked in the order of levels, and of lower corners among equal ones, the element is not subdivided by its call "
     "of refine, or not alone",
     check_refine_subdivides_others},
    {"patches-nested", "patch-not-nested", nullptr, check_patch_not_nested},
    {"levels-change-slowly", "coarser-in-patch", nullptr, check_levels_change},
    {"level-order-replay", "coarser-in-patch", nullptr, check_level_order},
    {"overlay-admissible", "overlay-not-admissible",
     "a subdivided element of the overlay has a coarser one in its patch", check_overlay_not_admissible},
    {"overlay-cardinality", "overlay-too-large", "elements(G1 (+) G2) + elements(G0) > elements(G1) + elements(G2)",
     check_overlay_too_large},
};

}  // namespace

std::span<const ClaimKind> refinement_kinds() { return kinds; }

}  // namespace asts::reference
