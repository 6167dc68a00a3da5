#include <gtest/gtest.h>

#include "properties/properties.hpp"

namespace asts {
namespace {

// 6 x 6 x 5 unit cubes, one of them subdivided: the nodes beside the cut have other index vectors, so there are
// pairs. A budget that allows none decides nothing, and what needs no pairs is decided.
TEST(Budget, LeavesWhatNeedsMorePairsUndecided) {
  RefinementTree tree(Setting{{3, 3, 3}, 2, {6, 6, 5}});
  tree.subdivide(tree.unit_cube({2, 2, 2}));
  tree.update_ranks();
  MeshUnderTest rich(tree);
  MeshUnderTest poor(tree);
  poor.pair_budget = 0;
  for (const char* id : {"analysis-suitable", "dual-compatible", "dual-basis"}) {
    EXPECT_EQ(decide(*find_property(id), rich).outcome, Outcome::holds) << id;
    const Verdict verdict = decide(*find_property(id), poor);
    EXPECT_EQ(verdict.outcome, Outcome::undecided) << id;
    EXPECT_FALSE(verdict.reason.empty()) << id;
  }
  for (const char* id : {"admissible", "nested-patches"}) {
    EXPECT_EQ(decide(*find_property(id), poor).outcome, Outcome::holds) << id;
  }
}

}  // namespace
}  // namespace asts
