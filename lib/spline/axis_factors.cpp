#include "lib/spline/axis_factors.hpp"

#include <algorithm>

namespace asts {

std::vector<Rational> vector_coordinates(const Mesh& mesh, const TSplines& splines, Axis axis, std::int32_t vector) {
  std::vector<Rational> result;
  for (const std::int32_t rank : splines.vectors[at(axis)][vector]) result.push_back(mesh.coordinate(axis, rank));
  return result;
}

AxisFactors::AxisFactors(const Mesh& mesh, const TSplines& splines, const Bricks& bricks, Axis axis)
    : mesh_(mesh), splines_(splines), bricks_(bricks), axis_(axis), functional_(mesh.setting.degree[at(axis)]) {}

FieldElement AxisFactors::lambda(std::int32_t x, std::int32_t x_tilde) {
  return functional_.lambda(vector_coordinates(mesh_, splines_, axis_, x),
                            vector_coordinates(mesh_, splines_, axis_, x_tilde));
}

bool AxisFactors::is_zero(std::int32_t x, std::int32_t x_tilde) {
  return zero_.get(x, x_tilde, [&] { return lambda(x, x_tilde).is_zero(); });
}

bool AxisFactors::is_one(std::int32_t x) {
  return one_.get(x, x, [&] { return lambda(x, x) == Rational(1); });
}

bool AxisFactors::meet(std::int32_t x, std::int32_t x_tilde) const {
  const IndexVectors& vectors = splines_.vectors[at(axis_)];
  return interiors_meet(RankInterval{vectors.front(x), vectors.back(x)},
                        RankInterval{vectors.front(x_tilde), vectors.back(x_tilde)});
}

NonzeroCounts AxisFactors::nonzero(const Brick& one, const Brick& other) {
  const std::int32_t a = one.profile[at(axis_)];
  const std::int32_t b = other.profile[at(axis_)];
  const NonzeroCounts counts = counts_.get(std::min(a, b), std::max(a, b), [&] {
    const auto& profiles = bricks_.profiles[at(axis_)];
    return count(profiles[at(std::min(a, b))], profiles[at(std::max(a, b))]);
  });
  return a <= b ? counts : NonzeroCounts{counts.backward, counts.forward};
}

NonzeroCounts AxisFactors::count(const AxisProfile& one, const AxisProfile& other) {
  NonzeroCounts result;
  for (const std::int32_t x : one.vector_ids) {
    for (const std::int32_t y : other.vector_ids) {
      if (!meet(x, y)) continue;
      result.forward += is_zero(x, y) ? 0 : 1;
      result.backward += is_zero(y, x) ? 0 : 1;
    }
  }
  return result;
}

std::int64_t AxisFactors::meeting(const Brick& one, const Brick& other) const {
  std::int64_t result = 0;
  for (const std::int32_t x : bricks_.profile(one, axis_).vector_ids) {
    for (const std::int32_t y : bricks_.profile(other, axis_).vector_ids) result += meet(x, y) ? 1 : 0;
  }
  return result;
}

}  // namespace asts
