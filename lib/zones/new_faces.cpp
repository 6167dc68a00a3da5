#include "lib/zones/new_faces.hpp"

#include <algorithm>
#include <numeric>

namespace asts {

namespace {

/// The places, from `begin` to before `end`, of those of some ascending ranks that lie in a closed interval.
struct Places {
  std::size_t begin;
  std::size_t end;
};

Places places_in(std::span<const std::int32_t> ranks, const RankInterval& side) {
  const auto begin = std::lower_bound(ranks.begin(), ranks.end(), side.lower);
  const auto end = std::upper_bound(begin, ranks.end(), side.upper);
  return {static_cast<std::size_t>(begin - ranks.begin()), static_cast<std::size_t>(end - ranks.begin())};
}

}  // namespace

void NewFaces::assign(const RefinementTree& tree, Axis axis, std::span<const std::int32_t> elements,
                      std::span<const std::int32_t> rows, std::span<const std::int32_t> columns) {
  columns_ = columns.size();
  crossings_.clear();
  begin_.assign(rows.size() * columns.size() + 1, 0);
  for (const std::int32_t element : elements) {
    const Places of_rows = places_in(rows, tree.extent(element, axis_after(axis)));
    const Places of_columns = places_in(columns, tree.extent(element, axis_after(axis_after(axis))));
    const std::int32_t first = tree.first_child(element);
    for (std::int32_t child = first + 1; child < first + tree.child_count(element); ++child) {
      const std::int32_t rank = tree.extent(child, axis).lower;
      for (std::size_t row = of_rows.begin; row < of_rows.end; ++row) {
        for (std::size_t column = of_columns.begin; column < of_columns.end; ++column) {
          crossings_.push_back({row * columns_ + column, rank});
        }
      }
    }
  }
  sort_by_line();
}

/// A counting sort by lines, then the few entries of each.
void NewFaces::sort_by_line() {
  for (const Crossing& crossing : crossings_) ++begin_[crossing.line];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());  // where each line ends
  entries_.resize(crossings_.size());
  for (const Crossing& crossing : crossings_) entries_[--begin_[crossing.line]] = crossing.rank;
  const auto place = [&](std::size_t i) { return entries_.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t line = 0; line + 1 < begin_.size(); ++line) std::sort(place(begin_[line]), place(begin_[line + 1]));
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
