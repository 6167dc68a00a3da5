#pragma once

#include <cstdint>
#include <vector>

#include "lib/zones/list_table.hpp"
#include "lib/zones/zone_axis.hpp"

namespace asts {

/// What is proven of a mesh, or of a part of it. False: not proven.
struct Proven {
  bool analysis_suitable = true;  ///< Definition 5.2
  bool dual_compatible = true;    ///< Definition 6.4
  bool dual_basis = true;         ///< lambda_v(B_w) = delta_vw (Definition 6.2)

  bool all() const { return analysis_suitable && dual_compatible && dual_basis; }
  Proven& operator&=(const Proven& other) {
    analysis_suitable = analysis_suitable && other.analysis_suitable;
    dual_compatible = dual_compatible && other.dual_compatible;
    dual_basis = dual_basis && other.dual_basis;
    return *this;
  }
};

/// Looks for violations of three properties at the points of a closed box Z, given all active nodes whose supports
/// touch Z.
///
/// Where boxes cover the domain and none finds a violation, the mesh has the properties:
///
/// Dual basis. If lambda_v(B_w) is not delta_vw, then v = w, or all three factors differ from 0, so that the supports
/// meet in positive volume. Any box that contains a common point has both nodes, and their factors do not depend on Z.
///
/// Dual-compatible. Say v and w fail to overlap along x and y, with supports that meet in positive volume: lines q and
/// r in the closed ranges of both are entries of one alone. Let z be in the interiors of both ranges, on no line. A box
/// Z that contains (q,r,z) has both nodes, both lines, and the gap between its lines that z is in.
///
/// Analysis-suitable. If the point (q,r,z) is in R_x and R_y, take a box Z that contains it. The four nodes behind it
/// have supports that contain it, so they are in the list. The points (q,r,t) of Z in R_x and R_y are, for each of the
/// four conditions, a union of closed intervals whose ends are entries of vectors, ends of Z, or of the active region:
/// all of them lines. A common point of four closed intervals with ends on lines is on a line if it is their greatest
/// lower end. So only points with three coordinates on lines are asked.
///
/// When only some of the nodes are asked, the first two are about pairs of which one at least is: the others hold
/// already. A violation found is one in each case; but the boxes do not tell which pair the paper's order has first.
///
/// Where the mesh around Z is uniform, nothing is compared: if every line is an entry of all vectors whose range
/// contains it, along two axes, no pair fails to overlap along them, and one region at most is not empty. And all three
/// properties depend on the nodes by the vectors that they have: nodes with the same vectors along two axes are a
/// column, the list of their vectors along the third one; nodes with the same vector along the first axis are a row,
/// the list of the second vectors with their columns. Equal columns, and equal rows, are compared once with each other
/// one. In a uniform part all columns are equal, and all rows.
///
/// Cost: linear in nodes, and in pairs of vectors of one axis; beyond that in pairs of different rows and columns, of
/// which those that have nothing to do with each other are passed over by words.
class ZoneCheck {
 public:
  /// REQUIRES: both outlive it.
  ZoneCheck(const RefinementTree& tree, const std::vector<VectorStore>& stores, const ZoneLimits& limits);

  ZoneAxis& axis(Axis axis) { return axes_[at(axis)]; }

  /// Starts a box with no nodes.
  void begin(const RankBox& box);
  /// A node by the numbers of its vectors (ZoneAxis::add), and whether pairs with it are asked.
  void add_node(const PerAxis<std::int32_t>& vectors, bool asked) {
    nodes_.push_back(vectors);
    if (asked) asked_.push_back(vectors);
  }

  /// Where the box has to be cut because too many lines run through it.
  struct Cut {
    Axis axis = -1;  ///< -1: nowhere
    std::int32_t rank = 0;
  };
  /// Numbers the lines. REQUIRES: all vectors are there.
  Cut number_lines();
  Proven decide();

 private:
  void group_by(Axis axis);
  void sort_by(Axis axis, std::vector<PerAxis<std::int32_t>>& nodes);
  void find_rows(Axis axis, const std::vector<PerAxis<std::int32_t>>& nodes, std::vector<std::int32_t>& row_of);
  void index_groups(Axis axis);
  BitSet numbers_with(const std::vector<std::int32_t>& row);
  bool compatible(Axis axis);
  bool rows_compatible(Axis axis, std::int32_t one, std::int32_t other) const;
  bool dual_basis();
  bool dual_pairs(const std::vector<std::int32_t>& row_of_v, const std::vector<std::int32_t>& row_of_w);
  bool dual_rows(std::int32_t one, std::int32_t other, bool same);
  bool dual_columns(std::int32_t one, std::int32_t other, bool same);
  void paint(Axis axis);
  bool regions_meet(Axis axis) const;

  const RefinementTree* tree_;
  ZoneLimits limits_;
  const std::vector<VectorStore>* stores_;
  std::vector<ZoneAxis> axes_;
  std::vector<PerAxis<std::int32_t>> nodes_;
  std::vector<PerAxis<std::int32_t>> asked_;  ///< of these
  PerAxis<bool> irregular_;
  Axis grouped_ = -1;  ///< the axis of the last grouping in this box; the nodes are in its order
  std::vector<PerAxis<std::int32_t>> sorted_;
  std::vector<std::size_t> begin_;
  ListTable columns_;    ///< nodes with the same vectors along two axes: their vectors along the third one
  ListTable rows_;       ///< nodes with the same vector along one axis: a list of vectors, then their columns
  ListTable seconds_;    ///< these lists of vectors
  BitRows second_sets_;  ///< the same as sets
  BitRows column_sets_;  ///< and those of the columns
  std::vector<std::uint64_t> column_gaps_;  ///< ZoneAxis::gaps of the vectors of each column
  std::vector<std::int32_t> column_of_;     ///< by row and vector of the second axis; set where the row has the vector
  std::vector<std::int32_t> row_;           ///< of each vector along the first axis, -1 where it has none
  std::vector<std::int32_t> asked_row_;     ///< the same of the asked nodes alone
  BitRows with_rows_;
  BitRows compatible_rows_;  ///< pairs that were asked and found good, as in the following
  BitRows dual_rows_;
  BitRows dual_columns_;
  BitRows dual_same_rows_;  ///< of nodes with the same vector along the first axis
  BitRows dual_same_columns_;
  PerAxis<std::vector<std::uint64_t>> regions_;  ///< R_a: for lines of a and the next axis, bits for those of the last
  std::vector<std::uint64_t> having_;
  std::vector<std::uint64_t> lacking_;
};

}  // namespace asts
