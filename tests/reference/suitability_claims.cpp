#include "tests/reference/suitability_claims.hpp"

#include <algorithm>
#include <set>

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
bool share_volume(const ActiveNode<T>& v, const ActiveNode<T>& w) {
  return intersect_with_volume(v.support, w.support);
}

/// The slices of Definition 5.1 cut from the closed domain.
template <class T>
Space<T> with_whole_domain(Space<T> space) {
  space.active = space.elements.front();
  for (const BasicBox<T>& element : space.elements)
    for (std::size_t a = 0; a < dimension; ++a) {
      space.active.lower[a] = std::min(space.active.lower[a], element.lower[a]);
      space.active.upper[a] = std::max(space.active.upper[a], element.upper[a]);
    }
  return space;
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

// ---- The cases in the proof of Theorem 6.6

/// A node whose support contains points of both slices, and what the cases ask of it.
template <class T>
struct Candidate {
  const ActiveNode<T>* node;
  bool in_x, in_y;
  T lower, upper;  ///< the support's range along the third axis
};

struct CaseFacts {
  bool uncovered = false;         ///< no case applies to a quadruple
  bool overlapping = false;       ///< a case's pair partially overlaps
  bool without_volume = false;    ///< a case's pair shares no volume
  bool quadruple = false;         ///< there is one
  bool quadruple_inside = false;  ///< with a point inside of all four supports' ranges along the third axis
};

template <class T>
class Quadruples {
 public:
  Quadruples(const Space<T>& space, const Splines<T>& splines) : space_(space), splines_(splines) {}

  CaseFacts decide() {
    for (std::size_t x = 0; x < dimension; ++x)
      for (std::size_t y = 0; y < dimension; ++y) {
        if (x == y) continue;
        for (const T& q : slices(space_, x))
          for (const T& r : slices(space_, y)) decide_slices(x, q, y, r);
      }
    return facts_;
  }

 private:
  std::vector<Candidate<T>> candidates(std::size_t x, const T& q, std::size_t y, const T& r) const {
    BasicBox<T> line = space_.active;
    line.lower[x] = line.upper[x] = q;
    line.lower[y] = line.upper[y] = r;
    const std::size_t z = 3 - x - y;
    std::vector<Candidate<T>> result;
    for (const auto& v : splines_)
      if (const auto part = closed_intersection(line, v.support))
        result.push_back({&v, in_slice_nodes(space_, x, q, v.node), in_slice_nodes(space_, y, r, v.node),
                          part->lower[z], part->upper[z]});
    return result;
  }

  void decide_slices(std::size_t x, const T& q, std::size_t y, const T& r) {
    const auto all = candidates(x, q, y, r);
    std::vector<Candidate<T>> with_x, without_x, with_y, without_y;
    for (const auto& v : all) {
      (v.in_x ? with_x : without_x).push_back(v);
      (v.in_y ? with_y : without_y).push_back(v);
    }
    for (const auto& v1 : with_x)
      for (const auto& v2 : without_x)
        for (const auto& v3 : with_y)
          for (const auto& v4 : without_y) {
            const T lower = std::max({v1.lower, v2.lower, v3.lower, v4.lower});
            const T upper = std::min({v1.upper, v2.upper, v3.upper, v4.upper});
            if (upper < lower) continue;
            facts_.quadruple = true;
            if (inside(3 - x - y, {&v1, &v2, &v3, &v4})) facts_.quadruple_inside = true;
            decide_cases(v1, v2, v3, v4);
          }
  }

  /// Do the open ranges of the supports along the third axis have a common point?
  static bool inside(std::size_t z, const std::array<const Candidate<T>*, 4>& nodes) {
    T lower = nodes[0]->node->support.lower[z], upper = nodes[0]->node->support.upper[z];
    for (const Candidate<T>* v : nodes) {
      lower = std::max(lower, v->node->support.lower[z]);
      upper = std::min(upper, v->node->support.upper[z]);
    }
    return lower < upper;
  }

  void decide_cases(const Candidate<T>& v1, const Candidate<T>& v2, const Candidate<T>& v3, const Candidate<T>& v4) {
    int cases = 0;
    const auto conclude = [&](const Candidate<T>& v, const Candidate<T>& w) {
      ++cases;
      if (partially_overlap(*v.node, *w.node)) facts_.overlapping = true;
      if (!share_volume(*v.node, *w.node)) facts_.without_volume = true;
    };
    if ((v1.in_y && !v2.in_y) || (!v1.in_y && v2.in_y)) conclude(v1, v2);
    if (v1.in_y && !v4.in_x) conclude(v1, v4);
    if (!v1.in_y && !v3.in_x) conclude(v1, v3);
    if (v2.in_y && v4.in_x) conclude(v2, v4);
    if (!v2.in_y && v3.in_x) conclude(v2, v3);
    if (cases == 0) facts_.uncovered = true;
  }

  const Space<T>& space_;
  const Splines<T>& splines_;
  CaseFacts facts_;
};

// ---- The remark to Definition 6.4

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

/// Is there, for every two elements K and L, an element with K's extent across the axis and L's along it?
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
  decide_cases(Quadruples<T>(space, *splines).decide(), suitable, verdicts);
  result.suitable_inside = !Quadruples<T>(whole, *splines).decide().quadruple_inside;
  return result;
}

}  // namespace

SuitabilityClaims decide_suitability_claims(const Setting& setting, const Mesh& mesh, std::size_t max_nodes) {
  if (const auto scale = grid_scale(setting, mesh)) return decide_in<Grid>(setting, mesh, *scale, max_nodes);
  return decide_in<Rational>(setting, mesh, 1, max_nodes);
}

std::vector<PrintedCases> printed_cases() {
  return {{"TTTT", {4}}, {"TTTF", {2}},    {"TTFT", {4}},    {"TTFF", {2}}, {"TFTT", {1, 5}},    {"TFTF", {1, 2, 5}},
          {"TFFT", {1}}, {"TFFF", {1, 2}}, {"FTTT", {1, 4}}, {"FTTF", {1}}, {"FTFT", {1, 3, 4}}, {"FTFF", {1, 3}},
          {"FFTT", {5}}, {"FFTF", {5}},    {"FFFT", {3}},    {"FFFF", {3}}};
}

int wrong_rows(bool printed_heads) {
  int wrong = 0;
  for (const bool v1 : {true, false})
    for (const bool v2 : {true, false})
      for (const bool v3 : {true, false})      // v3 in N_x(q)
        for (const bool v4 : {true, false}) {  // v4 in N_x(q)
          std::vector<int> cases;
          if ((v1 && !v2) || (!v1 && v2)) cases.push_back(1);
          if (v1 && !v4) cases.push_back(2);
          if (!v1 && !v3) cases.push_back(3);
          if (v2 && v4) cases.push_back(4);
          if (!v2 && v3) cases.push_back(5);
          std::string heads;
          for (const bool head : {v1, v2, printed_heads || v3, !printed_heads && v4}) heads += head ? 'T' : 'F';
          for (const PrintedCases& row : printed_cases())
            if (row.heads == heads && (row.cases != cases || cases.empty())) ++wrong;
        }
  return wrong;
}

}  // namespace asts::reference
