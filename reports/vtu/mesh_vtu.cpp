#include "reports/vtu/mesh_vtu.hpp"

#include <algorithm>
#include <span>

#include "reports/vtu/drawn_mesh.hpp"
#include "reports/vtu/grid_builder.hpp"

namespace asts {

namespace {

/// Points and cells.
class Assembly {
 public:
  Assembly(MeshUnderTest& test, const VtuChoice& choice)
      : mesh_(test.mesh()), drawn_mesh_{test, choice, {}, {}, {}, {}, {}, {}}, builder_(result_.grid) {
    if (choice.decided && choice.decided->verdict.witness)
      drawn_mesh_.witness = marks_of(*choice.decided->verdict.witness);
    if (choice.node) drawn_mesh_.function.emplace(mesh_, test.splines(), *choice.node);
  }

  MeshVtu result() {
    add_elements();
    add_active_nodes();
    add_witness_points();
    if (drawn_mesh_.function) add_samples();
    drawn_mesh_.points = builder_.points();
    counts().points = static_cast<std::int64_t>(drawn_mesh_.points);
    result_.grid.cell_data = cell_arrays(drawn_mesh_, counts());
    result_.grid.point_data = point_arrays(drawn_mesh_);
    result_.grid.field_data = field_arrays(drawn_mesh_);
    return std::move(result_);
  }

 private:
  VtuCounts& counts() { return result_.counts; }

  void add_kinds(VtuKind kind, std::int64_t count) {
    drawn_mesh_.kinds.insert(drawn_mesh_.kinds.end(), static_cast<std::size_t>(count), static_cast<std::uint8_t>(kind));
  }

  void add_elements() {
    drawn_mesh_.vertices = mesh_points(mesh_);
    PerAxis<std::vector<double>> lines;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      for (const Rational& line : mesh_.coordinates[axis]) lines[axis].push_back(drawn(line));
    }
    for (const PerAxis<std::int32_t>& position : drawn_mesh_.vertices.positions) {
      builder_.add_point({lines[0][at(position[0])], lines[1][at(position[1])], lines[2][at(position[2])]});
    }
    const std::span<const std::int32_t> corners(drawn_mesh_.vertices.corners);
    for (std::size_t element = 0; element < mesh_.elements.size(); ++element) {
      builder_.add_cell(kVtkVoxel, corners.subspan(element * MeshPoints::kCorners, MeshPoints::kCorners));
    }
    counts().elements = static_cast<std::int64_t>(mesh_.elements.size());
    counts().vertices = static_cast<std::int64_t>(drawn_mesh_.vertices.positions.size());
    add_kinds(VtuKind::element, counts().elements);
  }

  /// Both nodes and points are in lexicographic order, and every node is a vertex.
  void add_active_nodes() {
    const auto& positions = drawn_mesh_.vertices.positions;
    auto place = positions.begin();
    for (const PerAxis<std::int32_t>& node : drawn_mesh_.test.splines().nodes) {
      place = std::find(place, positions.end(), node);
      const auto point = static_cast<std::int32_t>(place - positions.begin());
      drawn_mesh_.node_points.push_back(point);
      builder_.add_cell(kVtkVertex, std::span(&point, 1));
    }
    counts().active_nodes = drawn_mesh_.test.splines().size();
    add_kinds(VtuKind::active_node, counts().active_nodes);
  }

  void add_witness_points() {
    for (const SliceMarks::Point& mark : drawn_mesh_.witness.points) {
      const std::int32_t point = builder_.add_point({drawn(mark.point[0]), drawn(mark.point[1]), drawn(mark.point[2])});
      builder_.add_cell(kVtkVertex, std::span(&point, 1));
    }
    counts().witness_points = static_cast<std::int64_t>(drawn_mesh_.witness.points.size());
    add_kinds(VtuKind::witness_point, counts().witness_points);
  }

  void add_samples() {
    drawn_mesh_.samples = blending_samples(*drawn_mesh_.function);
    const auto first = static_cast<std::int32_t>(builder_.points());
    PerAxis<std::vector<double>> places;
    PerAxis<std::size_t> points{};
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      for (const Rational& coordinate : drawn_mesh_.samples.coordinates[axis])
        places[axis].push_back(drawn(coordinate));
      points[axis] = places[axis].size();
    }
    for (const double x : places[0]) {
      for (const double y : places[1]) {
        for (const double z : places[2]) builder_.add_point({x, y, z});
      }
    }
    counts().samples = builder_.add_lattice(first, points);
    add_kinds(VtuKind::sample, counts().samples);
  }

  const Mesh& mesh_;
  DrawnMesh drawn_mesh_;
  MeshVtu result_;
  GridBuilder builder_;
};

}  // namespace

std::string array_name(const char* name, Axis axis) { return std::string(name) + "_" + axis_name(axis); }

MeshVtu mesh_vtu(MeshUnderTest& mesh, const VtuChoice& choice) { return Assembly(mesh, choice).result(); }

}  // namespace asts
