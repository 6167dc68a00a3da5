#include "lib/zones/zone_check.hpp"

#include <algorithm>
#include <numeric>

namespace asts {

namespace {

constexpr std::size_t kLines = ZoneAxis::kMostLines;

}  // namespace

ZoneCheck::ZoneCheck(const RefinementTree& tree, const std::vector<VectorStore>& stores, const ZoneLimits& limits)
    : tree_(&tree), limits_(limits), stores_(&stores) {
  axes_.reserve(kDimension);
  for (const int degree : tree.setting().degree) axes_.emplace_back(degree);
}

void ZoneCheck::begin(const RankBox& box) {
  nodes_.clear();
  asked_.clear();
  for (Axis axis = 0; axis < kDimension; ++axis) axes_[at(axis)].begin(box[axis]);
}

ZoneCheck::Cut ZoneCheck::number_lines() {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const std::int32_t rank = axes_[at(axis)].number_lines((*stores_)[at(axis)], tree_->grid(axis),
                                                           active_range(*tree_, axis), limits_.lines);
    if (rank >= 0) return {axis, rank};
  }
  return {};
}

Proven ZoneCheck::decide() {
  Proven proven;
  int irregular = 0;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    irregular_[at(axis)] = axes_[at(axis)].find_failures();
    irregular += irregular_[at(axis)] ? 1 : 0;
    axes_[at(axis)].forget_factors();
  }
  for (Axis axis = kDimension - 1; axis >= 0; --axis) {
    const bool pairs = irregular_[at(axis)] && irregular_[at(axis_after(axis))];
    const bool painted = irregular_[at(axis)] && irregular > 1;
    if (axis == 0 || pairs || painted) group_by(axis);
    if (pairs) proven.dual_compatible = proven.dual_compatible && compatible(axis);
    if (painted) paint(axis);
  }
  proven.dual_basis = dual_basis();  // with the groups of axis 0
  for (Axis axis = 0; axis < kDimension; ++axis) {
    if (irregular_[at(axis)] && irregular_[at(axis_after(axis))] && regions_meet(axis))
      proven.analysis_suitable = false;
  }
  return proven;
}

/// Groups the nodes by their vectors along an axis and the next one.
void ZoneCheck::group_by(Axis axis) {
  columns_.clear();
  rows_.clear();
  seconds_.clear();
  group_by(axis, nodes_, row_);
  if (asked_.size() == nodes_.size()) {
    asked_row_ = row_;
  } else {
    group_by(axis, asked_, asked_row_);
  }
}

/// Counting sorts by one vector after the other.
void ZoneCheck::group_by(Axis axis, const std::vector<PerAxis<std::int32_t>>& nodes,
                         std::vector<std::int32_t>& row_of) {
  order_.resize(nodes.size());
  std::iota(order_.begin(), order_.end(), 0);
  for (const Axis by : {axis_after(axis_after(axis)), axis_after(axis), axis}) {
    begin_.assign(axes_[at(by)].size() + 1, 0);
    for (const auto& node : nodes) ++begin_[at(node[at(by)]) + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    sorted_.resize(nodes.size());
    for (const std::int32_t node : order_) sorted_[begin_[at(nodes[at(node)][at(by)])]++] = node;
    order_.swap(sorted_);
  }
  row_of.assign(axes_[at(axis)].size(), -1);
  std::vector<std::int32_t> row;
  std::vector<std::int32_t> seconds;
  for (std::size_t i = 0; i < order_.size();) {
    const std::int32_t first = nodes[at(order_[i])][at(axis)];
    row.assign(1, 0);
    seconds.clear();
    while (i < order_.size() && nodes[at(order_[i])][at(axis)] == first) {
      const std::int32_t second = nodes[at(order_[i])][at(axis_after(axis))];
      const std::size_t begin = i;
      for (; i < order_.size(); ++i) {
        const PerAxis<std::int32_t>& node = nodes[at(order_[i])];
        if (node[at(axis)] != first || node[at(axis_after(axis))] != second) break;
        sorted_[i] = node[at(axis_after(axis_after(axis)))];
      }
      seconds.push_back(second);
      row.push_back(columns_.intern(std::span(sorted_).subspan(begin, i - begin)));
    }
    row.front() = seconds_.intern(seconds);
    row_of[at(first)] = rows_.intern(row);
  }
}

/// The pairs of two lists of vectors that are in a relation, found once for each pair of lists.
template <typename Relation>
const ZoneCheck::Pairs& ZoneCheck::related(std::int32_t one, std::int32_t other, const Relation& relation) {
  const std::int32_t place = known_pairs_.get(one, other, [&] {
    Pairs pairs;
    const auto first = seconds_[one];
    const auto second = seconds_[other];
    for (std::size_t i = 0; i < first.size(); ++i) {
      for (std::size_t j = 0; j < second.size(); ++j) {
        if (relation(at(first[i]), at(second[j]))) {
          pairs.emplace_back(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j));
        }
      }
    }
    pairs_.push_back(std::move(pairs));
    return static_cast<std::int32_t>(pairs_.size() - 1);
  });
  return pairs_[at(place)];
}

