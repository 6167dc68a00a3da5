#include "lib/spline/perturbed_regions.hpp"

#include <gtest/gtest.h>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "lib/spline/slices.hpp"

/// The perturbed regions point by point on the lattice of lines and of the intervals between them, from Definition 5.1.
namespace asts {
namespace {

using LatticePoint = PerAxis<HalfRank>;

bool in_support(const TSplines& splines, std::int32_t node, const LatticePoint& point) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval side = splines.support(node, axis);
    if (point[at(axis)] < 2 * side.lower || point[at(axis)] > 2 * side.upper) return false;
  }
  return true;
}

bool in_box(const Box& box, const LatticePoint& point) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (point[axis] < box.lower[axis] || point[axis] > box.upper[axis]) return false;
  }
  return true;
}

bool in_region(const std::vector<Box>& region, const LatticePoint& point) {
  return std::any_of(region.begin(), region.end(), [&](const Box& box) { return in_box(box, point); });
}

/// In the supports of a node whose projection on the slice lies in the skeleton, and of one whose does not.
bool is_perturbed(const TSplines& splines, const std::vector<bool>& projected, const LatticePoint& point) {
  bool with = false;
  bool without = false;
  for (std::int32_t node = 0; node < splines.size(); ++node) {
    if (in_support(splines, node, point)) (projected[at(node)] ? with : without) = true;
  }
  return with && without;
}

/// Compares all lattice points of the closed active region, and whether two regions have one in common.
void compare(const Mesh& mesh) {
  const TSplines splines = tsplines_of(mesh);
  if (splines.size() == 0 || splines.missing || splines.size() > 40) return;
  const Bricks bricks = bricks_of(splines);
  const PerturbedRegions regions = perturbed_regions(bricks, splines.region);
  PerAxis<std::vector<std::vector<bool>>> projected;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    for (HalfRank q = 0; q <= splines.region.upper[at(axis)]; ++q) {
      projected[at(axis)].push_back(slice_nodes(mesh, splines, axis, q));
    }
  }
  bool meet = false;
  LatticePoint point = splines.region.lower;
  for (; point[0] <= splines.region.upper[0]; ++point[0]) {
    for (point[1] = splines.region.lower[1]; point[1] <= splines.region.upper[1]; ++point[1]) {
      for (point[2] = splines.region.lower[2]; point[2] <= splines.region.upper[2]; ++point[2]) {
        int count = 0;
        for (std::size_t axis = 0; axis < kDimension; ++axis) {
          const std::vector<bool>& nodes = projected[axis][at(point[axis])];
          const bool expected = point[axis] % 2 == 0 && is_perturbed(splines, nodes, point);
          ASSERT_EQ(in_region(regions[axis], point), expected)
              << axis << ": " << point[0] << ' ' << point[1] << ' ' << point[2];
          count += expected ? 1 : 0;
        }
        meet = meet || count >= 2;
      }
    }
  }
  ASSERT_EQ(find_meeting(regions).has_value(), meet);
}

TEST(PerturbedRegions, AreThoseOfTheDefinitionOnRandomMeshes) {
  Draw draw(51);
  CaseLimits limits;
  limits.max_elements = 120;
  for (int i = 0; i < 1500 && !HasFatalFailure(); ++i) {
    const Case content = i % 3 == 0   ? random_box_case(draw, limits).content
                         : i % 3 == 1 ? random_bare_case(draw, limits).content
                                      : random_trouble_case(draw, limits).content;
    SCOPED_TRACE(write_case(content));
    compare(last_mesh(content));
  }
}

// Behind a common point of two regions: for each of them a node that has the slice in its vector, and one that lacks
// it.
TEST(PerturbedRegions, NodesBehindAPointHaveTheLineAndLackIt) {
  const Mesh mesh = last_mesh(read_case_file(std::string(ASTS_CASES) + "/../../reports/findings/dc-implies-as.case"));
  const TSplines splines = tsplines_of(mesh);
  const Bricks bricks = bricks_of(splines);
  const auto meeting = find_meeting_regions(splines, bricks);
  ASSERT_TRUE(meeting.has_value());
  for (const Axis axis : {meeting->first_axis, meeting->second_axis}) {
    const auto [in, out] = nodes_behind(splines, bricks, axis, meeting->point);
    const std::vector<bool> projected = slice_nodes(mesh, splines, axis, meeting->point[at(axis)]);
    EXPECT_TRUE(projected[at(in)]);
    EXPECT_FALSE(projected[at(out)]);
    EXPECT_TRUE(in_support(splines, in, meeting->point));
    EXPECT_TRUE(in_support(splines, out, meeting->point));
  }
}

}  // namespace
}  // namespace asts
