#include "lib/zones/box_check.hpp"

namespace asts {

/// Numbers the vectors of a zone that touch a box.
void BoxCheck::number_vectors(const Zone& zone, const RankBox& box) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const AxisGrid& grid = zones_.tree().grid(axis);
    std::vector<std::int32_t>& of_zone = of_zone_[at(axis)];
    of_zone.clear();
    for (const std::int32_t id : zone.vectors[at(axis)]) {
      std::int32_t& number = numbers_[at(axis)][at(id)];
      if (number < 0) {
        const auto lines = zones_.stores()[at(axis)][id];
        const RankInterval range{grid.rank_of_line(lines.front()), grid.rank_of_line(lines.back())};
        if (touch(range, box[axis])) number = check_.axis(axis).add(id, range);
      }
      of_zone.push_back(number);
    }
  }
}

/// The nodes whose supports touch a box.
void BoxCheck::gather(const RankBox& box, bool changed_only) {
  check_.begin(box);
  for (Axis axis = 0; axis < kDimension; ++axis) numbers_[at(axis)].resize(at(zones_.stores()[at(axis)].size()), -1);
  zones_.supports().for_each_touching(box, [&](std::size_t place) {
    const Zone& zone = zones_.list()[place];
    number_vectors(zone, box);
    for (std::size_t i = 0; i < zone.nodes.size(); ++i) {
      const PerAxis<std::uint16_t>& node = zone.nodes[i];
      const PerAxis<std::int32_t> numbers{of_zone_[0][node[0]], of_zone_[1][node[1]], of_zone_[2][node[2]]};
      if (numbers[0] < 0 || numbers[1] < 0 || numbers[2] < 0) continue;
      check_.add_node(numbers, !changed_only || (!zone.changed.empty() && zone.changed[i]));
    }
  });
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const ZoneAxis& along = check_.axis(axis);
    for (std::size_t i = 0; i < along.size(); ++i) numbers_[at(axis)][at(along.id(i))] = -1;
  }
}

Proven BoxCheck::decide(const RankBox& box, bool changed_only) {
  gather(box, changed_only);
  const ZoneCheck::Cut cut = check_.number_lines();
  if (cut.axis < 0) return check_.decide();
  RankBox low = box;
  RankBox high = box;
  low[cut.axis].upper = high[cut.axis].lower = cut.rank;
  Proven proven = decide(low, changed_only);
  proven &= decide(high, changed_only);
  return proven;
}

}  // namespace asts
