#pragma once

#include <optional>
#include <string>

#include "properties/claims/claim.hpp"
#include "properties/properties.hpp"

namespace asts {

/// What a case can violate: a claim, or one of the five properties. One of the two is there.
struct Statement {
  const Claim* claim = nullptr;
  const Property* property = nullptr;

  const char* id() const { return claim != nullptr ? claim->id : property->id; }
  /// Whether it is about the sequence of steps and not about the mesh that they make.
  bool of_sequence() const { return claim != nullptr && claim->on_mesh == nullptr; }
};

/// The claim or the property of an id; nothing if there is none. No id is both.
std::optional<Statement> find_statement(std::string_view id);

/// Decides a statement for the last mesh of a case, or, when it is about sequences, for all its steps.
/// A statement about sequences is not applicable to an explicit mesh. Cost: that of the replay and of the decision.
/// Throws InputError when the case cannot be replayed.
Trial try_on_case(const Statement& statement, const Case& test_case);

/// How a statement is violated, by the kind of the witness; nothing when it is not.
std::optional<std::string> violation_of(const Statement& statement, const Case& test_case);

}  // namespace asts
