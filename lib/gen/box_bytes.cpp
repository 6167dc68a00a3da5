#include <algorithm>

#include "lib/gen/byte_form.hpp"

namespace asts::byte_form {

namespace {

using Planes = PerAxis<std::vector<Coordinate>>;
using Cell = PerAxis<int>;

// The number of planes that a byte says: 0 to 3 in 192 of 256 values, 0 to 63 in the others.
constexpr int kOftenPlanes = 4;
constexpr int kManyPlanes = 192;

int plane_count(int byte) { return byte < kManyPlanes ? byte % kOftenPlanes : byte - kManyPlanes; }

// The extent that five bits say: 1 in 12 of 32 values, 2 in 6, then 3 to 16.
constexpr int kTwo = 12;
constexpr int kMore = 18;
constexpr int kExtents = 32;

int extent_of(int code) { return code < kTwo ? 1 : code < kMore ? 2 : code - kMore + 3; }
std::optional<int> extent_code(int extent) {
  if (extent <= 2) return extent == 1 ? 0 : kTwo;
  const int code = kMore + extent - 3;
  return code < kExtents ? std::optional(code) : std::nullopt;
}

Planes unit_planes(const Setting& setting) {
  Planes planes;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    for (int i = 0; i <= setting.domain[axis]; ++i) planes[axis].push_back({i, 1});
  }
  return planes;
}

Cell cells_of(const Planes& planes) {
  Cell cells;
  for (std::size_t axis = 0; axis < kDimension; ++axis) cells[axis] = static_cast<int>(planes[axis].size()) - 1;
  return cells;
}

bool has_room(const Planes& planes, std::size_t axis, int max_cells) {
  Cell cells = cells_of(planes);
  if (++cells[axis] > ByteCaseLimits::max_intervals) return false;
  return cells[0] * cells[1] * cells[2] <= max_cells;
}

/// Adds a plane, or takes it away; the domain's faces stay.
void toggle(Planes& planes, std::size_t axis, const Coordinate& plane, int max_cells) {
  std::vector<Coordinate>& line = planes[axis];
  if (plane.numerator == 0) return;
  const auto place = std::lower_bound(line.begin(), line.end(), plane);
  if (*place == plane) {
    line.erase(place);
  } else if (has_room(planes, axis, max_cells)) {
    line.insert(place, plane);
  }
}

Planes read_planes(Reader& reader, const Setting& setting, int max_cells) {
  Planes planes = unit_planes(setting);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    for (int count = plane_count(reader.next()); count > 0; --count) {
      toggle(planes, axis, read_coordinate(reader, setting.domain[axis], setting.domain[axis]), max_cells);
    }
  }
  return planes;
}

/// What is taken away stands first, so that there is room for what is added.
void write_planes(Writer& writer, const std::vector<Coordinate>& units, const std::vector<Coordinate>& wanted) {
  std::vector<Coordinate> toggled;
  std::set_difference(units.begin(), units.end(), wanted.begin(), wanted.end(), std::back_inserter(toggled));
  std::set_difference(wanted.begin(), wanted.end(), units.begin(), units.end(), std::back_inserter(toggled));
  const int count = static_cast<int>(toggled.size());
  if (count >= 256 - kManyPlanes) return writer.put(std::nullopt);
  writer.put(count < kOftenPlanes ? count : kManyPlanes + count);
  for (const Coordinate& plane : toggled) write_coordinate(writer, plane);
}

/// The cells of the grid that are covered, and boxes put among them.
class Filling {
 public:
  explicit Filling(const Cell& cells)
      : cells_(cells), covered_(static_cast<std::size_t>(cells[0] * cells[1] * cells[2])) {}

  bool is_covered(const Cell& cell) const { return covered_[place(cell)]; }

  /// The upper end of the box that begins in a free cell: along z, y and x in turn it goes as far as wanted and free.
  Cell cover(const Cell& lower, const Cell& wanted) {
    Cell upper;
    for (std::size_t axis = 0; axis < kDimension; ++axis) upper[axis] = lower[axis] + 1;
    for (std::size_t axis = kDimension; axis-- > 0;) {
      const int end = std::min(lower[axis] + wanted[axis], cells_[axis]);
      while (upper[axis] < end && is_free(next_layer(lower, upper, axis))) ++upper[axis];
    }
    for_each({lower, upper}, [&](const Cell& cell) { covered_[place(cell)] = true; });
    return upper;
  }

