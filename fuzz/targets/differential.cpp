#include <fmt/format.h>

#include <algorithm>

#include "fuzz/targets/case_in_literal_code.hpp"
#include "fuzz/targets/targets.hpp"
#include "lib/gen/case_bytes.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "properties/properties.hpp"
#include "reports/witness_json.hpp"
#include "tests/reference/decide.hpp"
#include "tests/reference/validate.hpp"

namespace asts::fuzz {

namespace {

const char* name(reference::Verdict verdict) {
  switch (verdict) {
    case reference::Verdict::holds:
      return "holds";
    case reference::Verdict::violated:
      return "violated";
    case reference::Verdict::not_applicable:
      return "not-applicable";
  }
  return "?";
}

/// The literal verdict on a property by its id.
std::string literal_verdict(const reference::Verdicts& verdicts, std::string_view property) {
  if (property == "admissible") return name(verdicts.admissible);
  if (property == "nested-patches") return name(verdicts.nested_patches);
  if (property == "analysis-suitable") return name(verdicts.analysis_suitable);
  if (property == "dual-compatible") return name(verdicts.dual_compatible);
  if (property == "dual-basis") return name(verdicts.dual_basis);
  return "no such property";
}

/// The kernel's elements in the literal code's numbers, ascending.
reference::Mesh sorted_boxes(const Mesh& mesh) {
  reference::Mesh boxes(mesh.elements.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (Axis axis = 0; axis < kDimension; ++axis) {
      boxes[i].lower[at(axis)] = mesh.coordinate(axis, mesh.elements[i].lower[at(axis)]);
      boxes[i].upper[at(axis)] = mesh.coordinate(axis, mesh.elements[i].upper[at(axis)]);
    }
  }
  std::sort(boxes.begin(), boxes.end());
  return boxes;
}

reference::Mesh sorted(reference::Mesh mesh) {
  std::sort(mesh.begin(), mesh.end());
  return mesh;
}

Fault compare_verdict(const Property& property, const Verdict& verdict, const std::string& expected,
                      const reference::Setting& setting, const reference::Mesh& mesh) {
  const std::string outcome = outcome_name(verdict.outcome);
  if (outcome != expected) return fmt::format("{}: {}, by the literal code: {}", property.id, outcome, expected);
  if (verdict.witness.has_value() != (verdict.outcome == Outcome::violated)) {
    return fmt::format("{}: a witness goes with a violation and with nothing else", property.id);
  }
  if (!verdict.witness) return std::nullopt;
  const auto witness = nlohmann::json::parse(witness_json(*verdict.witness).dump());
  const reference::Validation validation = reference::validate_witness(setting, mesh, property.id, witness);
  if (validation.valid) return std::nullopt;
  return fmt::format("{}: the witness {} is not valid: {}", property.id, witness.dump(), validation.report);
}

Fault compare(MeshUnderTest& fast, reference::ClaimSubject literal) {
  if (sorted_boxes(fast.mesh()) != sorted(literal.mesh())) return "the meshes differ";
  const reference::Verdicts verdicts = reference::decide(literal.setting(), literal.mesh());
  for (const Property& property : all_properties()) {
    const std::string expected = literal_verdict(verdicts, property.id);
    Fault fault = compare_verdict(property, decide(property, fast), expected, literal.setting(), literal.mesh());
    if (fault) return fault;
  }
  return std::nullopt;
}

Fault compare_case(const Case& content) {
  if (content.explicit_mesh) {
    MeshUnderTest mesh(mesh_of(setting_of(content), content.elements));
    return compare(mesh, literal_subject(content));
  }
  Replay replay(content);
  while (!replay.done()) replay.advance();
  MeshUnderTest mesh(replay.tree());
  return compare(mesh, literal_subject(content));
}

}  // namespace

Fault differential_fault(Bytes bytes) {
  const Case content = case_of_bytes(bytes, kTinyCases);
  try {
    const Fault fault = compare_case(content);
    if (!fault) return fault;
    return *fault + "\n" + write_case(content);
  } catch (const std::exception& error) {
    return std::string("an exception that is not documented: ") + error.what() + "\n" + write_case(content);
  }
}

}  // namespace asts::fuzz
