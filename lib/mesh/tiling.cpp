#include "lib/mesh/tiling.hpp"

#include <algorithm>
#include <string>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

class Tiling {
 public:
  Tiling(Mesh& mesh, const std::vector<ElementLine>& lines) : mesh_(mesh), lines_(lines) {}

  void build() {
    Region all;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      all.box.lower[axis] = 0;
      all.box.upper[axis] = static_cast<std::int32_t>(mesh_.coordinates[axis].size()) - 1;
    }
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(mesh_.elements.size()); ++i) all.members.push_back(i);
    mesh_.locator.nodes.assign(1, {-1, -1, 0, 0});
    std::vector<Region> pending{std::move(all)};
    while (!pending.empty()) {
      Region region = std::move(pending.back());
      pending.pop_back();
      divide(region, pending);
    }
  }

 private:
  struct Region {
    Box box;
    std::vector<std::int32_t> members;
    std::int32_t node = 0;
  };
  struct Cut {
    std::size_t axis = 0;
    std::int32_t rank = -1;
    std::size_t crossed = 0;
  };

  void divide(Region& region, std::vector<Region>& pending) {
    if (region.members.empty()) fail_gap(region.box);
    for (const std::int32_t member : region.members) {
      if (!covers(mesh_.elements[at(member)], region.box)) continue;
      if (region.members.size() > 1) fail_overlap(member, region.members[member == region.members[0] ? 1 : 0]);
      mesh_.locator.nodes[at(region.node)].first = member;
      return;
    }
    const Cut cut = best_cut(region);
    const auto first = static_cast<std::int32_t>(mesh_.locator.nodes.size());
    Locator::Node& node = mesh_.locator.nodes[at(region.node)];
    node = {static_cast<std::int32_t>(cut.axis), first, 2, node.lower};
    mesh_.locator.nodes.push_back({-1, -1, 0, region.box.lower[cut.axis]});
    mesh_.locator.nodes.push_back({-1, -1, 0, cut.rank});
    Region low{region.box, {}, first};
    Region high{region.box, {}, first + 1};
    low.box.upper[cut.axis] = high.box.lower[cut.axis] = cut.rank;
    for (const std::int32_t member : region.members) {
      const Box& box = mesh_.elements[at(member)];
      if (box.lower[cut.axis] < cut.rank) low.members.push_back(member);
      if (box.upper[cut.axis] > cut.rank) high.members.push_back(member);
    }
    pending.push_back(std::move(low));
    pending.push_back(std::move(high));
  }

  static bool covers(const Box& box, const Box& region) {
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if (box.lower[axis] > region.lower[axis] || box.upper[axis] < region.upper[axis]) return false;
    }
    return true;
  }

  /// For each axis the median of the sides inside the region; of these the cut that crosses the fewest boxes.
  Cut best_cut(const Region& region) {
    Cut best;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      sides_.clear();
      for (const std::int32_t member : region.members) {
        const Box& box = mesh_.elements[at(member)];
        for (const std::int32_t side : {box.lower[axis], box.upper[axis]}) {
          if (side > region.box.lower[axis] && side < region.box.upper[axis]) sides_.push_back(side);
        }
      }
      if (sides_.empty()) continue;
      const auto middle = sides_.begin() + static_cast<std::ptrdiff_t>(sides_.size() / 2);
      std::nth_element(sides_.begin(), middle, sides_.end());
      const Cut cut{axis, *middle, crossed(region, axis, *middle)};
      if (best.rank < 0 || cut.crossed < best.crossed) best = cut;
    }
    ensure(best.rank >= 0, "a region that no box covers has a box's side inside");
    return best;
  }

  std::size_t crossed(const Region& region, std::size_t axis, std::int32_t rank) const {
    return static_cast<std::size_t>(std::count_if(region.members.begin(), region.members.end(), [&](std::int32_t i) {
      return mesh_.elements[at(i)].lower[axis] < rank && mesh_.elements[at(i)].upper[axis] > rank;
    }));
  }

  std::string text(const Box& box) const {
    std::string result;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      result += axis == 0 ? "[" : " x [";
      result += to_string(mesh_.coordinate(axis, box.lower[at(axis)])) + ", ";
      result += to_string(mesh_.coordinate(axis, box.upper[at(axis)])) + "]";
    }
    return result;
  }

  [[noreturn]] void fail_gap(const Box& box) const {
    const std::size_t line = lines_.empty() ? 0 : lines_.back().line;
    throw InputError(std::to_string(line) + ": the elements leave a gap: none covers " + text(box));
  }

  [[noreturn]] void fail_overlap(std::int32_t one, std::int32_t other) const {
    const auto [first, second] = std::minmax(one, other);
    throw InputError(std::to_string(lines_[at(second)].line) + ": this element overlaps the one of line " +
                     std::to_string(lines_[at(first)].line));
  }

  Mesh& mesh_;
  const std::vector<ElementLine>& lines_;
  std::vector<std::int32_t> sides_;
};

}  // namespace

void build_tiling(Mesh& mesh, const std::vector<ElementLine>& lines) { Tiling(mesh, lines).build(); }

}  // namespace asts
