#include <gtest/gtest.h>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "lib/spline/axis_factors.hpp"
#include "lib/spline/axis_overlap.hpp"
#include "lib/spline/dual_basis.hpp"
#include "lib/spline/dual_compatibility.hpp"

/// What is decided for pairs of bricks, against all pairs of nodes one by one.
namespace asts {
namespace {

bool share_volume(const TSplines& splines, std::int32_t v, std::int32_t w) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    if (!interiors_meet(splines.support(v, axis), splines.support(w, axis))) return false;
  }
  return true;
}

bool compatible(const TSplines& splines, std::int32_t v, std::int32_t w) {
  int axes = 0;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    axes += overlap(splines.index_vector(v, axis), splines.index_vector(w, axis)) ? 1 : 0;
  }
  return axes >= 2;
}

bool all_compatible(const TSplines& splines) {
  for (std::int32_t v = 0; v < splines.size(); ++v) {
    for (std::int32_t w = 0; w < v; ++w) {
      if (share_volume(splines, v, w) && !compatible(splines, v, w)) return false;
    }
  }
  return true;
}

/// Ordered pairs that share volume, and those of them with a product other than delta_vw.
DualBasisFailures count_all(const Mesh& mesh, const TSplines& splines) {
  std::vector<DualFunctional> functionals;
  for (const int degree : mesh.setting.degree) functionals.emplace_back(degree);
  DualBasisFailures result;
  for (std::int32_t v = 0; v < splines.size(); ++v) {
    for (std::int32_t w = 0; w < splines.size(); ++w) {
      if (!share_volume(splines, v, w)) continue;
      ++result.pairs;
      int zeros = 0;
      int ones = 0;
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const auto a = at(axis);
        const FieldElement factor =
            functionals[a].lambda(vector_coordinates(mesh, splines, axis, splines.vector_ids[at(v)][a]),
                                  vector_coordinates(mesh, splines, axis, splines.vector_ids[at(w)][a]));
        zeros += factor.is_zero() ? 1 : 0;
        ones += factor == Rational(1) ? 1 : 0;
      }
      result.failures += (v == w ? ones < kDimension : zeros == 0) ? 1 : 0;
    }
  }
  if (result.failures == 0) result.pairs = 0;
  return result;
}

void expect_dual_failures(const Mesh& mesh, const TSplines& splines) {
  const DualBasisFailures found = find_dual_failures(mesh, splines, bricks_of(splines));
  const DualBasisFailures expected = count_all(mesh, splines);
  EXPECT_EQ(found.failures, expected.failures);
  EXPECT_EQ(found.pairs, expected.pairs);
  ASSERT_EQ(found.one.has_value(), expected.failures > 0);
  if (!found.one) return;
  const Rational delta = found.one->v == found.one->w ? 1 : 0;
  EXPECT_NE(dual_value(mesh, splines, found.one->v, found.one->w).value == delta, true);
}

// 74 active nodes, counted without the program's pairs: lambda_v(B_w) and lambda_w(B_v) fail independently.
TEST(NodePairs, DualFailuresOfThePublishedMesh) {
  const Mesh mesh = last_mesh(read_case_file(std::string(ASTS_CASES) + "/planar/published-bad-tmesh.case"));
  const TSplines splines = tsplines_of(mesh);
  EXPECT_GT(count_all(mesh, splines).failures, 0);
  expect_dual_failures(mesh, splines);
}

TEST(NodePairs, AgreeWithBricksOnRandomMeshes) {
  Draw draw(31);
  CaseLimits limits;
  limits.max_elements = 150;
  int incompatible = 0;
  int failing = 0;
  for (int i = 0; i < 400; ++i) {
    const Case content = i % 4 == 0 ? random_bare_case(draw, limits).content : random_box_case(draw, limits).content;
    SCOPED_TRACE(write_case(content));
    const Mesh mesh = last_mesh(content);
    const TSplines splines = tsplines_of(mesh);
    if (splines.size() == 0 || splines.missing) continue;
    const Bricks bricks = bricks_of(splines);
    ASSERT_EQ(!find_incompatible(splines, bricks), all_compatible(splines));
    incompatible += all_compatible(splines) ? 0 : 1;
    if (splines.size() > 40) continue;
    expect_dual_failures(mesh, splines);
    if (HasFailure()) return;
    failing += find_dual_failures(mesh, splines, bricks).failures > 0 ? 1 : 0;
  }
  EXPECT_GT(incompatible, 5);
  EXPECT_GT(failing, 5);
}

// Bricks that differ from one another along an axis: what holds for one pair says nothing about another.
TEST(NodePairs, OverlapIsAskedForEachPairOfBricks) {
  const Mesh mesh = last_mesh(read_case_file(std::string(ASTS_CASES) + "/planar/published-bad-tmesh.case"));
  const TSplines splines = tsplines_of(mesh);
  const Bricks bricks = bricks_of(splines);
  int overlapping = 0;
  int failing = 0;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    AxisOverlap overlaps(bricks, axis);
    for (const Brick& one : bricks.bricks) {
      for (const Brick& other : bricks.bricks) {
        const bool expected = overlap(bricks.profile(one, axis).entries, bricks.profile(other, axis).entries);
        ASSERT_EQ(overlaps.holds(one, other), expected) << axis;
        (expected ? overlapping : failing) += 1;
      }
    }
  }
  EXPECT_GT(overlapping, 40);
  EXPECT_GT(failing, 10);
}

}  // namespace
}  // namespace asts
