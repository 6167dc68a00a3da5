#include "lib/zones/zones.hpp"

#include <algorithm>
#include <limits>

#include "lib/exact/errors.hpp"
#include "lib/threads/apart.hpp"
#include "lib/threads/parallel_for.hpp"

namespace asts {

namespace {

/// A zone that is looked at again is divided until it has a fraction of the elements of a new one.
constexpr std::size_t kParts = 8;

/// How many elements a zone of the whole mesh has at most.
std::int32_t new_zone(const RefinementTree& tree, const ZoneLimits& limits) {
  constexpr std::int64_t kZones = 64;  // enough for all threads
  const std::int64_t elements = tree.element_count() / kZones;
  return static_cast<std::int32_t>(
      std::clamp<std::int64_t>(elements, limits.elements, 4 * std::int64_t{limits.elements}));
}

/// The nodes of the tree that become zones: the highest with few enough leaves.
std::vector<std::int32_t> small_subtrees(const RefinementTree& tree, std::int32_t most_leaves) {
  using Count = std::uint16_t;
  const auto most = static_cast<Count>(std::min<std::int32_t>(most_leaves, std::numeric_limits<Count>::max() - 1));
  std::vector<Count> leaves(at(tree.node_count()), 0);    // up to one more than counts
  for (std::int32_t id = tree.node_count(); --id > 0;) {  // children come after their parents
    Count& above = leaves[at(tree.parent(id))];
    above = static_cast<Count>(std::min<int>(above + std::max<int>(leaves[at(id)], 1), most + 1));
  }
  std::vector<std::int32_t> result;
  std::vector<std::int32_t> pending{0};
  while (!pending.empty()) {
    const std::int32_t id = pending.back();
    pending.pop_back();
    if (leaves[at(id)] <= most) {
      result.push_back(id);
    } else {
      tree.push_children(id, pending);
    }
  }
  return result;
}

std::vector<VectorStore> empty_stores(const RefinementTree& tree) {
  std::vector<VectorStore> stores;
  for (const int degree : tree.setting().degree) stores.emplace_back(degree);
  return stores;
}

using VectorIds = PerAxis<std::int32_t>;

Zone zone_of(std::int32_t tree_node, ZoneNodes&& found, PerAxis<std::vector<std::int32_t>>&& vectors) {
  return {tree_node, true, found.empty, std::move(vectors), std::move(found.nodes), found.window, {}};
}

VectorIds ids_of(const Zone& zone, const PerAxis<std::uint16_t>& node) {
  VectorIds ids;
  for (std::size_t axis = 0; axis < kDimension; ++axis) ids[axis] = zone.vectors[axis][node[axis]];
  return ids;
}

}  // namespace

Zones::Zones(const RefinementTree& tree, const ZoneLimits& limits)
    : tree_(tree),
      limits_(limits),
      stores_(empty_stores(tree)),
      supports_(tree),
      reaches_(tree),
      scanner_(tree, limits.lines) {}

/// Identifiers of the vectors along an axis that were found in a zone.
std::vector<std::int32_t> Zones::intern(Axis axis, const ZoneNodes& found) {
  std::vector<std::int32_t> ids;
  const std::span<const std::int32_t> lines(found.vectors[at(axis)]);
  const std::size_t length = at(tree_.setting().degree[at(axis)]) + 2;
  for (std::size_t i = 0; i < lines.size(); i += length) {
    ids.push_back(stores_[at(axis)].intern(tree_.grid(axis), lines.subspan(i, length)));
  }
  return ids;
}

/// Appends the zones of a node of the tree: itself, or where too much is in it those of its children.
void Zones::scan(std::int32_t tree_node, std::vector<Zone>& zones) {
  ZoneNodes found;
  const bool fits = scanner_.scan(tree_node, found);
  if (tree_.is_leaf(tree_node) || (fits && found.nodes.size() <= 2 * at(limits_.elements))) {
    PerAxis<std::vector<std::int32_t>> vectors;
    for (Axis axis = 0; axis < kDimension; ++axis) vectors[at(axis)] = intern(axis, found);
    zones.push_back(zone_of(tree_node, std::move(found), std::move(vectors)));
    zones.back().known = fits;
    return;
  }
  std::vector<std::int32_t> children;
  tree_.push_children(tree_node, children);
  for (std::size_t i = children.size(); i-- > 0;) scan(children[i], zones);
}

void Zones::rebuild(int jobs) {
  const std::vector<std::int32_t> subtrees = small_subtrees(tree_, new_zone(tree_, limits_));
  std::vector<ZoneNodes> found(subtrees.size());
  std::vector<char> fits(subtrees.size());
  std::vector<Apart<ZoneScanner>> scanners(static_cast<std::size_t>(jobs), {ZoneScanner(tree_, limits_.lines)});
  parallel_for(jobs, subtrees.size(), [&](std::size_t i, int worker) {
    ZoneNodes nodes;
    fits[i] = scanners[static_cast<std::size_t>(worker)].own.scan(subtrees[i], nodes) ? 1 : 0;
    found[i] = std::move(nodes);
  });
  std::vector<PerAxis<std::vector<std::int32_t>>> vectors(subtrees.size());
  parallel_for(jobs, kDimension, [&](std::size_t axis, int) {
    for (std::size_t i = 0; i < subtrees.size(); ++i) {
      if (fits[i] != 0) vectors[i][axis] = intern(static_cast<Axis>(axis), found[i]);
    }
  });
  zones_.clear();
  changed_.clear();
  for (std::size_t i = 0; i < subtrees.size(); ++i) {
    if (fits[i] != 0) {
      zones_.push_back(zone_of(subtrees[i], std::move(found[i]), std::move(vectors[i])));
    } else {
      scan(subtrees[i], zones_);
    }
  }
  index_all();
}

/// The hull of the supports of a zone's nodes, by lines.
RankBox Zones::support_hull(const Zone& zone) const {
  RankBox box = BoxTree::nothing();
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree_.grid(axis);
    for (const std::int32_t id : zone.vectors[at(axis)]) {
      const auto lines = stores_[at(axis)][id];
      RankInterval& side = box[axis];
      if (side.lower < 0) side = {lines.front(), lines.back()};
      if (grid.rank_of_line(lines.front()) < grid.rank_of_line(side.lower)) side.lower = lines.front();
      if (grid.rank_of_line(lines.back()) > grid.rank_of_line(side.upper)) side.upper = lines.back();
    }
  }
  return box;
}

