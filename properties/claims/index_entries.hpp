#pragma once

#include "properties/claims/claim.hpp"

namespace asts {

/// The note in Definition 4.3 for the axes asked for: each of 0, ..., ceil(p/2)-1 and X~-ceil(p/2)+1, ..., X~ is in
/// X(y,z) for every point (y,z) of the closed domain; likewise for the other axes.
///
/// It is enough to look at lines through the open cells between the mesh's lines: an element whose closed rectangle
/// contains a cell also contains the cell's closure, so that X(y,z) at a point on a line has all entries of the cells
/// beside it. Met: the cells whose index set has more than the integers.
Trial judge_frame_entries(const Mesh& mesh, const PerAxis<bool>& axes);

/// Definition 4.4: for each active node and axis there is exactly one way to take p+2 consecutive entries of the global
/// index set with the node's coordinate as the middle one. Met: the vectors that are not p+2 consecutive integers.
Trial judge_index_vectors(const Mesh& mesh);

Trial frame_in_index_sets(MeshUnderTest& mesh);
Trial frame_in_index_sets_repaired(MeshUnderTest& mesh);
Trial index_vectors_exist(MeshUnderTest& mesh);

}  // namespace asts
