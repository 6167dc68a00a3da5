#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.hpp"
#include "cli/last_mesh.hpp"
#include "cli/output_file.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
#include "reports/vtu/blending_values.hpp"
#include "reports/vtu/mesh_vtu.hpp"

namespace asts::cli {

namespace {

/// "1/2,2,3"
PerAxis<Rational> parsed_point(const std::string& text) {
  PerAxis<Rational> point;
  std::size_t begin = 0;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const std::size_t end = text.find(',', begin);
    if ((end == std::string::npos) != (axis + 1 == kDimension)) throw InputError("--node takes three numbers: X,Y,Z");
    const auto number = parse_rational(std::string_view(text).substr(begin, end - begin));
    if (const auto* reason = std::get_if<std::string>(&number)) throw InputError("--node " + text + ": " + *reason);
    point[axis] = std::get<Rational>(number);
    begin = end + 1;
  }
  return point;
}

std::string shown_name(const std::string& case_file) { return case_file == "-" ? "<stdin>" : case_file; }

std::int32_t chosen_node(const ExportOptions& options, const PerAxis<Rational>& point, MeshUnderTest& mesh) {
  const auto node = active_node_at(mesh.mesh(), mesh.splines(), point);
  const std::string text = fmt::format("({}, {}, {})", to_string(point[0]), to_string(point[1]), to_string(point[2]));
  if (!node) throw InputError(shown_name(options.case_file) + ": " + text + " is no active node of the last mesh");
  if (mesh.splines().missing) {
    throw InputError(shown_name(options.case_file) +
                     ": not all index vectors exist, so there are no blending functions");
  }
  return *node;
}

std::string text_of(const ExportOptions& options, const VtuChoice& choice, const VtuCounts& counts) {
  std::string text = fmt::format("{}: {} cells, {} points: {} elements, {} active nodes", options.out, counts.cells(),
                                 counts.points, counts.elements, counts.active_nodes);
  if (counts.witness_points > 0) text += fmt::format(", {} points of the witness", counts.witness_points);
  if (choice.node) {
    text += fmt::format(", {} cells of a lattice over the support, which {} elements share volume with", counts.samples,
                        counts.support_elements);
  }
  if (counts.witness_elements > 0)
    text += fmt::format("; {} elements in boxes of the witness", counts.witness_elements);
  if (counts.perturbed) {
    const PerAxis<std::int64_t>& n = *counts.perturbed;
    text += fmt::format("; {}, {} and {} elements meet the perturbed regions of x, y and z", n[0], n[1], n[2]);
  }
  return text + "\n";
}

std::string json_of(const ExportOptions& options, const VtuChoice& choice, const VtuCounts& counts) {
  nlohmann::ordered_json json{{"file", options.out},
                              {"cells", counts.cells()},
                              {"points", counts.points},
                              {"elements", counts.elements},
                              {"vertices", counts.vertices},
                              {"active_nodes", counts.active_nodes},
                              {"witness_points", counts.witness_points}};
  if (choice.node) {
    json["samples"] = counts.samples;
    json["support_elements"] = counts.support_elements;
  }
  if (choice.decided) json["witness_elements"] = counts.witness_elements;
  if (counts.perturbed) json["perturbed_elements"] = *counts.perturbed;
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

int write_grid(const ExportOptions& options, const std::optional<Statement>& statement, const VtuChoice& choice,
               MeshUnderTest& mesh, OutputFile& file) {
  const MeshVtu vtu = mesh_vtu(mesh, choice);
  stop_if_interrupted();
  file.finish(vtu_text(vtu.grid));
  if (statement) print(verdict_line(*statement, choice.decided->verdict, options.format));
  print(options.format == Format::text ? text_of(options, choice, vtu.counts) : json_of(options, choice, vtu.counts));
  return statement ? exit_code_of(choice.decided->verdict) : kHolds;
}

}  // namespace

int export_mesh(const ExportOptions& options) {
  const std::optional<Statement> statement = chosen_statement(options.claim, options.property);
  std::optional<PerAxis<Rational>> point;
  if (!options.node.empty()) point = parsed_point(options.node);
  Input input = read_input(options.case_file);
  if (same_file(options.case_file, options.out)) throw InputError(options.out + ": is the case itself");
  OutputFile file(options.out);
  LastMesh last(input);
  VtuChoice choice;
  choice.perturbed_regions = options.perturbed_regions || options.property == "analysis-suitable";
  if (point) choice.node = chosen_node(options, *point, last.mesh());
  if (statement) choice.decided = VtuChoice::Decided{statement->id(), last.decide(*statement)};
  stop_if_interrupted();
  return write_grid(options, statement, choice, last.mesh(), file);
}

}  // namespace asts::cli
