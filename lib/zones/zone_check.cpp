#include "lib/zones/zone_check.hpp"

#include <algorithm>
#include <numeric>

namespace asts {

namespace {

constexpr std::size_t kLines = ZoneAxis::kMostLines;

/// Whether all of visit(number) are true, for the numbers that are in both sets.
template <typename Visit>
bool all_common(BitSet one, BitSet other, const Visit& visit) {
  for (std::size_t word = 0; word < one.size(); ++word) {
    for (std::uint64_t left = one[word] & other[word]; left != 0; left &= left - 1) {
      if (!visit(64 * word + static_cast<std::size_t>(std::countr_zero(left)))) return false;
    }
  }
  return true;
}

}  // namespace

ZoneCheck::ZoneCheck(const RefinementTree& tree, const std::vector<VectorStore>& stores, const ZoneLimits& limits)
    : tree_(&tree), limits_(limits), stores_(&stores) {
  axes_.reserve(kDimension);
  for (const int degree : tree.setting().degree) axes_.emplace_back(degree);
}

void ZoneCheck::begin(const RankBox& box) {
  nodes_.clear();
  asked_.clear();
  grouped_ = -1;
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
  const bool all = asked_.size() == nodes_.size();
  if (grouped_ == axis_after(axis)) {
    sort_by(axis, nodes_);
    if (!all) sort_by(axis, asked_);
  } else {
    for (const Axis by : {axis_after(axis_after(axis)), axis_after(axis), axis}) {
      sort_by(by, nodes_);
      if (!all) sort_by(by, asked_);
    }
  }
  grouped_ = axis;
  find_rows(axis, nodes_, row_);
  if (all) {
    asked_row_ = row_;
  } else {
    find_rows(axis, asked_, asked_row_);
  }
  index_groups(axis);
}

/// A stable counting sort by the vectors along an axis. Nodes in the order of the vectors along an axis, the next one
/// and the one after it come into that order from the axis before with one of these.
void ZoneCheck::sort_by(Axis axis, std::vector<PerAxis<std::int32_t>>& nodes) {
  begin_.assign(axes_[at(axis)].size() + 1, 0);
  for (const auto& node : nodes) ++begin_[at(node[at(axis)]) + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  sorted_.resize(nodes.size());
  for (const auto& node : nodes) sorted_[begin_[at(node[at(axis)])]++] = node;
  nodes.swap(sorted_);
}

/// The rows of sorted nodes.
void ZoneCheck::find_rows(Axis axis, const std::vector<PerAxis<std::int32_t>>& nodes,
                          std::vector<std::int32_t>& row_of) {
  row_of.assign(axes_[at(axis)].size(), -1);
  const auto second_axis = at(axis_after(axis));
  const auto third_axis = at(axis_after(axis_after(axis)));
  std::vector<std::int32_t> row;
  std::vector<std::int32_t> seconds;
  std::vector<std::int32_t> column;
  for (std::size_t i = 0; i < nodes.size();) {
    const std::int32_t first = nodes[i][at(axis)];
    row.assign(1, 0);
    seconds.clear();
    while (i < nodes.size() && nodes[i][at(axis)] == first) {
      const std::int32_t second = nodes[i][second_axis];
      column.clear();
      for (; i < nodes.size() && nodes[i][at(axis)] == first && nodes[i][second_axis] == second; ++i) {
        column.push_back(nodes[i][third_axis]);
      }
      seconds.push_back(second);
      row.push_back(columns_.intern(column));
    }
    row.front() = seconds_.intern(seconds);
    row_of[at(first)] = rows_.intern(row);
  }
}

/// Writes lists of vectors as sets, and what the columns of a row are.
void ZoneCheck::index_groups(Axis axis) {
  const ZoneAxis& second = axes_[at(axis_after(axis))];
  const ZoneAxis& third = axes_[at(axis_after(axis_after(axis)))];
  second_sets_.reset(at(seconds_.size()), second.size());
  for (std::int32_t list = 0; list < seconds_.size(); ++list) {
    for (const std::int32_t y : seconds_[list]) second_sets_.set(at(list), at(y));
  }
  column_sets_.reset(at(columns_.size()), third.size());
  column_gaps_.assign(at(columns_.size()), 0);
  for (std::int32_t column = 0; column < columns_.size(); ++column) {
    for (const std::int32_t z : columns_[column]) {
      column_sets_.set(at(column), at(z));
      column_gaps_[at(column)] |= third.gaps(at(z));
    }
  }
  column_of_.resize(at(rows_.size()) * second.size());
  for (std::int32_t row = 0; row < rows_.size(); ++row) {
    const auto seconds = seconds_[rows_[row][0]];
    for (std::size_t i = 0; i < seconds.size(); ++i) {
      column_of_[at(row) * second.size() + at(seconds[i])] = rows_[row][i + 1];
    }
  }
}

/// Whether no vectors of two rows along the next axis fail to overlap in columns whose supports' interiors meet.
bool ZoneCheck::rows_compatible(Axis axis, std::int32_t one, std::int32_t other) const {
  const ZoneAxis& second = axes_[at(axis_after(axis))];
  const BitSet others = second_sets_[at(rows_[other][0])];
  const std::int32_t* const column_of = column_of_.data() + at(other) * second.size();
  const auto seconds = seconds_[rows_[one][0]];
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    const std::uint64_t gaps = column_gaps_[at(rows_[one][i + 1])];
    const bool apart = all_common(second.failures(at(seconds[i])), others,
                                  [&](std::size_t y) { return (gaps & column_gaps_[at(column_of[y])]) == 0; });
    if (!apart) return false;
  }
  return true;
}

/// Whether no two nodes, the one asked, with supports that meet in positive volume fail to overlap along this axis and
/// the next one. Where vectors fail to overlap, the interiors of their ranges meet (AxisOverlap).
bool ZoneCheck::compatible(Axis axis) {
  const ZoneAxis& first = axes_[at(axis)];
  const bool all = asked_.size() == nodes_.size();
  compatible_rows_.reset(at(rows_.size()), at(rows_.size()));
  const BitSet with_rows = numbers_with(row_);
  for (std::size_t x = 0; x < first.size(); ++x) {
    const std::int32_t one = asked_row_[x];
    if (one < 0 || !first.fails_anywhere(x)) continue;
    const bool good = all_common(first.failures(x), with_rows, [&](std::size_t other) {
      const std::int32_t two = row_[other];
      if ((all && other < x) || compatible_rows_.test(at(one), at(two))) return true;
      compatible_rows_.set(at(one), at(two));
      return rows_compatible(axis, one, two);
    });
    if (!good) return false;
  }
  return true;
}

/// The vectors that have a row, as a set that is there until the next call.
BitSet ZoneCheck::numbers_with(const std::vector<std::int32_t>& row) {
  with_rows_.reset(1, row.size());
  for (std::size_t x = 0; x < row.size(); ++x) {
    if (row[x] >= 0) with_rows_.set(0, x);
  }
  return with_rows_[0];
}

/// Whether lambda_v(B_w) = 0 for v in one column and w in another, v not w, when the other two factors are not 0.
bool ZoneCheck::dual_columns(std::int32_t one, std::int32_t other, bool same) {
  ZoneAxis& third = axes_[kDimension - 1];
  const auto column = columns_[one];
  return std::all_of(column.begin(), column.end(), [&](std::int32_t z) {
    return third.all_nonzero((*stores_)[kDimension - 1], at(z), column_sets_[at(other)],
                             [&](std::size_t z_tilde) { return same && at(z) == z_tilde; });  // v = w
  });
}

/// The same for rows, when the factor along the first axis is not 0.
bool ZoneCheck::dual_rows(std::int32_t one, std::int32_t other, bool same) {
  ZoneAxis& second = axes_[1];
  const BitSet others = second_sets_[at(rows_[other][0])];
  const std::int32_t* const column_of = column_of_.data() + at(other) * second.size();
  const auto seconds = seconds_[rows_[one][0]];
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    const std::int32_t column = rows_[one][i + 1];
    const bool good = second.all_nonzero((*stores_)[1], at(seconds[i]), others, [&](std::size_t y) {
      const bool same_line = same && at(seconds[i]) == y;
      BitRows& known = same_line ? dual_same_columns_ : dual_columns_;
      if (known.test(at(column), at(column_of[y]))) return true;
      known.set(at(column), at(column_of[y]));
      return dual_columns(column, column_of[y], same_line);
    });
    if (!good) return false;
  }
  return true;
}

