#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "lib/gen/enumerate.hpp"
#include "lib/gen/growing_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/reflection.hpp"
#include "lib/refine/overlay.hpp"
#include "lib/refine/refinement.hpp"
#include "lib/refine/replay.hpp"
#include "properties/claims/admissible_claims.hpp"
#include "properties/claims/example_table.hpp"
#include "properties/claims/overlay_claims.hpp"
#include "properties/claims/patch_claims.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/properties/claim_checks.hpp"
#include "tests/reference/overlay.hpp"
#include "tests/reference/tree.hpp"

namespace asts {
namespace {

/// The last mesh of a case.
RefinementTree tree_of(const Case& content) {
  Replay replay(content);
  while (!replay.done()) replay.advance();
  return replay.tree();
}

RefinementTree tree_of(const std::string& text) { return tree_of(parse_case("asts-case 1\n" + text, "case")); }

std::string corner_steps(const std::string& kind, int steps) {
  std::string text;
  for (; steps > 0; --steps) text += kind + " 0 0 0\n";
  return text;
}

/// Marks the corner of a long domain: closures go through several levels.
RefinementTree long_corner(int steps, int grading = 2) {
  return tree_of("degree 3 3 3\ngrading " + std::to_string(grading) + "\ndomain 16 2 2\n" +
                 corner_steps("refine", steps));
}

/// The same by bare subdivisions: levels 0 and `steps` side by side, not admissible from two steps on.
RefinementTree bare_corner(int steps) {
  return tree_of("degree 3 3 3\ngrading 2\ndomain 6 2 2\n" + corner_steps("subdivide", steps));
}

Trial try_on_tree(const char* id, const RefinementTree& tree) {
  MeshUnderTest mesh(tree);
  return try_on_mesh(*find_claim(id), mesh);
}

Trial try_on_text(const char* id, const std::string& text) {
  return try_on_sequence(*find_claim(id), parse_case("asts-case 1\n" + text, "case"));
}

reference::Mesh boxes_of(const RefinementTree& tree) {
  reference::Mesh result;
  for (const std::int32_t leaf : leaves_in_order(tree)) result.push_back(literal::box(tree, leaf));
  return result;
}

// Example 2.10 itself, and what is not quite it.
TEST(ExampleTable, DecidesTheThreeSequencesAndNoOther) {
  const Claim& claim = *find_claim("example-table");
  EXPECT_EQ(claim.alone(Extent::short_run).verdict.outcome, Outcome::holds);
  EXPECT_EQ(claim.alone(Extent::short_run).met, 3);
  const std::string setting = "degree 3 3 3\ndomain 4 5 8\n";
  EXPECT_EQ(try_on_text("example-table", setting + "grading 16\n" + corner_steps("refine", 3)).verdict.outcome,
            Outcome::holds);
  EXPECT_EQ(try_on_text("example-table", setting + "grading 4\n" + corner_steps("refine", 6)).met, 1);
  for (const std::string& other :
       {setting + "grading 4\n" + corner_steps("refine", 5), setting + "grading 4\n" + corner_steps("refine", 7),
        setting + "grading 3\n" + corner_steps("refine", 6), setting + "grading 16\n" + corner_steps("subdivide", 3),
        setting + "grading 16\n" + corner_steps("refine", 2) + "refine 1 1 1\n",
        "degree 3 3 3\ndomain 4 5 7\ngrading 16\n" + corner_steps("refine", 3),
        "degree 3 3 5\ndomain 4 5 8\ngrading 16\n" + corner_steps("refine", 3)}) {
    EXPECT_EQ(try_on_text("example-table", other).verdict.outcome, Outcome::not_applicable) << other;
  }
}

// The row of m = 16 by the literal algorithm alone.
TEST(ExampleTable, LastRowByTheLiteralAlgorithm) {
  const reference::Setting setting = literal::setting(example_setting(16));
  reference::Mesh mesh = reference::initial_mesh(setting);
  for (int step = 0; step < 3; ++step) {
    mesh = literal::after_step(setting, mesh, {Step::Kind::refine, {Point{}}});
  }
  const auto initial = std::count_if(mesh.begin(), mesh.end(),
                                     [&](const reference::Box& box) { return reference::level(setting, box) == 0; });
  const ExampleRow row = run_example(example_setting(16));
  EXPECT_EQ(static_cast<std::int64_t>(mesh.size()) - initial, row.new_elements);
  EXPECT_EQ(row.steps, 3);
}

// p = 3, m = 2, a row of 6 cubes whose first one is cut into a half and two quarters ([0,1/2] x [0,1/2] and above it).
// A quarter reaches 4 of its lengths beyond its sides, so along x it sees [0, 5/2): the other half, and the cubes [1,2]
// and [2,3]; the half [1/2,1] sees [0, 3), the same cubes. Cubes see nothing coarser. So the three small elements have
// larger closures, 4 elements for a quarter and 3 for the half.
TEST(ClosureLeast, ByHand) {
  const RefinementTree tree = tree_of("degree 3 3 3\ngrading 2\ndomain 6 1 1\n" + corner_steps("subdivide", 2));
  EXPECT_EQ(tree.element_count(), 8);
  const Trial trial = try_on_tree("closure-least", tree);
  EXPECT_EQ(trial.verdict.outcome, Outcome::holds);
  EXPECT_EQ(trial.met, 3);
  const CoarserInPatches patches(tree);
  const std::int32_t quarter = tree.leaf_at(Point{});
  EXPECT_EQ(patches.of(quarter).size(), 3U);
  EXPECT_EQ(least_closed_superset(patches, {quarter}).size(), 4U);
  const std::int32_t half = tree.node(tree.unit_cube({0, 0, 0})).first_child + 1;
  EXPECT_EQ(patches.of(half).size(), 2U);
}

// D(4) = m^-1 ((p1+3/2)/m, p2+3/2, p3+3/2); p = (3,5,7), m = 2: (9/8, 13/4, 17/4).
TEST(PatchRadius, ByHand) {
  EXPECT_EQ(radius_as_printed({3, 5, 7}, 2, 4), (ExactPoint{Rational(9, 8), Rational(13, 4), Rational(17, 4)}));
  EXPECT_EQ(radius_as_printed({3, 3, 3}, 5, 0), (ExactPoint{Rational(9, 2), Rational(9, 2), Rational(9, 2)}));
  EXPECT_EQ(radius_as_printed({3, 3, 3}, 5, 2), (ExactPoint{Rational(9, 10), Rational(9, 10), Rational(9, 2)}));
  EXPECT_EQ(judge_radius(radius_as_printed, {3, 3, 3}, 5, 0).met, 0) << "D(0) does not depend on m";
  EXPECT_EQ(judge_radius(radius_as_printed, {3, 3, 3}, 5, 2).met, 2);
  EXPECT_EQ(judge_radius(radius_as_printed, {3, 3, 3}, 5, 3).met, 3);
  const Trial alone = find_claim("patch-shrinks-with-grading")->alone(Extent::short_run);
  EXPECT_EQ(alone.verdict.outcome, Outcome::holds);
  // 4 degrees, 18 gradings with a smaller one, levels 0 .. 12 with 0, 1, 2 and eleven times 3 axes cut... but for 0
  EXPECT_EQ(alone.met, 4 * 18 * (1 + 2 + 10 * 3));
}

// One cube of a row of 4, cut once. A cube of level 0 has two generations below: 2 + 4 elements with 1 and 2 above. A
// half has level 1: 1 above itself, and 2 + 4 below with 2 and 3 above.
TEST(PatchesNested, CountsPairs) {
  const RefinementTree tree = tree_of("degree 3 3 3\ngrading 2\ndomain 4 1 1\nsubdivide 0 0 0\n");
  const Trial trial = try_on_tree("patches-nested", tree);
  EXPECT_EQ(trial.verdict.outcome, Outcome::holds);
  EXPECT_EQ(trial.met, 3 * (2 * 1 + 4 * 2) + 2 * (1 + 2 * 2 + 4 * 3));
  EXPECT_EQ(try_on_tree("patches-nested", tree_of("degree 3 3 3\ngrading 2\ndomain 1 1 1\n")).met, 2 + 4 * 2);
}

// Two cubes, one of them cut: all four elements see another level. Cut its half as well: not admissible.
TEST(LevelsChangeSlowly, ByHand) {
  const std::string setting = "degree 3 3 3\ngrading 2\ndomain 2 1 1\n";
  EXPECT_EQ(try_on_tree("levels-change-slowly", tree_of(setting)).met, 0);
  const Trial cut = try_on_tree("levels-change-slowly", tree_of(setting + corner_steps("subdivide", 1)));
  EXPECT_EQ(cut.verdict.outcome, Outcome::holds);
  EXPECT_EQ(cut.met, 3);
  EXPECT_EQ(try_on_tree("levels-change-slowly", tree_of(setting + corner_steps("subdivide", 2))).verdict.outcome,
            Outcome::not_applicable);
  const Trial two = judge_levels_change_slowly(tree_of(setting + corner_steps("subdivide", 2)), in_patch);
  EXPECT_EQ(two.verdict.outcome, Outcome::violated) << "a quarter, level 2, sees the cube of level 0";
}

// The corner marked three times: 3 calls for level 0, ... every inner element of level >= 1 is one call.
TEST(RefineGeneratesClass, CountsCalls) {
  const RefinementTree tree = long_corner(4);
  std::int64_t inner = 0;
  for (std::int32_t id = 0; id < tree.node_count(); ++id) inner += tree.node(id).level > 0 && !tree.is_leaf(id);
  EXPECT_GT(inner, 10);
  for (const char* id : {"refine-generates-class", "level-order-replay"}) {
    const Trial trial = try_on_tree(id, tree);
    EXPECT_EQ(trial.verdict.outcome, Outcome::holds) << id;
    EXPECT_EQ(trial.met, inner) << id;
    EXPECT_EQ(try_on_tree(id, bare_corner(3)).verdict.outcome, Outcome::not_applicable) << id;
  }
}

// The first cube of a row of 12 cut, and the last one: the overlay has both cuts, 14 + 12 = 13 + 13.
TEST(Overlay, ByHandAndTheBoundIsSharp) {
  const std::string setting = "degree 3 3 3\ngrading 2\ndomain 12 1 1\n";
  const RefinementTree one = tree_of(setting + "refine 0 0 0\n");
  const RefinementTree other = tree_of(setting + "refine 12 0 0\n");
  EXPECT_EQ(overlay(one, other).element_count(), 14);
  EXPECT_EQ(overlay_trial(one, other).verdict.outcome, Outcome::holds);
  EXPECT_EQ(overlay_trial(one, other).met, 1);
  EXPECT_EQ(overlay_trial(one, one).met, 0);
  EXPECT_EQ(overlay_trial(one, tree_of(setting)).met, 0);
  // of the seven images, the four along x differ from the mesh; the far corner is the mirror image
  EXPECT_EQ(try_on_tree("overlay-admissible", one).met, 5);
}

/// A case on a short domain: mostly small meshes with levels far apart, by Algorithm 2.9 or by bare subdivisions.
Case short_case(Draw& draw, bool admissible) {
  const Setting setting{{3, 3, 2 * draw.between(1, 3) + 1},
                        draw.between(2, 4),
                        {draw.between(1, 9), draw.between(1, 2), draw.between(1, 3)}};
  GrowingCase growing(setting, 60);
  for (int steps = draw.between(1, 7); steps > 0; --steps) {
    const std::vector<std::int32_t> leaves = leaves_of(growing.tree());
    const std::int32_t mark = draw.one_in(2) ? leaves.back() : draw.choose(leaves);
    if (!growing.add(admissible ? Step::Kind::refine : Step::Kind::subdivide, std::vector{mark})) break;
  }
  return growing.content();
}

/// One in four of the project's generators, with active regions; the others on short domains.
Case random_case(Draw& draw) {
  const bool admissible = !draw.one_in(3);
  if (!draw.one_in(4)) return short_case(draw, admissible);
  const CaseLimits limits{5, 4, 4, 64, 90, 5};
  return admissible ? random_admissible_case(draw, limits).content : random_bare_case(draw, limits).content;
}

/// The claim's trial on a mesh is that of the literal code; without its hypothesis, not applicable.
void expect_same(const char* id, MeshUnderTest& mesh, bool applicable, const reference::ClaimTrial& literal) {
  const Trial trial = try_on_mesh(*find_claim(id), mesh);
  if (!applicable) {
    EXPECT_EQ(trial.verdict.outcome, Outcome::not_applicable) << id;
    return;
  }
  EXPECT_EQ(trial.verdict.outcome, literal.holds ? Outcome::holds : Outcome::violated) << id;
  EXPECT_EQ(trial.met, static_cast<std::int64_t>(literal.met)) << id;
}

struct Tally {
  int meshes = 0;
  int admissible = 0;
  std::int64_t closures = 0;
  std::int64_t other_levels = 0;
  std::int64_t rebuilt = 0;
};

void compare_with_literal(const Case& content, Tally& tally) {
  const RefinementTree tree = tree_of(content);
  MeshUnderTest mesh(tree);
  const reference::Setting setting = literal::setting(tree.setting());
  const reference::Mesh boxes = boxes_of(tree);
  const bool admissible = reference::admissible_mesh(setting, boxes, reference::refinement_tree(setting, boxes));
  const reference::ClaimTrial closure = reference::closure_least(setting, boxes);
  expect_same("closure-least", mesh, true, closure);
  expect_same("patches-nested", mesh, true, reference::patches_nested(setting, boxes));
  const reference::ClaimTrial levels = reference::levels_change_slowly(setting, boxes);
  expect_same("levels-change-slowly", mesh, admissible, levels);
  const reference::ClaimTrial generated = reference::refine_generates(setting, boxes);
  expect_same("refine-generates-class", mesh, admissible, generated);
  expect_same("level-order-replay", mesh, admissible, reference::level_order(setting, boxes));
  ++tally.meshes;
  tally.admissible += admissible;
  tally.closures += static_cast<std::int64_t>(closure.met);
  if (!admissible) return;
  tally.other_levels += static_cast<std::int64_t>(levels.met);
  tally.rebuilt += static_cast<std::int64_t>(generated.met);
}

TEST(RefinementClaims, AgreeWithTheLiteralCodeOnRandomMeshes) {
  Draw draw(51);
  Tally tally;
  while (tally.meshes < 1200 && !HasFailure()) {
    const Case content = random_case(draw);
    SCOPED_TRACE(write_case(content));
    compare_with_literal(content, tally);
  }
  EXPECT_GT(tally.admissible, 500);
  EXPECT_GT(tally.closures, 8'000);
  EXPECT_GT(tally.other_levels, 8'000);
  EXPECT_GT(tally.rebuilt, 1'500);
  RecordProperty("admissible", tally.admissible);
}

// Theorem 3.3 takes a mesh for each mark: fewer meshes.
TEST(RefinementClaims, RefineAdmissibleAgreesWithTheLiteralCode) {
  Draw draw(52);
  std::int64_t met = 0;
  for (int round = 0; round < 250 && !HasFailure(); ++round) {
    const Case content = short_case(draw, !draw.one_in(8));
    SCOPED_TRACE(write_case(content));
    const RefinementTree tree = tree_of(content);
    MeshUnderTest mesh(tree);
    const reference::ClaimTrial literal =
        reference::refine_admissible(literal::setting(tree.setting()), boxes_of(tree));
    expect_same("refine-admissible", mesh, mesh.admissible(), literal);
    if (mesh.admissible()) met += static_cast<std::int64_t>(literal.met);
  }
  EXPECT_GT(met, 1'200);
}

// Subdivisions in the orders tried against Definition 2.7, one box after the other in yet another order.
TEST(RefinementClaims, SubdivisionsAreTheLiteralOnes) {
  Draw draw(53);
  for (int round = 0; round < 200 && !HasFailure(); ++round) {
    const Case content = random_case(draw);
    SCOPED_TRACE(write_case(content));
    const RefinementTree tree = tree_of(content);
    EXPECT_EQ(try_on_tree("subdivision-commutes", tree).verdict.outcome, Outcome::holds);
    const reference::Setting setting = literal::setting(tree.setting());
    for (const Elements& set : mark_sets(tree)) {
      Elements shuffled = set;
      draw.shuffle(shuffled);
      RefinementTree fast = tree;
      subdivide_all(fast, set);
      reference::Mesh slow = boxes_of(tree);
      for (const std::int32_t element : shuffled) {
        const auto found = std::find(slow.begin(), slow.end(), literal::box(tree, element));
        slow = reference::subdivide(setting, slow, {static_cast<std::size_t>(found - slow.begin())});
      }
      EXPECT_EQ(literal::sorted(slow), literal::sorted(boxes_of(fast)));
    }
  }
}

// Random pairs of admissible meshes of one setting, which share nothing but it.
TEST(RefinementClaims, OverlaysOfRandomPairsAgreeWithTheLiteralCode) {
  Draw draw(54);
  int third = 0;
  for (int round = 0; round < 600 && !HasFailure(); ++round) {
    const Case one = short_case(draw, true);
    Case other = short_case(draw, true);
    other.degree = one.degree;
    other.grading = one.grading;
    other.domain = one.domain;
    for (Step& step : other.steps) {
      for (Point& mark : step.marks) {
        for (std::size_t axis = 0; axis < kDimension; ++axis) {
          mark[axis] = CompactRational(std::min<Rational>(mark[axis].value(), one.domain[axis]));
        }
      }
    }
    SCOPED_TRACE(write_case(one) + write_case(other));
    const RefinementTree first = tree_of(one);
    const RefinementTree second = tree_of(other);
    const reference::Setting setting = literal::setting(first.setting());
    const auto admissible = reference::overlay_admissible(setting, boxes_of(first), boxes_of(second));
    const auto cardinality = reference::overlay_cardinality(setting, boxes_of(first), boxes_of(second));
    EXPECT_EQ(literal::sorted(boxes_of(overlay(first, second))),
              reference::common_refinement(boxes_of(first), boxes_of(second)));
    const Trial trial = overlay_trial(first, second);
    EXPECT_EQ(trial.verdict.outcome, admissible.holds && cardinality.holds ? Outcome::holds : Outcome::violated);
    EXPECT_EQ(trial.met, static_cast<std::int64_t>(admissible.met));
    third += admissible.met != 0;
  }
  EXPECT_GT(third, 200);
}

/// The inner elements of a tree, as boxes.
std::set<reference::Box> inner_of(const RefinementTree& tree) {
  std::set<reference::Box> inner;
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (tree.node(id).level >= 0 && !tree.is_leaf(id)) inner.insert(literal::box(tree, id));
  }
  return inner;
}

// Both claims for all pairs of a small scope: every admissible mesh that at most 5 subdivisions make of a row of 8
// cubes. What is left of the bound is m - 1 for each element that both meshes have subdivided.
TEST(RefinementClaims, OverlaysOfAllPairsOfASmallScope) {
  std::vector<RefinementTree> meshes;
  std::vector<std::set<reference::Box>> inner;
  enumerate_meshes({{{3, 3, 3}, 2, {8, 1, 1}}, 5, true, false}, [&](const EnumeratedMesh& mesh) {
    meshes.push_back(mesh.tree);
    inner.push_back(inner_of(mesh.tree));
  });
  // At most 5 of 8 cubes: 219 meshes. A half of the first cube needs the cubes 1 to 3 subdivided, one of the second
  // cube the cubes 1 to 4: 2 meshes with the first cube's one half alone, 1 with both, 2 * 5 with one and a fourth
  // cube, 2 with a half of the second cube; the same at the other end: 30 meshes.
  EXPECT_EQ(meshes.size(), 219U + 30U);
  std::int64_t third = 0;
  for (std::size_t i = 0; i < meshes.size() && !HasFailure(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const Trial trial = overlay_trial(meshes[i], meshes[j]);
      EXPECT_EQ(trial.verdict.outcome, Outcome::holds) << i << " " << j;
      const bool comparable = std::includes(inner[i].begin(), inner[i].end(), inner[j].begin(), inner[j].end()) ||
                              std::includes(inner[j].begin(), inner[j].end(), inner[i].begin(), inner[i].end());
      EXPECT_EQ(trial.met, comparable ? 0 : 1);
      third += trial.met;
      std::vector<reference::Box> common;
      std::set_intersection(inner[i].begin(), inner[i].end(), inner[j].begin(), inner[j].end(),
                            std::back_inserter(common));
      EXPECT_EQ(meshes[i].element_count() + meshes[j].element_count() - overlay(meshes[i], meshes[j]).element_count(),
                8 + static_cast<std::int64_t>(common.size()));
    }
  }
  EXPECT_EQ(third, 27'150) << "of 31125 pairs";
}

// The partners of a mesh are admissible with it, and the mirror images are the literal ones.
TEST(RefinementClaims, OverlayPartnersAreMirrorImages) {
  Draw draw(55);
  for (int round = 0; round < 60 && !HasFailure(); ++round) {
    const RefinementTree tree = tree_of(short_case(draw, true));
    const std::vector<RefinementTree> partners = overlay_partners(tree);
    ASSERT_EQ(partners.size(), 8U);
    for (std::size_t i = 0; i < 7; ++i) {
      EXPECT_EQ(literal::sorted(boxes_of(partners[i])),
                reference::mirrored(literal::setting(tree.setting()), boxes_of(tree), reflections()[i]));
    }
    for (const RefinementTree& partner : partners) EXPECT_TRUE(MeshUnderTest(partner).admissible());
  }
}

// A mesh gives the same mark sets whatever its history.
TEST(MarkSets, DependOnTheMeshAlone) {
  const std::string setting = "degree 3 3 3\ngrading 2\ndomain 5 2 1\n";
  const RefinementTree one = tree_of(setting + "subdivide 0 0 0\nsubdivide 3 1 0\nsubdivide 0 0 0\n");
  const RefinementTree other = tree_of(setting + "subdivide 3 1 0\nsubdivide 0 0 0\nsubdivide 0 0 0\n");
  const auto boxes_of_sets = [](const RefinementTree& tree) {
    std::vector<reference::Mesh> result;
    for (const Elements& set : mark_sets(tree)) {
      reference::Mesh& boxes = result.emplace_back();
      for (const std::int32_t element : set) boxes.push_back(literal::box(tree, element));
    }
    return result;
  };
  EXPECT_EQ(boxes_of_sets(one), boxes_of_sets(other));
  EXPECT_EQ(boxes_of_sets(one)[0].size(), 0U);
  EXPECT_EQ(boxes_of_sets(one)[1].size(), 13U);
}

// Among the finest elements are those whose patches have coarser ones: a set without any of them tries little.
TEST(MarkSets, HaveOneOfTheFinestElementsEach) {
  const RefinementTree tree =
      tree_of("degree 3 3 3\ngrading 2\ndomain 6 5 4\nrefine 0 0 0\nrefine 0 0 0\nrefine 0 0 0\n");
  const std::vector<Elements> sets = mark_sets(tree);
  ASSERT_EQ(sets.size(), 9U);
  for (std::size_t i = 4; i < sets.size(); ++i) {
    const auto finest = [&](std::int32_t leaf) { return tree.node(leaf).level == 3; };
    EXPECT_TRUE(std::any_of(sets[i].begin(), sets[i].end(), finest)) << i;
  }
}

/// A set that has an element too few or too many is not taken for the closure; the literal code agrees on each.
TEST(ClosureLeast, JudgesEachSetAsTheLiteralCodeDoes) {
  Draw draw(56);
  int least = 0;
  for (int round = 0; round < 300 && !HasFailure(); ++round) {
    const RefinementTree tree = tree_of(short_case(draw, draw.one_in(2)));
    const Elements leaves = leaves_in_order(tree);
    const Elements marks{draw.choose(leaves)};
    Elements set = closure_of_marks(tree, marks);
    if (draw.one_in(3) && set.size() > 1) set.erase(set.begin() + static_cast<std::ptrdiff_t>(draw.index(set.size())));
    const std::int32_t extra = draw.choose(leaves);
    if (draw.one_in(3) && std::find(set.begin(), set.end(), extra) == set.end()) set.push_back(extra);
    std::sort(set.begin(), set.end());
    std::vector<std::size_t> positions;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      if (std::binary_search(set.begin(), set.end(), leaves[i])) positions.push_back(i);
    }
    const auto mark = static_cast<std::size_t>(std::find(leaves.begin(), leaves.end(), marks[0]) - leaves.begin());
    const bool expected = reference::is_least_closed_superset(
        reference::patches(literal::setting(tree.setting()), boxes_of(tree)), {mark}, positions);
    EXPECT_EQ(least_closed_superset(CoarserInPatches(tree), marks) == set, expected);
    least += expected;
  }
  EXPECT_GT(least, 60);
  EXPECT_LT(least, 240);
}

/// Algorithm 2.8 with another relation for "coarser in the patch of K".
Elements closure_by(const RefinementTree& tree, const Elements& marks,
                    const std::function<bool(std::int32_t k, std::int32_t other)>& needed, bool repeat = true) {
  std::vector<bool> marked(at(tree.node_count()), false);
  for (const std::int32_t mark : marks) marked[at(mark)] = true;
  const Elements leaves = leaves_in_order(tree);
  for (bool grew = true; grew;) {
    grew = false;
    const std::vector<bool> before = marked;
    for (const std::int32_t k : leaves) {
      for (const std::int32_t other : leaves) {
        if (!before[at(k)] || marked[at(other)] || !needed(k, other)) continue;
        marked[at(other)] = true;
        grew = repeat;
      }
    }
  }
  Elements result;
  for (const std::int32_t leaf : leaves) {
    if (marked[at(leaf)]) result.push_back(leaf);
  }
  return result;
}

bool coarser(const RefinementTree& tree, std::int32_t k, std::int32_t other) {
  return tree.node(other).level < tree.node(k).level;
}

/// Closed for open: elements that only touch the environment count too.
bool touches_patch(const RefinementTree& tree, std::int32_t k, std::int32_t element) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval closed = tree.extent(element, axis);
    const RankInterval open = tree.environment(k, axis);
    if (closed.upper < open.lower || closed.lower > open.upper) return false;
  }
  return true;
}

Elements one_pass(const RefinementTree& tree, const Elements& marks) {
  return closure_by(
      tree, marks, [&](auto k, auto other) { return coarser(tree, k, other) && in_patch(tree, k, other); }, false);
}

Elements closed_patches(const RefinementTree& tree, const Elements& marks) {
  return closure_by(tree, marks,
                    [&](auto k, auto other) { return coarser(tree, k, other) && touches_patch(tree, k, other); });
}

Elements equal_levels_too(const RefinementTree& tree, const Elements& marks) {
  return closure_by(tree, marks,
                    [&](auto k, auto other) { return !coarser(tree, other, k) && in_patch(tree, k, other); });
}

Elements marks_alone(const RefinementTree&, const Elements& marks) { return marks; }

/// A common refinement that is not the coarsest.
RefinementTree one_cut_more(const RefinementTree& one, const RefinementTree& other) {
  RefinementTree both = overlay(one, other);
  for (const std::int32_t leaf : leaves_in_order(both)) {
    if (both.node(leaf).level < both.max_level()) continue;
    subdivide_all(both, Elements{leaf});
    return both;
  }
  return both;
}

ExactPoint levels_mixed_up(const PerAxis<int>& degree, int grading, int level) {
  return radius_as_printed(degree, grading, level % 3 == 1 ? level + 1 : level % 3 == 2 ? level - 1 : level);
}

ExactPoint grading_forgotten(const PerAxis<int>& degree, int, int level) { return radius_as_printed(degree, 2, level); }

}  // namespace

std::vector<NegativeControl> refinement_controls() {
  const auto refine_with = [](Elements (*closure)(const RefinementTree&, const Elements&)) {
    return [closure](RefinementTree& tree, std::int32_t mark) { subdivide_all(tree, closure(tree, {mark})); };
  };
  return {
      {"example-table", "patches of degree 5",
       [] {
         return judge_example(run_example({{5, 5, 5}, 16, {4, 5, 8}})).verdict;
       }},
      {"closure-least", "one pass instead of as many as the set grows",
       [] { return judge_closure_least(long_corner(5), one_pass).verdict; }},
      {"closure-least", "closed for open environments",
       [] { return judge_closure_least(long_corner(5), closed_patches).verdict; }},
      {"closure-least", "elements of the same level too",
       [] { return judge_closure_least(long_corner(2), equal_levels_too).verdict; }},
      {"subdivision-commutes", "a call of refine for each element instead of its subdivision",
       [&] { return judge_subdivision_commutes(bare_corner(4), refine_with(closure_of_marks)).verdict; }},
      {"patch-shrinks-with-grading", "the cases k = 1 and k = 2 mod 3 mixed up",
       [] {
         return judge_radius(levels_mixed_up, {3, 3, 3}, 3, 4).verdict;
       }},
      {"patch-shrinks-with-grading", "a radius that does not depend on m",
       [] {
         return judge_radius(grading_forgotten, {3, 3, 3}, 3, 4).verdict;
       }},
      {"refine-admissible", "the closure forgotten",
       [] { return judge_refine_admissible(long_corner(2), marks_alone).verdict; }},
      {"refine-admissible", "one pass instead of as many as the set grows",
       [] { return judge_refine_admissible(long_corner(5), one_pass).verdict; }},
      {"refine-generates-class", "a closure with elements of the same level",
       [&] { return judge_refine_generates(long_corner(3), refine_with(equal_levels_too)).verdict; }},
      {"refine-generates-class", "the mesh is not admissible",
       [&] { return judge_refine_generates(bare_corner(2), refine_with(closure_of_marks)).verdict; }},
      {"patches-nested", "a level off by one: the environment of an element's first child",
       [] {
         return judge_patches_nested(long_corner(5),
                                     [](const RefinementTree& tree, std::int32_t k, Axis axis) {
                                       return tree.environment(tree.is_leaf(k) ? k : tree.node(k).first_child, axis);
                                     })
             .verdict;
       }},
      {"levels-change-slowly", "closed for open environments",
       [] { return judge_levels_change_slowly(long_corner(5), touches_patch).verdict; }},
      {"levels-change-slowly", "the mesh is not admissible",
       [] { return judge_levels_change_slowly(bare_corner(2), in_patch).verdict; }},
      {"level-order-replay", "closed for open environments",
       [] { return judge_level_order(long_corner(5), touches_patch).verdict; }},
      {"overlay-admissible", "a common refinement that is not the coarsest: one element cut once more",
       [] {
         return judge_overlay_admissible(long_corner(2), reflect(long_corner(2), {true, false, false}).tree,
                                         one_cut_more)
             .verdict;
       }},
      {"overlay-cardinality", "a common refinement that is not the coarsest: one element cut once more",
       [] {
         return judge_overlay_cardinality(long_corner(1), reflect(long_corner(1), {true, false, false}).tree,
                                          one_cut_more)
             .verdict;
       }},
  };
}

std::vector<Confirmation> refinement_confirmations() { return {}; }

}  // namespace asts
