#include "properties/statement.hpp"

#include "properties/case_meshes.hpp"

namespace asts {

std::optional<Statement> find_statement(std::string_view id) {
  const Statement found{find_claim(id), find_property(id)};
  if (found.claim == nullptr && found.property == nullptr) return std::nullopt;
  return found;
}

Trial try_on_case(const Statement& statement, const Case& test_case) {
  if (statement.of_sequence()) return try_on_sequence(*statement.claim, test_case);
  Trial trial;
  with_last_mesh(test_case, [&](MeshUnderTest& mesh) {
    trial = statement.claim != nullptr ? try_on_mesh(*statement.claim, mesh) : Trial{decide(*statement.property, mesh)};
  });
  return trial;
}

std::optional<std::string> violation_of(const Statement& statement, const Case& test_case) {
  const Verdict verdict = try_on_case(statement, test_case).verdict;
  if (verdict.outcome != Outcome::violated) return std::nullopt;
  return kind_of(verdict.witness.value());
}

}  // namespace asts
