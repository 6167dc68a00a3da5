#include "properties/statement.hpp"

#include "lib/refine/replay.hpp"

namespace asts {

namespace {

Trial try_on_last_mesh(const Statement& statement, MeshUnderTest& mesh) {
  if (statement.claim != nullptr) return try_on_mesh(*statement.claim, mesh);
  return {decide(*statement.property, mesh)};
}

}  // namespace

std::optional<Statement> find_statement(std::string_view id) {
  const Statement found{find_claim(id), find_property(id)};
  if (found.claim == nullptr && found.property == nullptr) return std::nullopt;
  return found;
}

Trial try_on_case(const Statement& statement, const Case& test_case) {
  if (statement.of_sequence()) return try_on_sequence(*statement.claim, test_case);
  if (test_case.explicit_mesh) {
    MeshUnderTest mesh(mesh_of(setting_of(test_case), test_case.elements));
    return try_on_last_mesh(statement, mesh);
  }
  Replay replay(test_case);
  while (!replay.done()) replay.advance();
  MeshUnderTest mesh(replay.tree());
  return try_on_last_mesh(statement, mesh);
}

std::optional<std::string> violation_of(const Statement& statement, const Case& test_case) {
  const Verdict verdict = try_on_case(statement, test_case).verdict;
  if (verdict.outcome != Outcome::violated) return std::nullopt;
  return kind_of(verdict.witness.value());
}

}  // namespace asts
