#include <array>

#include "fuzz/targets/case_mutator.hpp"
#include "lib/gen/growing_case.hpp"
#include "lib/refine/replay.hpp"

namespace asts::fuzz {

namespace {

using Change = std::optional<Case> (*)(const Case&, Draw&);

/// A step and one of its marks.
struct MarkPlace {
  std::size_t step;
  std::size_t mark;
};

std::optional<MarkPlace> draw_mark(const Case& content, Draw& draw) {
  if (content.steps.empty()) return std::nullopt;
  const std::size_t step = draw.index(content.steps.size());
  if (content.steps[step].marks.empty()) return std::nullopt;
  return MarkPlace{step, draw.index(content.steps[step].marks.size())};
}

std::ptrdiff_t offset(std::size_t place) { return static_cast<std::ptrdiff_t>(place); }

Step::Kind draw_kind(Draw& draw) { return draw.one_in(2) ? Step::Kind::refine : Step::Kind::subdivide; }

std::optional<Case> add_step(const Case& content, Draw& draw) {
  Case result = content;
  const auto place = result.steps.begin() + offset(draw.index(content.steps.size() + 1));
  result.steps.insert(place, Step{draw_kind(draw), {random_point(draw, setting_of(content))}});
  return result;
}

std::optional<Case> remove_step(const Case& content, Draw& draw) {
  if (content.steps.empty()) return std::nullopt;
  Case result = content;
  result.steps.erase(result.steps.begin() + offset(draw.index(content.steps.size())));
  return result;
}

std::optional<Case> swap_steps(const Case& content, Draw& draw) {
  if (content.steps.size() < 2) return std::nullopt;
  Case result = content;
  const std::size_t first = draw.index(content.steps.size() - 1);
  std::swap(result.steps[first], result.steps[first + 1]);
  return result;
}

std::optional<Case> change_kind(const Case& content, Draw& draw) {
  if (content.steps.empty()) return std::nullopt;
  Case result = content;
  Step& step = result.steps[draw.index(content.steps.size())];
  step.kind = step.kind == Step::Kind::refine ? Step::Kind::subdivide : Step::Kind::refine;
  return result;
}

std::optional<Case> add_mark(const Case& content, Draw& draw) {
  if (content.steps.empty()) return std::nullopt;
  Case result = content;
  result.steps[draw.index(content.steps.size())].marks.push_back(random_point(draw, setting_of(content)));
  return result;
}

std::optional<Case> remove_mark(const Case& content, Draw& draw) {
  const auto place = draw_mark(content, draw);
  if (!place) return std::nullopt;
  Case result = content;
  auto& marks = result.steps[place->step].marks;
  marks.erase(marks.begin() + offset(place->mark));
  return result;
}

/// One coordinate elsewhere: one unit or a half on, or anywhere.
std::optional<Case> move_mark(const Case& content, Draw& draw) {
  const auto place = draw_mark(content, draw);
  if (!place) return std::nullopt;
  Case result = content;
  const std::size_t axis = draw.index(kDimension);
  CompactRational& value = result.steps[place->step].marks[place->mark][axis];
  Rational moved = random_point(draw, setting_of(content))[axis].value();
  if (!draw.one_in(3)) moved = value.value() + Rational(draw.one_in(2) ? 1 : -1) / draw.between(1, 2);
  if (moved < 0 || moved > content.domain[axis]) return std::nullopt;
  value = CompactRational(moved);
  return result;
}

/// Behind a step, another one for a child of an element that it marks.
std::optional<Case> go_deeper(const Case& content, Draw& draw) {
  const auto place = draw_mark(content, draw);
  if (!place) return std::nullopt;
  Replay replay(content);
  for (std::size_t i = 0; i < place->step; ++i) replay.advance();
  const RefinementTree& tree = replay.tree();
  const std::int32_t leaf = tree.leaf_at(content.steps[place->step].marks[place->mark]);
  Point child = lower_corner(tree, leaf);
  const Axis axis = tree.split_axis(leaf);
  const AxisGrid& grid = tree.grid(axis);
  const RankInterval extent = tree.extent(leaf, axis);
  const Rational lower = grid.coordinate(grid.line_of_rank(extent.lower));
  const Rational length = grid.coordinate(grid.line_of_rank(extent.upper)) - lower;
  child[at(axis)] = CompactRational(lower + length * draw.between(0, content.grading - 1) / content.grading);
  Case result = content;
  const Step::Kind kind = draw.one_in(4) ? draw_kind(draw) : content.steps[place->step].kind;
  result.steps.insert(result.steps.begin() + offset(place->step) + 1, Step{kind, {child}});
  return result;
}

/// Likely ones stand more than once.
constexpr std::array<Change, 14> kChanges{add_step,  add_step,    remove_step, swap_steps, change_kind,
                                          add_mark,  remove_mark, move_mark,   move_mark,  move_mark,
                                          go_deeper, go_deeper,   go_deeper,   add_mark};

}  // namespace

std::optional<Case> with_other_steps(const Case& content, Draw& draw) {
  return kChanges[draw.index(kChanges.size())](content, draw);
}

}  // namespace asts::fuzz
