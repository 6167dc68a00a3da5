#include "tests/reference/skeleton_claims.hpp"

#include <algorithm>
#include <set>

namespace asts::reference {

namespace {

std::set<Rational> coordinates(const Mesh& mesh, std::size_t axis) {
  std::set<Rational> result;
  for (const Box& k : mesh) {
    result.insert(k.lower[axis]);
    result.insert(k.upper[axis]);
  }
  return result;
}

/// All coordinates and the midpoints between neighbours, within [first, last].
std::vector<Rational> places(const Mesh& mesh, std::size_t axis, const Rational& first, const Rational& last) {
  std::vector<Rational> result;
  for (const Rational& c : coordinates(mesh, axis)) {
    if (c < first || last < c) continue;
    if (!result.empty()) result.push_back((result.back() + c) / 2);
    result.push_back(c);
  }
  return result;
}

bool in_closed_box(const Box& box, const Point& point) {
  for (std::size_t a = 0; a < dimension; ++a)
    if (point[a] < box.lower[a] || box.upper[a] < point[a]) return false;
  return true;
}

std::vector<Point> vertices(const Box& k) {
  std::vector<Point> result;
  for (const Rational& x : {k.lower[0], k.upper[0]})
    for (const Rational& y : {k.lower[1], k.upper[1]})
      for (const Rational& z : {k.lower[2], k.upper[2]}) result.push_back({x, y, z});
  return result;
}

bool is_vertex(const Box& k, const Point& point) {
  const std::vector<Point> all = vertices(k);
  return std::find(all.begin(), all.end(), point) != all.end();
}

std::vector<Box> edges(const Box& k) {
  std::vector<Box> result;
  const std::vector<Point> all = vertices(k);
  for (const Point& a : all)
    for (const Point& b : all) {
      int different = 0;
      for (std::size_t i = 0; i < dimension; ++i) different += a[i] != b[i];
      if (different == 1 && a < b) result.push_back({a, b});
    }
  return result;
}

Space<Rational> rational_space(const Setting& setting, const Mesh& mesh) {
  return make_space<Rational>(setting, mesh, 1);
}

}  // namespace

bool frame_entries_included(const Setting& setting, const Mesh& mesh, std::size_t axis) {
  const Space<Rational> space = rational_space(setting, mesh);
  const std::size_t b = (axis + 1) % 3, c = (axis + 2) % 3;
  const int half = (setting.degree[axis] + 1) / 2, length = setting.domain[axis];
  std::vector<Rational> entries;
  for (int i = 0; i <= half - 1; ++i) entries.push_back(i);
  for (int i = length - half + 1; i <= length; ++i) entries.push_back(i);
  for (const Rational& y : places(mesh, b, 0, setting.domain[b]))
    for (const Rational& z : places(mesh, c, 0, setting.domain[c])) {
      Point point;
      point[b] = y;
      point[c] = z;
      for (const Rational& entry : entries) {
        point[axis] = entry;
        if (entry < 0 || length < entry || !in_skeleton(space, axis, point)) return false;
      }
    }
  return true;
}

bool index_vectors_unique(const Setting& setting, const Mesh& mesh) {
  const Space<Rational> space = rational_space(setting, mesh);
  for (const Point& v : active_nodes(space))
    for (std::size_t a = 0; a < dimension; ++a) {
      const std::vector<Rational> set = global_index_set(space, a, v);
      const int half = (setting.degree[a] + 1) / 2;
      const int count = static_cast<int>(set.size());
      int choices = 0;
      for (int middle = 0; middle < count; ++middle)
        if (set[static_cast<std::size_t>(middle)] == v[a] && middle - half >= 0 && middle + half < count) ++choices;
      if (choices != 1) return false;
    }
  return true;
}

bool unperturbed(const Setting& setting, const Mesh& mesh) {
  const Space<Rational> space = rational_space(setting, mesh);
  const auto splines = active_splines(space);
  for (std::size_t a = 0; a < dimension; ++a)
    for (const Rational& q : slices(space, a))
      if (!slice_perturbation(space, *splines, a, q).empty()) return false;
  return true;
}

std::vector<Point> hanging_nodes(const Mesh& mesh) {
  std::set<Point> all;
  for (const Box& k : mesh)
    for (const Point& v : vertices(k)) all.insert(v);
  std::vector<Point> result;
  for (const Point& v : all)
    for (const Box& k : mesh)
      if (in_closed_box(k, v) && !is_vertex(k, v)) {
        result.push_back(v);
        break;
      }
  return result;
}

namespace {

/// Does the segment meet the relative interior of a face of k? On the axis across the face it lies in the face's plane,
/// on the others it meets the open range.
bool meets_inside_of_face(const Box& segment, const Box& k) {
  for (std::size_t across = 0; across < dimension; ++across) {
    const Rational& plane = segment.lower[across];
    if (segment.upper[across] != plane || (plane != k.lower[across] && plane != k.upper[across])) continue;
    bool meets = true;
    for (std::size_t a = 0; a < dimension; ++a) {
      if (a == across) continue;
      const bool point = segment.lower[a] == segment.upper[a];
      const bool open = point ? k.lower[a] < segment.lower[a] && segment.lower[a] < k.upper[a]
                              : segment.lower[a] < k.upper[a] && k.lower[a] < segment.upper[a];
      meets = meets && open;
    }
    if (meets) return true;
  }
  return false;
}

}  // namespace

Mesh hanging_edges(const Mesh& mesh) {
  std::set<Box> all;
  for (const Box& k : mesh)
    for (const Box& edge : edges(k)) all.insert(edge);
  Mesh result;
  for (const Box& edge : all)
    for (const Box& k : mesh)
      if (meets_inside_of_face(edge, k)) {
        result.push_back(edge);
        break;
      }
  return result;
}

namespace {

std::vector<Point> points_on(const Mesh& mesh, const Box& segment) {
  std::vector<Point> result;
  for (const Rational& x : places(mesh, 0, segment.lower[0], segment.upper[0]))
    for (const Rational& y : places(mesh, 1, segment.lower[1], segment.upper[1]))
      for (const Rational& z : places(mesh, 2, segment.lower[2], segment.upper[2])) result.push_back({x, y, z});
  return result;
}

/// The active nodes with the regions that they make, in integers.
struct Regions {
  Grid scale;
  Space<Grid> space;
  std::vector<ActiveNode<Grid>> splines;

