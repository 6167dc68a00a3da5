#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "lib/gen/case_bytes.hpp"
#include "lib/mesh/setting.hpp"

/// The parts of the form of case_bytes.hpp, each with its inverse.
namespace asts::byte_form {

/// Bytes from the front; zeros behind the end.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  bool done() const { return rest_.empty(); }
  int next() {
    if (done()) return 0;
    const int byte = rest_.front();
    rest_ = rest_.subspan(1);
    return byte;
  }

 private:
  std::span<const std::uint8_t> rest_;
};

/// Writes what Reader reads. A value that the form lacks makes the whole text void.
class Writer {
 public:
  void put(std::optional<int> byte) {
    complete_ = complete_ && byte.has_value();
    bytes_.push_back(static_cast<std::uint8_t>(byte.value_or(0)));
  }
  std::optional<std::vector<std::uint8_t>> take() {
    if (!complete_) return std::nullopt;
    return std::move(bytes_);
  }

 private:
  std::vector<std::uint8_t> bytes_;
  bool complete_ = true;
};

/// A coordinate numerator/denominator >= 0 in lowest terms.
struct Coordinate {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;

  friend bool operator==(const Coordinate&, const Coordinate&) = default;
  friend bool operator<(const Coordinate& a, const Coordinate& b) {
    return a.numerator * b.denominator < b.numerator * a.denominator;
  }
};
inline CompactRational compact(const Coordinate& coordinate) {
  return CompactRational::lowest_terms(coordinate.numerator, coordinate.denominator);
}
/// Nothing when the denominator is above the limit or the number is not small.
std::optional<Coordinate> coordinate_of(const CompactRational& value);

/// The setting of bytes 1 to 3.
Setting read_setting(Reader& reader, int grading, const ByteCaseLimits& limits);
/// The byte of one axis.
std::optional<int> axis_byte(int degree, int side);

/// Two bytes: the cell, then the fraction. `count` is the number of cells there are to choose from: side + 1 where the
/// upper face of the domain is one, side where it is none.
Coordinate read_coordinate(Reader& reader, int side, int count);
void write_coordinate(Writer& writer, const Coordinate& coordinate);

std::vector<Step> read_steps(Reader& reader, const Setting& setting, const ByteCaseLimits& limits);
void write_steps(Writer& writer, const std::vector<Step>& steps);

std::vector<ElementLine> read_boxes(Reader& reader, const Setting& setting, const ByteCaseLimits& limits);
/// REQUIRES: ascending order.
void write_boxes(Writer& writer, const Setting& setting, const std::vector<ElementLine>& boxes);

}  // namespace asts::byte_form