/// Whether lambda_v(B_w) = delta_vw for all v of some rows and w of others.
bool ZoneCheck::dual_pairs(const std::vector<std::int32_t>& row_of_v, const std::vector<std::int32_t>& row_of_w) {
  const BitSet with_rows = numbers_with(row_of_w);
  for (std::size_t x = 0; x < row_of_v.size(); ++x) {
    const std::int32_t one = row_of_v[x];
    if (one < 0) continue;
    const bool good = axes_[0].all_nonzero((*stores_)[0], x, with_rows, [&](std::size_t other) {
      const std::int32_t two = row_of_w[other];
      BitRows& known = x == other ? dual_same_rows_ : dual_rows_;
      if (known.test(at(one), at(two))) return true;
      known.set(at(one), at(two));
      return dual_rows(one, two, x == other);
    });
    if (!good) return false;
  }
  return true;
}

bool ZoneCheck::dual_basis() {
  for (std::size_t a = 0; a < kDimension; ++a) {
    for (std::size_t i = 0; i < axes_[a].size(); ++i) {
      if (!axes_[a].is_one((*stores_)[a], i)) return false;  // then products would have to be looked at
    }
  }
  for (BitRows* known : {&dual_rows_, &dual_same_rows_}) known->reset(at(rows_.size()), at(rows_.size()));
  for (BitRows* known : {&dual_columns_, &dual_same_columns_}) known->reset(at(columns_.size()), at(columns_.size()));
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
