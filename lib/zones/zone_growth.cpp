#include "lib/zones/zone_growth.hpp"

#include <algorithm>
#include <limits>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

constexpr std::size_t kMostVectors = std::numeric_limits<std::uint16_t>::max();

std::int32_t middle(std::span<const std::int32_t> vector) { return vector[vector.size() / 2]; }

/// Ranks of y, z and x: nodes of a zone are in the order of these.
using Position = PerAxis<std::int32_t>;

/// Given what rank_of(axis, number) a vector's middle entry has.
template <typename RankOf>
Position position_of(const PerAxis<std::uint16_t>& node, const RankOf& rank_of) {
  return {rank_of(1, node[1]), rank_of(2, node[2]), rank_of(0, node[0])};
}

}  // namespace

/// Numbers the zone's vectors along an axis and the lines that its nodes lie on.
void ZoneGrowth::number_old(const Zone& zone, Axis axis) {
  const VectorStore& store = (*stores_)[at(axis)];
  const std::vector<std::int32_t>& vectors = zone.vectors[at(axis)];
  Along& along = along_[at(axis)];
  along.number.resize(at(store.size()), -1);
  along.place.clear();
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    along.number[at(vectors[i])] = static_cast<std::int32_t>(i);
    along.place.push_back(tree_->grid(axis).rank_of_line(middle(store[vectors[i]])));
  }
  along.ranks = along.place;
  std::sort(along.ranks.begin(), along.ranks.end());
  along.ranks.erase(std::unique(along.ranks.begin(), along.ranks.end()), along.ranks.end());
  for (std::int32_t& place : along.place) {
    const auto found = std::lower_bound(along.ranks.begin(), along.ranks.end(), place);
    place = static_cast<std::int32_t>(found - along.ranks.begin());
  }
}

/// The number of a vector in the zone, its own or a new one.
std::uint16_t ZoneGrowth::number_of(Zone& zone, Axis axis, std::int32_t id) {
  std::vector<std::int32_t>& number = along_[at(axis)].number;
  if (at(id) >= number.size()) number.resize(at(id) + 1, -1);
  if (number[at(id)] < 0) {
    number[at(id)] = static_cast<std::int32_t>(zone.vectors[at(axis)].size());
    zone.vectors[at(axis)].push_back(id);
  }
  return static_cast<std::uint16_t>(number[at(id)]);
}

/// Gives the old nodes their vectors along an axis.
void ZoneGrowth::insert(Zone& zone, Axis axis) {
  const AxisGrid& grid = tree_->grid(axis);
  VectorStore& store = (*stores_)[at(axis)];
  const Axis across = axis_after(axis);
  const Axis other = axis_after(across);
  faces_.assign(*tree_, axis, along_[at(axis)].split, along_[at(across)].ranks, along_[at(other)].ranks);
  std::vector<std::int32_t> ranks;
  std::vector<std::int32_t> entries;
  for (std::size_t i = 0; i < zone.nodes.size(); ++i) {
    PerAxis<std::uint16_t>& node = zone.nodes[i];
    const auto on_line =
        faces_.on(at(along_[at(across)].place[node[at(across)]]), at(along_[at(other)].place[node[at(other)]]));
    if (on_line.empty()) continue;
    const auto old = store[zone.vectors[at(axis)][node[at(axis)]]];
    if (on_line.back() < grid.rank_of_line(old.front()) || on_line.front() > grid.rank_of_line(old.back())) continue;
    ranks.clear();
    for (const std::int32_t line : old) ranks.push_back(grid.rank_of_line(line));
    insert_entries(ranks, on_line, entries);
    if (entries == ranks) continue;
    for (std::int32_t& entry : entries) entry = grid.line_of_rank(entry);
    std::vector<std::int32_t>& places = along_[at(axis)].place;
    const std::int32_t place = places[node[at(axis)]];
    node[at(axis)] = number_of(zone, axis, store.intern(grid, entries));
    places.resize(zone.vectors[at(axis)].size(), place);  // the same: the vector's middle entry stays
    zone.changed[i] = true;
  }
}

/// A box that contains the new faces as far as they touch the zone.
std::optional<RankBox> ZoneGrowth::new_part(const Zone& zone, std::span<const std::int32_t> split) const {
  const RankBox own = box_of(*tree_, zone.tree_node);
  std::optional<RankBox> part;
  for (const std::int32_t element : split) {
    RankBox faces = box_of(*tree_, element);
    const Axis axis = tree_->split_axis(element);
    const std::int32_t child = tree_->first_child(element);
    faces[axis] = {tree_->extent(child, axis).upper,
                   tree_->extent(child + tree_->child_count(element) - 1, axis).lower};
    if (touch(faces, own)) part = part ? hull(*part, faces) : faces;
  }
  return part;
}

