#include "lib/zones/zone_growth.hpp"

#include <algorithm>
#include <limits>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

constexpr std::size_t kMostVectors = std::numeric_limits<std::uint16_t>::max();

std::int32_t middle(std::span<const std::int32_t> vector) { return vector[vector.size() / 2]; }

}  // namespace

void ZoneGrowth::begin(const Zone& zone, std::span<const std::int32_t> split) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree_->grid(axis);
    Along& along = along_[at(axis)];
    along.ranks.clear();
    along.split.clear();
    along.number.resize(at((*stores_)[at(axis)].size()), -1);
    const std::vector<std::int32_t>& vectors = zone.vectors[at(axis)];
    along.place.resize(vectors.size());
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      along.number[at(vectors[i])] = static_cast<std::int32_t>(i);
      along.place[i] = grid.rank_of_line(middle((*stores_)[at(axis)][vectors[i]]));
    }
    along.ranks = along.place;
    std::sort(along.ranks.begin(), along.ranks.end());
    along.ranks.erase(std::unique(along.ranks.begin(), along.ranks.end()), along.ranks.end());
    for (std::int32_t& place : along.place) {
      const auto found = std::lower_bound(along.ranks.begin(), along.ranks.end(), place);
      place = static_cast<std::int32_t>(found - along.ranks.begin());
    }
  }
  for (const std::int32_t element : split) along_[at(tree_->split_axis(element))].split.push_back(element);
}

/// The number of a vector in the zone, whose nodes lie on a line with this place.
std::uint16_t ZoneGrowth::number_of(Zone& zone, Axis axis, std::int32_t id, std::int32_t place) {
  Along& along = along_[at(axis)];
  if (at(id) >= along.number.size()) along.number.resize(at(id) + 1, -1);
  if (along.number[at(id)] < 0) {
    along.number[at(id)] = static_cast<std::int32_t>(zone.vectors[at(axis)].size());
    zone.vectors[at(axis)].push_back(id);
    along.place.push_back(place);
  }
  return static_cast<std::uint16_t>(along.number[at(id)]);
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
    node[at(axis)] = number_of(zone, axis, store.intern(grid, entries), along_[at(axis)].place[node[at(axis)]]);
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

/// Puts the nodes found in a part of a zone that are new between its own.
void ZoneGrowth::merge(Zone& zone, const ZoneNodes& found) {
  constexpr PerAxis<std::size_t> kOrder{1, 2, 0};
  using Key = PerAxis<std::int32_t>;
  PerAxis<std::vector<std::int32_t>> ids;
  PerAxis<std::vector<std::int32_t>> ranks;
  PerAxis<std::size_t> length;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    length[axis] = at(tree_->setting().degree[axis]) + 2;
    const std::vector<std::int32_t>& lines = found.vectors[axis];
    ids[axis].assign(lines.size() / length[axis], -1);
    for (std::size_t i = 0; i < lines.size(); i += length[axis]) {
      ranks[axis].push_back(tree_->grid(static_cast<Axis>(axis)).rank_of_line(lines[i + length[axis] / 2]));
    }
  }
  const auto key_of_old = [&](const PerAxis<std::uint16_t>& node) {
    Key key;
    for (std::size_t i = 0; i < kDimension; ++i) {
      const Along& along = along_[kOrder[i]];
      key[i] = along.ranks[at(along.place[node[kOrder[i]]])];
    }
    return key;
  };
  const auto key_of_found = [&](const PerAxis<std::uint16_t>& node) {
    Key key;
    for (std::size_t i = 0; i < kDimension; ++i) key[i] = ranks[kOrder[i]][node[kOrder[i]]];
    return key;
  };
  const auto id_of = [&](Axis axis, std::size_t number) {
    std::int32_t& id = ids[at(axis)][number];
    if (id < 0) {
      const std::span<const std::int32_t> lines(found.vectors[at(axis)]);
      id = (*stores_)[at(axis)].intern(tree_->grid(axis), lines.subspan(number * length[at(axis)], length[at(axis)]));
    }
    return id;
  };
  std::vector<PerAxis<std::uint16_t>> nodes;
  std::vector<bool> changed;
  nodes.reserve(zone.nodes.size() + found.nodes.size());
  changed.reserve(nodes.capacity());
  std::size_t old = 0;
  const auto take_old = [&] {
    nodes.push_back(zone.nodes[old]);
    changed.push_back(zone.changed[old++]);
  };
  for (const auto& node : found.nodes) {
    const Key key = key_of_found(node);
    while (old < zone.nodes.size() && key_of_old(zone.nodes[old]) < key) take_old();
    if (old < zone.nodes.size() && key_of_old(zone.nodes[old]) == key) {
      take_old();
      continue;
    }
    PerAxis<std::uint16_t> added;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      added[at(axis)] = number_of(zone, axis, id_of(axis, node[at(axis)]), 0);
    }
    nodes.push_back(added);
    changed.push_back(true);
  }
  while (old < zone.nodes.size()) take_old();
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
  begin(zone, split);
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
