#include "lib/refine/refinement.hpp"

#include <gtest/gtest.h>

#include <set>

#include "lib/gen/growing_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/admissibility.hpp"
#include "lib/refine/replay.hpp"
#include "tests/literal_mesh.hpp"

namespace asts {
namespace {

using Leaves = std::vector<std::int32_t>;

/// Marks the element at the origin, again and again; the numbers of new elements after each step.
std::vector<std::int64_t> corner_sequence(const Setting& setting, int steps) {
  RefinementTree tree(setting);
  std::vector<std::int64_t> new_elements;
  for (int step = 0; step < steps; ++step) {
    refine(tree, Leaves{tree.leaf_at(Point{})});
    new_elements.push_back(tree.new_element_count());
  }
  return new_elements;
}

// Example 2.10: p = (3,3,3), 4 x 5 x 8 cubes, the corner element marked until its size is 1/16 in each direction: three
// steps divide each side by m once, so 12 steps for 2^4, 6 for 4^2, 3 for 16.
TEST(Refinement, ExampleTable) {
  struct Row {
    int grading, steps;
    std::int64_t new_elements;
  };
  for (const Row& row : {Row{2, 12, 10728}, Row{4, 6, 3175}, Row{16, 3, 1030}}) {
    const Setting setting{{3, 3, 3}, row.grading, {4, 5, 8}};
    EXPECT_EQ(corner_sequence(setting, row.steps).back(), row.new_elements) << "m = " << row.grading;
    RefinementTree tree(setting);
    for (int step = 0; step < row.steps; ++step) refine(tree, Leaves{tree.leaf_at(Point{})});
    const reference::Box corner = literal::box(tree, tree.leaf_at(Point{}));
    EXPECT_EQ(corner.upper, (reference::Point{Rational(1) / 16, Rational(1) / 16, Rational(1) / 16}));
  }
}

// The half [0,1/2] x [0,1]^2 has U = (0, 5/2) x (0, 5)^2, clipped to the domain 4 x 4 x 5: the cubes below x = 5/2 but
// the one that was subdivided are coarser, 3 * 20 - 1 = 59; with the mark, 60.
TEST(Refinement, ClosureCollectsTheCoarserElementsOfThePatch) {
  RefinementTree tree(Setting{{3, 3, 3}, 2, {4, 4, 5}});
  refine(tree, Leaves{tree.leaf_at(Point{})});
  EXPECT_EQ(tree.new_element_count(), 2) << "an element of level 0 has nothing coarser";
  const std::int32_t half = tree.leaf_at(Point{});
  const Leaves closure = mark_closure(tree, Leaves{half, half});
  EXPECT_EQ(closure.size(), 60U);
  EXPECT_EQ(closure.front(), half);
}

// The paper's patches are closed boxes that meet an open one: elements that only touch U(K) do not belong to them.
// p = 3, m = 2, the half [4,9/2] of [4,5]: U reaches 4 halves beyond, (2, 13/2) along x, so of a row of 12 cubes those
// of [2,3] .. [6,7] meet it; [1,2] only touches.
TEST(Refinement, ElementsThatTouchTheEnvironmentAreLeftOut) {
  RefinementTree tree(Setting{{3, 3, 3}, 2, {12, 1, 1}});
  const Point in_fourth{CompactRational(4), CompactRational(0), CompactRational(0)};
  refine(tree, Leaves{tree.leaf_at(in_fourth)});
  std::set<Rational> lowers;
  for (const std::int32_t id : mark_closure(tree, Leaves{tree.leaf_at(in_fourth)})) {
    lowers.insert(literal::box(tree, id).lower[0]);
  }
  EXPECT_EQ(lowers, (std::set<Rational>{2, 3, 4, 5, 6}));
}

/// A random tree with levels far apart: bare steps, small enough for the literal closure.
RefinementTree random_tree(Draw& draw) {
  const CaseLimits limits{5, 4, 5, 70, 130, 8};
  const Case content =
      draw.one_in(2) ? random_bare_case(draw, limits).content : random_admissible_case(draw, limits).content;
  Replay replay(content);
  while (!replay.done()) replay.advance();
  return replay.tree();
}

/// One of the finest elements and up to three others.
Leaves random_marks(Draw& draw, const RefinementTree& tree) {
  Leaves leaves = leaves_of(tree);
  draw.shuffle(leaves);
  const auto finest = std::find_if(leaves.begin(), leaves.end(),
                                   [&](std::int32_t leaf) { return tree.node(leaf).level == tree.max_level(); });
  std::iter_swap(leaves.begin(), finest);
  leaves.resize(std::min(leaves.size(), draw.index(4) + 1));
  return leaves;
}

reference::Mesh boxes_of(const RefinementTree& tree, const Leaves& leaves) {
  reference::Mesh result;
  for (const std::int32_t leaf : leaves) result.push_back(literal::box(tree, leaf));
  return literal::sorted(std::move(result));
}

// Algorithms 2.8 and 2.9 against their literal transcription, as sets of boxes.
TEST(Refinement, AgreesWithTheLiteralAlgorithmOnRandomMeshes) {
  Draw draw(11);
  int grew = 0;
  for (int round = 0; round < 100; ++round) {
    RefinementTree tree = random_tree(draw);
    const reference::Setting setting = literal::setting(tree.setting());
    const Leaves marks = random_marks(draw, tree);
    reference::Mesh mesh;
    std::vector<std::size_t> positions;
    for (const std::int32_t leaf : leaves_of(tree)) {
      if (std::find(marks.begin(), marks.end(), leaf) != marks.end()) positions.push_back(mesh.size());
      mesh.push_back(literal::box(tree, leaf));
    }
    reference::Mesh expected;
    for (const std::size_t position : reference::closure(setting, mesh, positions)) expected.push_back(mesh[position]);
    RefinementTree marked = tree;
    EXPECT_EQ(boxes_of(tree, mark_closure(marked, marks)), literal::sorted(expected));
    refine(tree, marks);
    EXPECT_EQ(boxes_of(tree, leaves_of(tree)), literal::sorted(reference::refine(setting, mesh, positions)));
    grew += expected.size() > marks.size();
    ASSERT_FALSE(HasFailure()) << round;
  }
  EXPECT_GT(grew, 40) << "closures that add nothing test nothing";
}

// The closure is the least closed superset: the order of the marks does not matter, it is its own closure, and more
// marks give a superset.
TEST(Refinement, ClosureIsAnOrderFreeIdempotentMonotoneHull) {
  Draw draw(12);
  for (int round = 0; round < 150; ++round) {
    const RefinementTree tree = random_tree(draw);
    const auto closure_of = [&](const Leaves& marks) {
      RefinementTree copy = tree;
      Leaves closure = mark_closure(copy, marks);
      std::sort(closure.begin(), closure.end());
      return closure;
    };
    Leaves marks = random_marks(draw, tree);
    const Leaves closure = closure_of(marks);
    EXPECT_EQ(closure_of(closure), closure);
    draw.shuffle(marks);
    EXPECT_EQ(closure_of(marks), closure);
    marks.push_back(draw.choose(leaves_of(tree)));
    const Leaves more = closure_of(marks);
    EXPECT_TRUE(std::includes(more.begin(), more.end(), closure.begin(), closure.end()));
  }
}

// Definition 2.7: subdivisions of distinct elements commute.
TEST(Refinement, SubdivisionsCommute) {
  Draw draw(13);
  for (int round = 0; round < 80; ++round) {
    RefinementTree one = random_tree(draw);
    RefinementTree other = one;
    Leaves marks = random_marks(draw, one);
    subdivide_all(one, marks);
    draw.shuffle(marks);
    subdivide_all(other, marks);
    EXPECT_EQ(boxes_of(one, leaves_of(one)), boxes_of(other, leaves_of(other)));
  }
}

// 130 steps into one corner with m = 3: the smallest element has the side 3^-43 along y and z and 3^-44 along x, and
// the coordinates of its neighbours need more than 64 bits. Why 208645 is the right count:
//
// The scaling by m about the corner maps elements of level k to elements of level k-3 and their environments likewise,
// as long as the far ends of the domain cut off neither. The closure of step k+3 reaches, level by level, as far as
// that of step k, scaled; what the far ends cut off concerns coarse levels only, and these have been refined for good
// after some steps. So from then on the increments have period 3; here they are even equal, 1680 from step 12 on, and
// 208645 = 10405 + 118 * 1680, where 10405 after 12 steps is within reach of the literal code (compared once, in half a
// minute; the first steps are compared below in every run).
TEST(Refinement, DeepCornerSequenceIsSelfSimilarPastSixtyFourBits) {
  const std::vector<std::int64_t> counts = corner_sequence({{3, 3, 3}, 3, {5, 5, 5}}, 130);
  EXPECT_EQ(counts.back(), 208645);
  EXPECT_EQ(counts[11], 10405);
  for (std::size_t step = 12; step < counts.size(); ++step) EXPECT_EQ(counts[step] - counts[step - 1], 1680) << step;
}

// The beginning of that sequence, and of m = 2 and m = 5, by the literal algorithm.
TEST(Refinement, CornerSequencesBeginAsTheLiteralOnes) {
  struct Row {
    int grading, steps;
  };
  for (const Row& row : {Row{2, 6}, Row{3, 7}, Row{5, 4}}) {
    const Setting setting{{3, 3, 3}, row.grading, {5, 5, 5}};
    const reference::Setting literal_setting = literal::setting(setting);
    const std::vector<std::int64_t> counts = corner_sequence(setting, row.steps);
    reference::Mesh mesh = reference::initial_mesh(literal_setting);
    for (const std::int64_t count : counts) {
      mesh = literal::after_step(literal_setting, mesh, {Step::Kind::refine, {Point{}}});
      const auto old = std::count_if(mesh.begin(), mesh.end(), [&](const reference::Box& box) {
        return reference::level(literal_setting, box) == 0;
      });
      EXPECT_EQ(count, static_cast<std::int64_t>(mesh.size()) - old) << "m = " << row.grading;
    }
  }
}

// Replay: marks are resolved on the mesh before the step, two marks in one element are one mark, counts are what the
// interface says.
TEST(Replay, CountsMarkedAndSubdividedElements) {
  const Case content = parse_case(
      "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 5\n"
      "refine 1/4 1/4 1/4  1/2 1/2 1/2\nsubdivide 3/2 3/2 3/2  5/2 1/2 1/2\nrefine 1/4 1/4 1/4\n",
      "f");
  Replay replay(content);
  replay.watch_history();
  EXPECT_EQ(replay.subdivided(), Leaves{});
  replay.advance();
  EXPECT_EQ(replay.counts().marked, 1);
  EXPECT_EQ(replay.counts().subdivided, 1);
  const RefinementTree& tree = replay.tree();
  EXPECT_EQ(replay.subdivided(), Leaves{tree.unit_cube({0, 0, 0})});
  replay.advance();
  EXPECT_EQ(replay.counts().marked, 2);
  EXPECT_EQ(replay.counts().subdivided, 2);
  Leaves cubes{tree.unit_cube({1, 1, 1}), tree.unit_cube({2, 0, 0})};
  std::sort(cubes.begin(), cubes.end());
  EXPECT_EQ(replay.subdivided(), cubes);
  replay.advance();
  EXPECT_EQ(replay.counts().marked, 1);
  EXPECT_EQ(replay.counts().subdivided, 58) << "60 as in ClosureCollects..., less the two cubes of the step before";
  EXPECT_EQ(replay.subdivided().size(), 58U);
  EXPECT_EQ(replay.subdivided().front(), tree.node(tree.unit_cube({0, 0, 0})).first_child) << "the mark is the finest";
  EXPECT_EQ(replay.counts().step, 3);
  EXPECT_TRUE(replay.done());
  EXPECT_TRUE(replay.history_admissible());
}

}  // namespace
}  // namespace asts