/// Which of the nodes found in a part of a zone it does not have, and how many of its own come before each.
std::vector<ZoneGrowth::Added> ZoneGrowth::new_among(const Zone& zone, const ZoneNodes& found) const {
  PerAxis<std::vector<std::int32_t>> middles;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const std::span<const std::int32_t> lines(found.vectors[at(axis)]);
    const std::size_t length = vector_length(axis);
    for (std::size_t i = 0; i < lines.size(); i += length) {
      middles[at(axis)].push_back(tree_->grid(axis).rank_of_line(middle(lines.subspan(i, length))));
    }
  }
  const auto old_rank = [&](Axis axis, std::size_t number) {
    return along_[at(axis)].ranks[at(along_[at(axis)].place[number])];
  };
  const auto found_rank = [&](Axis axis, std::size_t number) { return middles[at(axis)][number]; };
  std::vector<Added> added;
  std::size_t old = 0;
  for (std::size_t i = 0; i < found.nodes.size(); ++i) {
    const Position position = position_of(found.nodes[i], found_rank);
    while (old < zone.nodes.size() && position_of(zone.nodes[old], old_rank) < position) ++old;
    const bool known = old < zone.nodes.size() && position_of(zone.nodes[old], old_rank) == position;
    if (!known) added.push_back({i, old});
  }
  return added;
}

/// A found node by the numbers of its vectors in the zone.
PerAxis<std::uint16_t> ZoneGrowth::numbers_of(Zone& zone, const ZoneNodes& found, std::size_t node) {
  PerAxis<std::uint16_t> numbers;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const std::size_t length = vector_length(axis);
    const std::span<const std::int32_t> lines(found.vectors[at(axis)]);
    const auto vector = lines.subspan(found.nodes[node][at(axis)] * length, length);
    numbers[at(axis)] = number_of(zone, axis, (*stores_)[at(axis)].intern(tree_->grid(axis), vector));
  }
  return numbers;
}

/// Puts the new ones of the found nodes between the zone's own.
void ZoneGrowth::merge(Zone& zone, const ZoneNodes& found) {
  const std::vector<Added> added = new_among(zone, found);
  std::vector<PerAxis<std::uint16_t>> nodes;
  std::vector<bool> changed;
  nodes.reserve(zone.nodes.size() + added.size());
  changed.reserve(zone.nodes.size() + added.size());
  std::size_t old = 0;
  const auto take_old_up_to = [&](std::size_t end) {
    for (; old < end; ++old) {
      nodes.push_back(zone.nodes[old]);
      changed.push_back(zone.changed[old]);
    }
  };
  for (const Added& one : added) {
    take_old_up_to(one.before);
    nodes.push_back(numbers_of(zone, found, one.node));
    changed.push_back(true);
  }
  take_old_up_to(zone.nodes.size());
  zone.nodes = std::move(nodes);
  zone.changed = std::move(changed);
}

/// Numbers the vectors of a zone's nodes; others are left out.
void ZoneGrowth::leave_out_unused(Zone& zone) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    std::vector<std::int32_t>& vectors = zone.vectors[axis];
    std::vector<std::int32_t> ids;
    std::vector<std::int32_t> number(vectors.size(), -1);
    for (auto& node : zone.nodes) {
      std::int32_t& now = number[node[axis]];
      if (now < 0) {
        now = static_cast<std::int32_t>(ids.size());
        ids.push_back(vectors[node[axis]]);
      }
      node[axis] = static_cast<std::uint16_t>(now);
    }
    for (const std::int32_t id : vectors) along_[axis].number[at(id)] = -1;
    vectors = std::move(ids);
  }
}

bool ZoneGrowth::add_nodes(Zone& zone, const RankBox& part) {
  ZoneNodes found;
  if (!scanner_->scan(zone.tree_node, part, found)) return false;
  if (found.empty) return true;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (zone.vectors[axis].size() + found.nodes.size() > kMostVectors) return false;
  }
  merge(zone, found);
  return true;
}

bool ZoneGrowth::follow(Zone& zone, std::span<const std::int32_t> split) {
  for (const std::vector<std::int32_t>& vectors : zone.vectors) {
    if (vectors.size() + zone.nodes.size() > kMostVectors) return false;
  }
  for (Axis axis = 0; axis < kDimension; ++axis) {
    number_old(zone, axis);
    along_[at(axis)].split.clear();
  }
  for (const std::int32_t element : split) along_[at(tree_->split_axis(element))].split.push_back(element);
  zone.changed.assign(zone.nodes.size(), false);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    if (!along_[at(axis)].split.empty()) insert(zone, axis);
  }
  const std::optional<RankBox> part = new_part(zone, split);
  const bool fits = !part || add_nodes(zone, *part);
  leave_out_unused(zone);
  return fits;
}

}  // namespace asts
