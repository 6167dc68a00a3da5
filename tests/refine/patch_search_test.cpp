#include "lib/refine/patch_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "lib/gen/growing_case.hpp"
#include "lib/gen/workloads.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/admissibility.hpp"
#include "lib/refine/parallel_marks.hpp"
#include "lib/refine/refinement.hpp"
#include "lib/refine/replay.hpp"

namespace asts {
namespace {

using Leaves = std::vector<std::int32_t>;
using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// All nodes in the order of the tree.
Leaves nodes_in_order(const RefinementTree& tree) {
  Leaves nodes, pending{0};
  while (!pending.empty()) {
    nodes.push_back(pending.back());
    pending.pop_back();
    if (!tree.is_leaf(nodes.back())) tree.push_children(nodes.back(), pending);
  }
  return nodes;
}

/// Any degree from 1, any grading below and above 64 (then no two elements share a cluster), domains as thin as a cube.
Setting any_setting(Draw& draw) {
  Setting setting;
  setting.grading = draw.choose(std::vector{2, 2, 3, 4, 7, 9, 70});
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    setting.degree[axis] = 1 + 2 * draw.between(0, 3);
    setting.domain[axis] = draw.between(1, draw.one_in(4) ? 12 : 4);
  }
  return setting;
}

/// Refined elements and bare subdivisions, mostly of what came last: levels jump, and corners get deep.
GrowingCase any_case(Draw& draw) {
  GrowingCase growing(any_setting(draw), 700);
  for (int step = draw.between(1, 24); step > 0; --step) {
    const Leaves leaves = leaves_of(growing.tree());
    const std::int32_t leaf = draw.one_in(3) ? draw.choose(leaves) : leaves.back();
    growing.add(draw.one_in(2) ? Step::Kind::subdivide : Step::Kind::refine, Leaves{leaf});
  }
  return growing;
}

/// Whether C is coarser than K and meets the open box U(K), by their sides.
bool is_coarser_in_patch(const RefinementTree& tree, std::int32_t k, std::int32_t c) {
  bool meets = tree.node(c).level < tree.node(k).level;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval environment = tree.environment(k, axis);
    const RankInterval side = tree.extent(c, axis);
    meets = meets && environment.lower < side.upper && side.lower < environment.upper;
  }
  return meets;
}

/// Marks what is found, one element K after the other, one leaf C after the other, in the order of the tree.
Leaves mark_one_by_one(RefinementTree& tree, const Leaves& elements) {
  Leaves found;
  const Leaves nodes = nodes_in_order(tree);
  for (const std::int32_t k : nodes) {
    if (std::find(elements.begin(), elements.end(), k) == elements.end()) continue;
    for (const std::int32_t c : nodes) {
      if (!tree.is_leaf(c) || tree.is_marked(c) || !is_coarser_in_patch(tree, k, c)) continue;
      tree.mark(c);
      found.push_back(c);
    }
  }
  return found;
}

/// Elements of one level: leaves and others, as they come.
Leaves any_elements(Draw& draw, const RefinementTree& tree, std::int32_t level) {
  Leaves elements;
  const int share = draw.between(1, 4);
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (tree.node(id).level == level && draw.one_in(share)) elements.push_back(id);
  }
  draw.shuffle(elements);
  return elements;
}

