#include <algorithm>
#include <array>
#include <numeric>

#include "lib/gen/byte_form.hpp"
#include "lib/mesh/refinement_tree.hpp"
#include "lib/refine/refinement.hpp"

namespace asts::byte_form {

namespace {

constexpr int kFractions = 128;
constexpr int kSimpleFractions = 8;

/// 0, 1/2, 1/3, 2/3, 1/4, 3/4, ...: by denominator, then numerator. There are 128 up to the denominator 20.
const std::array<Coordinate, kFractions>& fractions() {
  static const auto table = [] {
    std::array<Coordinate, kFractions> result;
    std::size_t count = 1;  // the first one is 0
    for (int denominator = 2; denominator <= ByteCaseLimits::max_denominator; ++denominator) {
      for (int numerator = 1; numerator < denominator; ++numerator) {
        if (std::gcd(numerator, denominator) == 1) result.at(count++) = {numerator, denominator};
      }
    }
    return result;
  }();
  return table;
}

// What a byte b of an axis says in b / 4: the first 56 values give p+1 and more, mostly p+1; the others 1 to p.
constexpr std::array kFirstOfExtra{0, 28, 42, 49, 53, 55};
constexpr int kNarrow = 56;

int side_of(int degree, int code) {
  if (code >= kNarrow) return std::min(code - kNarrow + 1, degree);
  const auto next = std::upper_bound(kFirstOfExtra.begin(), kFirstOfExtra.end(), code);
  return degree + static_cast<int>(next - kFirstOfExtra.begin());
}

void keep_limit(Setting& setting, int max_cubes) {
  const auto extra = [&](std::size_t axis) { return setting.domain[axis] - setting.degree[axis]; };
  while (setting.domain[0] * setting.domain[1] * setting.domain[2] > max_cubes) {
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < kDimension; ++axis) {
      if (extra(axis) > extra(longest)) longest = axis;
    }
    --setting.domain[longest];
  }
}

// The number of marks: 1 to 4 in 200 of 256 values, up to 27 in the others, and none in the last.
constexpr int kOftenMarks = 4;
constexpr int kManyMarks = 100;
constexpr int kNoMarks = 127;

int mark_count(int code) {
  if (code == kNoMarks) return 0;
  return code < kManyMarks ? 1 + code % kOftenMarks : code - kManyMarks + 1;
}

std::optional<int> mark_code(std::size_t count) {
  const int marks = static_cast<int>(std::min<std::size_t>(count, kNoMarks));
  if (marks == 0) return kNoMarks;
  if (marks <= kOftenMarks) return marks - 1;
  if (marks < kNoMarks - kManyMarks + 1) return kManyMarks + marks - 1;
  return std::nullopt;
}

Step read_step(Reader& reader, const Setting& setting) {
  const int byte = reader.next();
  Step step;
  step.kind = byte % 2 == 0 ? Step::Kind::refine : Step::Kind::subdivide;
  step.marks.resize(static_cast<std::size_t>(mark_count(byte / 2)));
  for (Point& mark : step.marks) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      mark[axis] = compact(read_coordinate(reader, setting.domain[axis], setting.domain[axis] + 1));
    }
  }
  return step;
}

/// Does a step; false and no change when the mesh would get too large.
bool advance(RefinementTree& tree, const Step& step, int max_elements) {
  std::vector<std::int32_t> leaves;
  for (const Point& mark : step.marks) leaves.push_back(tree.leaf_at(mark));
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  RefinementTree next = tree;
  if (step.kind == Step::Kind::refine) {
    refine(next, leaves);
  } else {
    subdivide_all(next, leaves);
  }
  if (next.element_count() > max_elements) return false;
  tree = std::move(next);
  return true;
}

}  // namespace

std::optional<Coordinate> coordinate_of(const CompactRational& value) {
  if (!value.is_small() || value.denominator() > ByteCaseLimits::max_denominator) return std::nullopt;
  return Coordinate{value.numerator(), value.denominator()};
}

Setting read_setting(Reader& reader, int grading, const ByteCaseLimits& limits) {
  Setting setting;
  setting.grading = grading;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const int byte = reader.next();
    setting.degree[axis] = byte % 4 == 3 ? 5 : 3;
    setting.domain[axis] = side_of(setting.degree[axis], byte / 4);
  }
  keep_limit(setting, limits.max_cubes);
  return setting;
}

std::optional<int> axis_byte(int degree, int side) {
  if (degree != 3 && degree != 5) return std::nullopt;
  const int low = degree == 5 ? 3 : 0;
  if (side <= degree) return low + 4 * (kNarrow + side - 1);
  const auto extra = static_cast<std::size_t>(side - degree - 1);
  if (extra >= kFirstOfExtra.size()) return std::nullopt;
  return low + 4 * kFirstOfExtra[extra];
}

Coordinate read_coordinate(Reader& reader, int side, int count) {
  const int cell = reader.next() % count;
  const int byte = reader.next();
  if (cell == side) return {side, 1};
  const Coordinate& fraction = fractions()[at(byte < kFractions ? byte : byte % kSimpleFractions)];
  return {cell * fraction.denominator + fraction.numerator, fraction.denominator};
}

void write_coordinate(Writer& writer, const Coordinate& coordinate) {
  const auto [numerator, denominator] = coordinate;
  const Coordinate fraction{numerator % denominator, denominator};
  writer.put(static_cast<int>(numerator / denominator % 256));
  const auto place = std::find(fractions().begin(), fractions().end(), fraction);
  writer.put(static_cast<int>(place - fractions().begin()));
}

std::vector<Step> read_steps(Reader& reader, const Setting& setting, const ByteCaseLimits& limits) {
  RefinementTree tree(setting);
  std::vector<Step> steps;
  while (!reader.done() && static_cast<int>(steps.size()) < limits.max_steps) {
    Step step = read_step(reader, setting);
    if (advance(tree, step, limits.max_elements)) steps.push_back(std::move(step));
  }
  return steps;
}

void write_steps(Writer& writer, const std::vector<Step>& steps) {
  for (const Step& step : steps) {
    const auto code = mark_code(step.marks.size());
    if (!code) return writer.put(std::nullopt);
    writer.put(2 * *code + (step.kind == Step::Kind::refine ? 0 : 1));
    for (const Point& mark : step.marks) {
      for (const CompactRational& value : mark) {
        const auto coordinate = coordinate_of(value);
        if (!coordinate) return writer.put(std::nullopt);
        write_coordinate(writer, *coordinate);
      }
    }
  }
}

}  // namespace asts::byte_form
