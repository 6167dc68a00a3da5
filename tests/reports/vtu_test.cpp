#include <gtest/gtest.h>

#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "reports/base64.hpp"
#include "reports/vtu/blending_values.hpp"
#include "reports/vtu/element_marks.hpp"
#include "reports/vtu/element_search.hpp"
#include "reports/vtu/mesh_points.hpp"
#include "reports/vtu/mesh_vtu.hpp"

namespace asts::testing {
namespace {

const std::string kRefined =
    "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 5 5 8\nrefine 5/2 5/2 5/2\nrefine 5/2 5/2 5/2\nsubdivide 3 3 3\n"
    "subdivide 3 3 3\nsubdivide 2 2 4 3 1 4\n";

Mesh refined_mesh() { return last_mesh(parse_case(kRefined, "case")); }

TEST(Base64, VectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\x00\xfe", 3)), "/wD+");
}

TEST(MeshPoints, AreTheVerticesOfElementsInOrder) {
  const Mesh mesh = refined_mesh();
  const MeshPoints points = mesh_points(mesh);
  EXPECT_TRUE(std::is_sorted(points.positions.begin(), points.positions.end()));
  EXPECT_EQ(std::adjacent_find(points.positions.begin(), points.positions.end()), points.positions.end());
  std::vector<bool> used(points.positions.size(), false);
  for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
    for (std::size_t corner = 0; corner < MeshPoints::kCorners; ++corner) {
      const std::int32_t point = points.corners[MeshPoints::kCorners * element + corner];
      used[at(point)] = true;
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        const Box& box = mesh.elements[element];
        EXPECT_EQ(points.positions[at(point)][axis], (corner >> axis & 1) != 0 ? box.upper[axis] : box.lower[axis]);
      }
    }
  }
  EXPECT_EQ(std::find(used.begin(), used.end(), false), used.end());
}

bool meets(const Box& element, const HalfBox& box) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (2 * element.upper[axis] < box.lower[axis] || 2 * element.lower[axis] > box.upper[axis]) return false;
  }
  return true;
}

// All boxes of half ranks between some ends, also empty, flat and outside ones, against the definition.
TEST(ElementSearch, AgreesWithLookingAtAllElements) {
  const Mesh mesh = refined_mesh();
  for (HalfRank lower = 0; lower <= 20; ++lower) {
    for (HalfRank upper = lower - 1; upper <= lower + 5; ++upper) {
      const HalfBox box{{lower, 3, 2}, {upper, 6, upper}};
      std::vector<std::int32_t> found(mesh.elements.size(), 0);
      for_each_element_meeting(mesh, box, [&](std::int32_t element) { ++found[at(element)]; });
      const bool empty = lower > upper || 2 > upper;
      for (std::size_t element = 0; element < mesh.elements.size(); ++element) {
        EXPECT_EQ(found[element], !empty && meets(mesh.elements[element], box) ? 1 : 0) << lower << " " << upper;
      }
    }
  }
}

TEST(ElementSearch, TheInteriorOfABoxBetweenLines) {
  const Mesh mesh = last_mesh(parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\n", "case"));
  const HalfBox half =
      interior_of(mesh, {{Rational(1), Rational(1, 2), Rational(0)}, {Rational(2), Rational(3, 2), Rational(4)}});
  EXPECT_EQ(half.lower, (PerAxis<HalfRank>{3, 1, 1}));
  EXPECT_EQ(half.upper, (PerAxis<HalfRank>{3, 3, 7}));
}

// The supports' elements and those of the perturbed regions, each against all elements.
TEST(ElementMarks, AgreeWithTheDefinitions) {
  const Case test_case = parse_case(kRefined, "case");
  Replay replay(test_case);
  while (!replay.done()) replay.advance();
  MeshUnderTest mesh(replay.tree());
  const TSplines& splines = mesh.splines();
  ASSERT_FALSE(splines.missing);
  for (std::int32_t node = 0; node < splines.size(); ++node) {
    const auto marks = marks_of_support(mesh, node);
    for (std::size_t element = 0; element < marks.size(); ++element) {
      const Box& box = mesh.mesh().elements[element];
      bool shares_volume = true;
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const RankInterval support = splines.support(node, axis);
        shares_volume &= box.lower[at(axis)] < support.upper && box.upper[at(axis)] > support.lower;
      }
      EXPECT_EQ(marks[element], shares_volume ? 1 : 0);
    }
  }
  std::int64_t marked = 0;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto marks = marks_of_perturbed_region(mesh, axis);
    for (std::size_t element = 0; element < marks.size(); ++element) {
      const auto& region = mesh.perturbed_regions()[at(axis)];
      const bool in = std::any_of(region.begin(), region.end(), [&](const Box& box) {
        return meets(mesh.mesh().elements[element], {box.lower, box.upper});
      });
      EXPECT_EQ(marks[element], in ? 1 : 0);
      marked += marks[element];
    }
  }
  EXPECT_GT(marked, 0);
}

