#include "cli/last_mesh.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/statements.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"

namespace asts::cli {

std::optional<Statement> chosen_statement(const std::string& claim, const std::string& property) {
  if (!claim.empty() && !property.empty()) throw InputError("one --claim or one --property, not both");
  if (!claim.empty()) return Statement{chosen_claims({claim}).front(), nullptr};
  if (!property.empty()) return Statement{nullptr, chosen_properties({property}).front()};
  return std::nullopt;
}

LastMesh::LastMesh(Input& input) : case_(input.content) {
  if (input.mesh) {
    mesh_.emplace(std::move(*input.mesh));
    return;
  }
  replay_.emplace(case_);
  sequence_.emplace(*replay_);
  while (!replay_->done()) {
    stop_if_interrupted();
    show_progress(fmt::format("step {}, {} elements", replay_->counts().step + 1, replay_->tree().element_count()));
    replay_->advance();
    sequence_->after_step();
  }
  show_progress({});
}

Verdict LastMesh::decide(const Statement& statement) {
  if (statement.of_sequence()) return try_on_case(statement, case_).verdict;
  if (statement.claim != nullptr) return try_on_mesh(*statement.claim, mesh()).verdict;
  return mesh_ ? asts::decide(*statement.property, *mesh_) : sequence_->decide(*statement.property);
}

std::string verdict_line(const Statement& statement, const Verdict& verdict, Format format) {
  const std::string kind = verdict.witness ? kind_of(*verdict.witness) : std::string();
  if (format == Format::text) {
    return fmt::format("{}: {}{}\n", statement.id(), outcome_name(verdict.outcome), kind.empty() ? "" : ": " + kind);
  }
  nlohmann::ordered_json json{{statement.claim != nullptr ? "claim" : "property", statement.id()},
                              {"verdict", outcome_name(verdict.outcome)}};
  if (!kind.empty()) json["kind"] = kind;
  return json.dump() + "\n";
}

int exit_code_of(const Verdict& verdict) {
  if (verdict.outcome == Outcome::violated) return kViolated;
  return verdict.outcome == Outcome::undecided ? kFailure : kHolds;
}

}  // namespace asts::cli
