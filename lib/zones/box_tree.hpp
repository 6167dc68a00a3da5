#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "lib/zones/rank_box.hpp"

namespace asts {

/// Finds which of a list of boxes touch a box: a binary hierarchy of hulls over the list, whose neighbours should be
/// neighbours in space. Boxes are kept by lines, so that they stay when ranks change.
/// Cost: linear to build, logarithmic to change one; a search visits the hulls that touch.
class BoxTree {
 public:
  explicit BoxTree(const RefinementTree& tree) : tree_(&tree) {}

  /// The ends are lines.
  void assign(const std::vector<RankBox>& boxes);
  void replace(std::size_t place, const RankBox& box);
  const RankBox& operator[](std::size_t place) const { return hulls_[leaves_ + place]; }

  /// Calls visit(place) for each that touches a box of ranks, in the order of the list.
  template <typename Visit>
  void for_each_touching(const RankBox& ranks, const Visit& visit) const {
    if (count_ > 0) search(1, ranks, visit);
  }

  /// A box that touches nothing.
  static RankBox nothing();

 private:
  static bool is_nothing(const RankBox& box) { return box[0].lower < 0; }
  RankBox hull_of(const RankBox& one, const RankBox& other) const;
  bool touches(const RankBox& lines, const RankBox& ranks) const;

  template <typename Visit>
  void search(std::size_t node, const RankBox& ranks, const Visit& visit) const {
    if (!touches(hulls_[node], ranks)) return;
    if (node >= leaves_) {
      visit(node - leaves_);
      return;
    }
    search(2 * node, ranks, visit);
    search(2 * node + 1, ranks, visit);
  }

  const RefinementTree* tree_;
  std::size_t count_ = 0;
  std::size_t leaves_ = 1;  ///< a power of two
  std::vector<RankBox> hulls_;
};

}  // namespace asts
