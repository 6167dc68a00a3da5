#include "lib/gen/enumerate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "cli/commands.hpp"
#include "cli/setting_options.hpp"
#include "cli/statements.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "reports/enumerate_report.hpp"

namespace asts::cli {

namespace {

/// A line of progress for every so many meshes.
constexpr std::int64_t kProgress = 256;

/// A claim or a property with what is known about it so far.
struct Statement {
  EnumerationRecord record;
  std::function<Trial(MeshUnderTest&)> decide;
  bool reflects = false;   ///< a mesh and its reflections give the same outcome and count
  std::size_t fewest = 0;  ///< subdivisions of the smallest violating mesh
};

Statement statement_of(const Property& property) {
  Statement statement;
  statement.record.kind = "property";
  statement.record.id = property.id;
  statement.decide = [&property](MeshUnderTest& mesh) { return Trial{decide(property, mesh)}; };
  statement.reflects = true;
  return statement;
}

Statement statement_of(const Claim& claim) {
  if (claim.on_mesh == nullptr) throw InputError(fmt::format("claim '{}' is not about one mesh", claim.id));
  Statement statement;
  statement.record.kind = "claim";
  statement.record.id = claim.id;
  statement.record.met = 0;
  statement.decide = [&claim](MeshUnderTest& mesh) { return try_on_mesh(claim, mesh); };
  statement.reflects = claim.reflects;
  return statement;
}

/// What was asked for; all claims about meshes when nothing was.
std::vector<Statement> statements_of(const EnumerateOptions& options) {
  std::vector<Statement> statements;
  for (const Property* property : chosen_properties(options.properties)) statements.push_back(statement_of(*property));
  for (const Claim* claim : chosen_claims(options.claims)) statements.push_back(statement_of(*claim));
  if (!options.claims.empty() || !options.properties.empty()) return statements;
  for (const Claim& claim : all_claims()) {
    if (claim.on_mesh != nullptr) statements.push_back(statement_of(claim));
  }
  return statements;
}

void count(Statement& statement, const EnumeratedMesh& mesh, const Trial& trial) {
  EnumerationRecord& record = statement.record;
  record.meshes += mesh.reflections;
  if (record.met) *record.met += trial.met * mesh.reflections;
  if (trial.verdict.outcome == Outcome::not_applicable) record.not_applicable += mesh.reflections;
  if (trial.verdict.outcome == Outcome::undecided) record.undecided += mesh.reflections;
  if (trial.verdict.outcome != Outcome::violated) return;
  record.violations += mesh.reflections;
  // meshes with as many subdivisions come in the canonical order: the first one stays
  if (record.smallest && mesh.subdivided.size() >= statement.fewest) return;
  statement.fewest = mesh.subdivided.size();
  record.smallest = write_case(case_of(mesh));
}

/// Decides some of the statements for every mesh.
void try_on_all(const Enumeration& enumeration, const std::vector<Statement*>& statements) {
  if (statements.empty()) return;
  std::int64_t meshes = 0;
  std::int64_t visits = 0;
  enumerate_meshes(enumeration, [&](const EnumeratedMesh& enumerated) {
    stop_if_interrupted();
    meshes += enumerated.reflections;
    if (++visits % kProgress == 0) show_progress(fmt::format("{} meshes", meshes));
    MeshUnderTest mesh(enumerated.tree);
    for (Statement* statement : statements) count(*statement, enumerated, statement->decide(mesh));
  });
}

void report(const std::vector<Statement>& statements, Format format) {
  if (format == Format::json) {
    for (const Statement& statement : statements) print(enumeration_json(statement.record));
    return;
  }
  print(enumeration_text_header());
  for (const Statement& statement : statements) print(enumeration_text(statement.record));
  for (const Statement& statement : statements) print(smallest_text(statement.record));
}

int exit_code(const std::vector<Statement>& statements) {
  const auto any = [&](std::int64_t EnumerationRecord::*count) {
    return std::any_of(statements.begin(), statements.end(),
                       [&](const Statement& statement) { return statement.record.*count > 0; });
  };
  return any(&EnumerationRecord::violations) ? kViolated : any(&EnumerationRecord::undecided) ? kFailure : kHolds;
}

}  // namespace

int enumerate(const EnumerateOptions& options) {
  Enumeration enumeration{checked_setting(options.setting), options.max_subdivisions, options.admissible, false};
  std::vector<Statement> statements = statements_of(options);
  for (const bool up_to_reflection : {true, false}) {
    std::vector<Statement*> part;
    for (Statement& statement : statements) {
      if ((statement.reflects && !options.no_symmetry) == up_to_reflection) part.push_back(&statement);
    }
    enumeration.up_to_reflection = up_to_reflection;
    try_on_all(enumeration, part);
  }
  report(statements, options.format);
  return exit_code(statements);
}

}  // namespace asts::cli
