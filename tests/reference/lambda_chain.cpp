#include "tests/reference/lambda_chain.hpp"

#include <algorithm>
#include <stdexcept>

#include "tests/reference/complexity_claims.hpp"

namespace asts::reference {

namespace {

constexpr int finest_level = 6;

bool meets(const GridBox& closed, const GridBox& open) {
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    if (closed.lower[axis] >= open.upper[axis] || open.lower[axis] >= closed.upper[axis]) return false;
  }
  return true;
}

bool holds_half_open(const GridBox& box, const Point& scaled) {
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    if (scaled[axis] < box.lower[axis] || scaled[axis] >= box.upper[axis]) return false;
  }
  return true;
}

}  // namespace

SubdividedSet::SubdividedSet(const Setting& setting)
    : setting_(setting), unit_(std::int64_t{2} * setting.grading * setting.grading) {}

GridBox SubdividedSet::unit_cube(const std::array<std::int64_t, dimension>& index) const {
  GridBox cube{};
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    cube.lower[axis] = index[axis] * unit_;
    cube.upper[axis] = cube.lower[axis] + unit_;
  }
  return cube;
}

/// Definition 2.6: along x, y, z for the level 0, 1, 2 modulo 3.
GridBox SubdividedSet::child(const GridBox& element, std::int64_t number) const {
  GridBox result = element;
  const auto axis = static_cast<std::size_t>(element.level % 3);
  const std::int64_t side = (element.upper[axis] - element.lower[axis]) / setting_.grading;
  result.lower[axis] += number * side;
  result.upper[axis] = result.lower[axis] + side;
  ++result.level;
  return result;
}

GridBox SubdividedSet::element_at(const Point& point) const {
  Point scaled;
  std::array<std::int64_t, dimension> index{};
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    scaled[axis] = point[axis] * unit_;
    while (scaled[axis] >= (index[axis] + 1) * unit_) ++index[axis];
  }
  GridBox element = unit_cube(index);
  while (subdivided_.contains(element)) {
    std::int64_t number = 0;
    while (!holds_half_open(child(element, number), scaled)) ++number;
    element = child(element, number);
  }
  return element;
}

/// Below `node`: the elements of the mesh with a lower level than `level` that meet the environment. Children are
/// equally wide, so that those that meet it are found by division.
void SubdividedSet::collect_coarser(const GridBox& node, const GridBox& environment, int level,
                                    std::vector<GridBox>& found) const {
  if (node.level >= level || !meets(node, environment)) return;
  if (!subdivided_.contains(node)) {
    found.push_back(node);
    return;
  }
  const auto axis = static_cast<std::size_t>(node.level % 3);
  const std::int64_t side = (node.upper[axis] - node.lower[axis]) / setting_.grading;
  const std::int64_t first = std::max(environment.lower[axis] - node.lower[axis], std::int64_t{0}) / side;
  const std::int64_t last = std::min(environment.upper[axis], node.upper[axis]) - node.lower[axis];
  for (std::int64_t number = first; number * side < last; ++number) {
    collect_coarser(child(node, number), environment, level, found);
  }
}

/// Definition 2.4. D(l(K)) is p + 3/2 times K's sides (in each of its three cases), from the midpoint of K: p + 1
/// times from its faces.
std::vector<GridBox> SubdividedSet::coarser_in_patch(const GridBox& k) const {
  GridBox environment = k;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    const std::int64_t reach = (setting_.degree[axis] + 1) * (k.upper[axis] - k.lower[axis]);
    environment.lower[axis] -= reach;
    environment.upper[axis] += reach;
  }
  std::vector<GridBox> found;
  for (std::int64_t x = 0; x < setting_.domain[0]; ++x)
    for (std::int64_t y = 0; y < setting_.domain[1]; ++y)
      for (std::int64_t z = 0; z < setting_.domain[2]; ++z)
        collect_coarser(unit_cube({x, y, z}), environment, k.level, found);
  return found;
}

/// Algorithm 2.8, then 2.9: the closure first, subdivisions afterwards.
void SubdividedSet::refine(const GridBox& mark) {
  std::vector<GridBox> closure{mark};
  std::set<GridBox> marked{mark};
  for (std::size_t next = 0; next < closure.size(); ++next) {
    if (closure[next].level >= finest_level) throw std::logic_error("an element of level 6 is not subdivided");
    for (const GridBox& coarser : coarser_in_patch(closure[next])) {
      if (marked.insert(coarser).second) closure.push_back(coarser);
    }
  }
  subdivided_.insert(closure.begin(), closure.end());
}

bool SubdividedSet::admissible() const {
  return std::all_of(subdivided_.begin(), subdivided_.end(),
                     [&](const GridBox& k) { return coarser_in_patch(k).empty(); });
}

bool SubdividedSet::is_new(const GridBox& element) const {
  if (element.level == 0 || subdivided_.contains(element)) return false;
  return std::any_of(subdivided_.begin(), subdivided_.end(), [&](const GridBox& parent) {
    if (parent.level + 1 != element.level) return false;
    const auto axis = static_cast<std::size_t>(parent.level % 3);
    const std::int64_t side = (parent.upper[axis] - parent.lower[axis]) / setting_.grading;
    const std::int64_t offset = element.lower[axis] - parent.lower[axis];
    return offset >= 0 && offset < parent.upper[axis] - parent.lower[axis] && child(parent, offset / side) == element;
  });
}

bool SubdividedSet::lambda_sum_below_one(const GridBox& k, const std::vector<GridBox>& marks) const {
  const int m = setting_.grading;
  std::vector<RootSum> bounds;
  for (int axis = 0; axis < 3; ++axis)
    bounds.push_back(root_power(m, -k.level) * distance_constant(setting_, axis) * Rational(2));
  RootSum sum{m};
  for (const GridBox& mark : marks) {
    bool within = k.level <= mark.level + 1;
    for (std::size_t axis = 0; axis < dimension && within; ++axis) {
      // twice the distance of the midpoints
      const Rational distance =
          abs(Rational(k.lower[axis] + k.upper[axis] - mark.lower[axis] - mark.upper[axis])) / (2 * unit_);
      within = sign(bounds[axis] - RootSum{m, distance}) >= 0;
    }
    if (within) sum = sum + root_power(m, k.level - mark.level);
  }
  return sign(sum - RootSum{m, 1}) < 0;
}

}  // namespace asts::reference
