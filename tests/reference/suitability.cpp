#include "tests/reference/suitability.hpp"

#include <algorithm>

namespace asts::reference {

template <class T>
bool in_slice_nodes(const Space<T>& space, std::size_t axis, const T& q, const PointIn<T>& v) {
  PointIn<T> projection = v;
  projection[axis] = q;
  return in_skeleton(space, axis, projection);
}

template <class T>
std::vector<T> slices(const Space<T>& space, std::size_t axis) {
  std::vector<T> result;
  for (const BasicBox<T>& k : space.elements)
    for (const T& q : {k.lower[axis], k.upper[axis]})
      if (space.active.lower[axis] <= q && q <= space.active.upper[axis]) result.push_back(q);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

template <class T>
std::optional<BasicBox<T>> closed_intersection(const BasicBox<T>& first, const BasicBox<T>& second) {
  BasicBox<T> result;
  for (std::size_t a = 0; a < dimension; ++a) {
    result.lower[a] = std::max(first.lower[a], second.lower[a]);
    result.upper[a] = std::min(first.upper[a], second.upper[a]);
    if (result.upper[a] < result.lower[a]) return std::nullopt;
  }
  return result;
}

namespace {

template <class T>
void keep_each_once(std::vector<BasicBox<T>>& boxes) {
  const auto before = [](const BasicBox<T>& a, const BasicBox<T>& b) {
    return a.lower != b.lower ? a.lower < b.lower : a.upper < b.upper;
  };
  const auto same = [](const BasicBox<T>& a, const BasicBox<T>& b) {
    return a.lower == b.lower && a.upper == b.upper;
  };
  std::sort(boxes.begin(), boxes.end(), before);
  boxes.erase(std::unique(boxes.begin(), boxes.end(), same), boxes.end());
}

}  // namespace

template <class T>
std::vector<BasicBox<T>> slice_perturbation(const Space<T>& space, const std::vector<ActiveNode<T>>& splines,
                                            std::size_t axis, const T& q) {
  BasicBox<T> slice = space.active;
  if (q < slice.lower[axis] || slice.upper[axis] < q) return {};
  slice.lower[axis] = slice.upper[axis] = q;
  std::vector<BasicBox<T>> in, out, result;
  for (const ActiveNode<T>& v : splines)
    if (const auto part = closed_intersection(slice, v.support))
      (in_slice_nodes(space, axis, q, v.node) ? in : out).push_back(*part);
  keep_each_once(in);
  keep_each_once(out);
  for (const BasicBox<T>& first : in)
    for (const BasicBox<T>& second : out)
      if (const auto common = closed_intersection(first, second)) result.push_back(*common);
  keep_each_once(result);
  return result;
}

template <class T>
bool in_perturbed_region(const Space<T>& space, const std::vector<ActiveNode<T>>& splines, std::size_t axis,
                         const PointIn<T>& t) {
  if (!in_closed(space.active, t)) return false;
  bool in = false, out = false;
  for (const ActiveNode<T>& v : splines) {
    if (!in_closed(v.support, t)) continue;
    (in_slice_nodes(space, axis, t[axis], v.node) ? in : out) = true;
  }
  return in && out;
}

template <class T>
bool analysis_suitable_by_rectangles(const Space<T>& space, const std::vector<ActiveNode<T>>& splines) {
  std::array<std::vector<BasicBox<T>>, dimension> regions;
  for (std::size_t a = 0; a < dimension; ++a)
    for (const T& q : slices(space, a))
      for (const BasicBox<T>& rectangle : slice_perturbation(space, splines, a, q)) regions[a].push_back(rectangle);
  for (std::size_t a = 0; a < dimension; ++a)
    for (std::size_t b = 0; b < a; ++b)
      for (const BasicBox<T>& first : regions[a])
        for (const BasicBox<T>& second : regions[b])
          if (closed_intersection(first, second)) return false;
  return true;
}

template <class T>
bool overlap(const std::vector<T>& first, const std::vector<T>& second) {
  for (const T& x : first)
    if (second.front() <= x && x <= second.back() && std::find(second.begin(), second.end(), x) == second.end())
      return false;
  for (const T& x : second)
    if (first.front() <= x && x <= first.back() && std::find(first.begin(), first.end(), x) == first.end())
      return false;
  return true;
}

template <class T>
bool partially_overlap(const ActiveNode<T>& v, const ActiveNode<T>& w) {
  int count = 0;
  for (std::size_t a = 0; a < dimension; ++a)
    if (overlap(v.vectors[a], w.vectors[a])) ++count;
  return count >= 2;
}

template <class T>
std::optional<std::pair<std::size_t, std::size_t>> not_dual_compatible(const std::vector<ActiveNode<T>>& splines) {
  for (std::size_t v = 0; v < splines.size(); ++v)
    for (std::size_t w = 0; w < v; ++w)
      if (intersect_with_volume(splines[v].support, splines[w].support) && !partially_overlap(splines[v], splines[w]))
        return std::pair{w, v};
  return std::nullopt;
}

#define ASTS_REFERENCE_INSTANTIATE(T)                                                                               \
  template bool in_slice_nodes(const Space<T>&, std::size_t, const T&, const PointIn<T>&);                          \
  template std::vector<T> slices(const Space<T>&, std::size_t);                                                     \
  template std::optional<BasicBox<T>> closed_intersection(const BasicBox<T>&, const BasicBox<T>&);                  \
  template std::vector<BasicBox<T>> slice_perturbation(const Space<T>&, const std::vector<ActiveNode<T>>&,          \
                                                       std::size_t, const T&);                                      \
  template bool in_perturbed_region(const Space<T>&, const std::vector<ActiveNode<T>>&, std::size_t,                \
                                    const PointIn<T>&);                                                             \
  template bool analysis_suitable_by_rectangles(const Space<T>&, const std::vector<ActiveNode<T>>&);                \
  template bool overlap(const std::vector<T>&, const std::vector<T>&);                                              \
  template bool partially_overlap(const ActiveNode<T>&, const ActiveNode<T>&);                                      \
  template std::optional<std::pair<std::size_t, std::size_t>> not_dual_compatible(const std::vector<ActiveNode<T>>&);
ASTS_REFERENCE_INSTANTIATE(Rational)
ASTS_REFERENCE_INSTANTIATE(Grid)
#undef ASTS_REFERENCE_INSTANTIATE

}  // namespace asts::reference
