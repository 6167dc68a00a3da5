#include "tests/reference/mesh.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace asts::reference {

bool operator<(const Box& a, const Box& b) {
  if (a.lower != b.lower) return a.lower < b.lower;
  return a.upper < b.upper;
}

Mesh initial_mesh(const Setting& setting) {
  Mesh mesh;
  for (int x = 1; x <= setting.domain[0]; ++x)
    for (int y = 1; y <= setting.domain[1]; ++y)
      for (int z = 1; z <= setting.domain[2]; ++z)
        mesh.push_back({{Rational(x - 1), Rational(y - 1), Rational(z - 1)}, {Rational(x), Rational(y), Rational(z)}});
  return mesh;
}

Rational volume(const Box& box) {
  Rational product = 1;
  for (std::size_t a = 0; a < dimension; ++a) product *= box.upper[a] - box.lower[a];
  return product;
}

Rational power(int grading, int exponent) {
  Rational result = 1;
  for (int i = 0; i < exponent; ++i) result *= grading;
  for (int i = 0; i > exponent; --i) result /= grading;
  return result;
}

std::optional<int> level(const Setting& setting, const Box& box) {
  Rational remaining = volume(box);
  if (remaining <= 0) return std::nullopt;
  int result = 0;
  for (; remaining < 1; ++result) remaining *= setting.grading;
  for (; remaining > 1; --result) remaining /= setting.grading;
  if (remaining != 1) return std::nullopt;
  return result;
}

Point midpoint(const Box& box) {
  Point result;
  for (std::size_t a = 0; a < dimension; ++a) result[a] = (box.lower[a] + box.upper[a]) / 2;
  return result;
}

Point distance(const Box& box, const Point& x) {
  Point result = midpoint(box);
  for (std::size_t a = 0; a < dimension; ++a) result[a] = Rational(abs(Rational(result[a] - x[a])));
  return result;
}

namespace {

Point times(const Rational& factor, const Point& vector) {
  return {Rational(factor * vector[0]), Rational(factor * vector[1]), Rational(factor * vector[2])};
}

}  // namespace

Point environment_radius(const Setting& setting, int k) {
  const Rational m = setting.grading;
  const Rational half3 = Rational(3) / 2;
  const Rational x = setting.degree[0] + half3, y = setting.degree[1] + half3, z = setting.degree[2] + half3;
  switch (((k % 3) + 3) % 3) {
    case 0: return times(power(setting.grading, -k / 3), {x, y, z});
    case 1: return times(power(setting.grading, -(k - 1) / 3), {Rational(x / m), y, z});
    default: return times(power(setting.grading, -(k - 2) / 3), {Rational(x / m), Rational(y / m), z});
  }
}

Box environment(const Setting& setting, const Box& box) {
  const std::optional<int> k = level(setting, box);
  if (!k) throw std::invalid_argument("environment of a box without a level");
  const Point middle = midpoint(box), radius = environment_radius(setting, *k);
  Box open;
  for (std::size_t a = 0; a < dimension; ++a) {
    open.lower[a] = std::max<Rational>(middle[a] - radius[a], 0);
    open.upper[a] = std::min<Rational>(middle[a] + radius[a], setting.domain[a]);
  }
  return open;
}

bool closed_meets_open(const Box& closed, const Box& open) {
  for (std::size_t a = 0; a < dimension; ++a)
    if (!(closed.lower[a] < open.upper[a] && open.lower[a] < closed.upper[a])) return false;
  return true;
}

std::vector<std::size_t> patch(const Setting& setting, const Mesh& mesh, const Box& box) {
  const Box open = environment(setting, box);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < mesh.size(); ++i)
    if (closed_meets_open(mesh[i], open)) result.push_back(i);
  return result;
}

std::vector<Box> subdivide_along(const Setting& setting, const Box& box, std::size_t axis) {
  const Rational side = box.upper[axis] - box.lower[axis];
  std::vector<Box> result;
  for (int j = 1; j <= setting.grading; ++j) {
    Box part = box;
    part.lower[axis] = box.lower[axis] + Rational(j - 1) / setting.grading * side;
    part.upper[axis] = box.lower[axis] + Rational(j) / setting.grading * side;
    result.push_back(part);
  }
  return result;
}

std::vector<Box> children(const Setting& setting, const Box& box) {
  const std::optional<int> k = level(setting, box);
  if (!k) throw std::invalid_argument("children of a box without a level");
  return subdivide_along(setting, box, static_cast<std::size_t>(((*k % 3) + 3) % 3));
}

Mesh subdivide(const Setting& setting, const Mesh& mesh, const std::vector<std::size_t>& marked) {
  const std::set<std::size_t> once(marked.begin(), marked.end());
  Mesh result, added;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    if (!once.contains(i)) {
      result.push_back(mesh[i]);
      continue;
    }
    for (const Box& child : children(setting, mesh[i])) added.push_back(child);
  }
  result.insert(result.end(), added.begin(), added.end());
  return result;
}

bool contains(const Box& outer, const Box& inner) {
  for (std::size_t a = 0; a < dimension; ++a)
    if (inner.lower[a] < outer.lower[a] || outer.upper[a] < inner.upper[a]) return false;
  return true;
}

std::optional<std::size_t> element_at(const Setting& setting, const Mesh& mesh, const Point& point) {
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    bool inside = true;
    for (std::size_t a = 0; a < dimension; ++a) {
      const bool last = point[a] == setting.domain[a] && mesh[i].upper[a] == setting.domain[a];
      inside = inside && mesh[i].lower[a] <= point[a] && (point[a] < mesh[i].upper[a] || last);
    }
    if (inside) return i;
  }
  return std::nullopt;
}

}  // namespace asts::reference
