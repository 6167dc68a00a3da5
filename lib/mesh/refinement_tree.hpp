#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "lib/mesh/axis_grid.hpp"
#include "lib/mesh/node_array.hpp"
#include "lib/mesh/setting.hpp"

namespace asts {

/// A mesh that level-directed subdivisions (Definitions 2.6, 2.7) make from the initial mesh (Definition 2.1), with
/// its history: the tree of all elements that were ever in it. The leaves are the mesh.
///
/// A node of the tree is a box: one cell of each axis. Nodes of level >= 0 are elements; the level is the number of
/// subdivisions behind it (Definition 2.2: -log_m of the volume, the volume being m^-level). Above the unit cubes a
/// binary hierarchy of blocks, with negative levels that grow towards the elements, ends in node 0, the domain; it
/// exists so that a search can leave out many elements at once.
///
/// Laws: (1) the leaves tile the domain; (2) an element of level k was split along axis k mod 3 only; (3) node 0 covers
/// the domain; (4) the children of a node are contiguous, in the order of their coordinates; (5) they come after it.
/// Bounds: fewer than 2^31 nodes (ResourceError); no bound on the level.
class RefinementTree {
 public:
  static constexpr std::int32_t kNone = -1;
  static constexpr std::int32_t kNoLevel = std::numeric_limits<std::int32_t>::max();

  struct Node {
    PerAxis<std::int32_t> cell;
    std::int32_t parent;
    std::int32_t first_child;  ///< kNone for a leaf
    std::int32_t level;        ///< negative for blocks
    std::int32_t coarsest;     ///< the lowest level of a leaf below that is not marked; kNoLevel if there is none
  };

  /// The initial mesh. Throws ResourceError when it has more than kMaxInitialElements elements.
  explicit RefinementTree(const Setting& setting);

  const Setting& setting() const { return setting_; }
  /// A copy of all of it. Where others mark leaves at the same time, ask for the parts.
  Node node(std::int32_t id) const {
    const Place& place = places_[at(id)];
    const Link& link = links_[at(id)];
    return {place.cell, link.parent, place.first_child, link.level, coarsest_[at(id)]};
  }
  std::int32_t node_count() const { return static_cast<std::int32_t>(places_.size()); }
  std::int32_t coarsest(std::int32_t id) const { return coarsest_[at(id)]; }
  std::int32_t cell(std::int32_t id, Axis axis) const { return places_[at(id)].cell[at(axis)]; }
  std::int32_t parent(std::int32_t id) const { return links_[at(id)].parent; }
  std::int32_t level(std::int32_t id) const { return links_[at(id)].level; }
  std::int32_t first_child(std::int32_t id) const { return places_[at(id)].first_child; }
  bool is_leaf(std::int32_t id) const { return places_[at(id)].first_child == kNone; }
  /// m for an element, 2 for a block.
  std::int32_t child_count(std::int32_t id) const { return links_[at(id)].level < 0 ? 2 : setting_.grading; }
  /// The axis along which a node is split: level mod 3 for an element (Definition 2.6).
  Axis split_axis(std::int32_t id) const {
    const std::int32_t level = links_[at(id)].level;
    return level < 0 ? longest_block_axis(id) : level % kDimension;
  }

  /// The place of a child among its siblings. REQUIRES: an element of level 1 or more.
  std::int32_t child_number(std::int32_t id) const { return (id - initial_nodes_) % setting_.grading; }

  /// Asks for a node, for what is above it, or for the coarsest levels and places of a node's children, a while before
  /// they are read: walks through large trees mostly wait for memory. The children of a leaf are nothing.
  void prefetch(std::int32_t id) const {
    __builtin_prefetch(&places_[at(id)]);
    __builtin_prefetch(&links_[at(id)]);
    __builtin_prefetch(&coarsest_[at(id)]);
  }
  void prefetch_parent(std::int32_t id) const {
    const std::int32_t parent = links_[at(id)].parent;
    if (parent == kNone) return;
    __builtin_prefetch(&links_[at(parent)]);
    __builtin_prefetch(&coarsest_[at(parent)]);
  }
  void prefetch_place(std::int32_t id) const { __builtin_prefetch(&places_[at(id)]); }
  void prefetch_children(std::int32_t first_child) const {
    if (first_child == kNone) return;
    __builtin_prefetch(&places_[at(first_child)]);
    __builtin_prefetch(&coarsest_[at(first_child)]);
  }

