#include "lib/gen/case_bytes.hpp"

#include <algorithm>

#include "lib/gen/byte_form.hpp"

namespace asts {

namespace {

constexpr int kGradings = 3;  // 2, 3, 4
constexpr int kForms = 4;     // the last one: explicit boxes

bool small_coordinates(const Case& test_case) {
  const auto small = [](const Point& point) {
    return std::all_of(point.begin(), point.end(), [](const CompactRational& value) { return value.is_small(); });
  };
  return std::all_of(test_case.elements.begin(), test_case.elements.end(),
                     [&](const ElementLine& box) { return small(box.lower) && small(box.upper); });
}

/// REQUIRES: small coordinates.
bool before(const ElementLine& a, const ElementLine& b) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const Rational one = a.lower[axis].value();
    const Rational other = b.lower[axis].value();
    if (one != other) return one < other;
  }
  return false;
}

}  // namespace

Case case_of_bytes(std::span<const std::uint8_t> bytes, const ByteCaseLimits& limits) {
  byte_form::Reader reader(bytes);
  const int form = reader.next();
  const Setting setting = byte_form::read_setting(reader, 2 + form % kGradings, limits);
  Case result{setting.degree, setting.grading, setting.domain, {}, false, {}};
  if (form / kGradings % kForms == kForms - 1) {
    result.explicit_mesh = true;
    result.elements = byte_form::read_boxes(reader, setting, limits);
  } else {
    result.steps = byte_form::read_steps(reader, setting, limits);
  }
  return result;
}

std::optional<std::vector<std::uint8_t>> bytes_of_case(const Case& test_case, const ByteCaseLimits& limits) {
  if (test_case.grading >= 2 + kGradings || !small_coordinates(test_case)) return std::nullopt;
  Case ordered = test_case;
  std::sort(ordered.elements.begin(), ordered.elements.end(), before);
  byte_form::Writer writer;
  writer.put(test_case.grading - 2 + (test_case.explicit_mesh ? kGradings * (kForms - 1) : 0));
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    writer.put(byte_form::axis_byte(test_case.degree[axis], test_case.domain[axis]));
  }
  if (test_case.explicit_mesh) {
    byte_form::write_boxes(writer, setting_of(ordered), ordered.elements);
  } else {
    byte_form::write_steps(writer, ordered.steps);
  }
  std::optional<std::vector<std::uint8_t>> bytes = writer.take();
  if (bytes && case_of_bytes(*bytes, limits) != ordered) return std::nullopt;  // beyond a limit
  return bytes;
}

}  // namespace asts
