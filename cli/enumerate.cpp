#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/setting_options.hpp"
#include "cli/terminal.hpp"
#include "cli/trial_chain.hpp"
#include "lib/mesh/case_file.hpp"
#include "reports/enumerate_report.hpp"

namespace asts::cli {

namespace {

/// A line of progress for every so many meshes.
constexpr std::int64_t kProgress = 256;

/// What was asked for; all claims about meshes when nothing was.
std::vector<MeshStatement> statements_of(const EnumerateOptions& options) {
  std::vector<MeshStatement> statements;
  for (const Property* property : chosen_properties(options.properties)) statements.push_back(statement_of(*property));
  for (const Claim* claim : chosen_claims(options.claims)) statements.push_back(statement_of(*claim));
  if (!options.claims.empty() || !options.properties.empty()) return statements;
  for (const Claim& claim : all_claims()) {
    if (claim.on_mesh != nullptr) statements.push_back(statement_of(claim));
  }
  return statements;
}

EnumerationRecord empty_record(const MeshStatement& statement) {
  EnumerationRecord record;
  record.kind = statement.kind;
  record.id = statement.id;
  if (record.kind == "claim") record.met = 0;
  return record;
}

void count(EnumerationRecord& record, const EnumeratedMesh& mesh, const TrialResult& result) {
  record.meshes += mesh.reflections;
  if (record.met) *record.met += result.met * mesh.reflections;
  if (result.outcome == Outcome::not_applicable) record.not_applicable += mesh.reflections;
  if (result.outcome == Outcome::undecided) record.undecided += mesh.reflections;
  if (result.outcome != Outcome::violated) return;
  record.violations += mesh.reflections;
  // meshes with as many subdivisions come in the canonical order: the first one stays
  const auto subdivisions = static_cast<std::int64_t>(mesh.subdivided.size());
  if (record.smallest && subdivisions >= record.fewest) return;
  record.fewest = subdivisions;
  record.smallest = write_case(case_of(mesh));
}

/// Tries those statements on every mesh for which a mesh can stand for its reflections, or those for which it cannot.
void try_on_all(Enumeration enumeration, bool up_to_reflection, const std::vector<MeshStatement>& statements,
                std::vector<EnumerationRecord>& records) {
  std::vector<const MeshStatement*> tried;
  std::vector<EnumerationRecord*> counted;
  for (std::size_t i = 0; i < statements.size(); ++i) {
    if (statements[i].reflects != up_to_reflection) continue;
    tried.push_back(&statements[i]);
    counted.push_back(&records[i]);
  }
  if (tried.empty()) return;
  enumeration.up_to_reflection = up_to_reflection;
  TrialChain trials(tried);
  std::int64_t visits = 0;
  enumerate_meshes(enumeration, [&](const EnumeratedMesh& mesh) {
    stop_if_interrupted();
    if (++visits % kProgress == 0) show_progress(fmt::format("{} meshes", counted[0]->meshes));
    const std::vector<TrialResult>& results = trials.results(mesh);
    for (std::size_t i = 0; i < results.size(); ++i) count(*counted[i], mesh, results[i]);
  });
}

void report(const std::vector<EnumerationRecord>& records, Format format) {
  if (format == Format::json) {
    for (const EnumerationRecord& record : records) print(enumeration_json(record));
    return;
  }
  print(enumeration_text_header());
  for (const EnumerationRecord& record : records) print(enumeration_text(record));
  for (const EnumerationRecord& record : records) print(smallest_text(record));
}

int exit_code(const std::vector<EnumerationRecord>& records) {
  const auto any = [&](std::int64_t EnumerationRecord::*count) {
    return std::any_of(records.begin(), records.end(),
                       [&](const EnumerationRecord& record) { return record.*count > 0; });
  };
  return any(&EnumerationRecord::violations) ? kViolated : any(&EnumerationRecord::undecided) ? kFailure : kHolds;
}

}  // namespace

int enumerate(const EnumerateOptions& options) {
  const Enumeration enumeration{checked_setting(options.setting), options.max_subdivisions, options.admissible};
  std::vector<MeshStatement> statements = statements_of(options);
  std::vector<EnumerationRecord> records;
  for (MeshStatement& statement : statements) {
    if (options.no_symmetry) statement.reflects = false;
    records.push_back(empty_record(statement));
  }
  try_on_all(enumeration, true, statements, records);
  try_on_all(enumeration, false, statements, records);
  report(records, options.format);
  return exit_code(records);
}

}  // namespace asts::cli
