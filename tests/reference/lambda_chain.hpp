#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "tests/reference/mesh.hpp"

/// Section 7's lambda for meshes that are too large to be written down: Algorithms 2.8 and 2.9 on the set of elements
/// that were subdivided, transcribed from the paper. Coordinates are integers, in units of 1/(2 m^2): every element of
/// level 6 or less has its corners on that grid, and its midpoint.
namespace asts::reference {

struct GridBox {
  std::array<std::int64_t, dimension> lower, upper;
  int level = 0;
  auto operator<=>(const GridBox&) const = default;
};

class SubdividedSet {
 public:
  explicit SubdividedSet(const Setting& setting);

  /// The element of the mesh that contains the point, half-open. REQUIRES: inside the domain, not on its upper faces.
  GridBox element_at(const Point& point) const;
  /// Algorithm 2.9 for one mark. Throws std::logic_error when an element of level 6 would be subdivided.
  void refine(const GridBox& mark);
  /// Definition 3.2 by its history: no element of the mesh is coarser than K in the patch of a subdivided K.
  bool admissible() const;
  /// In G_J \ G_0.
  bool is_new(const GridBox& element) const;
  std::size_t size() const { return subdivided_.size(); }
  /// The number of this child, 0 to m-1, of an element.
  GridBox child(const GridBox& element, std::int64_t number) const;

  /// lambda(K, K~) summed over the marks is below 1, exactly, with the printed constants.
  bool lambda_sum_below_one(const GridBox& k, const std::vector<GridBox>& marks) const;

 private:
  GridBox unit_cube(const std::array<std::int64_t, dimension>& index) const;
  std::vector<GridBox> coarser_in_patch(const GridBox& k) const;
  void collect_coarser(const GridBox& node, const GridBox& environment, int level, std::vector<GridBox>& found) const;

  Setting setting_;
  std::int64_t unit_;  ///< grid steps of a unit cube's side: 2 m^2
  std::set<GridBox> subdivided_;
};

}  // namespace asts::reference
