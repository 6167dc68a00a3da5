#include "lib/mesh/reflection.hpp"

#include <gtest/gtest.h>

#include "lib/gen/growing_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "tests/literal_mesh.hpp"

namespace asts {
namespace {

reference::Box mirrored(const Setting& setting, const reference::Box& box, const PerAxis<bool>& axes) {
  reference::Box result = box;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (!axes[axis]) continue;
    result.lower[axis] = setting.domain[axis] - box.upper[axis];
    result.upper[axis] = setting.domain[axis] - box.lower[axis];
  }
  return result;
}

reference::Mesh boxes_of(const RefinementTree& tree) {
  reference::Mesh result;
  for (const std::int32_t leaf : leaves_of(tree)) result.push_back(literal::box(tree, leaf));
  return literal::sorted(std::move(result));
}

// m = 3, domain 3 x 2 x 1: the cube [0,1]^3 cut along x, its first third [0,1/3] cut along y. Mirrored along x these
// are the cube [2,3] x [0,1]^2 and its last third; mirrored along y the cuts along y are those of [1,2], symmetric.
TEST(Reflection, ByHand) {
  RefinementTree tree(Setting{{3, 3, 3}, 3, {3, 2, 1}});
  tree.subdivide(tree.unit_cube({0, 0, 0}));
  const std::int32_t third = tree.node(tree.unit_cube({0, 0, 0})).first_child;
  tree.subdivide(third);
  tree.update_ranks();
  const Reflection along_x = reflect(tree, {true, false, false});
  EXPECT_EQ(along_x.image[at(tree.unit_cube({0, 1, 0}))], along_x.tree.unit_cube({2, 1, 0}));
  EXPECT_EQ(literal::box(along_x.tree, along_x.image[at(third)]), (reference::Box{{Rational(8) / 3, 0, 0}, {3, 1, 1}}));
  EXPECT_EQ(literal::box(along_x.tree, along_x.image[at(tree.node(third).first_child)]),
            (reference::Box{{Rational(8) / 3, 0, 0}, {3, Rational(1) / 3, 1}}));
  const Reflection along_y = reflect(tree, {false, true, false});
  EXPECT_EQ(literal::box(along_y.tree, along_y.image[at(tree.node(third).first_child)]),
            (reference::Box{{0, Rational(5) / 3, 0}, {Rational(1) / 3, 2, 1}}));
}

TEST(Reflection, ThereAreSevenAndEachIsAnother) {
  const auto all = reflections();
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_NE(all[i], (PerAxis<bool>{}));
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(all[i], all[j]);
  }
}

// Laws 1 and 2.
TEST(Reflection, MirrorsEveryElementAndIsAnInvolution) {
  Draw draw(31);
  for (int round = 0; round < 60; ++round) {
    const Case content = random_bare_case(draw, CaseLimits{3, 5, 5, 60, 120, 6}).content;
    SCOPED_TRACE(write_case(content));
    Replay replay(content);
    while (!replay.done()) replay.advance();
    const RefinementTree& tree = replay.tree();
    for (const PerAxis<bool>& axes : reflections()) {
      const Reflection mirror = reflect(tree, axes);
      for (std::int32_t id = 0; id < tree.node_count(); ++id) {
        if (tree.node(id).level < 0) {
          EXPECT_EQ(mirror.image[at(id)], RefinementTree::kNone);
          continue;
        }
        const std::int32_t image = mirror.image[at(id)];
        EXPECT_EQ(literal::box(mirror.tree, image), mirrored(tree.setting(), literal::box(tree, id), axes));
        EXPECT_EQ(mirror.tree.node(image).level, tree.node(id).level);
        EXPECT_EQ(mirror.tree.is_leaf(image), tree.is_leaf(id));
      }
      EXPECT_EQ(mirror.tree.element_count(), tree.element_count());
      EXPECT_EQ(boxes_of(reflect(mirror.tree, axes).tree), boxes_of(tree));
    }
  }
}

}  // namespace
}  // namespace asts
