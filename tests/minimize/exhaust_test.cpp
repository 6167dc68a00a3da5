#include "lib/minimize/exhaust.hpp"

#include <gtest/gtest.h>

#include "lib/mesh/case_file.hpp"
#include "lib/minimize/path_search.hpp"

namespace asts {
namespace {

const Excluded kNone = [](const Setting&) { return false; };

// What is counted is what is enumerated, and the closed formula gives it.
TEST(Exhaust, VisitsAsManyMeshesAsItCounts) {
  for (const Scope& scope : {Scope{0, 6, 3, 2}, Scope{1, 4, 5, 3}, Scope{2, 6, 3, 4}, Scope{3, 3, 3, 2}}) {
    std::int64_t visits = 0;
    const auto count = [&]() -> MeshTrial {
      return [&](const EnumeratedMesh&) {
        ++visits;
        return false;
      };
    };
    const Exhausted result = exhaust(scope, Case{}, CaseSize{}, false, kNone, count);
    EXPECT_EQ(result.meshes, visits) << scope_text(scope);
    EXPECT_EQ(count_meshes(scope, kNone, 1'000'000), visits) << scope_text(scope);
    EXPECT_EQ(count_meshes(scope, kNone, visits - 1), std::nullopt);
    EXPECT_EQ(result.violating, 0);
    EXPECT_FALSE(result.smaller);
  }
  EXPECT_EQ(scope_text({2, 80, 5, 3}),
            "every mesh of at most 2 subdivisions on domains of at most 80 cubes, degrees 3 "
            "to 5, m = 2 to 3");
}

/// Violated by meshes with an element of level 2 in the last layer along z.
bool level_2_on_top(const EnumeratedMesh& mesh) {
  for (const ElementPath& path : subdivided_of(mesh_paths(case_of(mesh)).value())) {
    if (level_of(path) == 1 && path[2] == mesh.tree.setting().domain[2] - 1) return true;
  }
  return false;
}

TEST(Exhaust, FindsTheSmallestOfAll) {
  const auto trial = []() -> MeshTrial { return level_2_on_top; };
  const Case start =
      parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 1 1 3\nsubdivide 0 0 2\nsubdivide 1/2 0 2\n", "test");
  const CaseSize size = size_of_mesh(mesh_paths(start).value());
  const Exhausted result = exhaust({2, 3, 3, 2}, start, size, false, kNone, trial);
  ASSERT_TRUE(result.smaller);
  EXPECT_EQ(write_case(*result.smaller),
            "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 1 1 1\nsubdivide 0 0 0\nsubdivide 0 0 0\n");
  const CaseSize least = size_of_mesh(mesh_paths(*result.smaller).value());
  EXPECT_FALSE(exhaust({2, 3, 3, 2}, *result.smaller, least, false, kNone, trial).smaller);
  const Excluded small = [](const Setting& setting) { return setting.domain[2] < 3; };
  const Exhausted without = exhaust({2, 3, 3, 2}, start, size, false, small, trial);
  EXPECT_EQ(without.excluded, 6) << "six of the domains 1x1x1, 1x1x2, 1x2x1, 2x1x1, 1x1x3, 1x3x1, 3x1x1";
  ASSERT_TRUE(without.smaller);
  EXPECT_EQ(without.smaller->domain, start.domain);
}

TEST(Exhaust, ChoosesTheLargestScopeThatFits) {
  const Case smallest =
      parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 1 1 3\nsubdivide 0 0 2\nsubdivide 1/2 0 2\n", "test");
  const CaseSize size = size_of_mesh(mesh_paths(smallest).value());
  const auto chosen = choose_scope(smallest, size, kNone, 1'000'000);
  ASSERT_TRUE(chosen);
  EXPECT_TRUE(chosen->complete);
  EXPECT_EQ(chosen->scope.volume, 6);
  EXPECT_EQ(chosen->scope.degree, 5);
  EXPECT_EQ(chosen->scope.grading, 3);
  Case wide = smallest;
  wide.domain = {3, 3, 4};
  const CaseSize wide_size = size_of_mesh(mesh_paths(wide).value());
  const std::int64_t complete = count_meshes({2, 36, 3, 2}, kNone, 1'000'000'000).value();
  EXPECT_TRUE(choose_scope(wide, wide_size, kNone, complete)->complete);
  const auto less = choose_scope(wide, wide_size, kNone, complete - 1);
  ASSERT_TRUE(less);
  EXPECT_FALSE(less->complete);
  EXPECT_EQ(less->scope.subdivisions, 1);
  EXPECT_LE(count_meshes(less->scope, kNone, complete).value(), complete / 10);
  EXPECT_FALSE(choose_scope(smallest, size, kNone, 10));
}

}  // namespace
}  // namespace asts