/// Whether two columns have nodes whose supports' interiors meet along the column.
bool ZoneCheck::interiors_meet(std::int32_t one, std::int32_t other, const ZoneAxis& along) const {
  for (const std::int32_t i : columns_[one]) {
    for (const std::int32_t j : columns_[other]) {
      if (along.meet(at(i), at(j))) return true;
    }
  }
  return false;
}

bool ZoneCheck::rows_compatible(Axis axis, std::int32_t one, std::int32_t other) {
  const ZoneAxis& second = axes_[at(axis_after(axis))];
  const ZoneAxis& third = axes_[at(axis_after(axis_after(axis)))];
  const auto first_row = rows_[one];
  const auto other_row = rows_[other];
  const Pairs& failing =
      related(first_row[0], other_row[0], [&](std::size_t y, std::size_t w) { return second.fails(y, w); });
  return std::none_of(failing.begin(), failing.end(), [&](const auto& pair) {
    const std::int32_t column = first_row[at(pair.first) + 1];
    const std::int32_t other_column = other_row[at(pair.second) + 1];
    return known_meetings_.get(column, other_column, [&] { return interiors_meet(column, other_column, third); });
  });
}

/// Whether no two nodes, the one asked, with supports that meet in positive volume fail to overlap along this axis and
/// the next one. Where vectors fail to overlap, the interiors of their ranges meet (AxisOverlap).
bool ZoneCheck::compatible(Axis axis) {
  const ZoneAxis& first = axes_[at(axis)];
  const bool all = asked_.size() == nodes_.size();
  known_rows_.clear();
  known_pairs_.clear();
  known_meetings_.clear();
  pairs_.clear();
  for (std::size_t x = 0; x < first.size(); ++x) {
    const std::int32_t one = asked_row_[x];
    if (one < 0 || !first.fails_anywhere(x)) continue;
    for (std::size_t other = all ? x + 1 : 0; other < first.size(); ++other) {
      if (row_[other] < 0 || !first.fails(x, other)) continue;
      if (!known_rows_.get(one, row_[other], [&] { return rows_compatible(axis, one, row_[other]); })) return false;
    }
  }
  return true;
}

/// Whether lambda_v(B_w) = 0 for v in one column and w in another, v not w, when the other two factors are not 0.
bool ZoneCheck::dual_columns(std::int32_t one, std::int32_t other, bool same) {
  ZoneAxis& third = axes_[kDimension - 1];
  for (const std::int32_t i : columns_[one]) {
    for (const std::int32_t j : columns_[other]) {
      if (same && i == j) continue;  // v = w
      if (third.nonzero((*stores_)[kDimension - 1], at(i), at(j))) return false;
    }
  }
  return true;
}

/// The same for rows, when the factor along the first axis is not 0.
bool ZoneCheck::dual_rows(std::int32_t one, std::int32_t other, bool same) {
  const auto first_row = rows_[one];
  const auto other_row = rows_[other];
  const auto seconds = seconds_[first_row[0]];
  const auto other_seconds = seconds_[other_row[0]];
  const Pairs& nonzero = related(first_row[0], other_row[0], [&](std::size_t y, std::size_t y_tilde) {
    return axes_[1].nonzero((*stores_)[1], y, y_tilde);
  });
  return std::all_of(nonzero.begin(), nonzero.end(), [&](const auto& pair) {
    const bool same_line = same && seconds[at(pair.first)] == other_seconds[at(pair.second)];
    const std::int32_t column = first_row[at(pair.first) + 1];
    const std::int32_t other_column = other_row[at(pair.second) + 1];
    PairTable<bool>& known = same_line ? known_same_columns_ : known_columns_;
    return known.get(column, other_column, [&] { return dual_columns(column, other_column, same_line); });
  });
}

