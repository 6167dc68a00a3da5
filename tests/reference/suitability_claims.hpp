#pragma once

#include <map>
#include <string>

#include "tests/reference/decide.hpp"
#include "tests/reference/suitability_cases.hpp"

/// Section 6's statements, from the paper alone and by brute force.
namespace asts::reference {

/// The statements by their ids in the ledger of claims, for a mesh. Left out: what needs more active nodes than
/// `max_nodes` allows for quadruples of nodes. Empty when there is no active node or an index vector is missing.
struct SuitabilityClaims {
  std::map<std::string, Verdict> verdicts;
  std::size_t lemma_met = 0;  ///< (axis, q, v1, v2) that satisfy the hypothesis of Lemma 6.5
  bool suitable_in_whole_domain = false;
  bool meeting_pairs_overlap = false;  ///< any two active nodes whose closed supports meet partially overlap
  bool compatible = false;             ///< Definition 6.4
  bool suitable_inside = false;        ///< the form of Theorem 6.6 that leaves Definition 6.4 as it is
};

SuitabilityClaims decide_suitability_claims(const Setting& setting, const Mesh& mesh, std::size_t max_nodes);

/// The remark to Definition 6.4: along how many of the axes the index vectors overlap, and the general definition,
/// different and overlapping vectors along one of them.
template <class T>
int overlaps(const ActiveNode<T>& v, const ActiveNode<T>& w, const std::vector<std::size_t>& axes);
template <class T>
bool weakly_overlap(const ActiveNode<T>& v, const ActiveNode<T>& w, const std::vector<std::size_t>& axes);

/// Is there, for every two elements K and L, an element with K's extent across the axis and L's along it?
template <class T>
bool extruded(const Space<T>& space, std::size_t axis);

}  // namespace asts::reference
