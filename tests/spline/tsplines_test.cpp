#include "lib/spline/tsplines.hpp"

#include <gtest/gtest.h>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/reference/spline.hpp"

namespace asts {
namespace {

Mesh mesh_of_text(const std::string& text) { return last_mesh(parse_case("asts-case 1\n" + text, "f")); }

reference::Point node_of(const Mesh& mesh, const TSplines& splines, std::int32_t node) {
  reference::Point point;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    point[a] = mesh.coordinate(axis, splines.nodes[static_cast<std::size_t>(node)][a]);
  }
  return point;
}

std::vector<Rational> vector_of(const Mesh& mesh, const TSplines& splines, std::int32_t node, Axis axis) {
  std::vector<Rational> result;
  for (const std::int32_t rank : splines.index_vector(node, axis)) result.push_back(mesh.coordinate(axis, rank));
  return result;
}

std::vector<Rational> integers(int first, int last) {
  std::vector<Rational> result;
  for (int i = first; i <= last; ++i) result.emplace_back(i);
  return result;
}

// p = (3,5,3), 5 x 6 x 4 cubes: AR = [2,3] x [3,3] x [2,2], so the nodes (2,3,2) and (3,3,2), with p+2 integers around.
TEST(TSplines, OfAnInitialMesh) {
  const Mesh mesh = mesh_of_text("degree 3 5 3\ngrading 2\ndomain 5 6 4\n");
  const TSplines splines = tsplines_of(mesh);
  EXPECT_FALSE(splines.missing);
  ASSERT_EQ(splines.size(), 2);
  EXPECT_EQ(node_of(mesh, splines, 0), (reference::Point{2, 3, 2}));
  EXPECT_EQ(node_of(mesh, splines, 1), (reference::Point{3, 3, 2}));
  EXPECT_EQ(vector_of(mesh, splines, 0, 0), integers(0, 4));
  EXPECT_EQ(vector_of(mesh, splines, 1, 0), integers(1, 5));
  EXPECT_EQ(vector_of(mesh, splines, 1, 1), integers(0, 6));
  EXPECT_EQ(vector_of(mesh, splines, 1, 2), integers(0, 4));
}

// X~ = 3 < p+1: AR is empty. X~ = p+1: it is one plane.
TEST(TSplines, NeedAnActiveRegion) {
  const Mesh narrow = mesh_of_text("degree 3 3 3\ngrading 2\ndomain 3 4 4\n");
  EXPECT_TRUE(tsplines_of(narrow).region.empty);
  EXPECT_EQ(tsplines_of(narrow).size(), 0);
  const Mesh thin = mesh_of_text("degree 3 3 3\ngrading 2\ndomain 4 4 4\n");
  EXPECT_FALSE(tsplines_of(thin).region.empty);
  EXPECT_EQ(tsplines_of(thin).size(), 1);
}

// [2,3]^3 is cut at x = 5/2: its four new nodes are on lines y, z in {2, 3}. Through (2, 2) run x = 2, 5/2, 3, so that
// x(5/2,2,2) = (1, 2, 5/2, 3, 4) and x(2,2,2) = (0, 1, 2, 5/2, 3).
TEST(TSplines, NewNodesShortenTheVectorsOnTheirLines) {
  const Mesh mesh = mesh_of_text("degree 3 3 3\ngrading 2\ndomain 5 5 5\nsubdivide 2 2 2\n");
  const TSplines splines = tsplines_of(mesh);
  ASSERT_EQ(splines.size(), 8 + 4);
  const Rational cut = Rational(5) / 2;
  EXPECT_EQ(node_of(mesh, splines, 0), (reference::Point{2, 2, 2}));
  EXPECT_EQ(node_of(mesh, splines, 4), (reference::Point{cut, 2, 2})) << "lexicographic";
  EXPECT_EQ(vector_of(mesh, splines, 0, 0), (std::vector<Rational>{0, 1, 2, cut, 3}));
  EXPECT_EQ(vector_of(mesh, splines, 4, 0), (std::vector<Rational>{1, 2, cut, 3, 4}));
  EXPECT_EQ(vector_of(mesh, splines, 4, 1), integers(0, 4)) << "Y(5/2, 2): faces of uncut elements are closed";
}

// Between two nodes of one line there may be any number of entries without a node: the halves [5/2,3] and [c,c+1/2] of
// two cubes of a row are cut at y = 5/2, and the line y = 5/2, z = 2 crosses the faces of the uncut cubes between them
// in their interiors. Whether there are fewer of these than (p+1)/2 = 2, as many or more, the vectors take the nearest.
TEST(TSplines, VectorsReachAcrossEntriesWithoutNodes) {
  const Rational half = Rational(1) / 2;
  for (int cube = 3; cube <= 9; ++cube) {
    const std::string c = std::to_string(cube);
    const Mesh mesh = mesh_of_text("degree 3 3 3\ngrading 2\ndomain 12 5 4\nsubdivide 2 2 1  " + c +
                                   " 2 1\nsubdivide 5/2 2 1  " + c + " 2 1\n");
    std::vector<Rational> line{0, 1, 2, 2 + half, 3};
    for (int i = 4; i <= 12; ++i) {
      line.emplace_back(i);
      if (i == cube) line.push_back(i + half);
    }
    if (cube == 3) line.insert(line.begin() + 5, 3 + half);
    const TSplines splines = tsplines_of(mesh);
    int found = 0;
    for (std::int32_t node = 0; node < splines.size(); ++node) {
      const reference::Point point = node_of(mesh, splines, node);
      if (point[1] != 2 + half || point[2] != 2) continue;
      const auto place = std::find(line.begin(), line.end(), point[0]);
      ASSERT_NE(place, line.end());
      EXPECT_EQ(vector_of(mesh, splines, node, 0), std::vector<Rational>(place - 2, place + 3))
          << cube << ", " << point[0];
      ++found;
    }
    EXPECT_EQ(found, cube == 3 ? 3 : 4);
  }
}

// The slab [0,2] x [0,4]^2 is one box, so no x-orthogonal face lies at 1: X(2,2) = {0, 2, 3, 4}, and the node (2,2,2)
// has one entry below it where p = 3 wants two.
TEST(TSplines, AMissingVectorNamesTheNodeAndTheAxis) {
  std::string text = "degree 3 3 3\ngrading 2\ndomain 4 4 4\nelement 0 0 0 2 4 4\n";
  for (const char* x : {"2 3", "3 4"}) {
    for (const char* y : {"0 1", "1 2", "2 3", "3 4"}) {
      for (const char* z : {"0 1", "1 2", "2 3", "3 4"}) {
        const std::string box{x[0], ' ', y[0], ' ', z[0], ' ', x[2], ' ', y[2], ' ', z[2], '\n'};
        text += "element " + box;
      }
    }
  }
  const Mesh mesh = mesh_of_text(text);
  const TSplines splines = tsplines_of(mesh);
  ASSERT_EQ(splines.size(), 1);
  ASSERT_TRUE(splines.missing);
  EXPECT_EQ(splines.missing->axis, 0);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    EXPECT_EQ(mesh.coordinates[axis][static_cast<std::size_t>(splines.missing->node[axis])], 2);
  }
}

