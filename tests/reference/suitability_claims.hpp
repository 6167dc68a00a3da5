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

}  // namespace asts::reference
