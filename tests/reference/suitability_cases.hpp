#pragma once

#include <string>
#include <vector>

#include "tests/reference/suitability.hpp"

/// The five cases in the proof of Theorem 6.6 and the figure after it.
namespace asts::reference {

/// What the cases come to over all pairs of axes, slices and quadruples v1, v2, v3, v4 as in the proof.
struct CaseFacts {
  bool uncovered = false;         ///< no case applies to a quadruple
  bool overlapping = false;       ///< a case's pair partially overlaps
  bool without_volume = false;    ///< a case's pair shares no volume
  bool quadruple = false;         ///< there is one
  bool quadruple_inside = false;  ///< with a point inside of all four supports' ranges along the third axis
};

/// Tries all quadruples of active nodes with a common point of the supports in both slices of space.active.
template <class T>
CaseFacts decide_quadruples(const Space<T>& space, const std::vector<ActiveNode<T>>& splines);

/// The figure after Theorem 6.6: the row's heads as printed, T or F for v1, v2, v3, v4, and its cases.
struct PrintedCases {
  std::string heads;
  std::vector<int> cases;
};
std::vector<PrintedCases> printed_cases();

/// The cases of the proof that apply to a situation, by number: v1, v2 in N_y(r), v3, v4 in N_x(q).
std::vector<int> applying_cases(bool v1, bool v2, bool v3, bool v4);

/// How many of the 16 situations the table gets wrong, or no case covers: with the printed heads for v3, v4, or with
/// "in N_x(q)".
int wrong_rows(bool printed_heads);

}  // namespace asts::reference
