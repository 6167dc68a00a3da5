#pragma once

#include <optional>

#include "lib/exact/cosine_field.hpp"  // DecimalEnclosure
#include "lib/exact/rational.hpp"

namespace asts {

/// The tightest enclosure by decimals with that many significant digits, rounded outwards: equal ends where the value
/// is such a decimal, one unit in the last place apart otherwise. Throws InputError unless digits >= 1.
DecimalEnclosure enclose_decimal(const Rational& value, int digits = 12);

/// The same for an irrational number between two rationals. Nothing while these are too far apart to tell: once they
/// are close enough both round to the same decimal, because an irrational number is none.
std::optional<DecimalEnclosure> enclose_irrational(const Rational& lower, const Rational& upper, int digits = 12);

}  // namespace asts
