#include "lib/mesh/refinement_tree.hpp"

#include <gtest/gtest.h>

#include "lib/exact/errors.hpp"
#include "lib/gen/growing_case.hpp"
#include "tests/literal_mesh.hpp"

namespace asts {
namespace {

Point point(const Rational& x, const Rational& y, const Rational& z) {
  return {CompactRational(x), CompactRational(y), CompactRational(z)};
}

Rational over(int top, int bottom) { return Rational(top) / bottom; }

reference::Mesh leaf_boxes(const RefinementTree& tree) {
  reference::Mesh boxes;
  for (const std::int32_t leaf : leaves_of(tree)) boxes.push_back(literal::box(tree, leaf));
  return literal::sorted(std::move(boxes));
}

// Definition 2.1.
TEST(RefinementTree, StartsAsTheInitialMesh) {
  const Setting setting{{3, 3, 3}, 2, {4, 3, 5}};
  const RefinementTree tree(setting);
  EXPECT_EQ(tree.element_count(), 60);
  EXPECT_EQ(tree.new_element_count(), 0);
  EXPECT_EQ(tree.max_level(), 0);
  EXPECT_EQ(leaf_boxes(tree), literal::sorted(reference::initial_mesh(literal::setting(setting))));
  EXPECT_EQ(literal::box(tree, tree.unit_cube({3, 0, 2})), (reference::Box{{3, 0, 2}, {4, 1, 3}}));
  EXPECT_EQ(literal::box(tree, 0), (reference::Box{{0, 0, 0}, {4, 3, 5}})) << "law 3";
}

// Definitions 2.5, 2.6: level 0 along x, 1 along y, 2 along z, 3 along x again, into m parts.
TEST(RefinementTree, SubdividesAlongTheAxisOfTheLevel) {
  RefinementTree tree(Setting{{3, 3, 3}, 3, {2, 1, 1}});
  std::int32_t leaf = tree.leaf_at(point(1, 0, 0));
  const std::vector<reference::Box> expected{
      {{over(4, 3), 0, 0}, {over(5, 3), 1, 1}},
      {{over(4, 3), over(1, 3), 0}, {over(5, 3), over(2, 3), 1}},
      {{over(4, 3), over(1, 3), over(1, 3)}, {over(5, 3), over(2, 3), over(2, 3)}},
      {{over(13, 9), over(1, 3), over(1, 3)}, {over(14, 9), over(2, 3), over(2, 3)}}};
  for (std::int32_t level = 1; level <= 4; ++level) {
    tree.subdivide(leaf);
    tree.update_ranks();
    leaf = tree.node(leaf).first_child + 1;
    EXPECT_EQ(tree.node(leaf).level, level);
    EXPECT_EQ(literal::box(tree, leaf), expected[static_cast<std::size_t>(level - 1)]);
  }
  EXPECT_EQ(tree.element_count(), 2 + 4 * 2);
  EXPECT_EQ(tree.new_element_count(), 9) << "all but [0,1]^3";
  EXPECT_EQ(tree.max_level(), 4);
}

// 3^39 fits into 64 bits and its m-fold does not: the point is just below 1, in the last third.
TEST(RefinementTree, FindsPointsWhoseDenominatorsNearlyFill64Bits) {
  RefinementTree tree(Setting{{3, 3, 3}, 3, {2, 1, 1}});
  tree.subdivide(tree.leaf_at(point(0, 0, 0)));
  tree.update_ranks();
  const std::int64_t large = 4'052'555'153'018'976'267;
  EXPECT_EQ(literal::box(tree, tree.leaf_at(point(Rational(large - 1, large), 0, 0))),
            (reference::Box{{over(2, 3), 0, 0}, {1, 1, 1}}));
}

// Half-open elements: 1/2 is the second half's; the domain's upper faces belong to the last element.
TEST(RefinementTree, APointOnAFaceBelongsToTheUpperElement) {
  RefinementTree tree(Setting{{3, 3, 3}, 2, {2, 2, 2}});
  tree.subdivide(tree.leaf_at(point(0, 0, 0)));
  tree.update_ranks();
  EXPECT_EQ(literal::box(tree, tree.leaf_at(point(over(1, 2), 0, 0))), (reference::Box{{over(1, 2), 0, 0}, {1, 1, 1}}));
  EXPECT_EQ(literal::box(tree, tree.leaf_at(point(over(49, 100), 0, 0))),
            (reference::Box{{0, 0, 0}, {over(1, 2), 1, 1}}));
  EXPECT_EQ(literal::box(tree, tree.leaf_at(point(1, 1, 1))), (reference::Box{{1, 1, 1}, {2, 2, 2}}));
  EXPECT_EQ(literal::box(tree, tree.leaf_at(point(2, 2, 2))), (reference::Box{{1, 1, 1}, {2, 2, 2}}));
}

TEST(RefinementTree, FindsPointsWithNumbersPastSixtyFourBits) {
  RefinementTree tree(Setting{{3, 3, 3}, 2, {1, 1, 1}});
  const Rational tiny = Rational(1) / Rational(boost::multiprecision::pow(Integer(10), 40));
  tree.subdivide(tree.leaf_at(point(tiny, 0, 0)));
  tree.update_ranks();
  EXPECT_EQ(literal::box(tree, tree.leaf_at(point(over(1, 2) - tiny, tiny, 1))),
            (reference::Box{{0, 0, 0}, {over(1, 2), 1, 1}}));
  EXPECT_EQ(literal::box(tree, tree.leaf_at(point(over(1, 2) + tiny, tiny, 1))),
            (reference::Box{{over(1, 2), 0, 0}, {1, 1, 1}}));
}

TEST(RefinementTree, RefusesWhatDoesNotFit) {
  EXPECT_THROW(RefinementTree(Setting{{3, 3, 3}, 2, {1000, 1000, 1000}}), ResourceError);
  EXPECT_THROW(RefinementTree(Setting{{3, 3, 3}, 2, {0, 1, 1}}), InputError);
}

/// The tree after subdividing what the case's marks name, one after the other, without closures.
RefinementTree subdivided(const Case& content) {
  RefinementTree tree(setting_of(content));
  for (const Step& step : content.steps) {
    for (const Point& mark : step.marks) tree.subdivide(tree.leaf_at(mark));
    tree.update_ranks();
  }
  return tree;
}

/// The leaf at a point, its level and its environment, by Definitions 2.2 and 2.4.
void expect_leaf(const RefinementTree& tree, const reference::Mesh& boxes, const Point& where) {
  const reference::Setting setting = literal::setting(tree.setting());
  const std::int32_t leaf = tree.leaf_at(where);
  const reference::Box box = literal::box(tree, leaf);
  EXPECT_EQ(box, boxes[*reference::element_at(setting, boxes, literal::point(where))]);
  EXPECT_EQ(tree.node(leaf).level, reference::level(setting, box));
  const reference::Box environment = reference::environment(setting, box);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree.grid(axis);
    const RankInterval window = tree.environment(leaf, axis);
    EXPECT_EQ(grid.coordinate(grid.line_of_rank(window.lower)), environment.lower[static_cast<std::size_t>(axis)]);
    EXPECT_EQ(grid.coordinate(grid.line_of_rank(window.upper)), environment.upper[static_cast<std::size_t>(axis)]);
  }
}

// Law 1, and what stands at random points.
TEST(RefinementTree, AgreesWithTheLiteralDefinitionsOnRandomSubdivisions) {
  Draw draw(6);
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    const RefinementTree tree = subdivided(random_bare_case(draw, {5, 5, 6, 60, 120, 8}).content);
    const reference::Mesh boxes = leaf_boxes(tree);
    EXPECT_TRUE(reference::tiles_domain(literal::setting(tree.setting()), boxes));
    EXPECT_EQ(static_cast<std::int64_t>(boxes.size()), tree.element_count());
    for (int tries = 0; tries < 20; ++tries) expect_leaf(tree, boxes, random_point(draw, tree.setting()));
  }
}

