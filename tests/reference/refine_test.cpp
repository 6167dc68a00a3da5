#include "tests/reference/refine.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/reference/example_meshes.hpp"
#include "tests/reference/tree.hpp"

namespace asts::reference {
namespace {

std::size_t new_elements(const Setting& setting, const Mesh& mesh) {
  std::size_t count = 0;
  for (const Box& box : mesh)
    if (level(setting, box) != 0) ++count;
  return count;
}

/// Marks the corner element of the 4 x 5 x 8 mesh until it has the level `last`; the mesh and the number of steps.
std::pair<Mesh, int> corner_refinement(const Setting& setting, int last) {
  Mesh mesh = initial_mesh(setting);
  const Point corner{0, 0, 0};
  int steps = 0;
  for (; level(setting, mesh[*element_at(setting, mesh, corner)]) != last; ++steps)
    mesh = refine(setting, mesh, {*element_at(setting, mesh, corner)});
  return {mesh, steps};
}

// Example 2.10: the corner element is marked until it has the size 1/16 x 1/16 x 1/16, volume 2^-12: level 3 for
// m = 16, level 6 for m = 4. The row m = 2 (12 steps, 10728 new elements) comes out too, in a minute.
TEST(ReferenceRefine, ExampleTableForGradingsSixteenAndFour) {
  const Setting sixteen{{3, 3, 3}, 16, {4, 5, 8}}, four{{3, 3, 3}, 4, {4, 5, 8}};
  const auto [coarse, coarse_steps] = corner_refinement(sixteen, 3);
  EXPECT_EQ(coarse_steps, 3);
  EXPECT_EQ(new_elements(sixteen, coarse), 1030U);
  EXPECT_TRUE(admissible_mesh(sixteen, coarse, refinement_tree(sixteen, coarse)));
  const auto [fine, fine_steps] = corner_refinement(four, 6);
  EXPECT_EQ(fine_steps, 6);
  EXPECT_EQ(new_elements(four, fine), 3175U);
}

// The half [0,1/2] x [0,1] x [0,1] has level 1 and U = (0, 1/4 + 9/4) x (0, 5) x (0, 5), clipped to the domain
// 4 x 4 x 5: the level-0 elements with x < 5/2 in it are [1,2] and [2,3] by y and z, and [0,1] except the cube that
// was subdivided: 3 * 20 - 1 = 59 coarser elements; their own patches have nothing coarser.
TEST(ReferenceRefine, ClosureCollectsTheCoarserElementsOfThePatch) {
  const Setting setting{{3, 3, 3}, 2, {4, 4, 5}};
  Mesh mesh = initial_mesh(setting);
  mesh = subdivide(setting, mesh, {*element_at(setting, mesh, {0, 0, 0})});
  const std::size_t half = *element_at(setting, mesh, {0, 0, 0});
  EXPECT_EQ(closure(setting, mesh, {half}).size(), 60U);
  EXPECT_FALSE(admissible_subdivision(setting, mesh, half));
  EXPECT_TRUE(admissible_subdivision(setting, mesh, *element_at(setting, mesh, {1, 0, 0})));
}

TEST(ReferenceRefine, SeveralElementsNeedOnlyOneAdmissibleOrder) {
  const Setting setting{{3, 3, 3}, 2, {1, 1, 2}};
  Mesh mesh = subdivide(setting, initial_mesh(setting), {0});  // level 0: [0,1]^2 x [1,2]; level 1: the other's halves
  EXPECT_TRUE(admissible_subdivision(setting, mesh, std::vector<std::size_t>{0, 1, 2}));
  EXPECT_FALSE(admissible_subdivision(setting, mesh, std::vector<std::size_t>{1, 2}));
}

TEST(ReferenceRefine, BareSubdivisionsAreNotAdmissible) {
  const BareSubdivisions example;
  const RefinementTree tree = refinement_tree(example.setting, example.mesh);
  EXPECT_TRUE(tree.outside.empty());
  EXPECT_EQ(tree.elements.size(), 80U + 2U + 2U);
  EXPECT_FALSE(admissible_mesh(example.setting, example.mesh, tree));
  EXPECT_FALSE(admissible_mesh_exhaustive(example.setting, tree));
  EXPECT_FALSE(patches_not_nested(example.setting, example.mesh, tree));
}

TEST(ReferenceRefine, BoxesThatNoSubdivisionMakesAreOutsideTheClass) {
  const CrossingExtensions example;
  const RefinementTree tree = refinement_tree(example.setting, example.mesh);
  EXPECT_EQ(tree.outside.size(), 4U * 4U * 2U);  // the halves across y, level 1 but cut along the wrong axis
  EXPECT_FALSE(admissible_mesh(example.setting, example.mesh, tree));
  EXPECT_TRUE(in_class(example.setting, {{3, 0, 0}, {over(7, 2), 1, 1}}));
  EXPECT_FALSE(in_class(example.setting, {{4, 4, 0}, {5, over(9, 2), 1}}));
  EXPECT_FALSE(in_class(example.setting, {{4, 4, 0}, {6, 5, 1}}));
}

// The greedy decision against the search over all orders, on random meshes with few subdivisions.
TEST(ReferenceRefine, GreedyAndExhaustiveAdmissibilityAgree) {
  const Setting setting{{3, 3, 3}, 2, {2, 1, 2}};
  std::mt19937_64 random(7);
  int admissible = 0;
  for (int round = 0; round < 150; ++round) {
    Mesh mesh = initial_mesh(setting);
    for (std::size_t steps = random() % 7; steps > 0; --steps)
      mesh = subdivide(setting, mesh, {random() % mesh.size()});
    const RefinementTree tree = refinement_tree(setting, mesh);
    const bool greedy = admissible_mesh(setting, mesh, tree);
    EXPECT_EQ(greedy, admissible_mesh_exhaustive(setting, tree));
    admissible += greedy;
  }
  EXPECT_GT(admissible, 20);
  EXPECT_LT(admissible, 130);
}

}  // namespace
}  // namespace asts::reference
