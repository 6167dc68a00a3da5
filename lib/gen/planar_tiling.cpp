#include "lib/gen/planar_tiling.hpp"

#include <algorithm>
#include <set>

namespace asts {

namespace {

using Box = PlanarTiling::Box;

/// The intervals between ascending places.
std::vector<std::array<int, 2>> intervals(const std::set<int>& places) {
  std::vector<std::array<int, 2>> result;
  for (auto place = places.begin(); std::next(place) != places.end(); ++place) {
    result.push_back({*place, *std::next(place)});
  }
  return result;
}

ElementLine as_element(const Box& box, const std::array<int, 2>& frame, int parts, int layer) {
  ElementLine line;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    line.lower[axis] = CompactRational(Rational(box.lower[axis]) / parts + frame[axis]);
    line.upper[axis] = CompactRational(Rational(box.upper[axis]) / parts + frame[axis]);
  }
  line.lower[2] = CompactRational(Rational(layer));
  line.upper[2] = CompactRational(Rational(layer + 1));
  return line;
}

}  // namespace

PlanarTiling::PlanarTiling(std::array<int, 2> squares, int parts) : squares_(squares), parts_(parts) {
  for (int j = 0; j < squares[1]; ++j) {
    for (int i = 0; i < squares[0]; ++i) {
      boxes_.push_back({{i * parts, j * parts}, {(i + 1) * parts, (j + 1) * parts}});
    }
  }
}

void PlanarTiling::cut(std::size_t box, std::size_t axis, int place) {
  Box upper = boxes_[box];
  boxes_[box].upper[axis] = upper.lower[axis] = place;
  boxes_.push_back(upper);
}

void PlanarTiling::cut_line(std::size_t axis, int place, int begin, int end) {
  const std::size_t count = boxes_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Box& box = boxes_[i];
    const bool beside = box.upper[1 - axis] <= begin || end <= box.lower[1 - axis];
    if (!beside && box.lower[axis] < place && place < box.upper[axis]) cut(i, axis, place);
  }
}

Case PlanarTiling::extruded(const PerAxis<int>& degree) const {
  std::vector<Box> all = boxes_;
  std::array<int, 2> frame;
  for (std::size_t axis = 0; axis < 2; ++axis) frame[axis] = (degree[axis] + 1) / 2;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const int length = squares_[axis] * parts_;
    // along this axis the frame is uniform; across it, lines that end on the region's sides run on
    for (int unit = 0; unit < frame[axis]; ++unit) {
      for (const int begin : {-(unit + 1) * parts_, length + unit * parts_}) {
        std::set<int> places;
        for (const Box& box : boxes_) {
          const bool beside = begin < 0 ? box.lower[axis] == 0 : box.upper[axis] == length;
          if (beside) places.insert({box.lower[1 - axis], box.upper[1 - axis]});
        }
        for (int corner = 1; axis == 0 && corner <= frame[1]; ++corner) {
          places.insert({-corner * parts_, (squares_[1] + corner) * parts_});
        }
        for (const auto& [lower, upper] : intervals(places)) {
          Box box;
          box.lower[axis] = begin;
          box.upper[axis] = begin + parts_;
          box.lower[1 - axis] = lower;
          box.upper[1 - axis] = upper;
          all.push_back(box);
        }
      }
    }
  }
  Case result{degree, 2, {squares_[0] + 2 * frame[0], squares_[1] + 2 * frame[1], degree[2] + 1}, {}, true, {}};
  for (int layer = 0; layer < result.domain[2]; ++layer) {
    for (const Box& box : all) result.elements.push_back(as_element(box, frame, parts_, layer));
  }
  return result;
}

PlanarTiling halved_squares(std::array<int, 2> squares, const std::vector<int>& ways) {
  PlanarTiling tiling(squares, 2);
  for (std::size_t square = 0; square < ways.size(); ++square) {
    const int way = ways[square];
    if (way == 0) continue;
    const std::size_t axis = way <= 3 ? 0 : 1;  // 1..3 and 4..6: two halves, one of them halved; 7: four quarters
    const std::array<int, 2> lower = tiling.boxes()[square].lower;
    const std::size_t other_half = tiling.boxes().size();
    tiling.cut(square, axis, lower[axis] + 1);
    const bool first = way == 2 || way == 5 || way == 7;
    const bool second = way == 3 || way == 6 || way == 7;
    // way 7 came with axis 1: the halves are cut along axis 0
    if (first) tiling.cut(square, 1 - axis, lower[1 - axis] + 1);
    if (second) tiling.cut(other_half, 1 - axis, lower[1 - axis] + 1);
  }
  return tiling;
}

PlanarTiling random_planar_tiling(Draw& draw, std::array<int, 2> squares) {
  PlanarTiling tiling(squares, draw.choose(std::vector{2, 3, 4}));
  const int count = squares[0] * squares[1];
  for (int cuts = draw.between(1, count + count / 2); cuts > 0; --cuts) {
    const std::size_t box = draw.index(tiling.boxes().size());
    const std::size_t axis = draw.index(2);
    const int lower = tiling.boxes()[box].lower[axis];
    const int upper = tiling.boxes()[box].upper[axis];
    if (upper - lower >= 2) tiling.cut(box, axis, draw.between(lower + 1, upper - 1));
  }
  return tiling;
}

}  // namespace asts
