#include "lib/spline/rectangles.hpp"

#include <algorithm>
#include <bit>

namespace asts {

namespace {

constexpr std::size_t kBits = 64;

/// Keeps the rectangles that meet the bounding box of another list.
std::vector<Rectangle> near(const std::vector<Rectangle>& rectangles, const std::vector<Rectangle>& others) {
  std::vector<Rectangle> result;
  if (others.empty()) return result;
  Rectangle hull = others.front();
  for (const Rectangle& other : others) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      hull.lower[axis] = std::min(hull.lower[axis], other.lower[axis]);
      hull.upper[axis] = std::max(hull.upper[axis], other.upper[axis]);
    }
  }
  for (Rectangle rectangle : rectangles) {
    if (!meet(rectangle, hull)) continue;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      rectangle.lower[axis] = std::max(rectangle.lower[axis], hull.lower[axis]);
      rectangle.upper[axis] = std::min(rectangle.upper[axis], hull.upper[axis]);
    }
    result.push_back(rectangle);
  }
  return result;
}

/// Runs of ones in a row of words, as [first, last] bit numbers.
std::vector<std::array<std::size_t, 2>> runs_of_ones(const std::vector<std::uint64_t>& row) {
  std::vector<std::array<std::size_t, 2>> runs;
  for (std::size_t word = 0; word < row.size(); ++word) {
    std::uint64_t rest = row[word];
    while (rest != 0) {
      const auto begin = static_cast<std::size_t>(std::countr_zero(rest));
      const auto length = static_cast<std::size_t>(std::countr_one(rest >> begin));
      const std::size_t first = word * kBits + begin;
      if (!runs.empty() && runs.back()[1] + 1 == first) {
        runs.back()[1] = first + length - 1;
      } else {
        runs.push_back({first, first + length - 1});
      }
      if (begin + length == kBits) break;
      rest &= ~std::uint64_t{0} << (begin + length);
    }
  }
  return runs;
}

}  // namespace

void UnionIntersection::choose_grid(const std::vector<Rectangle>& one, const std::vector<Rectangle>& other) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    ends_[axis].clear();
    for (const auto* list : {&one, &other}) {
      for (const Rectangle& rectangle : *list) {
        ends_[axis].push_back(rectangle.lower[axis]);
        ends_[axis].push_back(rectangle.upper[axis]);
      }
    }
    std::sort(ends_[axis].begin(), ends_[axis].end());
    ends_[axis].erase(std::unique(ends_[axis].begin(), ends_[axis].end()), ends_[axis].end());
  }
  words_a_row_ = (2 * ends_[1].size() + kBits - 1) / kBits;
}

std::size_t UnionIntersection::place(std::size_t axis, std::int32_t end) const {
  const auto found = std::lower_bound(ends_[axis].begin(), ends_[axis].end(), end);
  return 2 * static_cast<std::size_t>(found - ends_[axis].begin());
}

void UnionIntersection::paint(const std::vector<Rectangle>& rectangles, Words& words) const {
  words.assign(2 * ends_[0].size() * words_a_row_, 0);
  for (const Rectangle& rectangle : rectangles) {
    const std::size_t first = place(1, rectangle.lower[1]);
    const std::size_t last = place(1, rectangle.upper[1]);
    const std::size_t last_row = place(0, rectangle.upper[0]);
    for (std::size_t row = place(0, rectangle.lower[0]); row <= last_row; ++row) {
      std::uint64_t* const line = words.data() + row * words_a_row_;
      for (std::size_t word = first / kBits; word <= last / kBits; ++word) {
        std::uint64_t mask = ~std::uint64_t{0};
        if (word == first / kBits) mask &= ~std::uint64_t{0} << first % kBits;
        if (word == last / kBits) mask &= ~std::uint64_t{0} >> (kBits - 1 - last % kBits);
        line[word] |= mask;
      }
    }
  }
}

std::array<std::int32_t, 2> UnionIntersection::lattice_range(std::size_t axis, std::size_t first,
                                                             std::size_t last) const {
  const std::vector<std::int32_t>& ends = ends_[axis];
  return {first % 2 == 0 ? ends[first / 2] : ends[first / 2] + 1,
          last % 2 == 0 ? ends[last / 2] : ends[last / 2 + 1] - 1};
}

std::vector<Rectangle> UnionIntersection::gather() const {
  struct Open {
    std::array<std::size_t, 2> run;
    std::size_t first_row;
  };
  std::vector<Rectangle> result;
  std::vector<Open> open;
  const auto close = [&](const Open& rectangle, std::size_t last_row) {
    const auto rows = lattice_range(0, rectangle.first_row, last_row);
    const auto columns = lattice_range(1, rectangle.run[0], rectangle.run[1]);
    if (rows[0] <= rows[1] && columns[0] <= columns[1])
      result.push_back({{rows[0], columns[0]}, {rows[1], columns[1]}});
  };
  Words row(words_a_row_);
  const std::size_t row_count = 2 * ends_[0].size();
  for (std::size_t r = 0; r <= row_count; ++r) {
    for (std::size_t word = 0; word < words_a_row_; ++word) {
      const std::size_t i = r * words_a_row_ + word;
      row[word] = r < row_count ? one_[i] & other_[i] : 0;
    }
    std::vector<Open> next;
    for (const auto& run : runs_of_ones(row)) {
      const auto same = std::find_if(open.begin(), open.end(), [&](const Open& above) { return above.run == run; });
      next.push_back({run, same == open.end() ? r : same->first_row});
    }
    for (const Open& above : open) {
      const bool goes_on =
          std::any_of(next.begin(), next.end(), [&](const Open& below) { return below.run == above.run; });
      if (!goes_on) close(above, r - 1);
    }
    open = std::move(next);
  }
  std::sort(result.begin(), result.end(), [](const Rectangle& a, const Rectangle& b) { return a.lower < b.lower; });
  return result;
}

std::vector<Rectangle> UnionIntersection::of(const std::vector<Rectangle>& one, const std::vector<Rectangle>& other) {
  const std::vector<Rectangle> second = near(other, one);
  const std::vector<Rectangle> first = near(one, second);
  if (first.empty()) return {};
  choose_grid(first, second);
  paint(first, one_);
  paint(second, other_);
  return gather();
}

}  // namespace asts