/// Whether lambda_v(B_w) = delta_vw for all v of some rows and w of others.
bool ZoneCheck::dual_pairs(const std::vector<std::int32_t>& row_of_v, const std::vector<std::int32_t>& row_of_w) {
  for (std::size_t x = 0; x < row_of_v.size(); ++x) {
    const std::int32_t one = row_of_v[x];
    if (one < 0) continue;
    for (std::size_t other = 0; other < row_of_w.size(); ++other) {
      const std::int32_t two = row_of_w[other];
      if (two < 0 || !axes_[0].nonzero((*stores_)[0], x, other)) continue;
      PairTable<bool>& known = x == other ? known_same_rows_ : known_rows_;
      if (!known.get(one, two, [&] { return dual_rows(one, two, x == other); })) return false;
    }
  }
  return true;
}

bool ZoneCheck::dual_basis() {
  for (std::size_t a = 0; a < kDimension; ++a) {
    for (std::size_t i = 0; i < axes_[a].size(); ++i) {
      if (!axes_[a].is_one((*stores_)[a], i)) return false;  // then products would have to be looked at
    }
  }
  for (auto* known : {&known_rows_, &known_columns_, &known_same_rows_, &known_same_columns_}) known->clear();
  known_pairs_.clear();
  pairs_.clear();
  if (!dual_pairs(asked_row_, row_)) return false;
  return asked_.size() == nodes_.size() || dual_pairs(row_, asked_row_);
}

/// R_a (Definition 5.1) at the points of the box on lines of all axes.
void ZoneCheck::paint(Axis axis) {
  const ZoneAxis& first = axes_[at(axis)];
  const ZoneAxis& second = axes_[at(axis_after(axis))];
  const ZoneAxis& third = axes_[at(axis_after(axis_after(axis)))];
  having_.assign(first.line_count() * kLines, 0);
  lacking_.assign(having_.size(), 0);
  std::vector<std::uint64_t> plane;
  for (std::size_t x = 0; x < first.size(); ++x) {
    if (row_[x] < 0 || !first.fails_anywhere(x)) continue;
    const auto row = rows_[row_[x]];
    plane.assign(second.line_count(), 0);
    const auto seconds = seconds_[row[0]];
    for (std::size_t i = 0; i < seconds.size(); ++i) {
      std::uint64_t word = 0;
      for (const std::int32_t z : columns_[row[i + 1]]) word |= third.reached(at(z));
      word &= third.active();
      for_each_bit(second.reached(at(seconds[i])) & second.active(), [&](std::size_t line) { plane[line] |= word; });
    }
    const std::uint64_t entries = first.entries(x);
    for_each_bit(first.reached(x) & first.active(), [&](std::size_t line) {
      std::uint64_t* const words = ((entries >> line & 1) != 0 ? having_ : lacking_).data() + line * kLines;
      for (std::size_t i = 0; i < plane.size(); ++i) words[i] |= plane[i];
    });
  }
  std::vector<std::uint64_t>& region = regions_[at(axis)];
  region.resize(having_.size());
  for (std::size_t i = 0; i < region.size(); ++i) region[i] = having_[i] & lacking_[i];
}

/// Whether the regions of this axis and the next one have a common point.
bool ZoneCheck::regions_meet(Axis axis) const {
  const std::vector<std::uint64_t>& one = regions_[at(axis)];
  const std::vector<std::uint64_t>& other = regions_[at(axis_after(axis))];
  for (std::size_t i = 0; i < one.size(); ++i) {
    const std::size_t first = i / kLines;
    const std::size_t second = i % kLines;
    bool found = false;
    for_each_bit(one[i],
                 [&](std::size_t third) { found = found || (other[second * kLines + third] >> first & 1) != 0; });
    if (found) return true;
  }
  return false;
}

}  // namespace asts
