#include "lib/spline/slices.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/reference/suitability.hpp"

namespace asts {
namespace {

// 5 x 4 x 4 with [2,3] x [1,2] x [1,2] cut at x = 5/2: active nodes (2,2,2), (5/2,2,2), (3,2,2), which are all on the
// line (., 2, 2), on the border of the closed face at 5/2.
TEST(SliceNodes, ClosedFacesCountOnTheirBorder) {
  const Mesh mesh = last_mesh(parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 5 4 4\nsubdivide 2 1 1\n", "f"));
  const TSplines splines = tsplines_of(mesh);
  ASSERT_EQ(splines.size(), 3);
  EXPECT_EQ(slice_nodes(mesh, splines, 0, half_rank(mesh, 0, Rational(5) / 2)), std::vector<bool>(3, true));
  EXPECT_EQ(slice_nodes(mesh, splines, 0, half_rank(mesh, 0, Rational(7) / 3)), std::vector<bool>(3, false));
}

// All three supports reach the slice x = 5/2, whose part in the active region is the point y = z = 2; none the slice
// x = 1, which is outside the active region.
TEST(SupportsInSlice, AreClippedToTheActiveRegion) {
  const Mesh mesh = last_mesh(parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 5 4 4\nsubdivide 2 1 1\n", "f"));
  const TSplines splines = tsplines_of(mesh);
  const std::vector<std::int32_t> all{0, 1, 2};
  EXPECT_EQ(supports_in_slice(splines, 0, half_rank(mesh, 0, Rational(5) / 2), all),
            (std::vector<Rectangle>(3, Rectangle{{4, 4}, {4, 4}})));
  EXPECT_TRUE(supports_in_slice(splines, 0, half_rank(mesh, 0, 1), all).empty());
}

TEST(BoxInSlice, HasTheRectangleOnTheOtherAxes) {
  const Rectangle rectangle{{1, 2}, {3, 4}};
  EXPECT_EQ(box_in_slice(1, 7, rectangle), (Box{{1, 7, 2}, {3, 7, 4}}));
  for (Axis axis = 0; axis < kDimension; ++axis)
    EXPECT_EQ(rectangle_of(axis, box_in_slice(axis, 7, rectangle)), rectangle);
}

void compare_members(Draw& draw, const Mesh& mesh, const TSplines& splines) {
  const auto space = reference::make_space<Rational>(literal::setting(mesh.setting), literal::mesh(mesh), 1);
  const auto nodes = reference::active_nodes(space);
  ASSERT_EQ(nodes.size(), splines.nodes.size());
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const Rational q = mesh.coordinates[at(axis)][draw.index(mesh.coordinates[at(axis)].size())];
    const std::vector<bool> members = slice_nodes(mesh, splines, axis, half_rank(mesh, axis, q));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      EXPECT_EQ(members[i], reference::in_slice_nodes(space, at(axis), q, nodes[i])) << axis_name(axis) << " = " << q;
    }
  }
}

// Definition 5.1's N_x(q), N_y(r), N_z(s).
TEST(SliceNodes, AgreeWithTheLiteralCode) {
  for (std::uint64_t seed = 0; seed < 300 && !testing::Test::HasFailure(); ++seed) {
    Draw draw(seed);
    CaseLimits limits;
    limits.max_elements = 120;
    limits.max_cubes = 100;
    const Case content = (draw.one_in(2) ? random_bare_case(draw, limits) : random_box_case(draw, limits)).content;
    SCOPED_TRACE(write_case(content));
    const Mesh mesh = last_mesh(content);
    compare_members(draw, mesh, tsplines_of(mesh));
  }
}

// What perturbed_region is used for when regions are compared: where all ends are even, the intersection of two unions
// is the same list however the unions are cut into rectangles.
TEST(UnionIntersection, IsTheSameForTheSameSets) {
  UnionIntersection intersection;
  const std::vector<Rectangle> whole{{{0, 0}, {8, 6}}};
  const std::vector<Rectangle> parts{{{0, 0}, {4, 6}}, {{2, 0}, {8, 2}}, {{4, 2}, {8, 6}}};
  const std::vector<Rectangle> cross{{{2, 0}, {4, 6}}, {{0, 2}, {8, 4}}};
  const std::vector<Rectangle> cut_cross{{{2, 0}, {4, 2}}, {{2, 2}, {4, 6}}, {{0, 2}, {2, 4}}, {{4, 2}, {8, 4}}};
  EXPECT_EQ(intersection.of(whole, whole), intersection.of(parts, whole));
  EXPECT_EQ(intersection.of(whole, cross), intersection.of(cut_cross, parts));
}

}  // namespace
}  // namespace asts
