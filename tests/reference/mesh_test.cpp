#include "tests/reference/mesh.hpp"

#include <gtest/gtest.h>

#include "tests/reference/example_meshes.hpp"

namespace asts::reference {
namespace {

const Setting wide{{3, 5, 7}, 2, {20, 20, 20}};

Box box(Rational x0, Rational x1, Rational y0, Rational y1, Rational z0, Rational z1) {
  return {{x0, y0, z0}, {x1, y1, z1}};
}

TEST(ReferenceMesh, LevelIsMinusLogOfVolumeWhenThatIsAnInteger) {
  EXPECT_EQ(level(wide, box(0, 1, 0, 1, 0, 1)), 0);
  EXPECT_EQ(level(wide, box(0, over(1, 4), 0, over(1, 2), 0, over(1, 2))), 4);  // volume 1/16
  EXPECT_EQ(level(wide, box(0, 2, 0, 2, 0, 2)), -3);                            // volume 8
  EXPECT_EQ(level(wide, box(0, 1, 0, 1, 0, over(1, 3))), std::nullopt);
}

TEST(ReferenceMesh, RadiusFollowsTheThreeCases) {
  // p + 3/2 = (9/2, 13/2, 17/2), m = 2.
  EXPECT_EQ(environment_radius(wide, 0), (Point{over(9, 2), over(13, 2), over(17, 2)}));
  EXPECT_EQ(environment_radius(wide, 1), (Point{over(9, 4), over(13, 2), over(17, 2)}));
  EXPECT_EQ(environment_radius(wide, 2), (Point{over(9, 4), over(13, 4), over(17, 2)}));
  EXPECT_EQ(environment_radius(wide, 3), (Point{over(9, 4), over(13, 4), over(17, 4)}));
  EXPECT_EQ(environment_radius(wide, 4), (Point{over(9, 8), over(13, 4), over(17, 4)}));
  EXPECT_EQ(environment_radius(wide, -1), (Point{over(9, 2), over(13, 2), 17}));  // -1 = 2 mod 3, m^(3/3) = 2
}

TEST(ReferenceMesh, EnvironmentIsOpenAndWithinTheDomain) {
  const Setting setting{{3, 3, 3}, 2, {8, 8, 8}};
  const Box cube = box(0, 1, 0, 1, 0, 1);
  EXPECT_EQ(environment(setting, cube), box(0, 5, 0, 5, 0, 5));  // 1/2 + 9/2 = 5, and Omega begins at 0
  EXPECT_TRUE(closed_meets_open(box(4, 5, 0, 1, 0, 1), environment(setting, cube)));
  EXPECT_FALSE(closed_meets_open(box(5, 6, 0, 1, 0, 1), environment(setting, cube)));  // touches the boundary only
  EXPECT_EQ(patch(setting, initial_mesh(setting), cube).size(), 125U);
}

TEST(ReferenceMesh, SubdivisionDirectionFollowsTheLevel) {
  const Setting setting{{3, 3, 3}, 3, {4, 4, 4}};
  const std::vector<Box> first = children(setting, box(0, 1, 0, 1, 0, 1));
  ASSERT_EQ(first.size(), 3U);
  EXPECT_EQ(first[1], box(over(1, 3), over(2, 3), 0, 1, 0, 1));
  const std::vector<Box> second = children(setting, first[1]);
  EXPECT_EQ(second[2], box(over(1, 3), over(2, 3), over(2, 3), 1, 0, 1));
  EXPECT_EQ(children(setting, second[2])[0], box(over(1, 3), over(2, 3), over(2, 3), 1, 0, over(1, 3)));
}

TEST(ReferenceMesh, MarksNameHalfOpenElements) {
  const Setting setting{{3, 3, 3}, 2, {4, 4, 5}};
  const Mesh mesh = initial_mesh(setting);
  EXPECT_EQ(mesh[*element_at(setting, mesh, {1, 0, 0})], box(1, 2, 0, 1, 0, 1));
  EXPECT_EQ(mesh[*element_at(setting, mesh, {4, 4, 5})], box(3, 4, 3, 4, 4, 5));  // upper faces of the domain
  EXPECT_EQ(element_at(setting, mesh, {4, 4, over(51, 10)}), std::nullopt);
  EXPECT_EQ(element_at(setting, mesh, {over(-1, 100), 0, 0}), std::nullopt);
}

TEST(ReferenceMesh, TilingNeedsNeitherGapNorOverlap) {
  const Setting setting{{3, 3, 3}, 2, {2, 1, 1}};
  EXPECT_TRUE(tiles_domain(setting, {box(0, over(1, 3), 0, 1, 0, 1), box(over(1, 3), 2, 0, 1, 0, 1)}));
  EXPECT_FALSE(tiles_domain(setting, {box(0, 1, 0, 1, 0, 1)}));
  EXPECT_FALSE(tiles_domain(setting, {box(0, 1, 0, 1, 0, 1), box(0, 1, 0, 1, 0, 1)}));  // right volume, overlap
  EXPECT_FALSE(tiles_domain(setting, {box(0, 2, 0, 1, 0, 1), box(1, 1, 0, 1, 0, 1)}));  // an empty box
  EXPECT_FALSE(tiles_domain(setting, {box(-1, 1, 0, 1, 0, 1)}));                        // outside
  EXPECT_TRUE(tiles_domain({{3, 3, 3}, 2, {8, 8, 4}}, CrossingExtensions().mesh));
}

}  // namespace
}  // namespace asts::reference
