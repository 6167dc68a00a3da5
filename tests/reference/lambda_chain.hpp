#pragma once

#include <cstdint>
#include <set>
#include <stdexcept>
#include <vector>

#include "tests/reference/complexity_claims.hpp"

/// Section 7's lambda for meshes that are too large to be written down: Algorithms 2.8 and 2.9 on the set of elements
/// that were subdivided, transcribed from the paper. Coordinates are integers, in units of 1/(2 m^n) with n =
/// ceil(L/3): every element of level L or less has its corners on that grid, and its midpoint.
namespace asts::reference {

struct GridBox {
  std::array<std::int64_t, dimension> lower, upper;
  int level = 0;
  auto operator<=>(const GridBox&) const = default;
};

/// An element of the finest level would be subdivided.
struct TooFine : std::logic_error {
  using std::logic_error::logic_error;
};

/// The sum of lambda(K,K~) over some marks K~, and how many of these it is positive for.
struct LambdaSum {
  std::size_t within = 0;
  RootSum sum;
};

class SubdividedSet {
 public:
  /// Throws std::overflow_error when the grid of the finest level has coordinates of more than 62 bits.
  explicit SubdividedSet(const Setting& setting, int finest_level = 6);

  /// The element of the mesh that a mark names: half-open, but the domain's upper faces belong to the last element.
  /// REQUIRES: inside the domain.
  GridBox element_at(const Point& point) const;
  /// Algorithm 2.9. Throws TooFine when an element of the finest level would be subdivided.
  void refine(const std::vector<GridBox>& marks);
  void refine(const GridBox& mark) { refine(std::vector{mark}); }
  /// Definition 3.2 by its history: no element of the mesh is coarser than K in the patch of a subdivided K.
  bool admissible() const;
  /// In G_J \ G_0.
  bool is_new(const GridBox& element) const;
  std::size_t size() const { return subdivided_.size(); }
  /// The number of this child, 0 to m-1, of an element.
  GridBox child(const GridBox& element, std::int64_t number) const;

  Box box(const GridBox& element) const;

  /// |G_J \ G_0|.
  std::size_t new_element_count() const;
  /// G_J \ G_0. REQUIRES: new_element_count() of them fit into memory.
  std::vector<GridBox> new_elements() const;

  /// lambda(K, K~) summed over the marks, for the distances 2 (d_1, d_2, d_3).
  LambdaSum lambda_sum(const GridBox& k, const std::vector<GridBox>& marks, DistanceConstant d) const;
  /// The same sum over the new elements for one mark.
  LambdaSum lambda_sum_over_new(const GridBox& mark, DistanceConstant d) const;

  /// lambda(K, K~) summed over the marks is below 1, exactly, with the printed constants.
  bool lambda_sum_below_one(const GridBox& k, const std::vector<GridBox>& marks) const;

 private:
  std::array<RootSum, dimension> reach_at(int level, DistanceConstant d) const;
  bool within(const GridBox& k, const GridBox& mark, const std::array<RootSum, dimension>& reach) const;
  GridBox unit_cube(const std::array<std::int64_t, dimension>& index) const;
  std::vector<GridBox> coarser_in_patch(const GridBox& k) const;
  void collect_coarser(const GridBox& node, const GridBox& environment, int level, std::vector<GridBox>& found) const;

  Setting setting_;
  int finest_;
  std::int64_t unit_ = 2;  ///< grid steps of a unit cube's side
  std::set<GridBox> subdivided_;
};

}  // namespace asts::reference
