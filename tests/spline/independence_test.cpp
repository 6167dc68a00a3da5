#include "lib/spline/independence.hpp"

#include <gtest/gtest.h>

#include <set>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "tests/reference/independence_claims.hpp"

namespace asts {
namespace {

using Ranks = std::vector<std::int32_t>;

Mesh mesh_of_text(const std::string& text) { return last_mesh(parse_case("asts-case 1\n" + text, "f")); }

/// Blending functions of one's own choice on the lines of a mesh: one triple of index vectors a function.
TSplines functions_on(const Mesh& mesh, const std::vector<PerAxis<Ranks>>& functions) {
  TSplines splines;
  splines.region = active_region(mesh);
  for (Axis axis = 0; axis < kDimension; ++axis) splines.vectors.emplace_back(mesh.setting.degree[at(axis)]);
  for (const PerAxis<Ranks>& function : functions) {
    PerAxis<std::int32_t> ids{};
    for (std::size_t a = 0; a < kDimension; ++a) ids[a] = splines.vectors[a].intern(function[a]);
    splines.vector_ids.push_back(ids);
    splines.nodes.push_back({function[0][2], function[1][2], function[2][2]});
  }
  return splines;
}

/// Five of the ranks 0, ..., count - 1.
Ranks random_vector(Draw& draw, std::int32_t count) {
  Ranks all;
  for (std::int32_t i = 0; i < count; ++i) all.push_back(i);
  draw.shuffle(all);
  all.resize(5);
  std::sort(all.begin(), all.end());
  return all;
}

/// Different functions on the lines of a mesh of degree 3, about as many as the products of B-splines on them: every
/// other family or so is dependent.
TSplines random_functions(Draw& draw, const Mesh& mesh) {
  std::int64_t dimension = 1;
  for (const auto& lines : mesh.coordinates) dimension *= static_cast<std::int64_t>(lines.size()) - 4;
  std::set<PerAxis<Ranks>> functions;
  const auto wanted = static_cast<std::size_t>(draw.between(std::int64_t{1}, dimension + 1));
  for (int tries = 0; functions.size() < wanted && tries < 100; ++tries) {
    PerAxis<Ranks> function;
    for (std::size_t a = 0; a < kDimension; ++a) {
      function[a] = random_vector(draw, static_cast<std::int32_t>(mesh.coordinates[a].size()));
    }
    functions.insert(function);
  }
  return functions_on(mesh, {functions.begin(), functions.end()});
}

/// Their index vectors, for the literal code.
std::vector<reference::ActiveNode<Rational>> literal_functions(const Mesh& mesh, const TSplines& splines) {
  std::vector<reference::ActiveNode<Rational>> result(at(splines.size()));
  for (std::int32_t v = 0; v < splines.size(); ++v) {
    for (Axis axis = 0; axis < kDimension; ++axis) {
      for (const std::int32_t rank : splines.index_vector(v, axis)) {
        result[at(v)].vectors[at(axis)].push_back(mesh.coordinate(axis, rank));
      }
    }
  }
  return result;
}

bool killed(const Matrix<Rational>& matrix, const std::vector<Integer>& x) {
  for (std::size_t row = 0; row < matrix.rows; ++row) {
    Rational sum = 0;
    for (std::size_t c = 0; c < matrix.columns; ++c) sum += matrix(row, c) * x[c];
    if (sum != 0) return false;
  }
  return true;
}

/// Laws 1 to 3 for one family of functions; the dimension of its kernel.
std::size_t expect_laws(const Mesh& mesh, const TSplines& splines) {
  const Matrix<Rational> values = value_matrix(mesh, splines);
  const auto kernel = kernel_basis(coefficient_matrix(mesh, splines));
  EXPECT_EQ(kernel.size(), kernel_basis(values).size()) << "law 1";
  for (const auto& x : kernel) {
    EXPECT_TRUE(killed(values, x)) << "law 1";
    EXPECT_TRUE(vanishes_everywhere(mesh, splines, x)) << "law 2";
    std::vector<Integer> changed = x;
    changed.back() += 1;
    EXPECT_FALSE(vanishes_everywhere(mesh, splines, changed)) << "law 2: no function is 0";
  }
  EXPECT_EQ(certainly_independent(mesh, splines), kernel.empty()) << "law 3";
  EXPECT_EQ(find_dependence(mesh, splines).has_value(), !kernel.empty()) << "law 3";
  return kernel.size();
}

// On the lines 0, 1, 3/2, 2, 3, 4 along x: N(0,1,2,3,4) = 1/2 N(0,1,3/2,2,3) + 5/6 N(1,3/2,2,3,4).
TEST(Independence, KnotInsertionIsADependence) {
  const Mesh mesh = mesh_of_text("degree 3 3 3\ngrading 2\ndomain 4 4 4\nsubdivide 3/2 1/2 1/2\n");
  ASSERT_EQ(mesh.coordinates[0].size(), 6U);
  const Ranks y{0, 1, 2, 3, 4};
  const std::vector<PerAxis<Ranks>> functions{
      {Ranks{0, 1, 3, 4, 5}, y, y}, {Ranks{0, 1, 2, 3, 4}, y, y}, {Ranks{1, 2, 3, 4, 5}, y, y}};
  const TSplines splines = functions_on(mesh, functions);
  const auto dependence = find_dependence(mesh, splines);
  ASSERT_TRUE(dependence);
  EXPECT_EQ(*dependence, (std::vector<Integer>{6, -3, -5}));
  EXPECT_TRUE(vanishes_everywhere(mesh, splines, *dependence));
  EXPECT_FALSE(vanishes_everywhere(mesh, splines, {6, -3, -4}));
  for (std::size_t left_out = 0; left_out < 3; ++left_out) {
    auto two = functions;
    two.erase(two.begin() + static_cast<std::ptrdiff_t>(left_out));
    EXPECT_TRUE(certainly_independent(mesh, functions_on(mesh, two)));
  }
}

// With lines 0, 1/2, 1, 3/2, 2, 3, 4, 5, 6 along x and AR = [2,4] there: N(0,1/2,1,2,3) and N(0,1,3/2,2,3) are both a
// multiple of (3-x)^3 on [2,3], the end of their supports.
TEST(Independence, MayBeLostOnTheActiveRegionAlone) {
  const Mesh mesh =
      mesh_of_text("degree 3 3 3\ngrading 2\ndomain 6 6 6\nsubdivide 1/2 1/2 1/2\nsubdivide 3/2 1/2 1/2\n");
  ASSERT_EQ(mesh.coordinates[0].size(), 9U);
  const Ranks y{0, 1, 2, 3, 4};
  const TSplines splines = functions_on(mesh, {{Ranks{0, 1, 2, 4, 5}, y, y}, {Ranks{0, 2, 3, 4, 5}, y, y}});
  EXPECT_TRUE(certainly_independent(mesh, splines));
  EXPECT_FALSE(certainly_independent(mesh, splines, Region::active_region));
  EXPECT_TRUE(find_dependence(mesh, splines, Region::active_region));
}

TEST(Independence, LawsOnFamiliesThatNoMeshMakes) {
  Draw draw(7);
  int dependent = 0, independent = 0;
  const Mesh small = mesh_of_text("degree 3 3 3\ngrading 3\ndomain 5 5 4\n");
  const Mesh uneven = mesh_of_text("degree 3 3 3\ngrading 3\ndomain 4 5 4\nsubdivide 1/2 1/2 1/2\n");
  for (int round = 0; round < 80; ++round) {
    const Mesh& mesh = round % 2 == 0 ? small : uneven;
    const TSplines splines = random_functions(draw, mesh);
    const std::size_t kernel = expect_laws(mesh, splines);
    ++(kernel > 0 ? dependent : independent);
    EXPECT_EQ(at(splines.size()) - kernel, reference::rank_of_blending_functions(literal_functions(mesh, splines)));
    ASSERT_FALSE(testing::Test::HasFailure()) << "round " << round;
  }
  EXPECT_GE(dependent, 10);
  EXPECT_GE(independent, 10);
}

TEST(Independence, LawsOnSmallMeshes) {
  Draw draw(11);
  CaseLimits limits;
  limits.max_side = 5;
  limits.max_cubes = 100;
  limits.max_elements = 110;
  int decided = 0;
  for (int round = 0; decided < 40 && round < 1000; ++round) {
    const RandomCase random = round % 2 == 0 ? random_bare_case(draw, limits) : random_box_case(draw, limits);
    const Mesh mesh = last_mesh(random.content);
    const TSplines splines = tsplines_of(mesh);
    if (splines.missing || splines.size() < 2 || splines.size() > 16) continue;
    SCOPED_TRACE(write_case(random.content));
    EXPECT_EQ(expect_laws(mesh, splines), 0U);
    ++decided;
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_EQ(decided, 40);
}

// Lines that coincide modulo the prime are no certificate, and the exact kernel decides.
TEST(Independence, ThePrimeMayFail) {
  const std::string prime = "2147483647";
  const Mesh mesh = mesh_of_text("degree 3 3 3\ngrading 2\ndomain 4 4 4\n");
  Mesh scaled = mesh;
  scaled.coordinates[0][3] = Rational(prime);
  scaled.coordinates[0][4] = 2 * Rational(prime);
  const TSplines splines = tsplines_of(mesh);
  ASSERT_EQ(splines.size(), 1);
  EXPECT_TRUE(certainly_independent(mesh, splines));
  EXPECT_FALSE(certainly_independent(scaled, splines));
  EXPECT_FALSE(find_dependence(scaled, splines));
}

}  // namespace
}  // namespace asts
