#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "tests/reference/cosine_field.hpp"

/// Readers for the values of reports/WITNESS.md. Every one throws Rejected, with the reason, for anything else.
namespace asts::reference {

/// The witness is malformed, or says something that the definitions refute.
struct Rejected : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An object with exactly these keys. `what` names it in the reason.
void require_keys(const nlohmann::json& object, std::initializer_list<const char*> keys, const std::string& what);

/// An exact number: a string "-7/4" in lowest terms, denominator positive and left out when it is 1.
Rational read_number(const nlohmann::json& value);

/// A decimal: "-0.0123" or "5", no exponent.
Rational read_decimal(const nlohmann::json& value);

/// A nonnegative JSON integer.
std::size_t read_count(const nlohmann::json& value, const std::string& what);

std::vector<Rational> read_numbers(const nlohmann::json& array);
Point read_point(const nlohmann::json& value);
Box read_box(const nlohmann::json& value, const std::string& what);

/// A box with its level (null: none). The box's own claim only; nothing is compared with a mesh.
struct ElementText {
  Box box;
  std::optional<long long> level;
};
ElementText read_element(const nlohmann::json& value, const std::string& what);

/// "x", "y", "z" as 0, 1, 2.
std::size_t read_axis(const nlohmann::json& value);
const char* axis_name(std::size_t axis);

/// An active node as the witness prints it.
struct ActiveNodeText {
  Point node;
  std::array<std::vector<Rational>, dimension> vectors;
  Box support;
};
ActiveNodeText read_active_node(const nlohmann::json& value, const std::string& what);

/// A value in the field `common`. A rational value is a number; an irrational one has coefficients in a field with N
/// dividing common's, that field's minimal polynomial, and an enclosure, which must enclose the value.
Number read_value(const nlohmann::json& value, const CosineField& common, const std::string& what);

/// Plain words for reports: "5/2", "(1, 2, 5/2)", "[0,1] x [0,1] x [0,1/2]", "1/2 + 3*g".
std::string text(const Rational& value);
std::string text(const Point& point);
std::string text(const Box& box);
std::string text(const std::vector<Rational>& numbers);
std::string text(const CosineField& field, const Number& value);

}  // namespace asts::reference
