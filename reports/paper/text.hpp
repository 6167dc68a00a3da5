#pragma once

#include <string>

#include "lib/exact/cube_root_field.hpp"
#include "properties/witness.hpp"

namespace asts {

/// "[0,1/3] x [0,1] x [2,5/2]"
std::string box_text(const ExactBox& box);
/// "(3/2, 3/2, 9/2)"
std::string point_text_of(const ExactPoint& point);

/// A number's decimal with that many significant digits, rounded down: the lower end of its enclosure.
template <class Number>
std::string decimal_text(const Number& number, int digits) {
  return enclose_decimal(number, digits).lower;
}

}  // namespace asts
