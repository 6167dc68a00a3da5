#include "reports/vtu/blending_values.hpp"

#include <algorithm>
#include <span>

#include "lib/spline/bspline.hpp"

namespace asts {

std::optional<std::int32_t> active_node_at(const Mesh& mesh, const TSplines& splines, const PerAxis<Rational>& point) {
  PerAxis<std::int32_t> ranks{};
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const std::vector<Rational>& lines = mesh.coordinates[axis];
    const auto line = std::lower_bound(lines.begin(), lines.end(), point[axis]);
    if (line == lines.end() || *line != point[axis]) return std::nullopt;
    ranks[axis] = static_cast<std::int32_t>(line - lines.begin());
  }
  const auto node = std::lower_bound(splines.nodes.begin(), splines.nodes.end(), ranks);
  if (node == splines.nodes.end() || *node != ranks) return std::nullopt;
  return static_cast<std::int32_t>(node - splines.nodes.begin());
}

BlendingFunction::BlendingFunction(const Mesh& mesh, const TSplines& splines, std::int32_t node) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    for (const std::int32_t rank : splines.index_vector(node, axis)) {
      knots_[at(axis)].push_back(mesh.coordinate(axis, rank));
    }
  }
}

Rational BlendingFunction::factor(Axis axis, const Rational& coordinate) const {
  const std::vector<Rational>& knots = knots_[at(axis)];
  if (coordinate <= knots.front() || coordinate >= knots.back()) return 0;
  const auto above = std::upper_bound(knots.begin(), knots.end(), coordinate);
  const auto piece = static_cast<std::size_t>(above - knots.begin()) - 1;
  return bspline_piece_value(std::span<const Rational>(knots), piece, coordinate);
}

namespace {

int parts_an_interval(const BlendingFunction& function) {
  for (const int parts : {4, 2}) {
    std::size_t points = 1;
    for (Axis axis = 0; axis < kDimension; ++axis) points *= (function.knots(axis).size() - 1) * at(parts) + 1;
    if (points <= BlendingSamples::kMostSamples) return parts;
  }
  return 1;
}

}  // namespace

BlendingSamples blending_samples(const BlendingFunction& function) {
  const int parts = parts_an_interval(function);
  BlendingSamples samples;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const std::vector<Rational>& knots = function.knots(axis);
    std::vector<Rational>& coordinates = samples.coordinates[at(axis)];
    for (std::size_t interval = 0; interval + 1 < knots.size(); ++interval) {
      const Rational step = (knots[interval + 1] - knots[interval]) / parts;
      for (int part = 0; part < parts; ++part) coordinates.push_back(knots[interval] + step * part);
    }
    coordinates.push_back(knots.back());
    for (const Rational& coordinate : coordinates)
      samples.factors[at(axis)].push_back(function.factor(axis, coordinate));
  }
  return samples;
}

}  // namespace asts
