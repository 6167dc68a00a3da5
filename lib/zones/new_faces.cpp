#include "lib/zones/new_faces.hpp"

#include <algorithm>
#include <numeric>

namespace asts {

void NewFaces::assign(const RefinementTree& tree, Axis axis, std::span<const std::int32_t> elements,
                      std::span<const std::int32_t> rows, std::span<const std::int32_t> columns) {
  const auto places = [](std::span<const std::int32_t> ranks, const RankInterval& side) {
    const auto begin = std::lower_bound(ranks.begin(), ranks.end(), side.lower);
    const auto end = std::upper_bound(begin, ranks.end(), side.upper);
    return std::pair{static_cast<std::size_t>(begin - ranks.begin()), static_cast<std::size_t>(end - ranks.begin())};
  };
  columns_ = columns.size();
  crossings_.clear();
  begin_.assign(rows.size() * columns.size() + 1, 0);
  for (const std::int32_t element : elements) {
    const auto [first_row, last_row] = places(rows, tree.extent(element, axis_after(axis)));
    const auto [first_column, last_column] = places(columns, tree.extent(element, axis_after(axis_after(axis))));
    const std::int32_t child = tree.first_child(element);
    for (std::int32_t i = 1; i < tree.child_count(element); ++i) {
      const std::int32_t rank = tree.extent(child + i, axis).lower;
      for (std::size_t row = first_row; row < last_row; ++row) {
        for (std::size_t column = first_column; column < last_column; ++column) {
          crossings_.push_back({row * columns_ + column, rank});
          ++begin_[row * columns_ + column + 1];
        }
      }
    }
  }
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  entries_.resize(crossings_.size());
  for (std::size_t i = crossings_.size(); i-- > 0;) {  // from the ends of the lines to where they begin
    entries_[--begin_[crossings_[i].line + 1]] = crossings_[i].rank;
  }
  // begin_[line + 1] is now where the line begins
  std::move(begin_.begin() + 1, begin_.end(), begin_.begin());
  begin_.back() = entries_.size();
  for (std::size_t line = 0; line + 1 < begin_.size(); ++line) {
    std::sort(entries_.begin() + static_cast<std::ptrdiff_t>(begin_[line]),
              entries_.begin() + static_cast<std::ptrdiff_t>(begin_[line + 1]));
  }
}

void insert_entries(std::span<const std::int32_t> old, std::span<const std::int32_t> entries,
                    std::vector<std::int32_t>& result) {
  const std::size_t reach = old.size() / 2;
  const std::int32_t middle = old[reach];
  result.resize(old.size());
  result[reach] = middle;
  std::size_t next = reach;  // old entries from here on are not below, or not above, the last one taken
  auto below = std::lower_bound(entries.begin(), entries.end(), middle);
  for (std::size_t i = reach; i-- > 0;) {
    while (below != entries.begin() && *(below - 1) >= result[i + 1]) --below;
    if (below != entries.begin() && *(below - 1) > old[next - 1]) {
      result[i] = *--below;
    } else {
      result[i] = old[--next];
    }
  }
  next = reach;
  auto above = std::upper_bound(entries.begin(), entries.end(), middle);
  for (std::size_t i = reach + 1; i < old.size(); ++i) {
    while (above != entries.end() && *above <= result[i - 1]) ++above;
    if (above != entries.end() && *above < old[next + 1]) {
      result[i] = *above++;
    } else {
      result[i] = old[++next];
    }
  }
}

}  // namespace asts
