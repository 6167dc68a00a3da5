#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "lib/exact/rational.hpp"

/// The numbers of a record, for tests of the law that each of them is seen in its report.
namespace asts::testing {

/// Adds the places of all numbers: integers, and texts that are numbers.
inline void collect_numbers(const nlohmann::ordered_json& json, const nlohmann::ordered_json::json_pointer& place,
                            std::vector<nlohmann::ordered_json::json_pointer>& numbers) {
  if (json.is_structured()) {
    std::size_t index = 0;
    for (const auto& [key, value] : json.items()) {
      collect_numbers(value, json.is_array() ? place / index++ : place / key, numbers);
    }
    return;
  }
  const bool text = json.is_string() && parse_rational(json.get<std::string>()).index() == 0;
  if (json.is_number() || text) numbers.push_back(place);
}

inline std::vector<nlohmann::ordered_json::json_pointer> numbers_of(const nlohmann::ordered_json& json) {
  std::vector<nlohmann::ordered_json::json_pointer> numbers;
  collect_numbers(json, nlohmann::ordered_json::json_pointer(), numbers);
  return numbers;
}

/// Another number of the same form.
inline nlohmann::ordered_json changed_number(const nlohmann::ordered_json& number) {
  if (number.is_number()) return number.get<std::int64_t>() + 1000;
  return to_string(std::get<Rational>(parse_rational(number.get<std::string>())) + Rational(1, 7));
}

}  // namespace asts::testing
