#include "reports/paper/text.hpp"

#include <fmt/format.h>

namespace asts {

std::string box_text(const ExactBox& box) {
  std::string text;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    text += fmt::format("{}[{},{}]", axis == 0 ? "" : " x ", to_string(box.lower[axis]), to_string(box.upper[axis]));
  }
  return text;
}

std::string point_text_of(const ExactPoint& point) {
  return fmt::format("({}, {}, {})", to_string(point[0]), to_string(point[1]), to_string(point[2]));
}

}  // namespace asts
