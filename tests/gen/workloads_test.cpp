#include "lib/gen/workloads.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "lib/exact/errors.hpp"
#include "lib/gen/growing_case.hpp"
#include "lib/mesh/fingerprint.hpp"
#include "lib/refine/replay.hpp"

namespace asts {
namespace {

const Setting kCubes{{3, 3, 3}, 2, {8, 8, 8}};

// 512 leaves and 8 draws; without a library's distributions, so that a compiler cannot change the workload.
TEST(RandomWorkload, DrawsOneLeafIn64WithTheSeed1) {
  const Case content = generate_workload(Workload::random, kCubes, 513);
  ASSERT_EQ(content.steps.size(), 1U);
  const RefinementTree tree(kCubes);
  const std::vector<std::int32_t> leaves = leaves_of(tree);
  std::mt19937_64 engine(1);
  std::set<std::int32_t> drawn;
  for (int i = 0; i < 8; ++i) drawn.insert(leaves[engine() % 512]);
  Step expected;
  for (const std::int32_t leaf : drawn) expected.marks.push_back(lower_corner(tree, leaf));
  EXPECT_EQ(content.steps[0], expected);
}

TEST(RandomWorkload, MarksDistinctLeavesOnceInEveryStep) {
  const Case content = generate_workload(Workload::random, kCubes, 5'000);
  Replay replay(content);
  for (const Step& step : content.steps) {
    const std::int64_t leaves = replay.tree().element_count();
    replay.advance();
    EXPECT_EQ(step.kind, Step::Kind::refine);
    EXPECT_EQ(replay.counts().marked, static_cast<std::int64_t>(step.marks.size()));
    EXPECT_LE(replay.counts().marked, (leaves + 63) / 64);
    EXPECT_GE(replay.counts().marked, (leaves + 63) / 64 * 3 / 4) << "few leaves are drawn twice";
  }
}

// What another machine, or another release, must make too.
TEST(RandomWorkload, IsTheSameEverywhere) {
  const Case content = generate_workload(Workload::random, kCubes, 5'000);
  EXPECT_EQ(content, generate_workload(Workload::random, kCubes, 5'000));
  const Mesh mesh = last_mesh(content);
  EXPECT_EQ(content.steps.size(), 15U);
  EXPECT_EQ(mesh.elements.size(), 6632U);
  EXPECT_EQ(fingerprint_of(mesh).low, 1874572619085902463U);
}

TEST(RandomWorkload, AnInitialMeshOfOneElementGrowsToo) {
  const Case content = generate_workload(Workload::random, {{3, 3, 3}, 3, {1, 1, 1}}, 20);
  EXPECT_GE(last_mesh(content).elements.size(), 20U);
  for (const Step& step : content.steps) EXPECT_EQ(step.marks.size(), 1U);
}

TEST(Workloads, HaveNames) {
  ASSERT_EQ(workload_names().size(), 3U);
  EXPECT_EQ(workload_named("corner"), Workload::corner);
  EXPECT_EQ(workload_named("sphere"), Workload::sphere);
  EXPECT_EQ(workload_named("random"), Workload::random);
  EXPECT_THROW(workload_named("line"), InputError);
}

}  // namespace
}  // namespace asts
