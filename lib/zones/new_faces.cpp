#include "lib/zones/new_faces.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
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

namespace {

/// Fills a range, going away from the middle entry, with the nearest of the old entries and the new ones. All are given
/// in the order in which `nearer` compares. REQUIRES: old entries enough for the range.
template <typename Old, typename New, typename Result, typename Nearer>
void take_nearest(std::int32_t middle, Old old, New entry, New end, Result out, Result out_end, Nearer nearer) {
  for (std::int32_t last = middle; out != out_end; last = *out++) {
    while (entry != end && !nearer(last, *entry)) ++entry;
    *out = entry != end && nearer(*entry, *old) ? *entry++ : *old++;
  }
}

}  // namespace

void insert_entries(std::span<const std::int32_t> old, std::span<const std::int32_t> entries,
                    std::vector<std::int32_t>& result) {
  const std::size_t reach = old.size() / 2;
  const auto below = old.first(reach);
  const auto above = old.subspan(reach + 1);
  result.assign(old.begin(), old.end());
  const auto out = result.begin() + static_cast<std::ptrdiff_t>(reach);
  take_nearest(old[reach], below.rbegin(), entries.rbegin(), entries.rend(), std::make_reverse_iterator(out),
               result.rend(), std::greater());
  take_nearest(old[reach], above.begin(), entries.begin(), entries.end(), out + 1, result.end(), std::less());
}

}  // namespace asts