 private:
  struct Range {
    Cell lower, upper;
  };

  static Range next_layer(const Cell& lower, const Cell& upper, std::size_t axis) {
    Range range{lower, upper};
    range.lower[axis] = upper[axis];
    range.upper[axis] = upper[axis] + 1;
    return range;
  }

  template <typename Visit>
  static void for_each(const Range& range, const Visit& visit) {
    Cell cell;
    for (cell[0] = range.lower[0]; cell[0] < range.upper[0]; ++cell[0]) {
      for (cell[1] = range.lower[1]; cell[1] < range.upper[1]; ++cell[1]) {
        for (cell[2] = range.lower[2]; cell[2] < range.upper[2]; ++cell[2]) visit(cell);
      }
    }
  }

  bool is_free(const Range& range) const {
    bool free = true;
    for_each(range, [&](const Cell& cell) { free = free && !is_covered(cell); });
    return free;
  }

  std::size_t place(const Cell& cell) const {
    return static_cast<std::size_t>((cell[0] * cells_[1] + cell[1]) * cells_[2] + cell[2]);
  }

  Cell cells_;
  std::vector<bool> covered_;
};

Point point_at(const Planes& planes, const Cell& cell) {
  Point point;
  for (std::size_t axis = 0; axis < kDimension; ++axis) point[axis] = compact(planes[axis][at(cell[axis])]);
  return point;
}

Cell read_extents(Reader& reader) {
  const int low = reader.next();
  const int code = low + 256 * reader.next();
  return {extent_of(code % kExtents), extent_of(code / kExtents % kExtents),
          extent_of(code / kExtents / kExtents % kExtents)};
}

/// Nothing when a coordinate is none of the form.
std::optional<Planes> planes_of(const std::vector<ElementLine>& boxes) {
  Planes planes;
  for (const ElementLine& box : boxes) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      for (const CompactRational* value : {&box.lower[axis], &box.upper[axis]}) {
        const auto coordinate = coordinate_of(*value);
        if (!coordinate) return std::nullopt;
        planes[axis].push_back(*coordinate);
      }
    }
  }
  for (std::vector<Coordinate>& line : planes) {
    std::sort(line.begin(), line.end());
    line.erase(std::unique(line.begin(), line.end()), line.end());
  }
  return planes;
}

int rank_of(const std::vector<Coordinate>& line, const CompactRational& value) {
  const Coordinate coordinate{value.numerator(), value.denominator()};
  return static_cast<int>(std::lower_bound(line.begin(), line.end(), coordinate) - line.begin());
}

}  // namespace

std::vector<ElementLine> read_boxes(Reader& reader, const Setting& setting, const ByteCaseLimits& limits) {
  const Planes planes = read_planes(reader, setting, limits.max_cells);
  const Cell cells = cells_of(planes);
  Filling filling(cells);
  std::vector<ElementLine> boxes;
  Cell cell;
  for (cell[0] = 0; cell[0] < cells[0]; ++cell[0]) {
    for (cell[1] = 0; cell[1] < cells[1]; ++cell[1]) {
      for (cell[2] = 0; cell[2] < cells[2]; ++cell[2]) {
        if (filling.is_covered(cell)) continue;
        const Cell upper = filling.cover(cell, read_extents(reader));
        boxes.push_back({point_at(planes, cell), point_at(planes, upper)});
      }
    }
  }
  return boxes;
}

void write_boxes(Writer& writer, const Setting& setting, const std::vector<ElementLine>& boxes) {
  const auto planes = planes_of(boxes);
  if (!planes) return writer.put(std::nullopt);
  const Planes units = unit_planes(setting);
  for (std::size_t axis = 0; axis < kDimension; ++axis) write_planes(writer, units[axis], (*planes)[axis]);
  for (const ElementLine& box : boxes) {
    int code = 0;
    for (std::size_t axis = kDimension; axis-- > 0;) {
      const std::vector<Coordinate>& line = (*planes)[axis];
      const auto extent = extent_code(rank_of(line, box.upper[axis]) - rank_of(line, box.lower[axis]));
      if (!extent) return writer.put(std::nullopt);
      code = code * kExtents + *extent;
    }
    writer.put(code % 256);
    writer.put(code / 256);
  }
}

}  // namespace asts::byte_form
