#pragma once

#include <nlohmann/json.hpp>

#include "properties/verdict.hpp"

namespace asts {

/// A witness from its JSON (reports/WITNESS.md): what witness_json() wrote. Values of a claim are told apart by their
/// shape: a list of three numbers is a point, an object with a level an element, and a text that is a number a number.
/// Throws InputError for what is none, with the reason.
/// Law (tests/reports/witness_reading_test.cpp): witness_json() of the result is the JSON that was read, always.
Witness witness_from_json(const nlohmann::ordered_json& json);

/// The same for a verdict: what verdict_json() wrote; other members, such as `met`, are left alone.
Verdict verdict_from_json(const nlohmann::ordered_json& json);

/// An integer that is not negative. Throws InputError for anything else, and where there is no such member.
std::int64_t count_in(const nlohmann::ordered_json& object, const char* member);
/// A text. Throws InputError likewise.
std::string text_in(const nlohmann::ordered_json& object, const char* member);

}  // namespace asts