// Every pair (K, C), each once, among the leaves that are not marked.
TEST(PatchSearch, FindsEveryPairOnce) {
  Draw draw(61);
  std::size_t pairs = 0;
  for (int round = 0; round < 1500 && !HasFailure(); ++round) {
    const GrowingCase growing = any_case(draw);
    SCOPED_TRACE(write_case(growing.content()));
    RefinementTree tree = growing.tree();
    for (const std::int32_t leaf : leaves_of(tree)) {
      if (draw.one_in(5)) tree.mark(leaf);
    }
    const std::int32_t level = draw.between(0, tree.max_level());
    const Leaves elements = any_elements(draw, tree, level);
    Pairs expected, found;
    for (const std::int32_t k : elements) {
      for (const std::int32_t c : leaves_of(tree)) {
        if (!tree.is_marked(c) && is_coarser_in_patch(tree, k, c)) expected.emplace_back(k, c);
      }
    }
    PatchSearch(tree).coarser_in_patches(elements, level, [&](const PatchSearch::Coarser& coarser) {
      coarser.for_each_element([&](std::int32_t k) { found.emplace_back(k, coarser.leaf); });
      return true;
    });
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
    pairs += expected.size();
  }
  EXPECT_GT(pairs, 100'000U);
}

// The closure is that of one element after the other, in the same order, whatever the number of threads.
TEST(PatchSearch, MarksInTheOrderOfTheTree) {
  Draw draw(62);
  std::size_t marked = 0;
  for (int round = 0; round < 1500 && !HasFailure(); ++round) {
    const GrowingCase growing = any_case(draw);
    SCOPED_TRACE(write_case(growing.content()));
    const std::int32_t level = draw.between(0, growing.tree().max_level());
    const Leaves elements = any_elements(draw, growing.tree(), level);
    RefinementTree one_by_one = growing.tree();
    const Leaves expected = mark_one_by_one(one_by_one, elements);
    marked += expected.size();
    for (int jobs = 1; jobs <= (round % 16 == 0 ? 3 : 1); ++jobs) {
      RefinementTree tree = growing.tree();
      EXPECT_EQ(mark_coarser(tree, elements, level, jobs), expected) << jobs << " jobs";
      for (std::int32_t id = 0; id < tree.node_count(); ++id) EXPECT_EQ(tree.coarsest(id), one_by_one.coarsest(id));
    }
  }
  EXPECT_GT(marked, 20'000U);
}

// Algorithm 2.8, level by level, with the simple loop in place of the search.
TEST(PatchSearch, GivesTheClosureOfTheSimpleLoop) {
  Draw draw(63);
  std::size_t added = 0;
  for (int round = 0; round < 1500 && !HasFailure(); ++round) {
    const GrowingCase growing = any_case(draw);
    SCOPED_TRACE(write_case(growing.content()));
    RefinementTree simple = growing.tree();
    Leaves marks = leaves_of(simple);
    draw.shuffle(marks);
    marks.resize(std::min<std::size_t>(marks.size(), draw.index(4) + 1));
    std::vector<Leaves> by_level(at(simple.max_level()) + 1);
    for (const std::int32_t leaf : marks) {
      simple.mark(leaf);
      by_level[at(simple.node(leaf).level)].push_back(leaf);
    }
    Leaves expected;
    for (std::size_t level = by_level.size(); level-- > 0;) {
      for (const std::int32_t c : mark_one_by_one(simple, by_level[level])) {
        by_level[at(simple.node(c).level)].push_back(c);
      }
      expected.insert(expected.end(), by_level[level].begin(), by_level[level].end());
    }
    RefinementTree tree = growing.tree();
    EXPECT_EQ(mark_closure(tree, marks), expected);
    added += expected.size() - marks.size();
  }
  EXPECT_GT(added, 20'000U);
}

// A mesh so large that threads share the work of every step.
TEST(Replay, DoesTheSameForAnyNumberOfJobs) {
  const Case content = generate_workload(Workload::sphere, Setting{{3, 3, 3}, 2, {8, 8, 8}}, 60'000);
  Replay one(content), two(content, 2), three(content, 3);
  std::size_t most = 0;
  while (!one.done()) {
    for (Replay* replay : {&one, &two, &three}) replay->advance();
    EXPECT_EQ(two.subdivided(), one.subdivided());
    EXPECT_EQ(three.subdivided(), one.subdivided());
    most = std::max(most, one.subdivided().size());
  }
  EXPECT_GT(most, 20'000U);
  EXPECT_FALSE(find_inadmissible(two.tree(), 2));
  EXPECT_EQ(two.tree().node_count(), one.tree().node_count());
}

}  // namespace
}  // namespace asts
