#include <fmt/format.h>

#include <map>

#include "reports/slices/slice_drawing.hpp"

namespace asts {

namespace {

std::string list(const std::vector<Rational>& values) {
  std::string result;
  for (const Rational& value : values) result += (result.empty() ? "(" : ", ") + to_string(value);
  return result + ")";
}

std::string rectangle(const PlaneRectangle& r) {
  return fmt::format("[{}, {}] x [{}, {}]", to_string(r.lower[0]), to_string(r.upper[0]), to_string(r.lower[1]),
                     to_string(r.upper[1]));
}

std::string element_words(const SliceGeometry& geometry) {
  std::map<std::optional<std::int32_t>, std::size_t> counts;
  for (const ElementTrace& element : geometry.elements) ++counts[element.level];
  std::string result;
  for (const auto& [level, count] : counts) {
    result += fmt::format("{}{} of {}", result.empty() ? "" : ", ", count,
                          level ? fmt::format("level {}", *level) : std::string("no integer level"));
  }
  return fmt::format(
      "It shows {} traces of closed elements: {}. Where the plane has faces of elements, those on either side are "
      "drawn, the finer above the coarser, edges of those at smaller {} dashed; two of the same trace and level count "
      "once.",
      geometry.elements.size(), result, axis_name(geometry.slice.axis));
}

std::string region_words(const SliceGeometry& geometry) {
  if (geometry.active_region) {
    std::string result = fmt::format(
        " The active region's projection is {}; the plane {} the region. Active nodes in the "
        "plane: {}.",
        rectangle(*geometry.active_region), geometry.in_active_region ? "meets" : "misses",
        geometry.active_nodes.size());
    if (!geometry.regions) return result + " Perturbed regions: none, since some index vector does not exist.";
    for (Axis region = 0; region < kDimension; ++region) {
      std::string parts;
      for (const PlaneRectangle& part : (*geometry.regions)[at(region)]) {
        parts += (parts.empty() ? "" : ", ") + rectangle(part);
      }
      result +=
          fmt::format(" Perturbed region R_{} in the plane: {}.", axis_name(region), parts.empty() ? "nothing" : parts);
    }
    return result;
  }
  return " The active region is empty.";
}

std::string mark_words(const SliceMarks& marks) {
  std::string result = marks.says.empty() ? "" : fmt::format(" What is wrong: {}.", marks.says);
  for (const SliceMarks::Node& node : marks.nodes) {
    result += fmt::format(" Node {} = {} has the index vectors", node.name, point_text(node.info.node));
    for (Axis axis = 0; axis < kDimension; ++axis) {
      result +=
          fmt::format("{} {} along {}", axis == 0 ? "" : ",", list(node.info.index_vectors[at(axis)]), axis_name(axis));
    }
    result += ".";
  }
  for (const SliceMarks::Missing& missing : marks.missing) {
    result += fmt::format(" {} is no entry of {}'s along {}, though within its range.", to_string(missing.coordinate),
                          missing.node, axis_name(missing.axis));
  }
  for (const SliceMarks::Point& mark : marks.points) {
    result += fmt::format(" Point {} = {}.", mark.name, point_text(mark.point));
  }
  for (const SliceMarks::Box& mark : marks.boxes) {
    result += fmt::format(" Box {} from {} to {}.", mark.name, point_text(mark.box.lower), point_text(mark.box.upper));
  }
  return result;
}

}  // namespace

std::string point_text(const ExactPoint& point) {
  return fmt::format("({}, {}, {})", to_string(point[0]), to_string(point[1]), to_string(point[2]));
}

std::string slice_title(const SliceGeometry& geometry) {
  return fmt::format("Slice {} = {}", axis_name(geometry.slice.axis), to_string(geometry.slice.position));
}

std::string slice_description(const SliceGeometry& geometry, const SliceMarks& marks) {
  const std::array<Axis, 2> axes = axes_in(geometry.slice);
  return fmt::format("The plane {} = {} of the index domain, {} to the right and {} upwards, {}. ",
                     axis_name(geometry.slice.axis), to_string(geometry.slice.position), axis_name(axes[0]),
                     axis_name(axes[1]), rectangle(geometry.domain)) +
         element_words(geometry) + region_words(geometry) + mark_words(marks);
}

}  // namespace asts
