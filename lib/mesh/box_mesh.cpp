#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>

#include "lib/exact/errors.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/mesh/pair_table.hpp"

namespace asts {

namespace {

std::size_t at(std::int32_t id) { return static_cast<std::size_t>(id); }

/// -log_m of a volume, if it is an integer.
std::int32_t level_of_volume(Rational volume, int grading) {
  std::int32_t level = 0;
  for (; volume < 1; ++level) volume *= grading;
  for (; volume > 1; --level) volume /= grading;
  return volume == 1 ? level : Mesh::kNoLevel;
}

struct HashNumber {
  std::size_t operator()(const CompactRational& number) const {
    std::uint64_t top = 0;
    std::uint64_t bottom = 0;
    if (number.is_small()) {
      top = static_cast<std::uint64_t>(number.numerator());
      bottom = static_cast<std::uint64_t>(number.denominator());
    } else {
      const Rational value = number.value();
      top = mpz_get_ui(mpq_numref(value.backend().data()));
      bottom = mpz_get_ui(mpq_denref(value.backend().data()));
    }
    return (top * 0x9E3779B97F4A7C15ull ^ bottom) * 0xD6E8FEB86659FD93ull >> 16;
  }
};

/// The distinct coordinates of one axis and their ranks. The domain's ends belong to them even when no box reaches
/// them: then the search for gaps finds the boxes missing there.
class AxisLines {
 public:
  AxisLines(const std::vector<ElementLine>& lines, std::size_t axis, int length) {
    ranks_.try_emplace(CompactRational(0));
    ranks_.try_emplace(CompactRational(length));
    for (const ElementLine& line : lines) {
      ranks_.try_emplace(line.lower[axis]);
      ranks_.try_emplace(line.upper[axis]);
    }
    std::vector<std::pair<Rational, std::int32_t*>> sorted;
    sorted.reserve(ranks_.size());
    for (auto& [number, rank] : ranks_) sorted.emplace_back(number.value(), &rank);
    std::sort(sorted.begin(), sorted.end(), [](const auto& one, const auto& other) { return one.first < other.first; });
    for (auto& [value, rank] : sorted) {
      *rank = static_cast<std::int32_t>(coordinates_.size());
      coordinates_.push_back(std::move(value));
    }
  }

  std::int32_t rank(const CompactRational& number) const { return ranks_.find(number)->second; }
  std::vector<Rational> take_coordinates() { return std::move(coordinates_); }

 private:
  std::unordered_map<CompactRational, std::int32_t, HashNumber> ranks_;
  std::vector<Rational> coordinates_;
};

/// Levels by volume, each combination of side lengths computed once.
class BoxLevels {
 public:
  explicit BoxLevels(const Mesh& mesh) : mesh_(mesh) {}

  std::int32_t level(const Box& box) {
    PerAxis<std::int32_t> lengths;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      const std::int32_t lower = box.lower[axis];
      const std::int32_t upper = box.upper[axis];
      lengths[axis] = length_id_[axis].get(lower, upper, [&] {
        const Rational length = mesh_.coordinates[axis][at(upper)] - mesh_.coordinates[axis][at(lower)];
        return ids_.try_emplace(length, static_cast<std::int32_t>(ids_.size())).first->second;
      });
    }
    const auto [place, is_new] = levels_.try_emplace(lengths);
    if (is_new) place->second = level_of_volume(volume_of(box), mesh_.setting.grading);
    return place->second;
  }

 private:
  Rational volume_of(const Box& box) const {
    Rational volume = 1;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      volume *= mesh_.coordinate(axis, box.upper[at(axis)]) - mesh_.coordinate(axis, box.lower[at(axis)]);
    }
    return volume;
  }

  const Mesh& mesh_;
  PerAxis<PairTable<std::int32_t>> length_id_;
  std::map<Rational, std::int32_t> ids_;
  std::map<PerAxis<std::int32_t>, std::int32_t> levels_;
};

/// Cuts the domain until each region is covered by one box, which proves that the boxes tile it, and keeps the cuts as
/// the mesh's locator. A cut runs along a side of a box; a box that it crosses is listed on either side.
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

Mesh mesh_of(const Setting& setting, const std::vector<ElementLine>& elements) {
  Mesh mesh;
  mesh.setting = setting;
  mesh.elements.resize(elements.size());
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    AxisLines lines(elements, axis, setting.domain[axis]);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      mesh.elements[i].lower[axis] = lines.rank(elements[i].lower[axis]);
      mesh.elements[i].upper[axis] = lines.rank(elements[i].upper[axis]);
    }
    mesh.coordinates[axis] = lines.take_coordinates();
  }
  BoxLevels levels(mesh);
  mesh.levels.reserve(elements.size());
  for (const Box& box : mesh.elements) mesh.levels.push_back(levels.level(box));
  Tiling(mesh, elements).build();
  return mesh;
}

}  // namespace asts