/// A box that contains all elements that a zone's nodes and vectors are decided from, by lines.
RankBox Zones::reach(const Zone& zone) const {
  if (zone.empty) return BoxTree::nothing();
  RankBox box;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree_.grid(axis);
    const RankInterval own = tree_.extent(zone.tree_node, axis);
    box[axis] = zone.window[at(axis)];
    if (own.lower < grid.rank_of_line(box[axis].lower)) box[axis].lower = grid.line_of_rank(own.lower);
    if (own.upper > grid.rank_of_line(box[axis].upper)) box[axis].upper = grid.line_of_rank(own.upper);
  }
  return box;
}

void Zones::index_all() {
  std::vector<RankBox> supports;
  std::vector<RankBox> reaches;
  for (const Zone& zone : zones_) {
    supports.push_back(support_hull(zone));
    reaches.push_back(reach(zone));
  }
  supports_.assign(supports);
  reaches_.assign(reaches);
}

bool Zones::known() const {
  return std::all_of(zones_.begin(), zones_.end(), [](const Zone& zone) { return zone.known; });
}

std::int64_t Zones::active_nodes() const {
  std::int64_t count = 0;
  for (const Zone& zone : zones_) count += static_cast<std::int64_t>(zone.nodes.size());
  return count;
}

std::map<std::size_t, Zones::Effect> Zones::effects(std::span<const std::int32_t> subdivided) const {
  std::map<std::size_t, Effect> result;
  for (const std::int32_t element : subdivided) {
    const RankBox box = box_of(tree_, element);
    const Axis split = tree_.split_axis(element);
    const AxisGrid& grid = tree_.grid(split);
    reaches_.for_each_touching(box, [&](std::size_t place) {
      const Zone& zone = zones_[place];
      RankBox reached = box_of(tree_, zone.tree_node);
      const bool nodes = touch(reached, box);
      const RankInterval& window = zone.window[at(split)];
      reached[split] = {std::min(reached[split].lower, grid.rank_of_line(window.lower)),
                        std::max(reached[split].upper, grid.rank_of_line(window.upper))};
      if (!touch(reached, box)) return;
      Effect& effect = result[place];
      effect.vectors[at(split)] = true;
      effect.nodes = effect.nodes || nodes;
    });
  }
  return result;
}

