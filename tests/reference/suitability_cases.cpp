#include "tests/reference/suitability_cases.hpp"

#include <algorithm>

namespace asts::reference {

namespace {

template <class T>
using Splines = std::vector<ActiveNode<T>>;

/// A node whose support contains points of both slices, and what the cases ask of it.
template <class T>
struct Candidate {
  const ActiveNode<T>* node;
  bool in_x, in_y;
  T lower, upper;  ///< the support's range along the third axis
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
      if (!intersect_with_volume(v.node->support, w.node->support)) facts_.without_volume = true;
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

}  // namespace

template <class T>
CaseFacts decide_quadruples(const Space<T>& space, const std::vector<ActiveNode<T>>& splines) {
  return Quadruples<T>(space, splines).decide();
}

template CaseFacts decide_quadruples(const Space<Rational>&, const std::vector<ActiveNode<Rational>>&);
template CaseFacts decide_quadruples(const Space<Grid>&, const std::vector<ActiveNode<Grid>>&);

std::vector<PrintedCases> printed_cases() {
  return {{"TTTT", {4}}, {"TTTF", {2}},    {"TTFT", {4}},    {"TTFF", {2}}, {"TFTT", {1, 5}},    {"TFTF", {1, 2, 5}},
          {"TFFT", {1}}, {"TFFF", {1, 2}}, {"FTTT", {1, 4}}, {"FTTF", {1}}, {"FTFT", {1, 3, 4}}, {"FTFF", {1, 3}},
          {"FFTT", {5}}, {"FFTF", {5}},    {"FFFT", {3}},    {"FFFF", {3}}};
}

std::vector<int> applying_cases(bool v1, bool v2, bool v3, bool v4) {
  std::vector<int> cases;
  if ((v1 && !v2) || (!v1 && v2)) cases.push_back(1);
  if (v1 && !v4) cases.push_back(2);
  if (!v1 && !v3) cases.push_back(3);
  if (v2 && v4) cases.push_back(4);
  if (!v2 && v3) cases.push_back(5);
  return cases;
}

int wrong_rows(bool printed_heads) {
  int wrong = 0;
  for (const bool v1 : {true, false})
    for (const bool v2 : {true, false})
      for (const bool v3 : {true, false})      // v3 in N_x(q)
        for (const bool v4 : {true, false}) {  // v4 in N_x(q)
          const std::vector<int> cases = applying_cases(v1, v2, v3, v4);
          std::string heads;
          for (const bool head : {v1, v2, printed_heads || v3, !printed_heads && v4}) heads += head ? 'T' : 'F';
          for (const PrintedCases& row : printed_cases())
            if (row.heads == heads && (row.cases != cases || cases.empty())) ++wrong;
        }
  return wrong;
}

}  // namespace asts::reference
