#include "lib/refine/admissibility.hpp"

#include <gtest/gtest.h>

#include "lib/gen/growing_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/refinement.hpp"
#include "lib/refine/replay.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/reference/tree.hpp"

namespace asts {
namespace {

using Leaves = std::vector<std::int32_t>;

reference::Mesh boxes_of(const RefinementTree& tree) {
  reference::Mesh result;
  for (const std::int32_t leaf : leaves_of(tree)) result.push_back(literal::box(tree, leaf));
  return result;
}

// Two cubes, m = 2, p = 3. Subdividing [0,1]^3 is admissible; then its half [0,1/2] x [0,1]^2 sees the other cube of
// level 0 within 5/2: not admissible until that one is subdivided.
TEST(Admissibility, ByHand) {
  RefinementTree tree(Setting{{3, 3, 3}, 2, {2, 1, 1}});
  EXPECT_FALSE(find_inadmissible(tree));
  const std::int32_t first = tree.unit_cube({0, 0, 0});
  const std::int32_t second = tree.unit_cube({1, 0, 0});
  subdivide_all(tree, Leaves{first});
  EXPECT_FALSE(find_inadmissible(tree));
  const std::int32_t half = tree.node(first).first_child;
  EXPECT_FALSE(is_admissible_subdivision(tree, Leaves{half}));
  EXPECT_TRUE(is_admissible_subdivision(tree, Leaves{half, second})) << "the cube first, then the half";
  RefinementTree early = tree;
  subdivide_all(early, Leaves{half});
  const auto reason = find_inadmissible(early);
  ASSERT_TRUE(reason);
  EXPECT_EQ(reason->element, half);
  EXPECT_EQ(reason->coarser, second);
  subdivide_all(early, Leaves{second});
  EXPECT_FALSE(find_inadmissible(early)) << "another history makes this mesh: the cube first";
}

// Levels two apart in one set: the cube of level 0 has level 1 after its subdivision, too coarse for a quarter of
// level 2, whatever the order.
TEST(Admissibility, AnElementOfTheSetMayStayTooCoarse) {
  RefinementTree tree(Setting{{3, 3, 3}, 2, {2, 1, 1}});
  const std::int32_t first = tree.unit_cube({0, 0, 0});
  const std::int32_t second = tree.unit_cube({1, 0, 0});
  subdivide_all(tree, Leaves{first});
  subdivide_all(tree, Leaves{tree.node(first).first_child, tree.node(first).first_child + 1});
  const std::int32_t quarter = tree.leaf_at(Point{});
  EXPECT_EQ(tree.node(quarter).level, 2);
  EXPECT_FALSE(is_admissible_subdivision(tree, Leaves{quarter, second}));
}

// Theorem 3.3's proof sorts by level; the criterion against the greedy run of Definition 3.2, on admissible and bare
// meshes, and the witness by the definition.
TEST(Admissibility, CriterionAgreesWithTheLiteralGreedyRun) {
  Draw draw(14);
  int admissible = 0;
  for (int round = 0; round < 400; ++round) {
    const CaseLimits limits{5, 4, 5, 70, 130, 7};
    const Case content =
        draw.one_in(3) ? random_admissible_case(draw, limits).content : random_bare_case(draw, limits).content;
    SCOPED_TRACE(write_case(content));
    Replay replay(content);
    while (!replay.done()) replay.advance();
    const RefinementTree& tree = replay.tree();
    const reference::Setting setting = literal::setting(tree.setting());
    const reference::Mesh mesh = boxes_of(tree);
    const auto reason = find_inadmissible(tree);
    EXPECT_EQ(!reason, reference::admissible_mesh(setting, mesh, reference::refinement_tree(setting, mesh)));
    const auto by_threads = find_inadmissible(tree, 3);
    EXPECT_EQ(by_threads.has_value(), reason.has_value());
    admissible += !reason;
    if (!reason) continue;
    EXPECT_EQ(by_threads->element, reason->element);
    EXPECT_EQ(by_threads->coarser, reason->coarser);
    EXPECT_FALSE(tree.is_leaf(reason->element));
    EXPECT_LT(tree.node(reason->coarser).level, tree.node(reason->element).level);
    EXPECT_TRUE(reference::closed_meets_open(literal::box(tree, reason->coarser),
                                             reference::environment(setting, literal::box(tree, reason->element))));
  }
  EXPECT_GT(admissible, 80);
  EXPECT_LT(admissible, 320);
}

// After each step of a sequence, as long as the mesh before was admissible.
TEST(Admissibility, StaysOrNotByTheStepAlone) {
  Draw draw(17);
  int stays = 0;
  int ends = 0;
  for (int round = 0; round < 400; ++round) {
    const CaseLimits limits{5, 4, 5, 70, 130, 7};
    const Case content =
        draw.one_in(3) ? random_admissible_case(draw, limits).content : random_bare_case(draw, limits).content;
    SCOPED_TRACE(write_case(content));
    Replay replay(content);
    for (bool admissible = true; admissible && !replay.done();) {
      replay.advance();
      admissible = stays_admissible(replay.tree(), replay.subdivided());
      EXPECT_EQ(admissible, !find_inadmissible(replay.tree()));
      EXPECT_EQ(admissible, stays_admissible(replay.tree(), replay.subdivided(), 3));
      (admissible ? stays : ends) += 1;
    }
  }
  EXPECT_GT(stays, 500);
  EXPECT_GT(ends, 50);
}

// The same against the search through all orders, which shares no argument with the criterion: few subdivisions of few
// cubes.
TEST(Admissibility, CriterionAgreesWithEveryOrder) {
  Draw draw(15);
  int admissible = 0;
  for (int round = 0; round < 300; ++round) {
    RefinementTree tree(
        Setting{{3, 3, 3}, draw.between(2, 3), {draw.between(1, 6), draw.between(1, 2), draw.between(1, 3)}});
    for (int steps = draw.between(0, 7); steps > 0; --steps) {
      const Leaves leaves = leaves_of(tree);
      subdivide_all(tree, Leaves{draw.choose(leaves)});
    }
    const reference::Setting setting = literal::setting(tree.setting());
    const bool expected =
        reference::admissible_mesh_exhaustive(setting, reference::refinement_tree(setting, boxes_of(tree)));
    EXPECT_EQ(!find_inadmissible(tree), expected) << round;
    admissible += expected;
  }
  EXPECT_GT(admissible, 60);
  EXPECT_LT(admissible, 240);
}

// Definition 3.1 for one and for several elements, against every order.
TEST(Admissibility, SubdivisionOfASetAgreesWithEveryOrder) {
  Draw draw(16);
  int admissible = 0;
  int several = 0;
  for (int round = 0; round < 400; ++round) {
    RefinementTree tree(Setting{{3, 3, 3}, draw.between(2, 3), {draw.between(1, 7), draw.between(1, 2), 1}});
    for (int steps = draw.between(0, 6); steps > 0; --steps) {
      const Leaves leaves = leaves_of(tree);
      subdivide_all(tree, Leaves{draw.choose(leaves)});
    }
    const Leaves all = leaves_of(tree);
    std::vector<std::size_t> positions;
    Leaves set;
    for (std::size_t i = 0; i < all.size() && set.size() < 5; ++i) {
      if (!draw.one_in(3)) continue;
      positions.push_back(i);
      set.push_back(all[i]);
    }
    const bool expected =
        reference::admissible_subdivision(literal::setting(tree.setting()), boxes_of(tree), positions);
    EXPECT_EQ(is_admissible_subdivision(tree, set), expected) << round;
    admissible += expected;
    several += expected && set.size() > 1;
  }
  EXPECT_GT(admissible, 100);
  EXPECT_LT(admissible, 350);
  EXPECT_GT(several, 30);
}

}  // namespace
}  // namespace asts
