#include "lib/minimize/path_case.hpp"

#include <gtest/gtest.h>

#include "lib/exact/errors.hpp"
#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/fingerprint.hpp"
#include "lib/minimize/path_changes.hpp"
#include "lib/refine/replay.hpp"

namespace asts {
namespace {

Case with_steps(const std::string& steps, const std::string& setting = "grading 2\ndomain 3 2 2\n") {
  return parse_case("asts-case 1\ndegree 3 3 3\n" + setting + steps, "test");
}

Fingerprint mesh_after(const Case& test_case) {
  Replay replay(test_case);
  while (!replay.done()) replay.advance();
  return fingerprint_of(mesh_of(replay.tree()));
}

TEST(PathCase, OfAMeshNamesSubdividedElementsByLevel) {
  const auto mesh = mesh_paths(with_steps("subdivide 5/2 3/2 1/2\nsubdivide 9/4 1 0\nsubdivide 0 0 0\n")).value();
  ASSERT_EQ(mesh.steps.size(), 2U);
  EXPECT_EQ(mesh.steps[0].marks, (std::vector<ElementPath>{{0, 0, 0}, {2, 1, 0}}));
  EXPECT_EQ(mesh.steps[1].marks, (std::vector<ElementPath>{{2, 1, 0, 0}}));
  EXPECT_EQ(write_case(case_of(mesh)), write_case(with_steps("subdivide 0 0 0  2 1 0\nsubdivide 2 1 0\n")));
}

TEST(PathCase, WritesLowerCornersOfDeepElements) {
  PathCase mesh{{{3, 3, 3}, 3, {2, 1, 1}}, {}};
  mesh = mesh_of_paths(mesh.setting, {{1, 0, 0, 2, 1, 0, 2}});
  const Case written = case_of(mesh);
  ASSERT_EQ(written.steps.size(), 5U);  // with the four that it lies in
  EXPECT_EQ(written.steps[4].marks[0][0].value(), Rational(1) + Rational(2) / 3 + Rational(2) / 9);
  EXPECT_EQ(written.steps[4].marks[0][1].value(), Rational(1) / 3);
  EXPECT_EQ(written.steps[4].marks[0][2].value(), 0);
}

// Laws on random cases: a mesh's form makes the same mesh and is its own form; so is a sequence's.
TEST(PathCase, KeepsMeshesAndIsItsOwnForm) {
  CaseLimits limits;
  limits.max_degree = 5;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Draw draw(seed);
    const Case content =
        (draw.one_in(2) ? random_bare_case(draw, limits) : random_admissible_case(draw, limits)).content;
    SCOPED_TRACE(write_case(content));
    const Case mesh = case_of(mesh_paths(content).value());
    EXPECT_EQ(mesh_after(mesh), mesh_after(content));
    EXPECT_EQ(write_case(case_of(mesh_paths(mesh).value())), write_case(mesh));
    const FollowedPaths sequence = follow_paths(content);
    EXPECT_EQ(mesh_after(case_of(sequence.paths)), mesh_after(content));
    EXPECT_EQ(write_case(case_of(follow_paths(case_of(sequence.paths)).paths)), write_case(case_of(sequence.paths)));
    EXPECT_EQ(sequence.subdivisions, static_cast<std::int64_t>(subdivided_of(mesh_paths(content).value()).size()));
  }
}

TEST(PathCase, OfBoxesIsThereWhenSubdivisionsMakeThem) {
  const std::string halves = "element 0 0 0  1/2 1 1\nelement 1/2 0 0  1 1 1\n";
  const auto mesh = mesh_paths(with_steps(halves, "grading 2\ndomain 1 1 1\n"));
  ASSERT_TRUE(mesh);
  EXPECT_EQ(subdivided_of(*mesh), (std::vector<ElementPath>{{0, 0, 0}}));
  EXPECT_FALSE(mesh_paths(with_steps(halves, "grading 3\ndomain 1 1 1\n")));
  EXPECT_THROW(follow_paths(with_steps(halves, "grading 2\ndomain 1 1 1\n")), InputError);
}

// The two ways to follow a sequence agree: m = 200 makes more than a million elements.
TEST(PathCase, FollowsLargeSequencesBySubdividedElements) {
  std::string steps;
  for (int i = 0; i < 4; ++i) steps += "refine 0 0 0\n";
  const Case small = with_steps(steps, "grading 200\ndomain 1 1 1\n");
  Case large = small;
  large.domain = {60, 60, 60};
  for (int i = 0; i < 4; ++i) large.steps.push_back({Step::Kind::refine, {large.steps[0].marks[0]}});
  const FollowedPaths followed = follow_paths(large);
  EXPECT_EQ(followed.paths.steps[3].marks, follow_paths(small).paths.steps[3].marks);
  EXPECT_EQ(followed.paths.steps[7].marks[0].size(), 3U + 7U);
}

TEST(PathChanges, OfLayersUndoEachOther) {
  const PathCase mesh = mesh_paths(with_steps("subdivide 0 0 0  2 1 1\nsubdivide 5/2 1 1\n")).value();
  const PathCase wider = with_layers(mesh, 0, 1, 2);
  EXPECT_EQ(wider.setting.domain, (PerAxis<int>{5, 2, 2}));
  EXPECT_EQ(wider.steps[1].marks, (std::vector<ElementPath>{{4, 1, 1, 1}}));
  EXPECT_EQ(without_layers(wider, 0, 1, 2).steps, mesh.steps);
  const PathCase cut = without_layers(mesh, 1, 1, 1);
  EXPECT_EQ(subdivided_of(cut), (std::vector<ElementPath>{{0, 0, 0}}));
  EXPECT_EQ(cut.setting.domain, (PerAxis<int>{3, 1, 2}));
}

TEST(PathChanges, OfReflectionsAndAxes) {
  const PathCase mesh = mesh_paths(with_steps("subdivide 0 1 0\nsubdivide 1/2 1 0\nsubdivide 1/2 3/2 0\n")).value();
  const PathCase mirrored = reflected(mesh, {true, false, true});
  EXPECT_EQ(mirrored.steps[2].marks, (std::vector<ElementPath>{{2, 1, 1, 0, 1}}));
  EXPECT_EQ(reflected(mirrored, {true, false, true}).steps, mesh.steps);
  const PathCase turned = permuted(mesh, {1, 2, 0});
  EXPECT_EQ(turned.setting.domain, (PerAxis<int>{2, 2, 3}));
  EXPECT_EQ(turned.steps[1].marks, (std::vector<ElementPath>{{1, 0, 0, 1}}));
}

TEST(PathChanges, OfGradingKeepTheEndThatIsMeant) {
  PathCase mesh{{{3, 3, 3}, 5, {1, 1, 1}}, {}};
  mesh = mesh_of_paths(mesh.setting, {{0, 0, 0, 3, 1}});
  const auto mapped = [&](int m, ChildMap map) { return with_grading(mesh, m, map).steps[2].marks[0]; };
  EXPECT_EQ(mapped(3, ChildMap::lower_end), (ElementPath{0, 0, 0, 2, 1}));
  EXPECT_EQ(mapped(3, ChildMap::upper_end), (ElementPath{0, 0, 0, 1, 0}));
  EXPECT_EQ(mapped(3, ChildMap::both_ends), (ElementPath{0, 0, 0, 1, 1}));
  EXPECT_EQ(mapped(3, ChildMap::in_scale), (ElementPath{0, 0, 0, 1, 0}));
}

// [1,2] x [0,1]^2 is cut along x and its upper half along y: that cut is one along x of the last of two layers.
TEST(PathChanges, OneLevelLower) {
  const PathCase mesh = mesh_paths(with_steps("subdivide 1 0 0\nsubdivide 3/2 0 0\n")).value();
  const auto lower = one_level_lower(mesh);
  ASSERT_TRUE(lower);
  EXPECT_EQ(lower->setting.domain, (PerAxis<int>{2, 2, 4}));  // x: [0,1], [1,3/2], [3/2,2], [2,3]
  EXPECT_EQ(subdivided_of(*lower), (std::vector<ElementPath>{{0, 0, 2}}));
}

}  // namespace
}  // namespace asts