// `coarsest`: the lowest level of an unmarked leaf below, for every node, after random marks and subdivisions.
std::int32_t coarsest_below(const RefinementTree& tree, std::int32_t id) {
  if (tree.is_leaf(id)) return tree.is_marked(id) ? RefinementTree::kNoLevel : tree.node(id).level;
  std::int32_t coarsest = RefinementTree::kNoLevel;
  const std::int32_t first = tree.node(id).first_child;
  for (std::int32_t child = first; child < first + tree.child_count(id); ++child) {
    coarsest = std::min(coarsest, coarsest_below(tree, child));
  }
  return coarsest;
}

void expect_same_tree(const RefinementTree& one, const RefinementTree& other) {
  ASSERT_EQ(one.node_count(), other.node_count());
  EXPECT_EQ(one.element_count(), other.element_count());
  EXPECT_EQ(one.new_element_count(), other.new_element_count());
  EXPECT_EQ(one.max_level(), other.max_level());
  std::int64_t different = 0;
  for (std::int32_t id = 0; id < one.node_count(); ++id) {
    const RefinementTree::Node a = one.node(id);
    const RefinementTree::Node b = other.node(id);
    const bool same = a.parent == b.parent && a.first_child == b.first_child && a.level == b.level &&
                      a.coarsest == b.coarsest && literal::box(one, id) == literal::box(other, id);
    different += same ? 0 : 1;
  }
  EXPECT_EQ(different, 0);
}

