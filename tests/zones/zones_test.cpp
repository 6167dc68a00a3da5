#include "lib/zones/zones.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lib/exact/errors.hpp"
#include "lib/gen/case_stream.hpp"
#include "lib/gen/workloads.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "lib/spline/tsplines.hpp"

namespace asts {
namespace {

using Vectors = PerAxis<std::vector<Rational>>;

/// The index vectors of all active nodes, by coordinates: they have the nodes as middle entries.
std::vector<Vectors> of_mesh(const RefinementTree& tree) {
  const Mesh mesh = mesh_of(tree);
  const TSplines splines = tsplines_of(mesh);
  std::vector<Vectors> result(splines.nodes.size());
  for (std::int32_t node = 0; node < splines.size(); ++node) {
    for (Axis axis = 0; axis < kDimension; ++axis) {
      for (const std::int32_t rank : splines.index_vector(node, axis)) {
        result[at(node)][at(axis)].push_back(mesh.coordinate(axis, rank));
      }
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<Vectors> of_zones(const Zones& zones) {
  std::vector<Vectors> result;
  for (const Zone& zone : zones.list()) {
    for (const auto& node : zone.nodes) {
      Vectors& vectors = result.emplace_back();
      for (Axis axis = 0; axis < kDimension; ++axis) {
        for (const std::int32_t line : zones.stores()[at(axis)][zone.vectors[at(axis)][node[at(axis)]]]) {
          vectors[at(axis)].push_back(zones.tree().grid(axis).coordinate(line));
        }
      }
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The nodes and vectors of each mesh of a case, followed step by step. Returns how many meshes.
int compare(const Case& content, const ZoneLimits& limits) {
  Replay replay(content);
  Zones zones(replay.tree(), limits);
  zones.rebuild(1);
  int meshes = 0;
  for (;;) {
    EXPECT_TRUE(zones.known()) << write_case(content);
    EXPECT_EQ(of_zones(zones), of_mesh(replay.tree()))
        << write_case(content) << "mesh " << meshes << ", zones of " << limits.elements;
    ++meshes;
    if (replay.done() || ::testing::Test::HasFailure()) return meshes;
    replay.advance();
    zones.update(replay.subdivided());
  }
}

TEST(Zones, HaveTheNodesAndVectorsOfTheMesh) {
  constexpr ZoneLimits kLimits[] = {{1, 64}, {9, 64}, {64, 64}, {1000, 64}};
  int meshes = 0;
  for (std::int64_t number = 0; number < 600 && !HasFailure(); ++number) {
    const Case content = make_case(plan_case(97, number)).content;
    if (!content.explicit_mesh) meshes += compare(content, kLimits[number % 4]);
  }
  EXPECT_GT(meshes, 1000);
}

TEST(Zones, HaveThemWithOtherDegreesAndGradings) {
  for (const Setting& setting : {Setting{{3, 5, 7}, 2, {9, 9, 11}}, Setting{{5, 3, 3}, 3, {8, 7, 6}}}) {
    EXPECT_GT(compare(generate_workload(Workload::sphere, setting, 2000), {200, 64}), 2);
    EXPECT_GT(compare(generate_workload(Workload::random, setting, 2000), {50, 64}), 2);
  }
}

std::size_t zones_after(const Case& content, const ZoneLimits& limits) {
  Replay replay(content);
  Zones zones(replay.tree(), limits);
  zones.rebuild(1);
  while (!replay.done()) {
    replay.advance();
    zones.update(replay.subdivided());
  }
  return zones.list().size();
}

/// Steps bring more lines than what is left of a word: the zone is found anew, and divided, though it has few nodes.
TEST(Zones, HaveThemWhereTooManyLinesCome) {
  const Case content = generate_workload(Workload::corner, {{3, 3, 3}, 2, {8, 8, 8}}, 4000);
  EXPECT_EQ(zones_after(content, {8000, 64}), 1U);
  for (const std::size_t lines : {12, 14, 17}) {
    EXPECT_GT(zones_after(content, {8000, lines}), 1U);
    EXPECT_GT(compare(content, {8000, lines}), 6);
  }
}

/// One cube in 2^7 layers beside a whole one: its neighbour's window has more lines than a word has bits.
TEST(Zones, SayWhereTooManyLinesAre) {
  Case content = parse_case("asts-case 1\ndegree 3 3 3\ngrading 128\ndomain 6 6 6\nsubdivide 2 2 2\n", "layers");
  Replay replay(content);
  while (!replay.done()) replay.advance();
  Zones zones(replay.tree());
  zones.rebuild(1);
  EXPECT_FALSE(zones.known());
}

TEST(Zones, AreTheSameByAnyNumberOfThreads) {
  const Case content = generate_workload(Workload::sphere, {{3, 3, 3}, 2, {8, 8, 8}}, 5000);
  Replay replay(content);
  while (!replay.done()) replay.advance();
  Zones one(replay.tree(), {100, 64});
  Zones three(replay.tree(), {100, 64});
  one.rebuild(1);
  three.rebuild(3);
  EXPECT_EQ(one.active_nodes(), three.active_nodes());
  EXPECT_EQ(of_zones(one), of_zones(three));
}

/// Many zones with changed nodes, then fewer zones from scratch: none of these is changed.
TEST(Zones, ForgetWhatChangedWhenTheyAreFoundAnew) {
  Case content;
  content.domain = {12, 8, 8};
  content.steps.assign(6, {});
  for (int i = 0; i < 6; ++i) {
    for (int x = 2; x < 10; ++x) {
      content.steps[at(i)].kind = Step::Kind::refine;
      content.steps[at(i)].marks.push_back({CompactRational(x), CompactRational(2 + i % 4), CompactRational(3)});
    }
  }
  Replay replay(content);
  Zones zones(replay.tree(), {100, 64});
  zones.rebuild(1);
  const auto changed = [&] {
    return std::count_if(zones.list().begin(), zones.list().end(), [](const Zone& zone) {
      return std::find(zone.changed.begin(), zone.changed.end(), true) != zone.changed.end();
    });
  };
  for (int i = 0; i < 5; ++i) {
    replay.advance();
    zones.update(replay.subdivided());
    EXPECT_GT(changed(), 4);
  }
  const std::size_t many = zones.list().size();
  zones.rebuild(1);
  EXPECT_LT(zones.list().size(), many);
  EXPECT_EQ(changed(), 0);
  EXPECT_TRUE(zones.update({}).empty());
  replay.advance();
  EXPECT_FALSE(zones.update(replay.subdivided()).empty());
  EXPECT_EQ(of_zones(zones), of_mesh(replay.tree()));
}

/// The boxes that update() returns contain the supports of all nodes that the mesh before did not have like this.
TEST(Zones, NameBoxesAroundWhatChanged) {
  Case content = generate_workload(Workload::sphere, {{3, 3, 3}, 2, {8, 8, 8}}, 3000);
  const std::size_t before = content.steps.size();
  for (const char* mark : {"2", "9/4", "7/2", "15/4", "5"}) {
    Step step;
    step.kind = Step::Kind::refine;
    step.marks.push_back({CompactRational(Rational(mark)), CompactRational(4), CompactRational(3)});
    content.steps.push_back(step);
  }
  Replay replay(content);
  for (std::size_t i = 0; i < before; ++i) replay.advance();
  Zones zones(replay.tree(), {100, 64});
  zones.rebuild(1);
  int changed = 0;
  while (!replay.done()) {
    const std::vector<Vectors> old = of_mesh(replay.tree());
    replay.advance();
    const std::vector<RankBox> boxes = zones.update(replay.subdivided());
    for (const Vectors& vectors : of_mesh(replay.tree())) {
      if (std::binary_search(old.begin(), old.end(), vectors)) continue;
      ++changed;
      const bool contained = std::any_of(boxes.begin(), boxes.end(), [&](const RankBox& box) {
        for (Axis axis = 0; axis < kDimension; ++axis) {
          const AxisGrid& grid = replay.tree().grid(axis);
          if (grid.coordinate(grid.line_of_rank(box[axis].lower)) > vectors[at(axis)].front()) return false;
          if (grid.coordinate(grid.line_of_rank(box[axis].upper)) < vectors[at(axis)].back()) return false;
        }
        return true;
      });
      EXPECT_TRUE(contained);
    }
  }
  EXPECT_GT(changed, 100);
}

}  // namespace
}  // namespace asts
