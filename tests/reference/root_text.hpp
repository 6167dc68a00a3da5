#pragma once

#include <nlohmann/json.hpp>

#include "tests/reference/cube_root.hpp"

namespace asts::reference {

/// A number of Q(m^(1/3)) as reports/WITNESS.md has it: "5/2 - 1/3 5^(1/3) + 2 5^(2/3), between 7.77 and 7.78", zero
/// terms left out; a rational one is a number alone. Throws Rejected for anything else, when the root is not that of m,
/// or when the two decimals do not enclose the number.
RootSum read_root_sum(const nlohmann::json& value, int m, const std::string& what);

/// Rejects the value unless it is this number.
void require_equal(const RootSum& claimed, const RootSum& actual, const std::string& what);

/// The same form, with two decimals of 12 places around an irrational number.
std::string text(const RootSum& value);

}  // namespace asts::reference
