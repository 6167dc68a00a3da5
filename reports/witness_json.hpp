#pragma once

#include <nlohmann/json.hpp>

#include "properties/verdict.hpp"

namespace asts {

/// The version of the witnesses' form, reports/WITNESS.md: the value of "witness_format" in a record that has any.
inline constexpr int kWitnessFormat = 1;

/// The JSON form of a witness, as reports/WITNESS.md says. Keys stand in a fixed order.
nlohmann::ordered_json witness_json(const Witness& witness);

/// {"verdict":...} with "reason" or "witness" where there is one.
nlohmann::ordered_json verdict_json(const Verdict& verdict);

}  // namespace asts
