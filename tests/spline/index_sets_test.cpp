#include "lib/spline/index_sets.hpp"

#include <gtest/gtest.h>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/reference/spline.hpp"

namespace asts {
namespace {

Mesh mesh_of_text(const std::string& text) {
  const Case content = parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\n" + text, "f");
  return mesh_of(setting_of(content), content.elements);
}

/// The index set through a point, as coordinates.
std::vector<Rational> index_set(const Mesh& mesh, Axis axis, const reference::Point& point) {
  PerAxis<HalfRank> position{};
  for (Axis other = 0; other < kDimension; ++other) {
    if (other == axis) continue;
    position[static_cast<std::size_t>(other)] = half_rank(mesh, other, point[static_cast<std::size_t>(other)]);
  }
  std::vector<Rational> result;
  for (const std::int32_t rank : global_index_set(mesh, axis, position)) result.push_back(mesh.coordinate(axis, rank));
  return result;
}

// A row of 2 x 1 x 1 with lines 0, 1/3, 2 along x.
TEST(HalfRank, IsEvenOnLinesAndOddBetween) {
  const Mesh mesh = mesh_of_text("domain 2 1 1\nelement 0 0 0 1/3 1 1\nelement 1/3 0 0 2 1 1\n");
  EXPECT_EQ(half_rank(mesh, 0, 0), 0);
  EXPECT_EQ(half_rank(mesh, 0, Rational(1) / 4), 1);
  EXPECT_EQ(half_rank(mesh, 0, Rational(1) / 3), 2);
  EXPECT_EQ(half_rank(mesh, 0, 1), 3);
  EXPECT_EQ(half_rank(mesh, 0, 2), 4);
}

// [0,2] x [0,2] x [0,1]: below y = 1 cut at x = 1, above at x = 1/2. On the common line y = 1 both closed faces end, so
// both coordinates are in X(1, z), and only one of them off it.
TEST(GlobalIndexSet, ClosedFacesCountOnTheirBorder) {
  const Mesh mesh = mesh_of_text(
      "domain 2 2 1\nelement 0 0 0 1 1 1\nelement 1 0 0 2 1 1\nelement 0 1 0 1/2 2 1\nelement 1/2 1 0 2 2 1\n");
  const Rational half = Rational(1) / 2;
  for (const Rational& z : {Rational(0), Rational(1) / 7, Rational(1)}) {
    EXPECT_EQ(index_set(mesh, 0, {0, half, z}), (std::vector<Rational>{0, 1, 2}));
    EXPECT_EQ(index_set(mesh, 0, {0, 1, z}), (std::vector<Rational>{0, half, 1, 2}));
    EXPECT_EQ(index_set(mesh, 0, {0, Rational(3) / 2, z}), (std::vector<Rational>{0, half, 2}));
    EXPECT_EQ(index_set(mesh, 1, {half, 0, z}), (std::vector<Rational>{0, 1, 2}));
  }
  EXPECT_EQ(index_set(mesh, 2, {half, 1, 0}), (std::vector<Rational>{0, 1}));
}

/// Lines of the mesh half of the time, numbers between them otherwise.
reference::Point random_place(Draw& draw, const Mesh& mesh) {
  reference::Point point;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const std::vector<Rational>& lines = mesh.coordinates[axis];
    const std::size_t i = draw.index(lines.size());
    point[axis] = lines[i];
    if (i + 1 < lines.size() && draw.one_in(2)) point[axis] += (lines[i + 1] - lines[i]) * draw.between(1, 4) / 5;
  }
  return point;
}

void compare_index_sets(Draw& draw, const Mesh& mesh) {
  const reference::Setting setting = literal::setting(mesh.setting);
  const auto space = reference::make_space<Rational>(setting, literal::mesh(mesh), 1);
  for (int tries = 0; tries < 12; ++tries) {
    const reference::Point point = random_place(draw, mesh);
    for (Axis axis = 0; axis < kDimension; ++axis) {
      ASSERT_EQ(index_set(mesh, axis, point), reference::global_index_set(space, static_cast<std::size_t>(axis), point))
          << axis_name(axis) << " through " << point[0] << ", " << point[1] << ", " << point[2];
    }
  }
}

// Definition 4.3 through any point of the domain, its border included, on and off the mesh's lines.
TEST(GlobalIndexSet, AgreesWithTheLiteralDefinition) {
  Draw draw(17);
  for (int round = 0; round < 100; ++round) {
    const Case boxes = random_box_case(draw, {}).content;
    SCOPED_TRACE(write_case(boxes));
    compare_index_sets(draw, mesh_of(setting_of(boxes), boxes.elements));
    const Case steps = random_bare_case(draw, {}).content;
    SCOPED_TRACE(write_case(steps));
    Replay replay(steps);
    while (!replay.done()) replay.advance();
    compare_index_sets(draw, mesh_of(replay.tree()));
    ASSERT_FALSE(HasFailure());
  }
}

}  // namespace
}  // namespace asts
