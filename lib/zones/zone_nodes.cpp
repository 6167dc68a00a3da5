#include "lib/zones/zone_nodes.hpp"

#include <bit>

#include "lib/exact/errors.hpp"
#include "lib/zones/bits.hpp"

namespace asts {

std::size_t ZoneScanner::WordTable::slot_of(std::uint64_t word) const {
  const std::size_t mask = slots.size() - 1;
  std::size_t slot = (word * 0x9E3779B97F4A7C15ull >> 32) & mask;
  while (slots[slot] >= 0 && words[at(slots[slot])] != word) slot = (slot + 1) & mask;
  return slot;
}

std::size_t ZoneScanner::WordTable::number_of(std::uint64_t word) {
  const std::size_t slot = slot_of(word);
  if (slots[slot] >= 0) return at(slots[slot]);
  slots[slot] = static_cast<std::int32_t>(words.size());
  words.push_back(word);
  if (2 * words.size() > slots.size()) {
    slots.assign(2 * slots.size(), -1);
    for (std::size_t i = 0; i < words.size(); ++i) slots[slot_of(words[i])] = static_cast<std::int32_t>(i);
  }
  return words.size() - 1;
}

void ZoneScanner::WordTable::clear() {
  words.clear();
  slots.assign(256, -1);
}

/// Appends the leaves that touch a box, searching below the lowest node above the zone that has the box inside.
void ZoneScanner::gather(const RankBox& box, std::vector<RankBox>& leaves) {
  std::int32_t top = zone_;
  while (tree_->node(top).parent != RefinementTree::kNone && !inside(box, box_of(*tree_, top))) {
    top = tree_->node(top).parent;
  }
  reached_.assign(1, {top, tree_->level(top), {tree_->cell(top, 0), tree_->cell(top, 1), tree_->cell(top, 2)}});
  while (!reached_.empty()) {
    deeper_.clear();
    for (const Reached& one : reached_) {
      if (tree_->is_leaf(one.node)) {
        leaves.push_back({tree_->grid(0).extent(one.cell[0]), tree_->grid(1).extent(one.cell[1]),
                          tree_->grid(2).extent(one.cell[2])});
      } else {
        reach_children(one, box);
      }
    }
    reached_.swap(deeper_);
  }
}

/// Takes down the children of a node that touch a box, without reading them: they differ from it along one axis only.
void ZoneScanner::reach_children(const Reached& one, const RankBox& box) {
  const Axis axis = one.level < 0 ? tree_->split_axis(one.node) : one.level % kDimension;
  const std::int32_t first = tree_->first_child(one.node);
  const std::int32_t count = one.level < 0 ? 2 : tree_->setting().grading;
  tree_->prefetch_place(first);
  Reached child{first, one.level + 1, one.cell};
  child.cell[at(axis)] = tree_->grid(axis).known_children(one.cell[at(axis)]);
  for (; child.node < first + count; ++child.node, ++child.cell[at(axis)]) {
    if (one.level < 0) child.level = tree_->level(child.node);
    if (touch(tree_->grid(axis).extent(child.cell[at(axis)]), box[axis])) deeper_.push_back(child);
  }
}

/// Gathers the elements outside the zone, below it or above it, that the vectors along an axis are decided from.
/// Returns where the farthest of them ends.
std::int32_t ZoneScanner::extend(Axis axis, int direction) {
  const auto farthest = [&](const std::vector<RankBox>& leaves, std::int32_t end) {
    for (const RankBox& leaf : leaves) {
      end = direction > 0 ? std::max(end, leaf[axis].upper) : std::min(end, leaf[axis].lower);
    }
    return end;
  };
  outside_.clear();
  const int reach = (tree_->setting().degree[at(axis)] + 1) / 2;
  const std::int32_t side = direction > 0 ? own_[axis].upper : own_[axis].lower;
  std::int32_t end = farthest(core_, side);
  for (int entries = 1; entries < reach; ++entries) {
    RankBox part = own_;
    const std::int32_t from = entries + 1 < reach ? end : side;  // the last time all of them
    part[axis] = {std::min(from, end), std::max(from, end)};
    outside_.clear();
    gather(part, outside_);
    end = farthest(outside_, end);
  }
  std::vector<RankBox>& slab = slabs_[at(axis)];
  std::copy_if(outside_.begin(), outside_.end(), std::back_inserter(slab),
               [this](const RankBox& leaf) { return !touch(leaf, own_); });
  return end;
}

void ZoneScanner::mark_ends(Axis axis, const std::vector<RankBox>& leaves) {
  Lines& lines = lines_[at(axis)];
  const RankInterval& window = window_[at(axis)];
  for (const RankBox& leaf : leaves) {
    for (const std::int32_t end : {leaf[axis].lower, leaf[axis].upper}) {
      if (end >= window.lower && end <= window.upper) lines.below[at(end - lines.begin)] = 1;
    }
  }
}

/// Numbers the lines of a window; false if there are too many.
bool ZoneScanner::number_lines(Axis axis) {
  Lines& lines = lines_[at(axis)];
  const RankInterval& window = window_[at(axis)];
  lines.begin = window.lower;
  lines.below.assign(at(window.upper - window.lower + 2), 0);
  mark_ends(axis, core_);
  mark_ends(axis, slabs_[at(axis)]);
  for (const std::int32_t end : {own_[axis].lower, own_[axis].upper}) lines.below[at(end - lines.begin)] = 1;
  lines.rank.clear();
  for (std::size_t i = 0; i < lines.below.size(); ++i) {
    const bool in_use = lines.below[i] != 0;
    lines.below[i] = static_cast<std::uint8_t>(lines.rank.size());
    if (!in_use) continue;
    if (lines.rank.size() == most_lines_) return false;
    lines.rank.push_back(lines.begin + static_cast<std::int32_t>(i));
  }
  lines.first = lines.number_from(own_[axis].lower);
  lines.last = lines.number_from(own_[axis].upper);
  return true;
}

/// The numbers of the zone's own lines that an element's side contains.
RankInterval ZoneScanner::clipped(Axis axis, const RankInterval& side) const {
  const Lines& lines = lines_[at(axis)];
  return {lines.number_from(std::max(side.lower, own_[axis].lower)),
          lines.number_from(std::min(side.upper, own_[axis].upper) + 1) - 1};
}

/// The bit of a line; none beyond the window.
std::uint64_t ZoneScanner::bit(Axis axis, std::int32_t rank) const {
  if (rank < window_[at(axis)].lower || rank > window_[at(axis)].upper) return 0;
  return std::uint64_t{1} << lines_[at(axis)].number_from(rank);
}

/// The place of the word of a line parallel to an axis, by the numbers of lines of the next axis and the one after it.
std::size_t ZoneScanner::place(Axis across, std::int32_t one, std::int32_t other) const {
  const Lines& second = lines_[at(axis_after(axis_after(across)))];
  return at(one - lines_[at(axis_after(across))].first) * second.own() + at(other - second.first);
}

void ZoneScanner::add_entries(Axis axis, const std::vector<RankBox>& leaves) {
  const Axis one = axis_after(axis);
  const Axis other = axis_after(one);
  std::vector<std::uint64_t>& words = entries_[at(axis)];
  for (const RankBox& leaf : leaves) {
    const std::uint64_t bits = bit(axis, leaf[axis].lower) | bit(axis, leaf[axis].upper);
    const RankInterval rows = clipped(one, leaf[one]);
    const RankInterval columns = clipped(other, leaf[other]);
    for (std::int32_t row = rows.lower; row <= rows.upper; ++row) {
      std::uint64_t* const word = words.data() + place(axis, row, columns.lower);
      for (std::int32_t i = 0; i <= columns.upper - columns.lower; ++i) word[i] |= bits;
    }
  }
}

void ZoneScanner::add_vertices() {
  const auto inside = [this](Axis axis, std::int32_t rank) {
    return rank >= own_[axis].lower && rank <= own_[axis].upper;
  };
  for (const RankBox& leaf : core_) {
    std::uint64_t bits = 0;
    for (const std::int32_t x : {leaf[0].lower, leaf[0].upper}) bits |= inside(0, x) ? bit(0, x) : 0;
    for (const std::int32_t y : {leaf[1].lower, leaf[1].upper}) {
      if (!inside(1, y)) continue;
      for (const std::int32_t z : {leaf[2].lower, leaf[2].upper}) {
        if (inside(2, z)) vertices_[place(0, clipped(1, {y, y}).lower, clipped(2, {z, z}).lower)] |= bits;
      }
    }
  }
}

/// The bit of a number among the entries of a line, and the `reach` next ones on either side.
std::uint64_t ZoneScanner::vector_around(std::uint64_t entries, std::int32_t number, int reach) const {
  const std::uint64_t own = std::uint64_t{1} << number;
  std::uint64_t vector = own;
  std::uint64_t above = entries & ~(own | (own - 1));
  std::uint64_t below = entries & (own - 1);
  bool complete = (entries & own) != 0;
  for (int i = 0; i < reach; ++i) {
    complete = complete && above != 0 && below != 0;
    vector |= above & (~above + 1);
    above &= above - 1;
    const std::uint64_t highest = std::bit_floor(below);
    vector |= highest;
    below ^= highest;
  }
  ensure(complete, "an index vector lies in the window of its zone");
  return vector;
}

void ZoneScanner::collect(ZoneNodes& result) {
  const PerAxis<int>& degree = tree_->setting().degree;
  const auto number = [&](Axis axis, std::size_t where, std::int32_t own) {
    const std::uint64_t word = vector_around(entries_[at(axis)][where], own, (degree[at(axis)] + 1) / 2);
    return static_cast<std::uint16_t>(known_[at(axis)].number_of(word));
  };
  for (std::int32_t y = lines_[1].first; y <= lines_[1].last; ++y) {
    for (std::int32_t z = lines_[2].first; z <= lines_[2].last; ++z) {
      for_each_bit(vertices_[place(0, y, z)], [&](std::size_t bit) {
        const auto x = static_cast<std::int32_t>(bit);
        result.nodes.push_back(
            {number(0, place(0, y, z), x), number(1, place(1, z, x), y), number(2, place(2, x, y), z)});
      });
    }
  }
  for (Axis axis = 0; axis < kDimension; ++axis) {
    ensure(known_[at(axis)].words.size() <= std::numeric_limits<std::uint16_t>::max(), "a zone has few index vectors");
    for (const std::uint64_t word : known_[at(axis)].words) {
      for_each_bit(word, [&](std::size_t bit) {
        result.vectors[at(axis)].push_back(tree_->grid(axis).line_of_rank(lines_[at(axis)].rank[bit]));
      });
    }
  }
}

bool ZoneScanner::scan(std::int32_t zone, const RankBox& part, ZoneNodes& result) {
  result = {};
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval side = tree_->extent(zone, axis);
    const RankInterval active = active_range(*tree_, axis);
    own_[axis] = {std::max({side.lower, active.lower, part[axis].lower}),
                  std::min({side.upper - 1, active.upper, part[axis].upper})};
    if (own_[axis].lower > own_[axis].upper) return true;
  }
  result.empty = false;
  zone_ = zone;
  core_.clear();
  gather(own_, core_);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    slabs_[at(axis)].clear();
    window_[at(axis)] = {extend(axis, -1), extend(axis, +1)};
    if (!number_lines(axis)) return false;
    const AxisGrid& grid = tree_->grid(axis);
    result.window[at(axis)] = {grid.line_of_rank(window_[at(axis)].lower), grid.line_of_rank(window_[at(axis)].upper)};
    known_[at(axis)].clear();
  }
  for (Axis axis = 0; axis < kDimension; ++axis) {
    entries_[at(axis)].assign(lines_[at(axis_after(axis))].own() * lines_[at(axis_after(axis_after(axis)))].own(), 0);
    add_entries(axis, core_);
    add_entries(axis, slabs_[at(axis)]);
  }
  vertices_.assign(lines_[1].own() * lines_[2].own(), 0);
  add_vertices();
  collect(result);
  return true;
}

}  // namespace asts
