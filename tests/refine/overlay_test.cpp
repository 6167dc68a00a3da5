#include "lib/refine/overlay.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lib/exact/errors.hpp"
#include "lib/gen/growing_case.hpp"
#include "lib/mesh/reflection.hpp"
#include "tests/literal_mesh.hpp"

namespace asts {
namespace {

reference::Mesh boxes_of(const RefinementTree& tree) {
  reference::Mesh result;
  for (const std::int32_t leaf : leaves_of(tree)) result.push_back(literal::box(tree, leaf));
  return literal::sorted(std::move(result));
}

/// Every element of `fine` lies in an element of `coarse`.
bool refines(const reference::Mesh& fine, const reference::Mesh& coarse) {
  return std::all_of(fine.begin(), fine.end(), [&](const reference::Box& k) {
    return std::any_of(coarse.begin(), coarse.end(),
                       [&](const reference::Box& other) { return reference::contains(other, k); });
  });
}

/// The common refinement by its own definition: all intersections with interior.
reference::Mesh intersections(const reference::Mesh& one, const reference::Mesh& other) {
  reference::Mesh result;
  for (const reference::Box& a : one) {
    for (const reference::Box& b : other) {
      reference::Box both;
      bool interior = true;
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        both.lower[axis] = std::max(a.lower[axis], b.lower[axis]);
        both.upper[axis] = std::min(a.upper[axis], b.upper[axis]);
        interior = interior && both.lower[axis] < both.upper[axis];
      }
      if (interior) result.push_back(both);
    }
  }
  return literal::sorted(std::move(result));
}

/// A tree of a few random subdivisions, most of them below one another.
RefinementTree random_tree(Draw& draw, const Setting& setting, int steps) {
  RefinementTree tree(setting);
  for (; steps > 0; --steps) {
    const std::vector<std::int32_t> leaves = leaves_of(tree);
    const std::int32_t last = leaves.back();
    tree.subdivide(draw.one_in(2) ? last : draw.choose(leaves));
    tree.update_ranks();
  }
  return tree;
}

Setting small_setting(Draw& draw) {
  return {{3, 3, 3}, draw.between(2, 3), {draw.between(1, 4), draw.between(1, 2), draw.between(1, 2)}};
}

// Two cubes, m = 2: one mesh has the halves and two quarters of the first cube, the other one the halves of both. The
// overlay has the quarters, the other half of the first cube, and the halves of the second: 3 + 2 elements.
TEST(Overlay, ByHand) {
  const Setting setting{{3, 3, 3}, 2, {2, 1, 1}};
  RefinementTree one(setting);
  one.subdivide(one.unit_cube({0, 0, 0}));
  one.subdivide(one.node(one.unit_cube({0, 0, 0})).first_child);
  one.update_ranks();
  RefinementTree other(setting);
  other.subdivide(other.unit_cube({1, 0, 0}));
  other.subdivide(other.unit_cube({0, 0, 0}));
  other.update_ranks();
  const RefinementTree both = overlay(one, other);
  EXPECT_EQ(both.element_count(), 5);
  const Rational half = Rational(1) / 2;
  EXPECT_EQ(boxes_of(both), literal::sorted({{{0, 0, 0}, {half, half, 1}},
                                             {{0, half, 0}, {half, 1, 1}},
                                             {{half, 0, 0}, {1, 1, 1}},
                                             {{1, 0, 0}, {1 + half, 1, 1}},
                                             {{1 + half, 0, 0}, {2, 1, 1}}}));
}

TEST(Overlay, NeedsOneSetting) {
  const RefinementTree tree(Setting{{3, 3, 3}, 2, {2, 2, 2}});
  EXPECT_THROW(overlay(tree, RefinementTree(Setting{{3, 3, 3}, 3, {2, 2, 2}})), InputError);
  EXPECT_THROW(overlay(tree, RefinementTree(Setting{{3, 3, 5}, 2, {2, 2, 2}})), InputError);
  EXPECT_THROW(overlay(tree, RefinementTree(Setting{{3, 3, 3}, 2, {2, 2, 3}})), InputError);
}

// The definition: the intersections with interior; laws 1, 3 and 4.
TEST(Overlay, IsTheMeshOfIntersectionsAndASemilattice) {
  Draw draw(32);
  int incomparable = 0;
  for (int round = 0; round < 150; ++round) {
    const Setting setting = small_setting(draw);
    const RefinementTree a = random_tree(draw, setting, draw.between(0, 9));
    const RefinementTree b = random_tree(draw, setting, draw.between(0, 9));
    const RefinementTree c = random_tree(draw, setting, draw.between(0, 9));
    const reference::Mesh ab = boxes_of(overlay(a, b));
    EXPECT_EQ(ab, intersections(boxes_of(a), boxes_of(b)));
    EXPECT_EQ(ab, boxes_of(overlay(b, a)));
    EXPECT_EQ(boxes_of(overlay(overlay(a, b), c)), boxes_of(overlay(a, overlay(b, c))));
    EXPECT_EQ(boxes_of(overlay(a, a)), boxes_of(a));
    EXPECT_EQ(boxes_of(overlay(a, RefinementTree(setting))), boxes_of(a));
    EXPECT_EQ(boxes_of(overlay(RefinementTree(setting), a)), boxes_of(a));
    EXPECT_EQ(ab == boxes_of(b), refines(boxes_of(b), boxes_of(a)));
    const PerAxis<bool> axes = reflections()[draw.index(7)];
    EXPECT_EQ(boxes_of(overlay(reflect(a, axes).tree, reflect(b, axes).tree)),
              boxes_of(reflect(overlay(a, b), axes).tree));
    incomparable += ab != boxes_of(a) && ab != boxes_of(b);
    ASSERT_FALSE(HasFailure()) << round;
  }
  EXPECT_GT(incomparable, 60);
}

// Law 2: refines both; and whatever refines both refines it. Common refinements are found by cutting random elements of
// one mesh, most of them too large for the other one, until it refines that.
TEST(Overlay, IsTheCoarsestCommonRefinement) {
  Draw draw(33);
  int found = 0;
  for (int round = 0; round < 100; ++round) {
    const Setting setting = small_setting(draw);
    const RefinementTree a = random_tree(draw, setting, draw.between(0, 7));
    const RefinementTree b = random_tree(draw, setting, draw.between(0, 7));
    const reference::Mesh ab = boxes_of(overlay(a, b));
    EXPECT_TRUE(refines(ab, boxes_of(a)));
    EXPECT_TRUE(refines(ab, boxes_of(b)));
    RefinementTree common = a;
    const reference::Mesh boxes = boxes_of(b);
    while (true) {
      std::vector<std::int32_t> leaves = leaves_of(common);
      const std::int32_t any = draw.choose(leaves);
      std::erase_if(leaves, [&](std::int32_t leaf) { return refines({literal::box(common, leaf)}, boxes); });
      if (leaves.empty()) break;
      common.subdivide(draw.one_in(4) ? any : draw.choose(leaves));
      common.update_ranks();
    }
    EXPECT_TRUE(refines(boxes_of(common), ab));
    found += boxes_of(common) != ab;
  }
  EXPECT_GT(found, 25);
}

// An element of the overlay is an element of one of the two meshes: the smaller one at its place.
TEST(Overlay, HasNoElementOfItsOwn) {
  Draw draw(34);
  for (int round = 0; round < 100; ++round) {
    const Setting setting = small_setting(draw);
    const RefinementTree one = random_tree(draw, setting, 8);
    const RefinementTree other = random_tree(draw, setting, 8);
    const reference::Mesh a = boxes_of(one);
    const reference::Mesh b = boxes_of(other);
    for (const reference::Box& k : boxes_of(overlay(one, other))) {
      EXPECT_TRUE(std::binary_search(a.begin(), a.end(), k) || std::binary_search(b.begin(), b.end(), k));
    }
  }
}

}  // namespace
}  // namespace asts
