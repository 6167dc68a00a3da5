#include "tests/minimize/start_meshes.hpp"

#include <algorithm>
#include <array>

#include "lib/gen/growing_case.hpp"
#include "lib/gen/random_boxes.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/refine/replay.hpp"
#include "properties/claims/marked_sequence.hpp"

namespace asts {

namespace {

constexpr int kMostRefusals = 60;
constexpr int kLargeGrading = 100;

std::int64_t cubes_of(const Setting& setting) {
  return std::int64_t{setting.domain[0]} * setting.domain[1] * setting.domain[2];
}

Replay replayed(const Case& test_case) {
  Replay replay(test_case);
  while (!replay.done()) replay.advance();
  return replay;
}

std::int64_t element_count(const Case& test_case) {
  return test_case.explicit_mesh ? static_cast<std::int64_t>(test_case.elements.size())
                                 : replayed(test_case).tree().element_count();
}

bool sides_fit(const Setting& setting) {
  return std::all_of(setting.domain.begin(), setting.domain.end(), [](int side) { return side <= kLargestStartSide; });
}

/// Up to four marks: anywhere, at marks of other steps, or all at one place.
Step random_step(Draw& draw, const Case& test_case, const StartLimits& limits) {
  Step step;
  const bool bare = limits.steps == StartSteps::mixed && !draw.one_in(3);
  step.kind = bare ? Step::Kind::subdivide : Step::Kind::refine;
  for (int marks = draw.one_in(2) ? 1 : draw.between(2, 4); marks > 0; --marks) {
    step.marks.push_back(random_point(draw, setting_of(test_case)));
    if (test_case.steps.empty() || draw.one_in(2)) continue;
    step.marks.back() = draw.choose(draw.choose(test_case.steps).marks);
  }
  return step;
}

/// Of a start that is drawn as such, or of a step of one of the generators' biases.
Case unbiased_steps(Draw& draw, const Setting& setting, const StartLimits& limits) {
  Case result{setting.degree, setting.grading, setting.domain, {}, false, {}};
  for (int steps = draw.between(1, 12); steps > 0; --steps) {
    result.steps.push_back(random_step(draw, result, limits));
    if (element_count(result) <= limits.max_elements) continue;
    result.steps.pop_back();
    break;
  }
  return result;
}

Bias random_bias(Draw& draw, StartSteps steps) {
  std::vector<Bias> biases{Bias::marks_anywhere, Bias::marks_clustered, Bias::marks_corner,
                           Bias::marks_deep,     Bias::marks_edge,      Bias::marks_face};
  if (steps == StartSteps::mixed) {
    for (const Bias bias : all_biases()) {
      const bool bare = bias >= Bias::bare_scattered && bias <= Bias::bare_in_frame;
      if (bare || (bias >= Bias::bare_smaller_patch && bias <= Bias::region_plane)) biases.push_back(bias);
    }
  }
  return draw.choose(biases);
}

/// As many axes as drawn with the p+1 cubes that leave one coordinate to the active region.
void make_region_small(Draw& draw, Setting& setting) {
  std::vector<std::size_t> axes{0, 1, 2};
  draw.shuffle(axes);
  for (int thin = draw.between(0, 2); thin > 0; --thin) {
    const std::size_t axis = axes[static_cast<std::size_t>(thin)];
    setting.domain[axis] = std::min(setting.domain[axis], setting.degree[axis] + 1);
  }
}

}  // namespace

std::int64_t size_of(const Case& test_case) {
  if (test_case.explicit_mesh) return element_count(test_case) - cubes_of(setting_of(test_case));
  if (test_case.grading >= kLargeGrading && refines_only(test_case)) {
    return static_cast<std::int64_t>(follow_narrowly(test_case).subdivided.elements().size());
  }
  return (element_count(test_case) - cubes_of(setting_of(test_case))) / (test_case.grading - 1);
}

Setting start_setting(Draw& draw, const StartLimits& limits) {
  const bool high = draw.one_in(3);
  const CaseLimits general{
      high ? limits.max_degree : 3, limits.max_grading, kLargestStartSide, limits.max_cubes, limits.max_elements, 12};
  Setting setting = random_setting(draw, general);
  setting.grading = draw.between(limits.least_grading, limits.max_grading);
  make_region_small(draw, setting);
  return setting;
}

Case random_steps(Draw& draw, const StartLimits& limits) {
  if (draw.one_in(2)) return unbiased_steps(draw, start_setting(draw, limits), limits);
  const CaseLimits general{3, limits.max_grading, kLargestStartSide, limits.max_cubes, limits.max_elements, 12};
  while (true) {
    const Bias bias = random_bias(draw, limits.steps);
    Setting setting = setting_for(draw, general, bias);
    setting.grading = std::max(setting.grading, limits.least_grading);
    if (sides_fit(setting)) return random_case_in(draw, setting, general, bias).content;
  }
}

std::optional<Case> with_more_steps(Draw& draw, Case test_case, std::int64_t size, const StartLimits& limits,
                                    const Keeps& keeps) {
  int refusals = 0;
  while (size_of(test_case) < size && refusals < kMostRefusals) {
    Case next = test_case;
    Step step = random_step(draw, test_case, limits);
    if (!next.steps.empty() && draw.one_in(3)) {
      std::vector<Point>& marks = next.steps[draw.index(next.steps.size())].marks;
      marks.insert(marks.begin() + static_cast<std::ptrdiff_t>(draw.index(marks.size() + 1)), step.marks.front());
    } else {
      next.steps.insert(next.steps.begin() + static_cast<std::ptrdiff_t>(draw.index(next.steps.size() + 1)), step);
    }
    const bool kept = element_count(next) <= limits.max_elements && keeps(next);
    refusals = kept ? 0 : refusals + 1;
    if (kept) test_case = std::move(next);
  }
  if (refusals == kMostRefusals) return std::nullopt;
  return test_case;
}

Case as_boxes(Draw& draw, const Case& test_case) {
  const Replay replay = replayed(test_case);
  const Mesh mesh = mesh_of(replay.tree());
  Case result{test_case.degree, test_case.grading, test_case.domain, {}, true, {}};
  for (const Box& element : mesh.elements) {
    ElementLine line;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      line.lower[at(axis)] = CompactRational(mesh.coordinate(axis, element.lower[at(axis)]));
      line.upper[at(axis)] = CompactRational(mesh.coordinate(axis, element.upper[at(axis)]));
    }
    result.elements.push_back(line);
  }
  draw.shuffle(result.elements);
  return result;
}

