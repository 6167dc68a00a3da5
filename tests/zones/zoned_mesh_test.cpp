#include "lib/zones/zoned_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "lib/zones/zone_check.hpp"
#include "properties/properties.hpp"
#include "tests/step_cases.hpp"

namespace asts {
namespace {

struct Tally {
  int meshes = 0;
  std::map<std::string, int> outcomes;
};

/// What is proven is what holds, where no zone has too many lines: the shortcut agrees with the full check both ways.
void compare_proofs(const Case& content, const ZoneLimits& limits, Tally& tally) {
  Replay replay(content);
  ZonedMesh zones(replay.tree(), limits);
  for (;;) {
    const Proven proven = zones.decide(replay.subdivided());
    ASSERT_TRUE(zones.active_nodes()) << write_case(content);
    MeshUnderTest alone(replay.tree());
    const auto holds = [&](Verdict (*property)(MeshUnderTest&)) {
      return property(alone).outcome != Outcome::violated;
    };
    EXPECT_EQ(proven.analysis_suitable, holds(decide_analysis_suitable)) << write_case(content);
    EXPECT_EQ(proven.dual_compatible, holds(decide_dual_compatible)) << write_case(content);
    EXPECT_EQ(proven.dual_basis, holds(decide_dual_basis)) << write_case(content);
    ++tally.meshes;
    tally.outcomes["suitable but not compatible"] += proven.analysis_suitable && !proven.dual_compatible ? 1 : 0;
    tally.outcomes["compatible but not suitable"] += !proven.analysis_suitable && proven.dual_compatible ? 1 : 0;
    tally.outcomes["nothing proven"] += !proven.analysis_suitable && !proven.dual_compatible ? 1 : 0;
    if (replay.done() || ::testing::Test::HasFailure()) return;
    replay.advance();
  }
}

TEST(ZonedMesh, ProvesExactlyWhatHolds) {
  constexpr ZoneLimits kLimits[] = {{1, 64}, {7, 64}, {60, 64}, {4096, 64}};
  Tally tally;
  for (std::int64_t number = 3000; number < 4500 && !HasFailure(); ++number) {
    const auto content = testing::random_steps(number);
    if (content) compare_proofs(*content, kLimits[number % 4], tally);
  }
  EXPECT_GT(tally.meshes, 2000);
  EXPECT_GT(tally.outcomes["suitable but not compatible"], 5);
  EXPECT_GT(tally.outcomes["nothing proven"], 50);
}

TEST(ZonedMesh, ProvesExactlyWhatHoldsOfTheFindings) {
  Tally tally;
  for (const Case& content : testing::found_steps()) compare_proofs(content, {5, 64}, tally);
  EXPECT_GT(tally.outcomes["compatible but not suitable"], 0);
  EXPECT_GT(tally.outcomes["suitable but not compatible"], 0);
}

/// What is found in the box of a whole mesh, its nodes added in the order of a shuffled list.
Proven of_shuffled(const Zones& zones, std::mt19937_64& random) {
  const RefinementTree& tree = zones.tree();
  ZoneCheck check(tree, zones.stores(), zones.limits());
  check.begin(box_of(tree, 0));
  PerAxis<std::map<std::int32_t, std::int32_t>> numbers;
  std::vector<PerAxis<std::int32_t>> nodes;
  for (const Zone& zone : zones.list()) {
    for (const auto& node : zone.nodes) {
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        const AxisGrid& grid = tree.grid(static_cast<Axis>(axis));
        const std::int32_t id = zone.vectors[axis][node[axis]];
        const auto lines = zones.stores()[axis][id];
        if (numbers[axis].contains(id)) continue;
        const RankInterval range{grid.rank_of_line(lines.front()), grid.rank_of_line(lines.back())};
        numbers[axis][id] = check.axis(static_cast<Axis>(axis)).add(id, range);
      }
      nodes.push_back({numbers[0][zone.vectors[0][node[0]]], numbers[1][zone.vectors[1][node[1]]],
                       numbers[2][zone.vectors[2][node[2]]]});
    }
  }
  std::shuffle(nodes.begin(), nodes.end(), random);
  for (const auto& node : nodes) check.add_node(node, true);
  EXPECT_EQ(check.number_lines().axis, -1);
  return check.decide();
}

TEST(ZoneCheck, DoesNotDependOnTheOrderOfTheNodes) {
  std::mt19937_64 random(3);
  int violated = 0;
  for (const Case& content : testing::found_steps()) {
    Replay replay(content);
    while (!replay.done()) replay.advance();
    Zones zones(replay.tree());
    zones.rebuild(1);
    const Proven proven = ZonedMesh(replay.tree()).decide({});
    for (int i = 0; i < 20; ++i) {
      const Proven shuffled = of_shuffled(zones, random);
      EXPECT_EQ(shuffled.analysis_suitable, proven.analysis_suitable) << write_case(content);
      EXPECT_EQ(shuffled.dual_compatible, proven.dual_compatible) << write_case(content);
      EXPECT_EQ(shuffled.dual_basis, proven.dual_basis) << write_case(content);
    }
    violated += proven.all() ? 0 : 1;
  }
  EXPECT_GT(violated, 5);
}

/// One step makes the violation, and subdivides elements far away on either side of it: neither may hide the other.
TEST(ZonedMesh, FindsAViolationAmongChangesThatAreFarAway) {
  const auto point = [](const char* x, const char* y, const char* z) {
    return Point{CompactRational(Rational(x)), CompactRational(Rational(y)), CompactRational(Rational(z))};
  };
  Case content;
  content.domain = {24, 4, 5};
  for (const Rational at : {2, 10, 20}) {
    content.steps.assign(2, {});
    for (Step& step : content.steps) step.kind = Step::Kind::subdivide;
    content.steps[0].marks = {point(at.str().c_str(), "1", "1")};
    const Rational half = at + Rational(1, 2);
    content.steps[1].marks = {point("0", "1", "1"), point(half.str().c_str(), "1", "1"), point("23", "1", "1")};
    Tally tally;
    for (const ZoneLimits limits : {ZoneLimits{4096, 64}, ZoneLimits{30, 64}, ZoneLimits{1, 64}}) {
      compare_proofs(content, limits, tally);
    }
    EXPECT_EQ(tally.outcomes["suitable but not compatible"], 3);
  }
}

}  // namespace
}  // namespace asts