  /// Appends a node's children to a stack, so that they are taken off it in the order of their coordinates.
  /// REQUIRES: no leaf.
  void push_children(std::int32_t id, std::vector<std::int32_t>& stack) const {
    const std::int32_t first = first_child(id);
    for (std::int32_t child = first + child_count(id) - 1; child >= first; --child) stack.push_back(child);
  }

  std::int64_t element_count() const { return element_count_; }
  /// |G \ G_0|: the leaves that are no unit cubes.
  std::int64_t new_element_count() const { return element_count_ - initial_left_; }
  std::int32_t max_level() const { return max_level_; }

  const AxisGrid& grid(Axis axis) const { return grids_[at(axis)]; }
  RankInterval extent(std::int32_t id, Axis axis) const { return grid(axis).extent(cell(id, axis)); }
  /// The extent of the open environment U(K) (Definition 2.4) along an axis. REQUIRES: level >= 0.
  RankInterval environment(std::int32_t id, Axis axis) const { return grid(axis).window(cell(id, axis)); }

  /// The leaf that contains a point of the domain; elements are half-open, the domain's upper faces belong to the last
  /// element. Cost: linear in the leaf's level.
  std::int32_t leaf_at(const Point& point) const;

  /// Definition 2.7: replaces leaves by their m children each (Definition 2.6); the children follow in the order of the
  /// leaves. Ranks are stale until update_ranks(). Cost: linear in the leaves and the cells of the axes. `jobs` threads
  /// make the same tree as one. REQUIRES: distinct leaves, marked or not.
  void subdivide(std::span<const std::int32_t> leaves, int jobs = 1);
  void subdivide(std::int32_t leaf) { subdivide(std::span(&leaf, 1)); }
  void update_ranks();

  /// Marks a leaf: searches by `coarsest` do not see it any more, until it is subdivided. REQUIRES: a leaf.
  void mark(std::int32_t leaf) { mark_below(0, leaf); }
  /// The same, but no node above `top`, which has the leaf below, is told: threads may mark below different nodes, none
  /// above another, and one of them then calls carry_up() for each node.
  void mark_below(std::int32_t top, std::int32_t leaf) { set_coarsest(leaf, kNoLevel, top); }
  void carry_up(std::int32_t top) { set_coarsest(top, coarsest_[at(top)], 0); }
  bool is_marked(std::int32_t leaf) const { return is_leaf(leaf) && coarsest(leaf) == kNoLevel; }

  /// The node that is exactly this unit cube. REQUIRES: in the domain.
  std::int32_t unit_cube(const PerAxis<std::int32_t>& index) const;

 private:
  /// The nodes are stored in three parts, by what is read together: a search reads the coarsest levels of many nodes
  /// and the places of some.
  struct Place {
    PerAxis<std::int32_t> cell;
    std::int32_t first_child;
  };
  struct Link {
    std::int32_t parent;
    std::int32_t level;
  };

  void push_node(const Node& node);
  Axis longest_block_axis(std::int32_t block) const;
  std::int32_t block_level(const PerAxis<std::int32_t>& cells) const;
  void halve(std::int32_t block);
  void build_blocks();
  void set_coarsest(std::int32_t id, std::int32_t level, std::int32_t top);
  std::int32_t coarsest_sibling(std::int32_t id, std::int32_t bound) const;
  struct Seen;
  void prepare(std::span<const std::int32_t> leaves, int jobs);
  std::vector<Seen> look_at(std::span<const std::int32_t> leaves, int jobs) const;
  void split_cells(const std::vector<Seen>& seen);
  void grow(std::size_t count);
  void write_children(std::int32_t leaf, std::int32_t first);
  void lower_coarsest(std::int32_t id, std::int32_t level);

  Setting setting_;
  std::vector<AxisGrid> grids_;
  NodeArray<Place> places_;
  NodeArray<Link> links_;
  NodeArray<std::int32_t> coarsest_;
  std::vector<std::int32_t> unit_cubes_;
  std::int32_t initial_nodes_ =
      0;  ///< after the domain every two nodes are the halves of one up to here, then every m the children of one
  std::int64_t element_count_ = 0;
  std::int64_t initial_left_ = 0;
  std::int32_t max_level_ = 0;
};

}  // namespace asts
