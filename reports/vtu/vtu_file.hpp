#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace asts {

/// An array of a VTK file: `tuples` times `components` values, as they stand in memory or, of type String, each ended
/// by a zero byte.
struct VtuArray {
  std::string name;
  std::string type;  ///< VTK's word for the type of a value: "Float64", "Int32", "UInt8", "String"
  std::size_t components;
  std::size_t tuples;
  std::string bytes;
};

template <class Value>
constexpr const char* vtu_type() {
  if constexpr (std::same_as<Value, double>) {
    return "Float64";
  } else if constexpr (std::same_as<Value, std::int32_t>) {
    return "Int32";
  } else {
    static_assert(std::same_as<Value, std::uint8_t>);
    return "UInt8";
  }
}

/// REQUIRES: `components` divides the number of values.
template <class Value>
VtuArray vtu_array(std::string name, const std::vector<Value>& values, std::size_t components = 1) {
  std::string bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
  return {std::move(name), vtu_type<Value>(), components, values.size() / components, std::move(bytes)};
}

VtuArray vtu_texts(std::string name, const std::vector<std::string>& texts);

/// VTK's numbers of the shapes of cells.
inline constexpr std::uint8_t kVtkVertex = 1;
inline constexpr std::uint8_t kVtkVoxel =
    11;  ///< a box; the corner with bit a of its place set is the upper one on axis a

/// An unstructured grid as VTK has it.
struct VtuGrid {
  std::vector<double> points;              ///< three coordinates a point
  std::vector<std::int32_t> connectivity;  ///< the points of each cell, one cell after the other
  std::vector<std::int32_t> offsets;       ///< where each cell ends in `connectivity`
  std::vector<std::uint8_t> types;
  std::vector<VtuArray> point_data;
  std::vector<VtuArray> cell_data;
  std::vector<VtuArray> field_data;
};

/// The grid as an XML file of VTK (`.vtu`, format 1.0), arrays as base64 in their elements.
///
/// Written by pugixml, which this project needs anyway, not by VTK itself: Debian 12's libvtk9-dev brings 217 packages
/// and 600 MB, against some 20 lines here; the tests read the files with VTK (tests/cli/export_command_test.cpp).
/// Cost: linear; about three times the size of the arrays in memory.
std::string vtu_text(const VtuGrid& grid);

}  // namespace asts