void compare(const Mesh& mesh, int& nodes, int& missing) {
  const auto space = reference::make_space<Rational>(literal::setting(mesh.setting), literal::mesh(mesh), 1);
  const TSplines splines = tsplines_of(mesh);
  const auto expected_nodes = reference::active_nodes(space);
  ASSERT_EQ(static_cast<std::size_t>(splines.size()), expected_nodes.size());
  const auto expected = reference::active_splines(space);
  ASSERT_EQ(splines.missing.has_value(), !expected.has_value());
  missing += splines.missing.has_value();
  for (std::int32_t node = 0; node < splines.size(); ++node) {
    const auto i = static_cast<std::size_t>(node);
    ASSERT_EQ(node_of(mesh, splines, node), expected_nodes[i]);
    if (splines.missing) continue;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      ASSERT_EQ(vector_of(mesh, splines, node, axis), (*expected)[i].vectors[a]) << node << axis_name(axis);
      const RankInterval support = splines.support(node, axis);
      ASSERT_EQ(mesh.coordinate(axis, support.lower), (*expected)[i].support.lower[a]);
      ASSERT_EQ(mesh.coordinate(axis, support.upper), (*expected)[i].support.upper[a]);
    }
    ++nodes;
  }
}

// Definitions 4.1 and 4.4 on meshes of all origins, degrees mixed.
TEST(TSplines, AgreeWithTheLiteralDefinitions) {
  Draw draw(19);
  int nodes = 0;
  int missing = 0;
  const CaseLimits thick{5, 5, 8, 320, 450, 6};
  const CaseLimits narrow{3, 3, 14, 224, 300, 10};  // long lines with nodes far apart
  for (int round = 0; round < 180; ++round) {
    const CaseLimits& limits = round % 2 == 0 ? thick : narrow;
    const auto generate = round % 3 == 0 ? random_box_case : round % 3 == 1 ? random_bare_case : random_admissible_case;
    const Case content = generate(draw, limits).content;
    SCOPED_TRACE(write_case(content));
    compare(last_mesh(content), nodes, missing);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(nodes, 1000);
  EXPECT_GT(missing, 0);
}

/// Active nodes with their index vectors, as coordinates.
using Described = std::vector<std::pair<reference::Point, PerAxis<std::vector<Rational>>>>;

Described described(const Mesh& mesh) {
  const TSplines splines = tsplines_of(mesh);
  Described result;
  for (std::int32_t node = 0; node < splines.size(); ++node) {
    PerAxis<std::vector<Rational>> vectors;
    for (Axis axis = 0; axis < kDimension; ++axis) vectors[at(axis)] = vector_of(mesh, splines, node, axis);
    result.emplace_back(node_of(mesh, splines, node), vectors);
  }
  return result;
}

// Where no active node projects into the element nothing changes; where one does, mostly something does.
TEST(TSplines, ASubdivisionChangesThemOnlyWhereANodeProjectsIntoTheElement) {
  int unchanged = 0;
  int changed = 0;
  int spurious = 0;
  Draw draw(11);
  for (int round = 0; round < 60; ++round) {
    const RandomCase random = random_bare_case(draw, {5, 4, 7, 120, 160, 4});
    Replay replay(random.content);
    while (!replay.done()) replay.advance();
    const Mesh mesh = mesh_of(replay.tree());
    const TSplines splines = tsplines_of(mesh);
    const Described before = described(mesh);
    for (std::int32_t leaf = 0; leaf < replay.tree().node_count(); ++leaf) {
      if (!replay.tree().is_leaf(leaf)) continue;
      RefinementTree next = replay.tree();
      next.subdivide(leaf);
      next.update_ranks();
      const Box& element = mesh.elements[at(mesh.locator.nodes[at(leaf)].first)];
      const bool may = may_change_splines(splines, element, replay.tree().split_axis(leaf));
      const bool does = described(mesh_of(next)) != before;
      EXPECT_TRUE(may || !does) << write_case(random.content);
      unchanged += !may;
      changed += does;
      spurious += may && !does;
    }
  }
  EXPECT_GT(unchanged, 2'000);
  EXPECT_GT(changed, 1'000);
  EXPECT_LT(spurious, changed);
}

}  // namespace
}  // namespace asts
