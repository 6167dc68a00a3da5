#include "tests/reference/spline.hpp"

#include <algorithm>

namespace asts::reference {

template <class T>
Space<T> make_space(const Setting& setting, const Mesh& mesh, Grid scale) {
  Box active;
  for (std::size_t a = 0; a < dimension; ++a) {
    const int half = (setting.degree[a] + 1) / 2;  // ceil(p/2)
    active.lower[a] = half;
    active.upper[a] = setting.domain[a] - half;
  }
  Space<T> space{setting.degree, in_units<T>(active, scale), {}};
  for (const Box& box : mesh) space.elements.push_back(in_units<T>(box, scale));
  return space;
}

template <class T>
bool in_closed(const BasicBox<T>& box, const PointIn<T>& point) {
  for (std::size_t a = 0; a < dimension; ++a)
    if (point[a] < box.lower[a] || box.upper[a] < point[a]) return false;
  return true;
}

template <class T>
std::vector<PointIn<T>> nodes(const Space<T>& space) {
  std::vector<PointIn<T>> result;
  for (const BasicBox<T>& k : space.elements)
    for (const T& x : {k.lower[0], k.upper[0]})
      for (const T& y : {k.lower[1], k.upper[1]})
        for (const T& z : {k.lower[2], k.upper[2]}) result.push_back({x, y, z});
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

template <class T>
std::vector<PointIn<T>> active_nodes(const Space<T>& space) {
  std::vector<PointIn<T>> result;
  for (const PointIn<T>& v : nodes(space))
    if (in_closed(space.active, v)) result.push_back(v);
  return result;
}

namespace {

/// Are the coordinates other than `axis` within the closed box?
template <class T>
bool beside(const BasicBox<T>& box, std::size_t axis, const PointIn<T>& point) {
  for (std::size_t a = 0; a < dimension; ++a)
    if (a != axis && (point[a] < box.lower[a] || box.upper[a] < point[a])) return false;
  return true;
}

}  // namespace

template <class T>
bool in_skeleton(const Space<T>& space, std::size_t axis, const PointIn<T>& point) {
  for (const BasicBox<T>& k : space.elements)
    if ((point[axis] == k.lower[axis] || point[axis] == k.upper[axis]) && beside(k, axis, point)) return true;
  return false;
}

template <class T>
std::vector<T> global_index_set(const Space<T>& space, std::size_t axis, const PointIn<T>& point) {
  std::vector<T> result;
  for (const BasicBox<T>& k : space.elements) {
    if (!beside(k, axis, point)) continue;
    result.push_back(k.lower[axis]);
    result.push_back(k.upper[axis]);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

namespace {

template <class T>
std::optional<std::vector<T>> centred(const std::vector<T>& set, const T& middle, int degree) {
  const auto at = std::find(set.begin(), set.end(), middle);
  const std::ptrdiff_t half = (degree + 1) / 2;
  if (at == set.end() || at - set.begin() < half || set.end() - at <= half) return std::nullopt;
  return std::vector<T>(at - half, at + half + 1);
}

}  // namespace

template <class T>
std::optional<std::vector<T>> local_index_vector(const Space<T>& space, std::size_t axis, const PointIn<T>& v) {
  return centred(global_index_set(space, axis, v), v[axis], space.degree[axis]);
}

template <class T>
std::optional<ActiveNode<T>> active_node(const Space<T>& space, const PointIn<T>& v) {
  ActiveNode<T> result{v, {}, {}, {}};
  for (std::size_t a = 0; a < dimension; ++a) {
    result.index_sets[a] = global_index_set(space, a, v);
    std::optional<std::vector<T>> vector = centred(result.index_sets[a], v[a], space.degree[a]);
    if (!vector) return std::nullopt;
    result.vectors[a] = std::move(*vector);
    result.support.lower[a] = result.vectors[a].front();
    result.support.upper[a] = result.vectors[a].back();
  }
  return result;
}

template <class T>
std::optional<std::vector<ActiveNode<T>>> active_splines(const Space<T>& space) {
  std::vector<ActiveNode<T>> result;
  for (const PointIn<T>& v : active_nodes(space)) {
    std::optional<ActiveNode<T>> spline = active_node(space, v);
    if (!spline) return std::nullopt;
    result.push_back(std::move(*spline));
  }
  return result;
}

template <class T>
bool intersect_with_volume(const BasicBox<T>& first, const BasicBox<T>& second) {
  for (std::size_t a = 0; a < dimension; ++a)
    if (!(first.lower[a] < second.upper[a] && second.lower[a] < first.upper[a])) return false;
  return true;
}

#define ASTS_REFERENCE_INSTANTIATE(T)                                                                              \
  template Space<T> make_space<T>(const Setting&, const Mesh&, Grid);                                              \
  template bool in_closed(const BasicBox<T>&, const PointIn<T>&);                                                  \
  template std::vector<PointIn<T>> nodes(const Space<T>&);                                                         \
  template std::vector<PointIn<T>> active_nodes(const Space<T>&);                                                  \
  template bool in_skeleton(const Space<T>&, std::size_t, const PointIn<T>&);                                      \
  template std::vector<T> global_index_set(const Space<T>&, std::size_t, const PointIn<T>&);                       \
  template std::optional<std::vector<T>> local_index_vector(const Space<T>&, std::size_t, const PointIn<T>&);      \
  template std::optional<ActiveNode<T>> active_node(const Space<T>&, const PointIn<T>&);                           \
  template std::optional<std::vector<ActiveNode<T>>> active_splines(const Space<T>&);                              \
  template bool intersect_with_volume(const BasicBox<T>&, const BasicBox<T>&);
ASTS_REFERENCE_INSTANTIATE(Rational)
ASTS_REFERENCE_INSTANTIATE(Grid)
#undef ASTS_REFERENCE_INSTANTIATE

}  // namespace asts::reference
