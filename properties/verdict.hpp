#pragma once

#include <optional>
#include <string>

#include "properties/witness.hpp"

namespace asts {

enum class Outcome {
  holds,
  violated,        ///< always with a witness
  not_applicable,  ///< the property says nothing about this mesh; `reason` says why
  undecided,       ///< a budget ran out; never counts as holding
};

/// "holds", "violated", "not-applicable" or "undecided".
const char* outcome_name(Outcome outcome);

struct Verdict {
  Outcome outcome = Outcome::holds;
  std::string reason;
  std::optional<Witness> witness;

  static Verdict holds() { return {}; }
  static Verdict violated(Witness witness) { return {Outcome::violated, {}, std::move(witness)}; }
  static Verdict not_applicable(std::string reason) { return {Outcome::not_applicable, std::move(reason), {}}; }
  static Verdict undecided(std::string reason) { return {Outcome::undecided, std::move(reason), {}}; }
};

}  // namespace asts