// Leaves of several levels, in any order, so many that every thread gets some; half of them are marked before.
TEST(RefinementTree, IsTheSameForAnyNumberOfThreadsAndLeafByLeaf) {
  Draw draw(8);
  const Setting setting{{3, 5, 3}, 3, {12, 11, 10}};
  RefinementTree together(setting), by_threads(setting), one_by_one(setting);
  for (int step = 0; step < 4; ++step) {
    std::vector<std::int32_t> leaves;
    for (const std::int32_t leaf : leaves_of(together)) {
      if (!draw.one_in(step + 2)) leaves.push_back(leaf);
    }
    for (std::size_t i = leaves.size(); i-- > 1;) {
      std::swap(leaves[i], leaves[static_cast<std::size_t>(draw.between(0, static_cast<int>(i)))]);
    }
    for (std::size_t i = 0; i < leaves.size(); i += 2) {
      for (RefinementTree* tree : {&together, &by_threads}) tree->mark(leaves[i]);
    }
    together.subdivide(leaves);
    by_threads.subdivide(leaves, 3);
    for (const std::int32_t leaf : leaves) one_by_one.subdivide(leaf);
    for (RefinementTree* tree : {&together, &by_threads, &one_by_one}) tree->update_ranks();
    expect_same_tree(together, by_threads);
    expect_same_tree(together, one_by_one);
  }
  EXPECT_GT(together.element_count(), 30000);
  EXPECT_EQ(together.node(0).coarsest, coarsest_below(together, 0));
}

TEST(RefinementTree, KnowsTheCoarsestUnmarkedLeafBelowEveryNode) {
  Draw draw(7);
  for (int round = 0; round < 30; ++round) {
    RefinementTree tree(Setting{{3, 3, 3}, draw.between(2, 4), {2, 3, 2}});
    for (int changes = draw.between(1, 30); changes > 0; --changes) {
      const std::int32_t leaf = draw.choose(leaves_of(tree));
      if (draw.one_in(2)) {
        tree.subdivide(leaf);
      } else {
        tree.mark(leaf);
      }
    }
    for (std::int32_t id = 0; id < tree.node_count(); ++id) EXPECT_EQ(tree.node(id).coarsest, coarsest_below(tree, id));
  }
}

}  // namespace
}  // namespace asts
