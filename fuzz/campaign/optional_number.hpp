#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

namespace asts {

/// A number that may be missing, as JSON: then null; and back.
inline nlohmann::ordered_json number_json(const std::optional<std::int64_t>& number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json(nullptr);
}

inline std::optional<std::int64_t> number_from(const nlohmann::ordered_json& json) {
  return json.is_null() ? std::nullopt : std::optional<std::int64_t>(json.get<std::int64_t>());
}

}  // namespace asts
