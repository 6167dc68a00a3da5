#include "tests/reference/equation_claims.hpp"

#include <gtest/gtest.h>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/level_formulas.hpp"
#include "lib/refine/replay.hpp"
#include "properties/claims/family_equations.hpp"
#include "properties/claims/radius_bounds.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/properties/claim_checks.hpp"

namespace asts {

namespace {

Rational over(int top, int bottom) { return Rational(top) / Rational(bottom); }

/// The children of the unit cube, or of an element below it, of grading m.
std::vector<ParentAndChild> children_of_level(int m, int level) {
  return families_at({{3, 3, 3}, m, {1, 1, 1}}, level);
}

using Change = void (*)(ParentAndChild&);

/// The equation for a family with a fault in it, for grading 2, where every printed form holds.
std::function<Verdict()> with_fault(FamilyJudge judge, Change change, int parent_level = 0) {
  return [=] {
    std::vector<ParentAndChild> families = children_of_level(2, parent_level);
    for (ParentAndChild& family : families) change(family);
    return judge_families(families, judge).verdict;
  };
}

/// The fault: Definition 2.6 with the axes x and y exchanged.
void mix_up_axes(ParentAndChild& family) {
  for (ElementInfo* element : {&family.parent, &family.child}) {
    std::swap(element->box.lower[0], element->box.lower[1]);
    std::swap(element->box.upper[0], element->box.upper[1]);
  }
}

/// The fault: the child is put one child's width further, as if children were counted from 1.
void shift_child(ParentAndChild& family) {
  const Rational width = family.child.box.upper[0] - family.child.box.lower[0];
  family.child.box.lower[0] += width;
  family.child.box.upper[0] += width;
}

/// The fault: halves of other sizes than the child's level says.
void level_off_by_one(ParentAndChild& family) { ++*family.child.level; }

/// The fault: m^(1/3) is forgotten in the second component of p~ + s.
Verdict patch_bound_without_root() {
  RefinementTree tree({{3, 3, 3}, 16, {2, 12, 1}});
  MeshUnderTest mesh(tree);
  PerAxis<CubeRootNumber> factor = patch_distance_factor(tree.setting());
  factor[1] /= cube_root_power(16, 2);
  std::int64_t met = 0;
  auto witness = judge_patch_distances(tree, LeafPatches(mesh), factor, met);
  return witness ? Verdict::violated(std::move(*witness)) : Verdict::holds();
}

std::string outcome(const char* id, MeshUnderTest& mesh) {
  return outcome_name(try_on_mesh(*find_claim(id), mesh).verdict.outcome);
}

const char* word(bool holds) { return holds ? "holds" : "violated"; }

/// One mesh, decided by the claims and by the literal code.
void compare(const Case& content, MeshUnderTest& mesh) {
  const reference::Setting setting = literal::setting(setting_of(content));
  const reference::Mesh boxes = literal::last_mesh(content);
  using Holds = bool (*)(const reference::Setting&, const reference::Mesh&);
  const std::vector<std::pair<const char*, Holds>> families{
      {"size-formula", reference::size_formula_holds},
      {"child-distance", reference::child_distance_holds},
      {"child-distance-repaired", reference::child_distance_repaired_holds},
      {"patch-radius-step", reference::radius_step_holds},
      {"child-distance-bound", reference::child_bound_holds},
      {"child-distance-bound-repaired", reference::child_bound_repaired_holds}};
  const bool applicable = reference::has_children(setting, boxes);
  for (const auto& [id, holds] : families) {
    EXPECT_EQ(outcome(id, mesh), applicable ? word(holds(setting, boxes)) : "not-applicable") << id;
  }
  if (!mesh.admissible() || boxes.size() > 60) return;
  EXPECT_EQ(outcome("radius-bounds", mesh), word(reference::radius_bounds_hold(setting, boxes)));
}

RandomCase random_case(Draw& draw, int number) {
  CaseLimits limits;
  limits.max_degree = number % 16 == 2 ? 5 : 3;  // the domain grows with the degree
  limits.max_side = 4;
  limits.max_cubes = 24;
  limits.max_elements = 60;
  limits.max_grading = 16;
  if (number % 3 == 0) return random_bare_case(draw, limits);
  return number % 8 == 1 ? random_box_case(draw, limits) : random_admissible_case(draw, limits);
}

void with_mesh(const Case& content, const std::function<void(MeshUnderTest&)>& test) {
  if (content.explicit_mesh) {
    MeshUnderTest mesh(mesh_of(setting_of(content), content.elements));
    return test(mesh);
  }
  Replay replay(content);
  while (!replay.done()) replay.advance();
  MeshUnderTest mesh(replay.tree());
  test(mesh);
}

TEST(EquationClaims, AgreeWithTheLiteralCode) {
  Draw draw(7);
  for (int number = 0; number < 1200 && !testing::Test::HasFailure(); ++number) {
    const Case content = random_case(draw, number).content;
    SCOPED_TRACE(write_case(content));
    with_mesh(content, [&](MeshUnderTest& mesh) { compare(content, mesh); });
  }
}

// The family of statements that has no mesh: every m from 2 to 20, every child, levels 0 to 12.
TEST(EquationClaims, ForEveryGradingAndChild) {
  const std::int64_t pairs = 4 * 13 * (2 + 20) * 19 / 2;  // degrees, levels, the children of m = 2, ..., 20
  for (const char* id :
       {"size-formula", "child-distance-repaired", "patch-radius-step", "child-distance-bound-repaired"}) {
    const Trial trial = try_alone(*find_claim(id), Extent::short_run);
    EXPECT_EQ(trial.verdict.outcome, Outcome::holds) << id;
    EXPECT_EQ(trial.met, pairs) << id;
  }
  EXPECT_EQ(try_alone(*find_claim("radius-bounds"), Extent::short_run).verdict.outcome, Outcome::holds);
  for (const char* id : {"child-distance", "child-distance-bound"}) {
    const Trial trial = try_alone(*find_claim(id), Extent::short_run);
    EXPECT_EQ(trial.verdict.outcome, Outcome::violated) << id;
    EXPECT_EQ(trial.met, 4 * 13 * 2 + 1) << id << " fails for no m = 2 and for the first child of m = 3";
  }
}

// The printed distances hold for m = 2; for m >= 3 the first form fails for every child, the bound for the outer ones.
TEST(EquationClaims, WhichChildrenThePrintedFormsAreWrongFor) {
  for (int m = 2; m <= 20; ++m) {
    for (int level = 0; level <= 5; ++level) {
      for (const ParentAndChild& family : children_of_level(m, level)) {
        EXPECT_EQ(judge_child_distance(family).has_value(), m >= 3) << m << ' ' << level << ' ' << family.number;
        // |2j - 1 - m|/(2m) > 1/m^2 times a root that the axis and the bound share
        const bool beyond = std::abs(2 * family.number - 1 - m) * m > 2;
        EXPECT_EQ(judge_child_bound(family).has_value(), beyond) << m << ' ' << level << ' ' << family.number;
      }
    }
  }
}

TEST(EquationClaims, DistancesByHand) {
  const std::vector<ParentAndChild> thirds = children_of_level(3, 0);
  EXPECT_EQ(distance(thirds[0].child.box, thirds[0].parent.box), (ExactPoint{over(1, 3), 0, 0}));
  EXPECT_EQ(distance(thirds[1].child.box, thirds[1].parent.box), (ExactPoint{0, 0, 0}));
  const std::vector<ParentAndChild> quarters = children_of_level(2, 4);  // of an element 1/4 x 1/2 x 1/2, along y
  EXPECT_EQ(distance(quarters[1].child.box, quarters[1].parent.box), (ExactPoint{0, over(1, 8), 0}));
  EXPECT_EQ(sides(quarters[1].child.box), (ExactPoint{over(1, 4), over(1, 4), over(1, 2)}));
}

TEST(EquationClaims, LevelFormulasByHand) {
  EXPECT_EQ(level_size(3, 0), (PerAxis<Rational>{1, 1, 1}));
  EXPECT_EQ(level_size(3, 4), (PerAxis<Rational>{over(1, 9), over(1, 3), over(1, 3)}));
  EXPECT_EQ(level_radius({3, 5, 7}, 2, 2), (PerAxis<Rational>{over(9, 4), over(13, 4), over(17, 2)}));
  EXPECT_EQ(grading_power(5, -2), over(1, 25));
  EXPECT_EQ(grading_power(5, 2), 25);
}

}  // namespace

std::vector<NegativeControl> equation_controls() {
  return {
      {"size-formula", "the axes x and y exchanged", with_fault(judge_size, mix_up_axes)},
      {"child-distance", "a child counted from 1", with_fault(judge_child_distance, shift_child)},
      {"child-distance-repaired", "a child counted from 1", with_fault(judge_child_distance_repaired, shift_child)},
      {"patch-radius-step", "the child's level one too high", with_fault(judge_radius_step, level_off_by_one, 3)},
      {"radius-bounds", "m^(1/3) forgotten in the second component", patch_bound_without_root},
      {"child-distance-bound", "a child counted from 1", with_fault(judge_child_bound, shift_child)},
      {"child-distance-bound-repaired", "a child counted from 1", with_fault(judge_child_bound_repaired, shift_child)}};
}

std::vector<Confirmation> equation_confirmations() {
  const auto fails = [](bool (*holds)(const reference::Setting&, const reference::Mesh&)) {
    return [holds](const Case& content) {
      const reference::Setting setting = literal::setting(setting_of(content));
      const reference::Mesh mesh = literal::last_mesh(content);
      const bool hypotheses =
          reference::has_children(setting, mesh) && reference::refinement_tree(setting, mesh).outside.empty();
      return hypotheses && !holds(setting, mesh);
    };
  };
  return {{"child-distance", fails(reference::child_distance_holds)},
          {"child-distance-bound", fails(reference::child_bound_holds)}};
}

}  // namespace asts
