#include "tests/reference/lambda_chain.hpp"

#include <algorithm>

namespace asts::reference {

namespace {

bool meets(const GridBox& closed, const GridBox& open) {
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    if (closed.lower[axis] >= open.upper[axis] || open.lower[axis] >= closed.upper[axis]) return false;
  }
  return true;
}

/// The grid step that the number lies in.
std::int64_t floor_of(const Rational& value) {
  Integer result;
  mpz_fdiv_q(result.backend().data(), mpq_numref(value.backend().data()), mpq_denref(value.backend().data()));
  return static_cast<std::int64_t>(result);
}

}  // namespace

SubdividedSet::SubdividedSet(const Setting& setting, int finest_level) : setting_(setting), finest_(finest_level) {
  std::int64_t largest = 2;
  for (std::size_t axis = 0; axis < dimension; ++axis)
    largest = std::max<std::int64_t>(largest, setting.domain[axis] + setting.degree[axis] + 2);
  for (int level = 0; level < finest_level; level += 3) {
    if (unit_ > (std::int64_t{1} << 61) / largest / setting.grading)
      throw std::overflow_error("the levels are too high for whole numbers of 62 bits");
    unit_ *= setting.grading;
  }
}

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
  std::array<std::int64_t, dimension> step{}, index{};
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    step[axis] = std::min(floor_of(point[axis] * unit_), setting_.domain[axis] * unit_ - 1);
    index[axis] = step[axis] / unit_;
  }
  GridBox element = unit_cube(index);
  while (subdivided_.contains(element)) {
    const auto axis = static_cast<std::size_t>(element.level % 3);
    const std::int64_t side = (element.upper[axis] - element.lower[axis]) / setting_.grading;
    element = child(element, (step[axis] - element.lower[axis]) / side);
  }
  return element;
}

Box SubdividedSet::box(const GridBox& element) const {
  Box result;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    result.lower[axis] = Rational(element.lower[axis]) / unit_;
    result.upper[axis] = Rational(element.upper[axis]) / unit_;
  }
  return result;
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
void SubdividedSet::refine(const std::vector<GridBox>& marks) {
  std::set<GridBox> marked(marks.begin(), marks.end());
  std::vector<GridBox> closure(marked.begin(), marked.end());
  for (std::size_t next = 0; next < closure.size(); ++next) {
    if (closure[next].level >= finest_) throw TooFine("an element of the finest level is not subdivided");
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

/// Each subdivision has made m elements; those that were subdivided in turn are none any more.
std::size_t SubdividedSet::new_element_count() const {
  const auto inner =
      std::count_if(subdivided_.begin(), subdivided_.end(), [](const GridBox& element) { return element.level > 0; });
  return subdivided_.size() * static_cast<std::size_t>(setting_.grading) - static_cast<std::size_t>(inner);
}

std::vector<GridBox> SubdividedSet::new_elements() const {
  std::vector<GridBox> result;
  for (const GridBox& parent : subdivided_)
    for (std::int64_t number = 0; number < setting_.grading; ++number) {
      const GridBox element = child(parent, number);
      if (!subdivided_.contains(element)) result.push_back(element);
    }
  return result;
}

std::array<RootSum, dimension> SubdividedSet::reach_at(int level, DistanceConstant d) const {
  const RootSum scale = root_power(setting_.grading, -level) * Rational(2);
  return {scale * d(setting_, 0), scale * d(setting_, 1), scale * d(setting_, 2)};
}

/// l(K) <= l(K~) + 1 and Dist(K,K~) <= the reach along each axis.
bool SubdividedSet::within(const GridBox& k, const GridBox& mark, const std::array<RootSum, dimension>& reach) const {
  if (k.level > mark.level + 1) return false;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    const std::int64_t twice = k.lower[axis] + k.upper[axis] - mark.lower[axis] - mark.upper[axis];
    const Rational distance = Rational(twice < 0 ? -twice : twice) / (2 * unit_);
    if (sign(reach[axis] - RootSum{setting_.grading, distance}) < 0) return false;
  }
  return true;
}

LambdaSum SubdividedSet::lambda_sum(const GridBox& k, const std::vector<GridBox>& marks, DistanceConstant d) const {
  const std::array<RootSum, dimension> reach = reach_at(k.level, d);
  LambdaSum result{0, {setting_.grading}};
  for (const GridBox& mark : marks) {
    if (!within(k, mark, reach)) continue;
    ++result.within;
    result.sum = result.sum + root_power(setting_.grading, k.level - mark.level);
  }
  return result;
}

LambdaSum SubdividedSet::lambda_sum_over_new(const GridBox& mark, DistanceConstant d) const {
  std::vector<std::array<RootSum, dimension>> reach;
  for (int level = 0; level <= finest_; ++level) reach.push_back(reach_at(level, d));
  LambdaSum result{0, {setting_.grading}};
  for (const GridBox& k : new_elements()) {
    if (!within(k, mark, reach[static_cast<std::size_t>(k.level)])) continue;
    ++result.within;
    result.sum = result.sum + root_power(setting_.grading, k.level - mark.level);
  }
  return result;
}

bool SubdividedSet::lambda_sum_below_one(const GridBox& k, const std::vector<GridBox>& marks) const {
  const int m = setting_.grading;
  return sign(lambda_sum(k, marks, distance_constant).sum - RootSum{m, 1}) < 0;
}

}  // namespace asts::reference
