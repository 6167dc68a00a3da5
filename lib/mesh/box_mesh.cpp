#include <algorithm>
#include <map>
#include <unordered_map>

#include "lib/exact/errors.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/mesh/pair_table.hpp"
#include "lib/mesh/tiling.hpp"

namespace asts {

namespace {

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
  build_tiling(mesh, elements);
  return mesh;
}

}  // namespace asts