// Of the boxes that an element lies in, the first; a box outside the domain counts and marks nothing.
TEST(ElementMarks, BoxesInTheirOrder) {
  const Mesh mesh = last_mesh(parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 3 1 1\n", "case"));
  const auto box = [](int lower, int upper) { return ExactBox{{lower, 0, 0}, {upper, 1, 1}}; };
  EXPECT_EQ(marks_of_boxes(mesh, {box(-1, 3), box(1, 2), box(1, 3)}), (std::vector<std::int32_t>{0, 2, 3}));
}

// The cubic B-spline on integers, by hand; and 0 at the ends and outside.
TEST(BlendingFunction, ValuesByHand) {
  const Mesh mesh = last_mesh(parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\n", "case"));
  const TSplines splines = tsplines_of(mesh);
  const auto node = active_node_at(mesh, splines, {2, 2, 2});
  ASSERT_TRUE(node);
  EXPECT_FALSE(active_node_at(mesh, splines, {1, 2, 2}));
  EXPECT_FALSE(active_node_at(mesh, splines, {Rational(3, 2), 2, 2}));
  const BlendingFunction function(mesh, splines, *node);
  const std::vector<std::pair<Rational, Rational>> values{{0, 0},
                                                          {Rational(1, 2), Rational(1, 48)},
                                                          {1, Rational(1, 6)},
                                                          {Rational(3, 2), Rational(23, 48)},
                                                          {2, Rational(2, 3)},
                                                          {3, Rational(1, 6)},
                                                          {Rational(7, 2), Rational(1, 48)},
                                                          {4, 0},
                                                          {5, 0}};
  for (const auto& [coordinate, value] : values) EXPECT_EQ(function.factor(1, coordinate), value) << coordinate;
  const BlendingSamples samples = blending_samples(function);
  EXPECT_EQ(samples.coordinates[2].size(), 17U);
  EXPECT_EQ(samples.coordinates[2][2], Rational(1, 2));
  EXPECT_EQ(samples.factors[2][2], Rational(1, 48));
  EXPECT_EQ(samples.coordinates[2].back(), 4);
}

// Very high degrees get a coarser lattice: (28 intervals * 4 + 1)^3 points would be too many.
TEST(BlendingFunction, ALatticeIsNeverTooLarge) {
  const Mesh mesh = last_mesh(parse_case("asts-case 1\ndegree 27 27 27\ngrading 2\ndomain 28 28 28\n", "case"));
  const TSplines splines = tsplines_of(mesh);
  ASSERT_EQ(splines.size(), 1);
  EXPECT_EQ(blending_samples(BlendingFunction(mesh, splines, 0)).coordinates[0].size(), 28U * 2 + 1);
}

// A coordinate that float64 does not have is rounded; nothing is lost by it.
TEST(MeshVtu, PointsThatCoincideWhenDrawnAreCountedStill) {
  const std::string header = "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 2 1 1\n";
  const std::string near = "1180591620717411303425/1180591620717411303424";  // 1 + 2^-70
  const Case test_case = parse_case(
      header + "element 0 0 0 1 1 1\nelement 1 0 0 " + near + " 1 1\nelement " + near + " 0 0 2 1 1\n", "case");
  MeshUnderTest mesh(mesh_of(setting_of(test_case), test_case.elements));
  const MeshVtu vtu = mesh_vtu(mesh, {});
  EXPECT_EQ(vtu.counts.elements, 3);
  EXPECT_EQ(vtu.counts.points, 16);
  EXPECT_EQ(vtu.grid.points[3 * 4], 1.0);
  EXPECT_EQ(vtu.grid.points[3 * 8], 1.0);
}

}  // namespace
}  // namespace asts::testing
