#include "lib/refine/subdivided_elements.hpp"

#include <gtest/gtest.h>

#include <set>

#include "lib/exact/errors.hpp"
#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/level_formulas.hpp"
#include "lib/refine/replay.hpp"
#include "tests/literal_mesh.hpp"

namespace asts {
namespace {

/// A node of the tree, by its lower corner in units of its sides.
LevelCell cell_of(const RefinementTree& tree, std::int32_t id) {
  LevelCell cell{tree.node(id).level, {}};
  const PerAxis<Rational> side = level_size(tree.setting().grading, cell.level);
  const reference::Box box = literal::box(tree, id);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const Rational index = box.lower[axis] / side[axis];
    EXPECT_EQ(denominator(index), 1);
    cell.index[axis] = static_cast<std::int64_t>(numerator(index));
  }
  return cell;
}

using Cells = std::set<LevelCell>;

Cells subdivided_in(const RefinementTree& tree) {
  Cells cells;
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (tree.node(id).level >= 0 && !tree.is_leaf(id)) cells.insert(cell_of(tree, id));
  }
  return cells;
}

/// One step in both forms. Returns whether more than the marks was subdivided.
bool compare_step(const Step& step, Replay& replay, SubdividedElements& compact) {
  std::vector<LevelCell> marks;
  for (const Point& mark : step.marks) {
    marks.push_back(compact.element_at(mark));
    EXPECT_EQ(marks.back(), cell_of(replay.tree(), replay.tree().leaf_at(mark)));
  }
  const std::vector<LevelCell> closure = compact.refine(marks);
  replay.advance();
  EXPECT_EQ(static_cast<std::int64_t>(closure.size()), replay.counts().subdivided);
  EXPECT_TRUE(std::is_sorted(closure.begin(), closure.end(),
                             [](const LevelCell& a, const LevelCell& b) { return a.level > b.level; }));
  EXPECT_EQ(compact.new_element_count(), replay.tree().new_element_count());
  EXPECT_EQ(Cells(compact.elements().begin(), compact.elements().end()), subdivided_in(replay.tree()));
  return closure.size() > Cells(marks.begin(), marks.end()).size();
}

// Law (1), m = 2, ..., 16.
TEST(SubdividedElements, AgreeWithTheTreeOnRandomSequences) {
  Draw draw(41);
  int grew = 0;
  for (int number = 0; number < 400 && !HasFailure(); ++number) {
    CaseLimits limits;
    limits.max_degree = 5;
    limits.max_grading = 16;
    limits.max_elements = 400;
    limits.max_steps = 9;
    const Case content = random_admissible_case(draw, limits).content;
    SCOPED_TRACE(write_case(content));
    Replay replay(content);
    SubdividedElements compact(setting_of(content));
    for (const Step& step : content.steps) grew += compare_step(step, replay, compact);
  }
  EXPECT_GT(grew, 200);
}

// Two cubes in a row, m = 1000: the first is subdivided, then its last slab is marked; U reaches into the second cube.
TEST(SubdividedElements, ByHand) {
  SubdividedElements compact({{3, 3, 3}, 1000, {2, 1, 1}});
  const Point last{CompactRational(Rational(9999) / 10000), CompactRational(1), CompactRational(0)};
  const LevelCell cube{0, {0, 0, 0}}, slab{1, {999, 0, 0}};
  EXPECT_EQ(compact.element_at(last), cube);
  EXPECT_EQ(compact.refine(std::vector{cube, cube}), std::vector{cube});
  EXPECT_EQ(compact.element_at(last), slab);
  EXPECT_EQ(compact.refine(std::vector{slab}), (std::vector{slab, {0, {1, 0, 0}}}));
  EXPECT_EQ(compact.new_element_count(), 1000 + 1000 + 999);
  EXPECT_EQ(compact.element_at(last), (LevelCell{2, {999, 999, 0}})) << "upper faces belong to the last element";
  EXPECT_EQ(child_of(slab, 1000, 999), (LevelCell{2, {999, 999, 0}}));
}

TEST(SubdividedElements, RejectWhatIsNoElement) {
  SubdividedElements compact({{3, 3, 3}, 2, {1, 1, 1}});
  const LevelCell cube{0, {0, 0, 0}};
  EXPECT_THROW(compact.refine(std::vector{child_of(cube, 2, 0)}), InputError);
  compact.refine(std::vector{cube});
  EXPECT_THROW(compact.refine(std::vector{cube}), InputError);
  EXPECT_THROW(compact.element_at({CompactRational(2), CompactRational(0), CompactRational(0)}), InputError);
}

// m = 10^6: 10^18 cells of an axis fit, 10^24 do not.
TEST(SubdividedElements, RefuseWhatDoesNotFit) {
  SubdividedElements compact({{3, 3, 3}, 1'000'000, {1, 1, 1}});
  for (int level = 0; level <= 9; ++level) {
    const LevelCell origin = compact.element_at(Point{});
    EXPECT_EQ(origin.level, level);
    compact.refine(std::vector{origin});
  }
  EXPECT_THROW(compact.element_at(Point{}), ResourceError) << "level 10";
}

}  // namespace
}  // namespace asts
