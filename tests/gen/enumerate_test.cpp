#include "lib/gen/enumerate.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/reference/tree.hpp"

namespace asts {
namespace {

/// Meshes as sets of boxes, with how often they occur.
using Meshes = std::map<reference::Mesh, std::int64_t>;

struct Scope {
  Setting setting;
  int max_subdivisions;
};

/// One line: test discovery reads it.
void PrintTo(const Scope& scope, std::ostream* out) {
  *out << "m" << scope.setting.grading << " on";
  for (const int side : scope.setting.domain) *out << ' ' << side;
  *out << ", " << scope.max_subdivisions;
}

/// Small enough for the literal code; with elements inside and outside of each other's patches.
const Scope kScopes[] = {
    {{{3, 3, 3}, 2, {1, 1, 1}}, 5}, {{{3, 3, 3}, 3, {1, 1, 1}}, 4}, {{{3, 3, 3}, 2, {2, 1, 1}}, 4},
    {{{3, 5, 3}, 2, {1, 2, 2}}, 3}, {{{3, 3, 3}, 3, {2, 2, 1}}, 3}, {{{3, 3, 5}, 4, {1, 1, 2}}, 3},
    {{{3, 3, 3}, 2, {1, 7, 1}}, 3}, {{{3, 3, 3}, 3, {8, 1, 1}}, 3}, {{{3, 3, 3}, 2, {3, 2, 1}}, 0},
};

class EnumeratedScope : public ::testing::TestWithParam<Scope> {
 protected:
  Enumeration enumeration(bool admissible, bool up_to_reflection) const {
    return {GetParam().setting, GetParam().max_subdivisions, admissible, up_to_reflection};
  }
  reference::Setting setting() const { return literal::setting(GetParam().setting); }
};

INSTANTIATE_TEST_SUITE_P(Scopes, EnumeratedScope, ::testing::ValuesIn(kScopes));

reference::Mesh boxes_of(const RefinementTree& tree) { return literal::sorted(literal::mesh(mesh_of(tree))); }

Meshes enumerated(const Enumeration& enumeration) {
  Meshes meshes;
  enumerate_meshes(enumeration, [&](const EnumeratedMesh& mesh) { ++meshes[boxes_of(mesh.tree)]; });
  return meshes;
}

/// All meshes that at most so many literal subdivisions make, each of them admissible if that is asked for.
std::set<reference::Mesh> literally_reached(const reference::Setting& setting, int max_subdivisions, bool admissible) {
  std::set<reference::Mesh> all{literal::sorted(reference::initial_mesh(setting))};
  std::set<reference::Mesh> latest = all;
  for (int i = 0; i < max_subdivisions; ++i) {
    std::set<reference::Mesh> next;
    for (const reference::Mesh& mesh : latest) {
      for (std::size_t k = 0; k < mesh.size(); ++k) {
        if (admissible && !reference::admissible_subdivision(setting, mesh, k)) continue;
        next.insert(literal::sorted(reference::subdivide(setting, mesh, {k})));
      }
    }
    all.insert(next.begin(), next.end());
    latest = std::move(next);
  }
  return all;
}

void expect_each_once(const Meshes& meshes, const std::set<reference::Mesh>& expected) {
  EXPECT_EQ(meshes.size(), expected.size());
  for (const auto& [mesh, times] : meshes) {
    EXPECT_EQ(times, 1);
    EXPECT_TRUE(expected.contains(mesh));
  }
}

TEST_P(EnumeratedScope, HasEachMeshThatLiteralSubdivisionsMakeOnce) {
  expect_each_once(enumerated(enumeration(false, false)),
                   literally_reached(setting(), GetParam().max_subdivisions, false));
}

TEST_P(EnumeratedScope, HasEachMeshThatLiteralAdmissibleSubdivisionsMakeOnce) {
  expect_each_once(enumerated(enumeration(true, false)),
                   literally_reached(setting(), GetParam().max_subdivisions, true));
}

TEST_P(EnumeratedScope, AdmissibleMeshesAreThoseThatTheLiteralDefinitionAccepts) {
  std::set<reference::Mesh> accepted;
  for (const auto& [mesh, times] : enumerated(enumeration(false, false))) {
    if (reference::admissible_mesh(setting(), mesh, reference::refinement_tree(setting(), mesh))) accepted.insert(mesh);
  }
  expect_each_once(enumerated(enumeration(true, false)), accepted);
}

reference::Mesh reflected(const reference::Setting& setting, reference::Mesh mesh, std::size_t axis) {
  for (reference::Box& box : mesh) {
    const Rational lower = setting.domain[axis] - box.upper[axis];
    box.upper[axis] = setting.domain[axis] - box.lower[axis];
    box.lower[axis] = lower;
  }
  return literal::sorted(mesh);
}

std::set<reference::Mesh> reflections_of(const reference::Setting& setting, const reference::Mesh& mesh) {
  std::set<reference::Mesh> images{mesh};
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    for (const reference::Mesh& image : std::set(images)) images.insert(reflected(setting, image, axis));
  }
  return images;
}

TEST_P(EnumeratedScope, RepresentativesStandForEachMeshOnce) {
  for (const bool admissible : {false, true}) {
    Meshes represented;
    enumerate_meshes(enumeration(admissible, true), [&](const EnumeratedMesh& mesh) {
      const std::set<reference::Mesh> images = reflections_of(setting(), boxes_of(mesh.tree));
      EXPECT_EQ(mesh.reflections, static_cast<std::int64_t>(images.size()));
      for (const reference::Mesh& image : images) ++represented[image];
    });
    EXPECT_EQ(represented, enumerated(enumeration(admissible, false)));
  }
}

/// Level, unit cube, and the indices of the children that lead to an element: its place in the canonical order.
using Place = std::pair<std::int32_t, std::vector<std::int64_t>>;

Place place_of(const RefinementTree& tree, std::int32_t element) {
  const std::int32_t level = tree.node(element).level;
  std::vector<std::int64_t> path;
  while (tree.node(element).level > 0) {
    const std::int32_t parent = tree.node(element).parent;
    path.insert(path.begin(), element - tree.node(parent).first_child);
    element = parent;
  }
  const reference::Box cube = literal::box(tree, element);
  for (std::size_t axis = kDimension; axis-- > 0;) {
    path.insert(path.begin(), static_cast<std::int64_t>(boost::multiprecision::numerator(cube.lower[axis])));
  }
  return {level, path};
}

TEST_P(EnumeratedScope, VisitsInTheCanonicalOrder) {
  for (const bool up_to_reflection : {false, true}) {
    std::map<std::size_t, std::vector<Place>> last;
    enumerate_meshes(enumeration(false, up_to_reflection), [&](const EnumeratedMesh& mesh) {
      std::vector<Place> places;
      for (const std::int32_t element : mesh.subdivided) places.push_back(place_of(mesh.tree, element));
      EXPECT_TRUE(std::is_sorted(places.begin(), places.end()));
      EXPECT_TRUE(!last.contains(places.size()) || last[places.size()] < places);
      last[places.size()] = places;
    });
    EXPECT_EQ(last.size(), at(GetParam().max_subdivisions) + 1);
  }
}

// The representative of a mesh's reflections is the first of them, so that the first mesh with a property that
// reflections keep is found among the representatives: here, each set of meshes that some first one stands for.
TEST_P(EnumeratedScope, TheFirstOfTheReflectionsIsTheRepresentative) {
  std::set<reference::Mesh> seen;
  std::vector<reference::Mesh> first;
  enumerate_meshes(enumeration(false, false), [&](const EnumeratedMesh& mesh) {
    const reference::Mesh boxes = boxes_of(mesh.tree);
    if (seen.contains(boxes)) return;
    first.push_back(boxes);
    seen.merge(reflections_of(setting(), boxes));
  });
  std::vector<reference::Mesh> representatives;
  enumerate_meshes(enumeration(false, true),
                   [&](const EnumeratedMesh& mesh) { representatives.push_back(boxes_of(mesh.tree)); });
  EXPECT_EQ(representatives, first);
}

TEST_P(EnumeratedScope, CasesMakeTheirMeshesByAdmissibleStepsIfAskedFor) {
  enumerate_meshes(enumeration(true, false), [&](const EnumeratedMesh& mesh) {
    const Case content = parse_case(write_case(case_of(mesh)), "enumerated");
    EXPECT_EQ(content.steps.size(), mesh.subdivided.size());
    Replay replay(content);
    replay.watch_history();
    while (!replay.done()) replay.advance();
    EXPECT_EQ(boxes_of(replay.tree()), boxes_of(mesh.tree));
    EXPECT_TRUE(replay.history_admissible());
  });
}

/// The number of sets of k elements, each with its ancestors, in a forest of n trees in which every element has m
/// children: the coefficient of x^k in F^n, where F = 1 + x F^m; by Lagrange's inversion n/(n + mk) binomial(n + mk,
/// k).
Integer closed_formula(std::int64_t cubes, int grading, int subdivisions) {
  Integer binomial = 1;
  for (int i = 1; i <= subdivisions; ++i) {
    binomial *= cubes + grading * subdivisions - subdivisions + i;
    binomial /= i;
  }
  return binomial * cubes / (cubes + grading * subdivisions);
}

struct Count {
  Scope scope;
  std::int64_t meshes;
};

std::int64_t count_meshes(const Enumeration& enumeration) {
  std::int64_t meshes = 0;
  enumerate_meshes(enumeration, [&](const EnumeratedMesh& mesh) { meshes += mesh.reflections; });
  return meshes;
}

TEST(Enumerate, CountsAreThoseOfTheClosedFormula) {
  const Count counts[] = {
      {{{{3, 3, 3}, 2, {4, 4, 5}}, 2}, 1 + 80 + 80 * 79 / 2 + 160},
      {{{{3, 3, 3}, 2, {4, 4, 5}}, 3}, 98'601},
      {{{{3, 3, 3}, 2, {5, 5, 8}}, 2}, 20'501},
      {{{{3, 3, 3}, 2, {1, 1, 1}}, 8}, 1 + 1 + 2 + 5 + 14 + 42 + 132 + 429 + 1430},  // Catalan's numbers
      {{{{5, 3, 7}, 3, {2, 3, 2}}, 4}, 1 + 12 + 102 + 760 + 5'313},
      {{{{3, 3, 3}, 16, {3, 1, 2}}, 3}, 1 + 6 + 111 + 2'756},
  };
  for (const auto& [scope, meshes] : counts) {
    Integer expected = 0;
    for (int k = 0; k <= scope.max_subdivisions; ++k) {
      const PerAxis<int>& side = scope.setting.domain;
      expected += closed_formula(std::int64_t{side[0]} * side[1] * side[2], scope.setting.grading, k);
    }
    EXPECT_EQ(expected, meshes);
    EXPECT_EQ(count_meshes({scope.setting, scope.max_subdivisions, false, false}), meshes);
    EXPECT_EQ(count_meshes({scope.setting, scope.max_subdivisions, false, true}), meshes);
  }
}

TEST(Enumerate, RefusesWhatHasNoEnd) {
  const Setting setting{{3, 3, 3}, 2, {1, 1, 1}};
  const auto nothing = [](const EnumeratedMesh&) {};
  EXPECT_THROW(enumerate_meshes({setting, -1, false, false}, nothing), InputError);
  EXPECT_THROW(enumerate_meshes({setting, 63, false, false}, nothing), InputError);
  EXPECT_THROW(enumerate_meshes({{{3, 3, 3}, 1'000'000, {1, 1, 1}}, 4, false, false}, nothing), InputError);
}

}  // namespace
}  // namespace asts