  Regions(const Setting& setting, const Mesh& mesh)
      : scale(grid_scale(setting, mesh).value()),
        space(make_space<Grid>(setting, mesh, scale)),
        splines(active_splines(space).value()) {}

  PointIn<Grid> in_units(const Point& t) const {
    return {on_grid(t[0], scale), on_grid(t[1], scale), on_grid(t[2], scale)};
  }
  bool active(const Point& t) const { return in_closed(space.active, in_units(t)); }
  bool has(const Point& t, std::size_t axis) const { return in_perturbed_region(space, splines, axis, in_units(t)); }
  bool has(const Point& t) const { return has(t, 0) || has(t, 1) || has(t, 2); }
  /// Is the active node in N_x(q)?
  bool in_slice(const Point& v, std::size_t axis, const Rational& q) const {
    return in_slice_nodes(space, axis, on_grid(q, scale), in_units(v));
  }
};

/// The hanging nodes and edges as boxes.
Mesh all_hanging(const Mesh& mesh) {
  Mesh result = hanging_edges(mesh);
  for (const Point& node : hanging_nodes(mesh)) result.push_back({node, node});
  return result;
}

}  // namespace

bool hanging_covered(const Setting& setting, const Mesh& mesh) {
  const Regions regions(setting, mesh);
  for (const Box& hanging : all_hanging(mesh))
    for (const Point& t : points_on(mesh, hanging))
      if (!regions.has(t)) return false;
  return true;
}

bool is_node_of(const Mesh& mesh, const Point& point) {
  return std::any_of(mesh.begin(), mesh.end(), [&](const Box& k) { return is_vertex(k, point); });
}

bool is_edge_of(const Mesh& mesh, const Box& segment) {
  return std::any_of(mesh.begin(), mesh.end(), [&](const Box& k) {
    const std::vector<Box> all = edges(k);
    return std::find(all.begin(), all.end(), segment) != all.end();
  });
}

bool hangs_on(const Box& hanging, const Box& k) {
  if (hanging.lower == hanging.upper) return in_closed_box(k, hanging.lower) && !is_vertex(k, hanging.lower);
  return meets_inside_of_face(hanging, k);
}

namespace {

bool has_active_vertex_outside(const Regions& regions, const Box& k, std::size_t axis, const Rational& q) {
  for (const Point& w : vertices(k))
    if (regions.active(w) && !regions.in_slice(w, axis, q)) return true;
  return false;
}

}  // namespace

bool hanging_covered_if_vertex_outside(const Setting& setting, const Mesh& mesh) {
  const Regions regions(setting, mesh);
  for (const Box& hanging : all_hanging(mesh)) {
    if (!regions.active(hanging.lower) && !regions.active(hanging.upper)) continue;
    for (const Box& k : mesh)
      for (std::size_t axis = 0; axis < dimension; ++axis) {
        const Rational& q = hanging.lower[axis];
        if (hanging.upper[axis] != q || q <= k.lower[axis] || k.upper[axis] <= q) continue;
        if (!hangs_on(hanging, k) || !has_active_vertex_outside(regions, k, axis, q)) continue;
        for (const Point& t : points_on(mesh, hanging))
          if (regions.active(t) && !regions.has(t, axis)) return false;
      }
  }
  return true;
}

std::optional<std::vector<Rectangle>> planar_rectangles(const Mesh& mesh, std::size_t axis) {
  const std::size_t h = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  const std::set<Rational> all = coordinates(mesh, axis);
  std::optional<Mesh> first;
  for (auto low = all.begin(); std::next(low) != all.end(); ++low) {
    Mesh layer;
    for (Box k : mesh) {
      if (k.lower[axis] >= *std::next(low) || k.upper[axis] <= *low) continue;
      if (k.lower[axis] != *low || k.upper[axis] != *std::next(low)) return std::nullopt;
      k.lower[axis] = k.upper[axis] = 0;
      layer.push_back(k);
    }
    std::sort(layer.begin(), layer.end());
    if (first && layer != *first) return std::nullopt;
    first = layer;
  }
  std::vector<Rectangle> result;
  for (const Box& k : *first) result.push_back({{k.lower[h], k.lower[v]}, {k.upper[h], k.upper[v]}});
  return result;
}

namespace {

using Point2 = std::array<Rational, 2>;

/// Is there an edge along the axis that starts at the point and goes in the direction?
bool edge_from(const std::vector<Rectangle>& mesh, const Point2& point, std::size_t axis, int direction) {
  for (const Rectangle& k : mesh) {
    if (point[1 - axis] != k.lower[1 - axis] && point[1 - axis] != k.upper[1 - axis]) continue;
    if (direction > 0 ? k.lower[axis] <= point[axis] && point[axis] < k.upper[axis]
                      : k.lower[axis] < point[axis] && point[axis] <= k.upper[axis])
      return true;
  }
  return false;
}

/// hI(j) or vI(i): where edges across the axis, closed, meet the line along it through the point.
std::vector<Rational> planar_index_set(const std::vector<Rectangle>& mesh, const Point2& point, std::size_t axis) {
  std::set<Rational> result;
  for (const Rectangle& k : mesh)
    if (k.lower[1 - axis] <= point[1 - axis] && point[1 - axis] <= k.upper[1 - axis])
      result.insert({k.lower[axis], k.upper[axis]});
  return {result.begin(), result.end()};
}

}  // namespace

Rectangle planar_extension(const std::vector<Rectangle>& mesh, const PlanarJunction& junction, int degree) {
  const std::vector<Rational> set = planar_index_set(mesh, junction.point, junction.axis);
  const int at = static_cast<int>(std::find(set.begin(), set.end(), junction.point[junction.axis]) - set.begin());
  const int face = (degree + 1) / 2, edge = (degree - 1) / 2, last = static_cast<int>(set.size()) - 1;
  const int low = std::max(at - (junction.direction > 0 ? edge : face), 0);
  const int high = std::min(at + (junction.direction > 0 ? face : edge), last);
  Rectangle segment{junction.point, junction.point};
  segment.lower[junction.axis] = set[static_cast<std::size_t>(low)];
  segment.upper[junction.axis] = set[static_cast<std::size_t>(high)];
  return segment;
}

std::vector<PlanarJunction> planar_junctions(const std::vector<Rectangle>& mesh) {
  Point2 lower = mesh.front().lower, upper = mesh.front().upper;
  std::set<Point2> all;
  for (const Rectangle& k : mesh) {
    for (std::size_t a = 0; a < 2; ++a) {
      lower[a] = std::min(lower[a], k.lower[a]);
      upper[a] = std::max(upper[a], k.upper[a]);
    }
    all.insert({k.lower, k.upper, {k.lower[0], k.upper[1]}, {k.upper[0], k.lower[1]}});
  }
  std::vector<PlanarJunction> result;
  for (const Point2& point : all) {
    if (point[0] == lower[0] || point[0] == upper[0] || point[1] == lower[1] || point[1] == upper[1]) continue;
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (const int direction : {-1, 1})
        if (!edge_from(mesh, point, axis, direction)) result.push_back({point, axis, direction});
  }
  return result;
}

bool planar_extensions_meet(const std::vector<Rectangle>& mesh, std::array<int, 2> degree) {
  const std::vector<PlanarJunction> junctions = planar_junctions(mesh);
  for (const PlanarJunction& one : junctions)
    for (const PlanarJunction& other : junctions) {
      if (one.axis != 0 || other.axis != 1) continue;
      const Rectangle a = planar_extension(mesh, one, degree[0]), b = planar_extension(mesh, other, degree[1]);
      if (a.lower[0] <= b.lower[0] && b.lower[0] <= a.upper[0] && b.lower[1] <= a.lower[1] && a.lower[1] <= b.upper[1])
        return true;
    }
  return false;
}

bool planar_junctions_face(const std::vector<Rectangle>& mesh) {
  const std::vector<PlanarJunction> junctions = planar_junctions(mesh);
  for (const Rectangle& k : mesh)
    for (const PlanarJunction& one : junctions)
      for (const PlanarJunction& other : junctions) {
        const std::size_t a = one.axis, b = 1 - a;
        if (other.axis != a || one.direction < 0 || other.direction > 0 || one.point[b] != other.point[b]) continue;
        const bool across = k.lower[b] < one.point[b] && one.point[b] < k.upper[b];
        if (across && one.point[a] == k.lower[a] && other.point[a] == k.upper[a]) return true;
      }
  return false;
}

std::optional<bool> analysis_suitable(const Setting& setting, const Mesh& mesh) {
  const Space<Grid> space = make_space<Grid>(setting, mesh, grid_scale(setting, mesh).value());
  const auto splines = active_splines(space);
  if (!splines || splines->empty()) return std::nullopt;
  return analysis_suitable_by_rectangles(space, *splines);
}

}  // namespace asts::reference
