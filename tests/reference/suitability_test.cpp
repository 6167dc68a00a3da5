#include "tests/reference/suitability.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/reference/decide.hpp"
#include "tests/reference/example_meshes.hpp"

namespace asts::reference {
namespace {

using Vector = std::vector<Rational>;

TEST(ReferenceSpline, ActiveNodesOfTheUniformMesh) {
  const Setting setting{{3, 3, 3}, 2, {4, 4, 5}};
  const Space<Rational> space = make_space<Rational>(setting, initial_mesh(setting), 1);
  EXPECT_EQ(nodes(space).size(), 5U * 5U * 6U);
  EXPECT_EQ(active_nodes(space), (std::vector<Point>{{2, 2, 2}, {2, 2, 3}}));  // AR = [2,2] x [2,2] x [2,3]
  EXPECT_EQ(local_index_vector(space, 2, {2, 2, 3}), (Vector{1, 2, 3, 4, 5}));
  EXPECT_EQ(local_index_vector(space, 2, {2, 2, 1}), std::nullopt);  // one entry short on the left
  EXPECT_EQ(global_index_set(space, 0, {0, over(1, 2), over(1, 3)}), (Vector{0, 1, 2, 3, 4}));
}

TEST(ReferenceSpline, IndexVectorsOfTheCrossingExample) {
  const CrossingExtensions example;
  const Space<Rational> space = make_space<Rational>(example.setting, example.mesh, 1);
  const Point v{over(7, 2), 4, 2}, w{4, over(9, 2), 2};
  EXPECT_EQ(local_index_vector(space, 0, v), (Vector{2, 3, over(7, 2), 4, 5}));
  EXPECT_EQ(local_index_vector(space, 1, v), (Vector{2, 3, 4, 5, 6}));
  EXPECT_EQ(local_index_vector(space, 0, w), (Vector{2, 3, 4, 5, 6}));
  EXPECT_EQ(local_index_vector(space, 1, w), (Vector{3, 4, over(9, 2), 5, 6}));
  EXPECT_TRUE(in_skeleton(space, 0, {over(7, 2), 4, 2}));  // the closed face ends here
  EXPECT_FALSE(in_skeleton(space, 0, {over(7, 2), over(401, 100), 2}));
}

TEST(ReferenceSuitability, CrossingExtensionsAreNeitherSuitableNorDualCompatible) {
  const CrossingExtensions example;
  const Space<Rational> space = make_space<Rational>(example.setting, example.mesh, 1);
  const auto splines = active_splines(space);
  ASSERT_TRUE(splines);
  // v is in N_x(7/2) and not in N_y(9/2), w the other way round; the point lies in both supports.
  const Point t{over(7, 2), over(9, 2), 2};
  EXPECT_TRUE(in_perturbed_region(space, *splines, 0, t));
  EXPECT_TRUE(in_perturbed_region(space, *splines, 1, t));
  EXPECT_FALSE(in_perturbed_region(space, *splines, 2, t));  // extruded: every z-face spans the domain
  EXPECT_TRUE(perturbed_regions_meet(space, *splines));
  EXPECT_FALSE(analysis_suitable_by_rectangles(space, *splines));
  EXPECT_TRUE(not_dual_compatible(*splines));
}

TEST(ReferenceSuitability, OverlapLooksAtTheClosedRanges) {
  EXPECT_TRUE(overlap<Rational>({0, 1, 2, 3, 4}, {1, 2, 3, 4, 5}));
  EXPECT_TRUE(overlap<Rational>({0, 1, 2, 3, 4}, {5, 6, 7, 8, 9}));   // nothing in the other's range
  EXPECT_TRUE(overlap<Rational>({0, 1, 2, 3, 4}, {4, 5, 6, 7, 8}));   // 4 is in both
  EXPECT_FALSE(overlap<Rational>({0, 1, 2, 3, 4}, {2, 3, over(7, 2), 4, 5}));
  EXPECT_FALSE(overlap<Rational>({0, 1, 2, 3, 4}, {over(7, 2), 5, 6, 7, 8}));
}

TEST(ReferenceSuitability, SlicePerturbationOfAUniformMeshIsEmpty) {
  const Setting setting{{3, 3, 3}, 2, {6, 5, 5}};
  const Space<Rational> space = make_space<Rational>(setting, initial_mesh(setting), 1);
  const auto splines = active_splines(space);
  ASSERT_TRUE(splines);
  for (std::size_t a = 0; a < dimension; ++a)
    for (const Rational& q : slices(space, a)) EXPECT_TRUE(slice_perturbation(space, *splines, a, q).empty());
}

Mesh random_mesh(const Setting& setting, std::mt19937_64& random) {
  Mesh mesh = initial_mesh(setting);
  for (std::size_t steps = random() % 12; steps > 0; --steps) {
    Point point;
    for (std::size_t a = 0; a < dimension; ++a)
      point[a] = over(static_cast<int>(random() % static_cast<unsigned>(4 * setting.domain[a])), 4) + over(1, 64);
    mesh = subdivide(setting, mesh, {*element_at(setting, mesh, point)});
  }
  return mesh;
}

// Definition 5.2 three ways: rectangles against rectangles, points, and points in scaled integers.
TEST(ReferenceSuitability, RectanglesAndPointsAgree) {
  const Setting setting{{3, 3, 3}, 2, {6, 6, 5}};
  std::mt19937_64 random(11);
  int violated = 0;
  for (int round = 0; round < 60; ++round) {
    const Mesh mesh = random_mesh(setting, random);
    const Grid scale = *grid_scale(setting, mesh);
    const Space<Grid> space = make_space<Grid>(setting, mesh, scale);
    const auto splines = active_splines(space);
    ASSERT_TRUE(splines);
    const auto common = perturbed_regions_meet(space, *splines);
    EXPECT_EQ(common.has_value(), !analysis_suitable_by_rectangles(space, *splines));
    violated += common.has_value();
    if (!common) continue;
    int regions = 0;
    for (std::size_t a = 0; a < dimension; ++a) regions += in_perturbed_region(space, *splines, a, *common);
    EXPECT_GE(regions, 2);
  }
  EXPECT_GT(violated, 0);
  EXPECT_LT(violated, 60);
}

// Domain 5 x 5 x 5, m = 2, AR = [2,3]^3; two bare subdivisions: [2,3] x [1,2] x [2,3] along x, then its upper half along
// y. The nodes v = (2, 3, 2) and w = (5/2, 2, 2) have
//   x(v) = (0, 1, 2, 3, 4), y(v) = (1, 2, 3, 4, 5)   and   x(w) = (1, 2, 5/2, 3, 4), y(w) = (1, 3/2, 2, 3, 4):
// they overlap neither along x (5/2) nor along y (3/2), and their supports have common interior: not dual-compatible.
// But S_y(3/2) is empty because 3/2 lies outside the active region, so R_y(3/2) is empty, and R_x meets no other
// perturbed region: analysis-suitable. Theorem 6.6 does not hold literally for meshes that are not admissible.
TEST(ReferenceDecide, SuitableButNotDualCompatible) {
  const Setting setting{{3, 3, 3}, 2, {5, 5, 5}};
  Mesh mesh = initial_mesh(setting);
  for (int step = 0; step < 2; ++step)
    mesh = subdivide(setting, mesh, {*element_at(setting, mesh, {over(11, 4), over(5, 4), over(9, 4)})});
  const Space<Rational> space = make_space<Rational>(setting, mesh, 1);
  const auto v = active_node(space, {2, 3, 2}), w = active_node(space, {over(5, 2), 2, 2});
  ASSERT_TRUE(v && w);
  EXPECT_EQ(v->vectors[1], (Vector{1, 2, 3, 4, 5}));
  EXPECT_EQ(w->vectors[1], (Vector{1, over(3, 2), 2, 3, 4}));
  EXPECT_TRUE(intersect_with_volume(v->support, w->support));
  EXPECT_FALSE(partially_overlap(*v, *w));
  EXPECT_TRUE(analysis_suitable_by_rectangles(space, *active_splines(space)));
  const Verdicts expected{Verdict::violated, Verdict::holds, Verdict::holds, Verdict::violated, Verdict::violated};
  EXPECT_EQ(decide(setting, mesh), expected);
}

// 195 bare subdivisions around one point: denominators 2^65 do not fit the integer grid, and all stays exact.
TEST(ReferenceDecide, DeepMeshesStayExact) {
  const Setting setting{{3, 3, 3}, 2, {4, 4, 5}};
  Mesh mesh = initial_mesh(setting);
  for (int step = 0; step < 195; ++step)
    mesh = subdivide(setting, mesh, {*element_at(setting, mesh, {2, 2, over(5, 2)})});
  EXPECT_FALSE(grid_scale(setting, mesh));
  EXPECT_TRUE(tiles_domain(setting, mesh));
  const Verdicts verdicts = decide(setting, mesh);
  EXPECT_EQ(verdicts.admissible, Verdict::violated);
  EXPECT_EQ(verdicts.nested_patches, Verdict::holds);
  EXPECT_NE(verdicts.dual_basis, Verdict::not_applicable);
}

TEST(ReferenceDecide, UniformMeshesHoldEverything) {
  const Verdicts all{Verdict::holds, Verdict::holds, Verdict::holds, Verdict::holds, Verdict::holds};
  const Setting setting{{3, 3, 3}, 2, {6, 5, 4}};
  EXPECT_EQ(decide(setting, initial_mesh(setting)), all);
  EXPECT_EQ(decide({{3, 5, 3}, 3, {4, 6, 5}}, initial_mesh({{3, 5, 3}, 3, {4, 6, 5}})), all);
}

TEST(ReferenceDecide, WithoutActiveNodesTheSplinePropertiesDoNotApply) {
  const Setting setting{{3, 3, 3}, 2, {3, 5, 4}};  // AR is empty along x: [2, 1]
  const Verdicts expected{Verdict::holds, Verdict::holds, Verdict::not_applicable, Verdict::not_applicable,
                          Verdict::not_applicable};
  EXPECT_EQ(decide(setting, initial_mesh(setting)), expected);
  const Setting small{{3, 3, 3}, 2, {2, 1, 1}};
  const Mesh one{{{0, 0, 0}, {2, 1, 1}}};  // one box, outside the class
  EXPECT_EQ(decide(small, one).admissible, Verdict::violated);
  EXPECT_EQ(decide(small, one).nested_patches, Verdict::not_applicable);
}

TEST(ReferenceDecide, IntegersAndRationalsAgree) {
  const Setting setting{{3, 3, 3}, 2, {5, 5, 5}};
  std::mt19937_64 random(13);
  for (int round = 0; round < 25; ++round) {
    const Mesh mesh = random_mesh(setting, random);
    EXPECT_EQ(decide(setting, mesh), decide_with_rationals(setting, mesh));
  }
  const CrossingExtensions example;
  const Verdicts expected{Verdict::violated, Verdict::holds, Verdict::violated, Verdict::violated, Verdict::violated};
  EXPECT_EQ(decide(example.setting, example.mesh), expected);
  EXPECT_EQ(decide_with_rationals(example.setting, example.mesh), expected);
}

}  // namespace
}  // namespace asts::reference
