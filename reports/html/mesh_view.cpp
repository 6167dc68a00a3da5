#include "reports/html/mesh_view.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "lib/exact/errors.hpp"
#include "reports/base64.hpp"
#include "reports/slices/slice_marks.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;
using Ranks = PerAxis<std::int32_t>;

Json texts(const ExactPoint& point) {
  Json result = Json::array();
  for (const Rational& coordinate : point) result.push_back(to_string(coordinate));
  return result;
}

std::optional<std::int32_t> rank_of(const Mesh& mesh, Axis axis, const Rational& coordinate) {
  const std::vector<Rational>& lines = mesh.coordinates[at(axis)];
  const auto line = std::lower_bound(lines.begin(), lines.end(), coordinate);
  if (line == lines.end() || *line != coordinate) return std::nullopt;
  return static_cast<std::int32_t>(line - lines.begin());
}

std::optional<Ranks> ranks_of(const Mesh& mesh, const ExactPoint& point) {
  Ranks result{};
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto rank = rank_of(mesh, axis, point[at(axis)]);
    if (!rank) return std::nullopt;
    result[at(axis)] = *rank;
  }
  return result;
}

Json place(const Mesh& mesh, Axis axis, const Rational& coordinate) {
  const auto rank = rank_of(mesh, axis, coordinate);
  return rank ? Json(*rank) : Json(to_string(coordinate));
}

Json lines_json(const Mesh& mesh) {
  Json result = Json::array();
  for (const std::vector<Rational>& lines : mesh.coordinates) {
    Json axis = Json::array();
    for (const Rational& line : lines) axis.push_back(to_string(line));
    result.push_back(std::move(axis));
  }
  return result;
}

Json elements_json(const Mesh& mesh) {
  std::vector<std::int32_t> table;
  table.reserve(7 * mesh.elements.size());
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      table.push_back(mesh.elements[i].lower[axis]);
      table.push_back(mesh.elements[i].upper[axis]);
    }
    table.push_back(mesh.levels[i]);
  }
  return {{"count", mesh.elements.size()}, {"data", base64_of(table)}};
}

Json nodes_json(const TSplines& splines) {
  std::vector<std::int32_t> table;
  table.reserve(6 * splines.nodes.size());
  for (std::size_t i = 0; i < splines.nodes.size(); ++i) {
    for (const std::int32_t rank : splines.nodes[i]) table.push_back(rank);
    for (const std::int32_t id : splines.vector_ids[i]) table.push_back(splines.missing ? -1 : id);
  }
  return {{"count", splines.nodes.size()}, {"data", base64_of(table)}};
}

Json vectors_json(const TSplines& splines) {
  Json result = Json::array();
  for (const IndexVectors& vectors : splines.vectors) {
    Json axis = Json::array();
    for (std::int32_t id = 0; id < vectors.size() && !splines.missing; ++id) axis.push_back(vectors[id]);
    result.push_back(std::move(axis));
  }
  return result;
}

/// Definition 4.1: the active region's sides.
Rational margin(const Mesh& mesh, Axis axis) { return (mesh.setting.degree[at(axis)] + 1) / 2; }
Rational far_side(const Mesh& mesh, Axis axis) { return mesh.setting.domain[at(axis)] - margin(mesh, axis); }

Json active_json(const Mesh& mesh, const ActiveRegion& region) {
  if (region.empty) return nullptr;
  Json result = Json::array();
  for (Axis axis = 0; axis < kDimension; ++axis) {
    result.push_back(Json::array({place(mesh, axis, margin(mesh, axis)), place(mesh, axis, far_side(mesh, axis))}));
  }
  return result;
}

/// The closure of a box of half ranks: an odd one is the open interval between lines, up to the active region's sides.
Json closure_json(const Mesh& mesh, const Box& half_ranks) {
  Json result = Json::array();
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const Rational lower = mesh.coordinate(axis, half_ranks.lower[at(axis)] / 2);
    const Rational upper = mesh.coordinate(axis, (half_ranks.upper[at(axis)] + 1) / 2);
    result.push_back(place(mesh, axis, std::max(lower, margin(mesh, axis))));
    result.push_back(place(mesh, axis, std::min(upper, far_side(mesh, axis))));
  }
  return result;
}

