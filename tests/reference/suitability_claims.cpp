#include "tests/reference/suitability_claims.hpp"

#include <algorithm>
#include <set>

#include "tests/reference/spline_hypotheses.hpp"
#include "tests/reference/tree.hpp"

namespace asts::reference {

namespace {

template <class T>
using Splines = std::vector<ActiveNode<T>>;

Verdict implies(bool hypothesis, bool conclusion) {
  if (!hypothesis) return Verdict::not_applicable;
  return conclusion ? Verdict::holds : Verdict::violated;
}

template <class T>
bool supports_meet(const ActiveNode<T>& v, const ActiveNode<T>& w) {
  return closed_intersection(v.support, w.support).has_value();
}

template <class T>
bool meeting_pairs_overlap(const Splines<T>& splines) {
  for (const auto& v : splines)
    for (const auto& w : splines)
      if (supports_meet(v, w) && !partially_overlap(v, w)) return false;
  return true;
}

// ---- Lemma 6.5

template <class T>
struct Lemma {
  std::size_t met = 0;
  bool holds = true;
};

template <class T>
Lemma<T> lemma(const Space<T>& space, const Splines<T>& splines) {
  Lemma<T> result;
  for (std::size_t axis = 0; axis < dimension; ++axis)
    for (const T& q : slices(space, axis)) {
      BasicBox<T> slice = space.active;
      slice.lower[axis] = slice.upper[axis] = q;
      for (const auto& v1 : splines) {
        if (!in_slice_nodes(space, axis, q, v1.node)) continue;
        const auto part = closed_intersection(slice, v1.support);
        if (!part) continue;
        for (const auto& v2 : splines) {
          if (!closed_intersection(*part, v2.support) || in_slice_nodes(space, axis, q, v2.node)) continue;
          ++result.met;
          if (overlap(v1.vectors[axis], v2.vectors[axis])) result.holds = false;
        }
      }
    }
  return result;
}

// ---- The remark to Definition 6.4

}  // namespace

template <class T>
int overlaps(const ActiveNode<T>& v, const ActiveNode<T>& w, const std::vector<std::size_t>& axes) {
  int count = 0;
  for (const std::size_t a : axes) count += overlap(v.vectors[a], w.vectors[a]);
  return count;
}

template <class T>
bool weakly_overlap(const ActiveNode<T>& v, const ActiveNode<T>& w, const std::vector<std::size_t>& axes) {
  for (const std::size_t a : axes)
    if (v.vectors[a] != w.vectors[a] && overlap(v.vectors[a], w.vectors[a])) return true;
  return false;
}

template <class T>
bool extruded(const Space<T>& space, std::size_t axis) {
  std::set<std::pair<PointIn<T>, PointIn<T>>> elements;
  for (const auto& k : space.elements) elements.insert({k.lower, k.upper});
  for (const auto& k : space.elements)
    for (const auto& l : space.elements) {
      auto corners = std::pair{k.lower, k.upper};
      corners.first[axis] = l.lower[axis];
      corners.second[axis] = l.upper[axis];
      if (!elements.contains(corners)) return false;
    }
  return true;
}

template int overlaps(const ActiveNode<Rational>&, const ActiveNode<Rational>&, const std::vector<std::size_t>&);
template bool weakly_overlap(const ActiveNode<Rational>&, const ActiveNode<Rational>&, const std::vector<std::size_t>&);
template bool extruded(const Space<Rational>&, std::size_t);

namespace {

template <class T>
bool definitions_agree(const Space<T>& space, const Splines<T>& splines) {
  for (const auto& v : splines)
    for (const auto& w : splines)
      if (v.node != w.node && partially_overlap(v, w) && !weakly_overlap(v, w, {0, 1, 2})) return false;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    if (!extruded(space, axis)) continue;
    const std::vector<std::size_t> planar{axis == 0 ? 1U : 0U, axis == 2 ? 1U : 2U};
    for (const auto& v : splines)
      for (const auto& w : splines)
        if (v.node != w.node && v.node[axis] == w.node[axis] &&
            (overlaps(v, w, planar) >= 1) != weakly_overlap(v, w, planar))
          return false;
  }
  return true;
}

// ---- All of them

void decide_cases(const CaseFacts& facts, bool suitable, std::map<std::string, Verdict>& verdicts) {
  const bool any = facts.quadruple && !facts.uncovered && !facts.overlapping;
  verdicts["case-table"] = implies(!suitable, any && !facts.without_volume);
  verdicts["case-table-repaired"] = implies(!suitable, any);
}

template <class T>
SuitabilityClaims decide_in(const Setting& setting, const Mesh& mesh, Grid scale, std::size_t max_nodes) {
  SuitabilityClaims result;
  const Space<T> space = make_space<T>(setting, mesh, scale);
  const auto splines = active_splines(space);
  if (!splines || splines->empty()) return result;
  const bool suitable = !perturbed_regions_meet(space, *splines);
  const bool dual_basis = count_dual_failures(setting.degree, *splines, true).failures == 0;
  result.compatible = !not_dual_compatible(*splines);
  result.meeting_pairs_overlap = meeting_pairs_overlap(*splines);
  const Space<T> whole = with_whole_domain(space);
  result.suitable_in_whole_domain = !perturbed_regions_meet(whole, *splines);
  auto& verdicts = result.verdicts;
  verdicts["as-implies-dc"] = implies(suitable, result.compatible);
  verdicts["dc-implies-as"] = implies(result.compatible, suitable);
  verdicts["dc-implies-as-repaired"] = implies(result.meeting_pairs_overlap, suitable);
  verdicts["as-implies-dc-repaired"] = implies(result.suitable_in_whole_domain, result.compatible);
  if (!result.suitable_in_whole_domain && admissible_mesh(setting, mesh, refinement_tree(setting, mesh)))
    verdicts["as-implies-dc-repaired"] = Verdict::violated;
  verdicts["dc-implies-dual-basis"] = implies(result.compatible, dual_basis);
  verdicts["as-implies-dual-basis"] = implies(suitable, dual_basis);
  verdicts["as-implies-dual-basis-repaired"] = implies(result.suitable_in_whole_domain, dual_basis);
  verdicts["dc-within-weak-dc"] = implies(true, definitions_agree(space, *splines));
  const auto lemma_6_5 = lemma(space, *splines);
  result.lemma_met = lemma_6_5.met;
  verdicts["perturbed-means-no-overlap"] = implies(true, lemma_6_5.holds);
  if (splines->size() > max_nodes) return result;
  decide_cases(decide_quadruples(space, *splines), suitable, verdicts);
  result.suitable_inside = !decide_quadruples(whole, *splines).quadruple_inside;
  return result;
}

}  // namespace

SuitabilityClaims decide_suitability_claims(const Setting& setting, const Mesh& mesh, std::size_t max_nodes) {
  if (const auto scale = grid_scale(setting, mesh)) return decide_in<Grid>(setting, mesh, *scale, max_nodes);
  return decide_in<Rational>(setting, mesh, 1, max_nodes);
}

}  // namespace asts::reference
