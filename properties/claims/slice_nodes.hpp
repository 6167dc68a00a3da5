#pragma once

#include <cstdint>
#include <vector>

#include "properties/mesh_under_test.hpp"

namespace asts {

/// The sets N_x(q), N_y(r), N_z(s) of Definition 5.1 for all lines of a mesh: v is in N_x(q) exactly if (q, v_2, v_3)
/// is in Xi_x, that is, if q is in the global index set X(v_2, v_3) (Definition 4.3). Index vectors play no part in it.
/// Cost and memory: lines times active nodes.
class SliceNodes {
 public:
  explicit SliceNodes(MeshUnderTest& mesh);

  bool contains(Axis axis, std::int32_t rank, std::int32_t node) const {
    return members_[at(axis)][at(rank) * nodes_ + at(node)];
  }
  void set(Axis axis, std::int32_t rank, std::int32_t node, bool belongs) {
    members_[at(axis)][at(rank) * nodes_ + at(node)] = belongs;
  }

 private:
  std::size_t nodes_;
  PerAxis<std::vector<bool>> members_;
};

/// A slice that tells two nodes apart: S_axis(q) meets both supports, `in` is in N_axis(q), `out` is not.
struct TellingSlice {
  Axis axis;
  std::int32_t rank;
  std::int32_t in;
  std::int32_t out;
};

/// All slices of the active region along an axis that tell v and w apart.
std::vector<TellingSlice> telling_slices(const TSplines& splines, const SliceNodes& slice_nodes, Axis axis,
                                         std::int32_t v, std::int32_t w);

}  // namespace asts
