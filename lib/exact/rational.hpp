#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <string>
#include <string_view>
#include <variant>

namespace asts {

/// Exact integer of any size (GMP). No expression templates: `auto x = a + b` is a value.
using Integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Exact rational number, always in lowest terms with a positive denominator when it comes from this header (GMP).
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// Reads `-?[0-9]+` or `-?[0-9]+/[0-9]+`, nothing else: no blanks, no sign behind the slash, no decimal point.
/// Returns the number in lowest terms, or the reason why `text` is none ("1/0" has a zero denominator).
/// Cost: linear in the length for short numbers, GMP's conversion for long ones.
std::variant<Rational, std::string> parse_rational(std::string_view text);

/// The canonical text: "5/2", "3", "-7/4". parse_rational reads it back.
std::string to_string(const Rational& value);

}  // namespace asts