/// Finds the vectors of a zone's nodes along some axes again, where the nodes are what they were. False when its window
/// has too many lines now.
bool Zones::change_vectors(Zone& zone, const PerAxis<bool>& axes) {
  ZoneNodes found;
  if (!scanner_.scan(zone.tree_node, found, axes)) return false;
  ensure(found.nodes.size() == zone.nodes.size(), "a zone that no subdivided element touches has no new nodes");
  zone.changed.assign(zone.nodes.size(), false);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto a = at(axis);
    if (!axes[a]) continue;
    const std::vector<std::int32_t> ids = intern(axis, found);
    for (std::size_t i = 0; i < zone.nodes.size(); ++i) {
      if (zone.vectors[a][zone.nodes[i][a]] != ids[found.nodes[i][a]]) zone.changed[i] = true;
      zone.nodes[i][a] = found.nodes[i][a];
    }
    zone.vectors[a] = ids;
    zone.window[a] = found.window[a];
  }
  return true;
}

/// Marks the nodes of a zone that it did not have before, or not with these vectors. Nodes stay when a mesh is refined,
/// and so does their order.
void Zones::mark_changed(const Zone& before, Zone& zone) const {
  std::size_t old = 0;
  for (const auto& node : zone.nodes) {
    const bool stayed = old < before.nodes.size() && position(before, before.nodes[old]) == position(zone, node);
    zone.changed.push_back(!stayed || ids_of(before, before.nodes[old]) != ids_of(zone, node));
    if (stayed) ++old;
  }
  ensure(old == before.nodes.size(), "no node leaves its zone");
}

/// The zones that come of one, with the changed nodes marked: all, if they are several or one is not known.
std::vector<Zone> Zones::scan_again(const Zone& before) {
  std::vector<Zone> zones;
  scan(before.tree_node, zones);
  if (zones.size() == 1 && zones.front().known) {
    mark_changed(before, zones.front());
  } else {
    for (Zone& zone : zones) zone.changed.assign(zone.nodes.size(), true);
  }
  return zones;
}

RankBox Zones::support(const Zone& zone, const PerAxis<std::uint16_t>& node) const {
  RankBox box;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto lines = stores_[at(axis)][zone.vectors[at(axis)][node[at(axis)]]];
    box[axis] = {tree_.grid(axis).rank_of_line(lines.front()), tree_.grid(axis).rank_of_line(lines.back())};
  }
  return box;
}

/// The hull of the supports of a zone's changed nodes.
std::optional<RankBox> Zones::changed_box(const Zone& zone) const {
  std::optional<RankBox> box;
  for (std::size_t i = 0; i < zone.changed.size(); ++i) {
    if (!zone.changed[i]) continue;
    box = box ? hull(*box, support(zone, zone.nodes[i])) : support(zone, zone.nodes[i]);
  }
  return box;
}

/// The ranks of a node: of the middle entries of its index vectors.
PerAxis<std::int32_t> Zones::position(const Zone& zone, const PerAxis<std::uint16_t>& node) const {
  PerAxis<std::int32_t> ranks;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto lines = stores_[at(axis)][zone.vectors[at(axis)][node[at(axis)]]];
    ranks[at(axis)] = tree_.grid(axis).rank_of_line(lines[lines.size() / 2]);
  }
  return ranks;
}

