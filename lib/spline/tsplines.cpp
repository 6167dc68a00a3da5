#include "lib/spline/tsplines.hpp"

#include <algorithm>
#include <numeric>

#include "lib/spline/active_nodes.hpp"

namespace asts {

namespace {

/// The local index vectors along one axis. The nodes of a line are taken in ascending order; consecutive entries of the
/// global index set are gathered around them, (p+1)/2 on either side of each node, and the vectors are cut out.
class LineVectors {
 public:
  LineVectors(const Mesh& mesh, const ActiveNodes& nodes, Axis axis, TSplines& splines)
      : mesh_(mesh),
        nodes_(nodes),
        axis_(axis),
        a_(at(axis)),
        splines_(splines),
        reach_((mesh.setting.degree[a_] + 1) / 2) {}

  void fill() {
    const std::vector<std::int32_t>& order = splines_.line_order[a_];
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
      for (end = begin + 1; end < order.size() && same_line(order[begin], order[end]);) ++end;
      walk_line({order.begin() + static_cast<std::ptrdiff_t>(begin), order.begin() + static_cast<std::ptrdiff_t>(end)});
    }
  }

 private:
  bool same_line(std::int32_t one, std::int32_t other) const {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if (axis != a_ && nodes_.positions[at(one)][axis] != nodes_.positions[at(other)][axis]) return false;
    }
    return true;
  }

  std::int32_t place(std::int32_t node) const { return nodes_.positions[at(node)][a_]; }

  LineWalker walker_at(std::int32_t node, int direction) const {
    PerAxis<HalfRank> position{};
    for (std::size_t axis = 0; axis < kDimension; ++axis) position[axis] = 2 * nodes_.positions[at(node)][axis];
    LineWalker walker(mesh_, axis_, position, direction);
    for (std::size_t quadrant = 0; quadrant < LineWalker::kQuadrants; ++quadrant) {
      const std::int32_t element = nodes_.beside[at(node)][octant_of(quadrant, direction)];
      if (element >= 0) walker.enter(quadrant, element);
    }
    return walker;
  }

