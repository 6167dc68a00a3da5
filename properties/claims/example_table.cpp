#include "properties/claims/example_table.hpp"

#include <algorithm>
#include <array>

#include "lib/exact/errors.hpp"
#include "lib/refine/refinement.hpp"
#include "lib/refine/replay.hpp"

namespace asts {

namespace {

constexpr std::array kPrinted{ExampleRow{2, 12, 10728}, ExampleRow{4, 6, 3175}, ExampleRow{16, 3, 1030}};

/// The sides' reciprocal when the refinement ends.
constexpr int kParts = 16;

const ExampleRow* printed_row(int grading) {
  const auto row =
      std::find_if(kPrinted.begin(), kPrinted.end(), [&](const ExampleRow& r) { return r.grading == grading; });
  return row == kPrinted.end() ? nullptr : &*row;
}

bool is_example_setting(const Setting& setting) {
  const Setting example = example_setting(setting.grading);
  return printed_row(setting.grading) && setting.degree == example.degree && setting.domain == example.domain;
}

bool small_enough(const RefinementTree& tree, std::int32_t corner) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree.grid(axis);
    if (grid.coordinate(grid.line_of_rank(tree.extent(corner, axis).upper)) * kParts > 1) return false;
  }
  return true;
}

std::int32_t corner_of(const RefinementTree& tree) { return tree.leaf_at(Point{}); }

/// The step marks the corner element and nothing else.
bool marks_corner(const Step& step, const RefinementTree& tree) {
  return step.kind == Step::Kind::refine && !step.marks.empty() &&
         std::all_of(step.marks.begin(), step.marks.end(),
                     [&](const Point& mark) { return tree.leaf_at(mark) == corner_of(tree); });
}

}  // namespace

Setting example_setting(int grading) { return {{3, 3, 3}, grading, {4, 5, 8}}; }

ExampleRow run_example(const Setting& setting) {
  RefinementTree tree(setting);
  ExampleRow row{setting.grading, 0, 0};
  for (; !small_enough(tree, corner_of(tree)); ++row.steps) refine(tree, std::vector{corner_of(tree)});
  row.new_elements = tree.new_element_count();
  return row;
}

Trial judge_example(const ExampleRow& found) {
  const ExampleRow* printed = printed_row(found.grading);
  require(printed != nullptr, "the table of Example 2.10 has m = 2, 4, 16");
  if (found.steps == printed->steps && found.new_elements == printed->new_elements) return {Verdict::holds(), 1};
  return {Verdict::violated(ClaimWitness{"example-table",
                                         "the numbers are not those of the table",
                                         {{"grading", std::int64_t{found.grading}},
                                          {"refinement steps", found.steps},
                                          {"printed steps", printed->steps},
                                          {"new elements", found.new_elements},
                                          {"printed new elements", printed->new_elements}}}),
          1};
}

Trial try_example(const Case& sequence) {
  const Setting setting = setting_of(sequence);
  const Trial other{Verdict::not_applicable("not one of the three sequences of Example 2.10")};
  if (!is_example_setting(setting)) return other;
  Replay replay(sequence);
  while (!replay.done()) {
    const Step& step = sequence.steps[static_cast<std::size_t>(replay.counts().step)];
    if (small_enough(replay.tree(), corner_of(replay.tree())) || !marks_corner(step, replay.tree())) return other;
    replay.advance();
  }
  if (!small_enough(replay.tree(), corner_of(replay.tree()))) return other;
  return judge_example({setting.grading, replay.counts().step, replay.tree().new_element_count()});
}

Trial try_example_alone(Extent) {
  Trial trial;
  for (const ExampleRow& printed : kPrinted) {
    const Trial one = judge_example(run_example(example_setting(printed.grading)));
    ++trial.met;
    if (one.verdict.outcome != Outcome::holds) return {one.verdict, trial.met};
  }
  return trial;
}

}  // namespace asts