/// Appends the zones of the children of a zone's node of the tree, with its nodes and its windows.
void Zones::divide(const Zone& zone, std::vector<Zone>& parts) const {
  const Axis split = tree_.split_axis(zone.tree_node);
  const std::int32_t first = tree_.first_child(zone.tree_node);
  const auto count = at(tree_.child_count(zone.tree_node));
  const std::size_t begin = parts.size();
  for (std::size_t i = 0; i < count; ++i) {
    parts.push_back({first + static_cast<std::int32_t>(i), true, false, {}, {}, zone.window, {}});
  }
  std::vector<PerAxis<std::vector<std::int32_t>>> number(count);
  for (const auto& node : zone.nodes) {
    const std::int32_t rank = position(zone, node)[at(split)];
    std::size_t part = 0;
    while (rank >= tree_.extent(parts[begin + part].tree_node, split).upper) ++part;
    PerAxis<std::uint16_t> moved;
    for (std::size_t a = 0; a < kDimension; ++a) {
      std::vector<std::int32_t>& known = number[part][a];
      known.resize(zone.vectors[a].size(), -1);
      if (known[node[a]] < 0) {
        known[node[a]] = static_cast<std::int32_t>(parts[begin + part].vectors[a].size());
        parts[begin + part].vectors[a].push_back(zone.vectors[a][node[a]]);
      }
      moved[a] = static_cast<std::uint16_t>(known[node[a]]);
    }
    parts[begin + part].nodes.push_back(moved);
  }
}

/// Divides those of the zones that have many nodes; false when none has.
bool Zones::divide_large(const std::map<std::size_t, Effect>& affected) {
  const std::size_t most = at(limits_.elements) / kParts;
  std::map<std::size_t, std::vector<Zone>> replaced;
  for (const auto& [place, effect] : affected) {
    if (zones_[place].nodes.size() <= most || tree_.is_leaf(zones_[place].tree_node)) continue;
    std::vector<Zone>& parts = replaced[place];
    std::vector<Zone> pending{zones_[place]};
    while (!pending.empty()) {
      const Zone zone = std::move(pending.back());
      pending.pop_back();
      if (zone.nodes.size() <= most || tree_.is_leaf(zone.tree_node)) {
        parts.push_back(zone);
        continue;
      }
      std::vector<Zone> children;
      divide(zone, children);
      std::move(children.rbegin(), children.rend(), std::back_inserter(pending));
    }
  }
  if (replaced.empty()) return false;
  replace(replaced);
  return true;
}

/// Puts zones in the places of others.
void Zones::replace(std::map<std::size_t, std::vector<Zone>>& replaced) {
  std::vector<Zone> zones;
  for (std::size_t place = 0; place < zones_.size(); ++place) {
    const auto found = replaced.find(place);
    if (found == replaced.end()) {
      zones.push_back(std::move(zones_[place]));
    } else {
      std::move(found->second.begin(), found->second.end(), std::back_inserter(zones));
    }
  }
  zones_ = std::move(zones);
  index_all();
}

std::vector<RankBox> Zones::update(std::span<const std::int32_t> subdivided) {
  for (const std::size_t place : changed_) zones_[place].changed.clear();
  changed_.clear();
  std::map<std::size_t, Effect> affected = effects(subdivided);
  if (divide_large(affected)) affected = effects(subdivided);
  std::map<std::size_t, std::vector<Zone>> replaced;  // by several
  for (const auto& [place, effect] : affected) {
    Zone& zone = zones_[place];
    if (effect.nodes || !zone.known || !change_vectors(zone, effect.vectors)) {
      std::vector<Zone> again = scan_again(zone);
      if (again.size() > 1) {
        replaced[place] = std::move(again);
        continue;
      }
      zone = std::move(again.front());
    }
    supports_.replace(place, support_hull(zone));
    reaches_.replace(place, reach(zone));
  }
  if (!replaced.empty()) replace(replaced);
  std::vector<RankBox> boxes;
  for (std::size_t place = 0; place < zones_.size(); ++place) {
    if (zones_[place].changed.empty()) continue;
    changed_.push_back(place);
    if (const auto box = changed_box(zones_[place])) boxes.push_back(*box);
  }
  return boxes;
}

}  // namespace asts
