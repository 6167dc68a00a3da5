#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <unordered_set>
#include <vector>

#include "lib/mesh/case.hpp"
#include "lib/mesh/setting.hpp"

namespace asts {

/// An element that level-directed subdivisions make from unit cubes: along each axis it is the interval
/// [index, index + 1] * side, where `side` is level_size(m, level) along that axis.
struct LevelCell {
  std::int32_t level = 0;
  PerAxis<std::int64_t> index{};

  friend auto operator<=>(const LevelCell&, const LevelCell&) = default;
};

/// How often the elements above one of this level were split along an axis.
constexpr std::int32_t splits(std::int32_t level, Axis axis) { return (level + 2 - axis) / kDimension; }

/// A mesh that calls of Algorithm 2.9 make from the initial mesh, known by nothing but the set of elements that were
/// subdivided. For large m that is all there is room for: a thousand steps with a few dozen subdivisions each are
/// nothing, but make 6 * 10^7 elements when m is 1303, and a RefinementTree has a node for each.
///
/// An element is in the mesh exactly if it is not in the set and is a unit cube or has its parent in the set.
///
/// The closure (Algorithm 2.8) goes through the levels from the finest. For K of level k the elements of the patch that
/// are coarser have level k-1, as the mesh is admissible (Lemma 3.5), so they are found among the cells of level k-1
/// that meet the open U(K): those that have not been subdivided. Were some element of the patch coarser than that, one
/// of these cells would have a parent that was not subdivided; that is checked for every one of them (InternalError).
///
/// Laws (each has a test that names it): (1) subdivided elements, element_at and new_element_count are those of a
/// RefinementTree after the same steps of lib/refine/refinement.
/// Bounds: X~ m^splits stays below 2^61 along each axis (ResourceError).
/// Cost: for each subdivided element one look-up for each cell of the next coarser level in its patch, at most
/// (2p+3)^3; memory linear in the subdivided elements.
class SubdividedElements {
 public:
  explicit SubdividedElements(const Setting& setting) : setting_(setting) {}

  const Setting& setting() const { return setting_; }
  /// In the order in which they were subdivided.
  const std::vector<LevelCell>& elements() const { return order_; }
  bool contains(const LevelCell& cell) const { return set_.contains(cell); }
  /// |G \ G_0|: each subdivision takes one element away and brings m.
  std::int64_t new_element_count() const;

  /// The element of the mesh that contains a point of the domain, as RefinementTree::leaf_at.
  LevelCell element_at(const Point& point) const;

  /// Algorithm 2.9; the marks may repeat themselves. Returns the closure, ordered by falling level, within a level the
  /// marks first. REQUIRES: elements of the mesh (InputError).
  std::vector<LevelCell> refine(std::span<const LevelCell> marks);

 private:
  struct Hash {
    std::size_t operator()(const LevelCell& cell) const;
  };
  using Cells = std::vector<LevelCell>;
  using Set = std::unordered_set<LevelCell, Hash>;

  std::int64_t cells_along(std::int32_t level, Axis axis) const;
  LevelCell parent(const LevelCell& cell) const;
  bool is_there(const LevelCell& cell) const { return cell.level == 0 || contains(parent(cell)); }
  void add_coarser(const LevelCell& element, Set& marked, Cells& coarser) const;

  Setting setting_;
  Cells order_;
  Set set_;
  std::int64_t subdivided_cubes_ = 0;
};

/// The child of an element with this number, 0 to m-1 along the axis of the split.
LevelCell child_of(const LevelCell& element, int grading, std::int64_t number);

}  // namespace asts