namespace {

/// Whether boxes have a common interior along all axes but one.
bool in_row(const ElementLine& one, const ElementLine& other, std::size_t axis) {
  for (std::size_t across = 0; across < kDimension; ++across) {
    if (across == axis) continue;
    if (one.upper[across].value() <= other.lower[across].value()) return false;
    if (other.upper[across].value() <= one.lower[across].value()) return false;
  }
  return true;
}

/// A plane through one box, and in every other case through all boxes that stand in a row with it.
void cut_somewhere(Draw& draw, std::vector<ElementLine>& boxes) {
  const std::size_t axis = draw.index(kDimension);
  const std::size_t row = (axis + 1 + draw.index(kDimension - 1)) % kDimension;
  const ElementLine first = boxes[draw.index(boxes.size())];
  const bool all = draw.one_in(2);
  const Rational place = random_between(draw, first.lower[axis].value(), first.upper[axis].value());
  for (std::size_t i = 0, count = boxes.size(); i < count; ++i) {
    if (!(boxes[i] == first) && !(all && in_row(boxes[i], first, row))) continue;
    if (boxes[i].lower[axis].value() >= place || boxes[i].upper[axis].value() <= place) continue;
    ElementLine upper = boxes[i];
    boxes[i].upper[axis] = upper.lower[axis] = CompactRational(place);
    boxes.push_back(upper);
  }
}

}  // namespace

std::optional<Case> with_more_cuts(Draw& draw, Case test_case, std::int64_t size, const Keeps& keeps) {
  int refusals = 0;
  while (size_of(test_case) < size && refusals < kMostRefusals) {
    Case next = test_case;
    cut_somewhere(draw, next.elements);
    const bool kept = keeps(next);
    refusals = kept ? 0 : refusals + 1;
    if (kept) test_case = std::move(next);
  }
  if (refusals == kMostRefusals) return std::nullopt;
  draw.shuffle(test_case.elements);
  return test_case;
}

}  // namespace asts
