#include "reports/vtu/grid_builder.hpp"

#include <limits>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

std::int32_t vtk_number(std::size_t number) {
  if (number > at(std::numeric_limits<std::int32_t>::max())) throw ResourceError("too many points for one grid of VTK");
  return static_cast<std::int32_t>(number);
}

}  // namespace

double drawn(const Rational& value) { return value.convert_to<double>(); }

std::int32_t GridBuilder::add_point(const PerAxis<double>& coordinates) {
  const std::int32_t number = vtk_number(points());
  grid_.points.insert(grid_.points.end(), coordinates.begin(), coordinates.end());
  return number;
}

void GridBuilder::add_cell(std::uint8_t type, std::span<const std::int32_t> points) {
  grid_.connectivity.insert(grid_.connectivity.end(), points.begin(), points.end());
  grid_.offsets.push_back(vtk_number(grid_.connectivity.size()));
  grid_.types.push_back(type);
}

std::int64_t GridBuilder::add_lattice(std::int32_t first_point, const PerAxis<std::size_t>& points) {
  const auto number = [&](std::size_t x, std::size_t y, std::size_t z) {
    return first_point + vtk_number((x * points[1] + y) * points[2] + z);
  };
  std::int64_t voxels = 0;
  for (std::size_t x = 0; x + 1 < points[0]; ++x) {
    for (std::size_t y = 0; y + 1 < points[1]; ++y) {
      for (std::size_t z = 0; z + 1 < points[2]; ++z) {
        std::array<std::int32_t, 8> corners{};
        for (std::size_t c = 0; c < corners.size(); ++c) {
          corners[c] = number(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2 & 1));
        }
        add_cell(kVtkVoxel, corners);
        ++voxels;
      }
    }
  }
  return voxels;
}

}  // namespace asts
