#pragma once

#include <optional>
#include <string>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "lib/refine/replay.hpp"
#include "properties/sequence_under_test.hpp"
#include "properties/statement.hpp"

namespace asts::cli {

/// What --claim or --property names; nothing when both are empty. Throws InputError when both are given, or the id is
/// none.
std::optional<Statement> chosen_statement(const std::string& claim, const std::string& property);

/// The last mesh of a case. Shows progress while it replays; throws Interrupted.
class LastMesh {
 public:
  /// REQUIRES: the input outlives it.
  explicit LastMesh(Input& input);
  LastMesh(const LastMesh&) = delete;
  LastMesh& operator=(const LastMesh&) = delete;

  MeshUnderTest& mesh() { return mesh_ ? *mesh_ : sequence_->mesh(); }

  /// Of a statement about one mesh for this one, of one about sequences for all steps of the case.
  Verdict decide(const Statement& statement);

 private:
  const Case& case_;
  std::optional<MeshUnderTest> mesh_;  ///< an explicit one
  std::optional<Replay> replay_;
  std::optional<SequenceUnderTest> sequence_;
};

/// The verdict in one line, with the kind of its witness.
std::string verdict_line(const Statement& statement, const Verdict& verdict, Format format);
int exit_code_of(const Verdict& verdict);

}  // namespace asts::cli