Json regions_json(MeshUnderTest& test) {
  if (test.splines().missing || test.mesh().elements.size() > kMostElementsWithRegions) return nullptr;
  try {
    Json result = Json::array();
    for (const std::vector<Box>& region : test.perturbed_regions()) {
      Json boxes = Json::array();
      for (const Box& box : region) boxes.push_back(closure_json(test.mesh(), box));
      result.push_back(std::move(boxes));
    }
    return result;
  } catch (const BudgetExhausted&) {
    return nullptr;
  }
}

std::optional<std::int32_t> node_at(const Mesh& mesh, const TSplines& splines, const ExactPoint& point) {
  const auto ranks = ranks_of(mesh, point);
  if (!ranks) return std::nullopt;
  const auto node = std::lower_bound(splines.nodes.begin(), splines.nodes.end(), *ranks);
  if (node == splines.nodes.end() || *node != *ranks) return std::nullopt;
  return static_cast<std::int32_t>(node - splines.nodes.begin());
}

std::optional<std::int32_t> element_with(const Mesh& mesh, const ExactBox& box) {
  const auto lower = ranks_of(mesh, box.lower);
  const auto upper = ranks_of(mesh, box.upper);
  if (!lower || !upper) return std::nullopt;
  const auto element = std::find(mesh.elements.begin(), mesh.elements.end(), Box{*lower, *upper});
  if (element == mesh.elements.end()) return std::nullopt;
  return static_cast<std::int32_t>(element - mesh.elements.begin());
}

void push_once(Json& list, std::int32_t number) {
  if (std::find(list.begin(), list.end(), Json(number)) == list.end()) list.push_back(number);
}

/// `says`, `picked`, `elements_picked` and `marks`.
void add_marks(Json& json, MeshUnderTest& test, const SliceMarks& marks) {
  Json picked = Json::array();
  Json elements = Json::array();
  Json nodes = Json::array();
  Json points = Json::array();
  Json boxes = Json::array();
  for (const SliceMarks::Node& mark : marks.nodes) {
    const auto node = node_at(test.mesh(), test.splines(), mark.info.node);
    if (!node) continue;
    push_once(picked, *node);
    nodes.push_back({{"name", mark.name}, {"node", *node}});
  }
  for (const SliceMarks::Point& mark : marks.points) points.push_back({{"name", mark.name}, {"at", texts(mark.point)}});
  for (const SliceMarks::Box& mark : marks.boxes) {
    const auto element = element_with(test.mesh(), mark.box);
    if (element) push_once(elements, *element);
    boxes.push_back({{"name", mark.name}, {"lower", texts(mark.box.lower)}, {"upper", texts(mark.box.upper)}});
  }
  json["says"] = marks.says;
  json["picked"] = std::move(picked);
  json["elements_picked"] = std::move(elements);
  json["marks"] = {{"nodes", nodes}, {"points", points}, {"boxes", boxes}};
}

/// A text that no HTML parser takes for the end of the script around it.
std::string safe_text(const Json& json) {
  std::string result;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (c == '<') {
      result += "\\u003c";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::string mesh_view_json(MeshUnderTest& test, const Witness* witness) {
  const Mesh& mesh = test.mesh();
  const TSplines& splines = test.splines();
  Json json;
  json["degree"] = mesh.setting.degree;
  json["grading"] = mesh.setting.grading;
  json["domain"] = mesh.setting.domain;
  json["lines"] = lines_json(mesh);
  json["elements"] = elements_json(mesh);
  json["nodes"] = nodes_json(splines);
  json["vectors"] = vectors_json(splines);
  json["active"] = active_json(mesh, splines.region);
  json["regions"] = regions_json(test);
  add_marks(json, test, witness == nullptr ? SliceMarks{} : marks_of(*witness));
  return safe_text(json);
}

}  // namespace asts