  /// The octant of a node that a walk from it enters in one of its quadrants.
  std::size_t octant_of(std::size_t quadrant, int direction) const {
    std::size_t octant = direction > 0 ? std::size_t{1} << a_ : 0;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if (axis == a_) continue;
      if ((quadrant & 1) == 0) octant |= std::size_t{1} << axis;
      quadrant >>= 1;
    }
    return octant;
  }

  /// The next entry above a node: the nearest upper end among the elements in the octants above it. An octant without
  /// an element that has the node as a vertex is looked up. Active nodes are inside the domain: all octants have
  /// elements.
  std::int32_t next_above(std::int32_t node) const {
    std::int32_t nearest = std::numeric_limits<std::int32_t>::max();
    for (std::size_t octant = 0; octant < ActiveNodes::kOctants; ++octant) {
      if ((octant >> a_ & 1) == 0) continue;
      std::int32_t element = nodes_.beside[at(node)][octant];
      if (element < 0) element = element_in(node, octant);
      nearest = std::min(nearest, mesh_.elements[at(element)].upper[a_]);
    }
    return nearest;
  }

  std::int32_t element_in(std::int32_t node, std::size_t octant) const {
    PerAxis<std::int32_t> cell = nodes_.positions[at(node)];
    for (std::size_t axis = 0; axis < kDimension; ++axis) cell[axis] -= (octant >> axis & 1) == 0 ? 1 : 0;
    return mesh_.locator.element_at(cell);
  }

  void walk_line(std::span<const std::int32_t> line) {
    begin_segment(line.front());
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (next_above(line[i - 1]) != place(line[i]) && !bridge(line[i - 1], place(line[i]))) {
        cut_vectors();
        begin_segment(line[i]);
        continue;
      }
      entries_.push_back(place(line[i]));
      members_.push_back({line[i], entries_.size() - 1});
    }
    append_above(line.back(), reach_);
    cut_vectors();
  }

  /// Starts a run of consecutive entries with a node and the entries below that its vector needs.
  void begin_segment(std::int32_t node) {
    entries_.clear();
    members_.clear();
    LineWalker walker = walker_at(node, -1);
    for (int i = 0; i < reach_; ++i) {
      const std::int32_t rank = walker.next();
      if (rank < 0) break;
      entries_.push_back(rank);
    }
    std::reverse(entries_.begin(), entries_.end());
    entries_.push_back(place(node));
    members_.push_back({node, entries_.size() - 1});
  }

  void append_above(std::int32_t node, int count) {
    LineWalker walker = walker_at(node, +1);
    for (int i = 0; i < count; ++i) {
      const std::int32_t rank = walker.next();
      if (rank < 0) break;
      entries_.push_back(rank);
    }
  }

  /// Appends the entries between a node and the next node of the line, up to as many as the node's vector needs.
  /// Returns whether the next node was reached.
  bool bridge(std::int32_t node, std::int32_t target) {
    LineWalker walker = walker_at(node, +1);
    for (int i = 0; i < reach_; ++i) {
      const std::int32_t entry = walker.next();
      if (entry == target) return true;
      entries_.push_back(entry);
    }
    return walker.next() == target;
  }

  void cut_vectors() {
    const auto reach = at(reach_);
    for (const auto& [node, index] : members_) {
      if (index < reach || index + reach >= entries_.size()) {
        if (!splines_.missing) splines_.missing = TSplines::MissingVector{nodes_.positions[at(node)], axis_};
        continue;
      }
      splines_.vector_ids[at(node)][a_] =
          splines_.vectors[a_].intern(std::span(entries_).subspan(index - reach, 2 * reach + 1));
    }
  }

  struct Member {
    std::int32_t node;
    std::size_t index;  ///< of the node's own entry
  };

  const Mesh& mesh_;
  const ActiveNodes& nodes_;
  Axis axis_;
  std::size_t a_;
  TSplines& splines_;
  int reach_;
  std::vector<std::int32_t> entries_;
  std::vector<Member> members_;
};

/// Nodes of one line parallel to the axis stand together: sorted by the other axes first.
std::vector<std::int32_t> order_along(const Mesh& mesh, const ActiveNodes& nodes, Axis axis) {
  std::vector<std::int32_t> order(nodes.positions.size());
  std::iota(order.begin(), order.end(), 0);
  stable_sort_by_axis(mesh, nodes.positions, axis, order);
  for (Axis other = kDimension - 1; other >= 0; --other) {
    if (other != axis) stable_sort_by_axis(mesh, nodes.positions, other, order);
  }
  return order;
}

}  // namespace

TSplines tsplines_of(const Mesh& mesh) {
  TSplines splines;
  splines.region = active_region(mesh);
  ActiveNodes nodes = active_nodes(mesh, splines.region);
  splines.vector_ids.assign(nodes.positions.size(), {});
  for (Axis axis = 0; axis < kDimension; ++axis) splines.vectors.emplace_back(mesh.setting.degree[at(axis)]);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    splines.line_order[at(axis)] = order_along(mesh, nodes, axis);
    LineVectors(mesh, nodes, axis, splines).fill();
  }
  splines.nodes = std::move(nodes.positions);
  return splines;
}

bool may_change_splines(const TSplines& splines, const Box& element, Axis axis) {
  const auto projects_into = [&](const PerAxis<std::int32_t>& node) {
    for (Axis other = 0; other < kDimension; ++other) {
      const std::int32_t place = node[at(other)];
      if (other != axis && (place < element.lower[at(other)] || place > element.upper[at(other)])) return false;
    }
    return true;
  };
  return std::any_of(splines.nodes.begin(), splines.nodes.end(), projects_into);
}

}  // namespace asts
