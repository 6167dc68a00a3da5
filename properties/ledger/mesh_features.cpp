#include "properties/ledger/mesh_features.hpp"

#include <algorithm>

#include "lib/spline/support_contacts.hpp"

namespace asts {

namespace {

/// For each line its coordinate if that is an integer, else -1.
using IntegerLines = PerAxis<std::vector<std::int64_t>>;

IntegerLines integer_lines(const Mesh& mesh) {
  IntegerLines result;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    for (const Rational& line : mesh.coordinates[axis]) {
      const bool integer = boost::multiprecision::denominator(line) == 1;
      result[axis].push_back(integer ? static_cast<std::int64_t>(boost::multiprecision::numerator(line)) : -1);
    }
  }
  return result;
}

bool is_unit_cube(const IntegerLines& lines, const Box& box) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const std::int64_t lower = lines[axis][at(box.lower[axis])];
    if (lower < 0 || lines[axis][at(box.upper[axis])] != lower + 1) return false;
  }
  return true;
}

/// The active region by lines: an element reaches outside if it begins before `first` or ends behind `last`.
PerAxis<RankInterval> lines_of_region(const Mesh& mesh) {
  PerAxis<RankInterval> region;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const std::vector<Rational>& lines = mesh.coordinates[axis];
    const Rational frame = (mesh.setting.degree[axis] + 1) / 2;
    const auto first = std::lower_bound(lines.begin(), lines.end(), frame);
    const auto behind = std::upper_bound(lines.begin(), lines.end(), mesh.setting.domain[axis] - frame);
    region[axis] = {static_cast<std::int32_t>(first - lines.begin()),
                    static_cast<std::int32_t>(behind - lines.begin()) - 1};
  }
  return region;
}

bool refined_outside_region(const Mesh& mesh) {
  const PerAxis<RankInterval> region = lines_of_region(mesh);
  const IntegerLines lines = integer_lines(mesh);
  return std::any_of(mesh.elements.begin(), mesh.elements.end(), [&](const Box& box) {
    bool outside = false;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      outside |= box.lower[axis] < region[axis].lower || box.upper[axis] > region[axis].upper;
    }
    return outside && !is_unit_cube(lines, box);
  });
}

}  // namespace

std::vector<std::string> features_of(MeshUnderTest& mesh) {
  std::vector<std::string> features;
  if (!mesh.splines().missing) {
    const SupportContacts contacts = count_contacts(mesh.splines(), mesh.bricks());
    if (contacts.by_dimension[2] > 0) features.emplace_back("supports-touch-in-face");
    if (contacts.by_dimension[1] > 0) features.emplace_back("supports-touch-in-edge");
    if (contacts.by_dimension[0] > 0) features.emplace_back("supports-touch-in-point");
  }
  if (refined_outside_region(mesh.mesh())) features.emplace_back("refined-outside-region");
  if (!mesh.admissible()) features.emplace_back("not-admissible");
  return features;
}

}  // namespace asts
