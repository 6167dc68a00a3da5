#include "lib/zones/zones.hpp"

#include <algorithm>
#include <limits>

#include "lib/exact/errors.hpp"
#include "lib/threads/apart.hpp"
#include "lib/threads/parallel_for.hpp"

namespace asts {

namespace {

/// A zone that follows a step is divided until it has at most one node for so many elements of a new one.
constexpr std::size_t kParts = 4;

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

Zone zone_of(std::int32_t tree_node, ZoneNodes&& found, PerAxis<std::vector<std::int32_t>>&& vectors) {
  return {tree_node, true, found.empty, std::move(vectors), std::move(found.nodes), found.window, {}};
}

}  // namespace

Zones::Zones(const RefinementTree& tree, const ZoneLimits& limits)
    : tree_(tree),
      limits_(limits),
      stores_(empty_stores(tree)),
      supports_(tree),
      reaches_(tree),
      scanner_(tree, limits.lines),
      growth_(tree, stores_, scanner_) {}

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

/// For each axis the box that an element split along it touches if it may change nodes of a zone, or their vectors.
PerAxis<RankBox> Zones::reached_boxes(const Zone& zone) const {
  PerAxis<RankBox> boxes;
  boxes.fill(box_of(tree_, zone.tree_node));
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = tree_.grid(axis);
    const RankInterval& window = zone.window[at(axis)];
    RankInterval& side = boxes[at(axis)][axis];
    side = {std::min(side.lower, grid.rank_of_line(window.lower)),
            std::max(side.upper, grid.rank_of_line(window.upper))};
  }
  return boxes;
}

Zones::Affected Zones::affected_by(std::span<const std::int32_t> subdivided) const {
  constexpr std::size_t kAtOnce = 64;  // neighbours mostly: one search for all of them
  struct Split {
    std::int32_t element;
    Axis axis;
    RankBox box;
  };
  Affected result;
  std::vector<Split> splits;
  while (!subdivided.empty()) {
    splits.clear();
    RankBox all = box_of(tree_, subdivided.front());
    for (const std::int32_t element : subdivided.first(std::min(kAtOnce, subdivided.size()))) {
      splits.push_back({element, tree_.split_axis(element), box_of(tree_, element)});
      all = hull(all, splits.back().box);
    }
    subdivided = subdivided.subspan(splits.size());
    reaches_.for_each_touching(all, [&](std::size_t place) {
      const PerAxis<RankBox> reached = reached_boxes(zones_[place]);
      std::vector<std::int32_t>* elements = nullptr;
      for (const Split& split : splits) {
        if (!touch(reached[at(split.axis)], split.box)) continue;
        if (elements == nullptr) elements = &result[place];
        elements->push_back(split.element);
      }
    });
  }
  return result;
}

/// The zones that come of one, with all nodes marked as changed.
std::vector<Zone> Zones::scan_again(const Zone& before) {
  std::vector<Zone> zones;
  scan(before.tree_node, zones);
  for (Zone& zone : zones) zone.changed.assign(zone.nodes.size(), true);
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
bool Zones::divide_large(const Affected& affected) {
  const std::size_t most = at(limits_.elements) / kParts;
  std::map<std::size_t, std::vector<Zone>> replaced;
  for (const auto& [place, split] : affected) {
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
  Affected affected = affected_by(subdivided);
  if (divide_large(affected)) affected = affected_by(subdivided);
  std::map<std::size_t, std::vector<Zone>> replaced;  // by several
  for (const auto& [place, split] : affected) {
    Zone& zone = zones_[place];
    if (!zone.known || !growth_.follow(zone, split)) {
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
