#include "lib/gen/enumerate.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <vector>

#include "lib/exact/errors.hpp"
#include "lib/gen/growing_case.hpp"
#include "lib/refine/admissibility.hpp"

namespace asts {

namespace {

/// The reflections: bit a of the number says whether axis a is reflected. Number 0 is the identity.
constexpr std::size_t kReflections = std::size_t{1} << kDimension;

bool reflects(std::size_t reflection, Axis axis) { return (reflection >> axis & 1) != 0; }

/// An element that could be subdivided. Among the elements of one level, `place` is its number in the canonical order:
/// that of the unit cube, followed by the indices of the children as digits of a number of base m.
struct Candidate {
  std::int32_t node;
  std::int32_t level;
  std::array<std::int64_t, kReflections> place;  ///< of the element's image under each reflection
};

void require_numbers(const Enumeration& enumeration) {
  require(enumeration.max_subdivisions >= 0, "the number of subdivisions is negative");
  std::int64_t places = 1;
  const auto multiply = [&](std::int64_t factor) {
    require(places <= std::numeric_limits<std::int64_t>::max() / factor, "so many subdivisions cannot be enumerated");
    places *= factor;
  };
  for (const int side : enumeration.setting.domain) multiply(side);
  for (int i = 0; i < enumeration.max_subdivisions; ++i) multiply(enumeration.setting.grading);
}

class Enumerator {
 public:
  using Visit = std::function<void(const EnumeratedMesh&)>;

  Enumerator(const Enumeration& enumeration, const Visit& visit)
      : enumeration_(enumeration), visit_(visit), trees_(1, RefinementTree(enumeration.setting)) {
    add_unit_cubes();
  }

  void run() { extend(0, 1); }

 private:
  void add_unit_cubes() {
    const PerAxis<int>& domain = enumeration_.setting.domain;
    PerAxis<std::int32_t> cube{};
    for (cube[0] = 0; cube[0] < domain[0]; ++cube[0]) {
      for (cube[1] = 0; cube[1] < domain[1]; ++cube[1]) {
        for (cube[2] = 0; cube[2] < domain[2]; ++cube[2]) add_unit_cube(cube);
      }
    }
  }

  void add_unit_cube(const PerAxis<std::int32_t>& cube) {
    Candidate candidate{trees_[0].unit_cube(cube), 0, {}};
    for (std::size_t reflection = 0; reflection < kReflections; ++reflection) {
      std::int64_t place = 0;
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const int side = enumeration_.setting.domain[at(axis)];
        const std::int32_t index = cube[at(axis)];
        place = place * side + (reflects(reflection, axis) ? side - 1 - index : index);
      }
      candidate.place[reflection] = place;
    }
    queue_.push_back(candidate);
  }

  /// Appends the children of an element that has just been subdivided.
  void add_children(const RefinementTree& tree, const Candidate& parent) {
    const Axis axis = tree.split_axis(parent.node);
    const int grading = enumeration_.setting.grading;
    for (int index = 0; index < grading; ++index) {
      Candidate child{tree.node(parent.node).first_child + index, parent.level + 1, {}};
      for (std::size_t reflection = 0; reflection < kReflections; ++reflection) {
        const int image = reflects(reflection, axis) ? grading - 1 - index : index;
        child.place[reflection] = parent.place[reflection] * grading + image;
      }
      queue_.push_back(child);
    }
  }

  /// Visits the mesh of the set, and all that elements from a place of the queue on make of it.
  void extend(std::size_t first, std::int64_t reflections) {
    const std::size_t depth = set_.size();
    visit_({trees_[depth], subdivided_, reflections});
    if (depth == static_cast<std::size_t>(enumeration_.max_subdivisions)) return;
    if (trees_.size() == depth + 1) trees_.push_back(trees_[depth]);
    const std::size_t end = queue_.size();
    for (std::size_t next = first; next < end; ++next) {
      if (enumeration_.admissible && !is_admissible_subdivision(trees_[depth], {&queue_[next].node, 1})) continue;
      set_.push_back(queue_[next]);
      subdivided_.push_back(queue_[next].node);
      const std::int64_t own = enumeration_.up_to_reflection ? distinct_reflections() : 1;
      if (own > 0) {
        trees_[depth + 1] = trees_[depth];
        trees_[depth + 1].subdivide(set_.back().node);
        trees_[depth + 1].update_ranks();
        add_children(trees_[depth + 1], set_.back());
        extend(next + 1, own);
        queue_.resize(end);
      }
      set_.pop_back();
      subdivided_.pop_back();
    }
  }

  /// How many distinct sets the reflections make of this one; 0 if one of them comes before it in the canonical order.
  std::int64_t distinct_reflections() {
    std::int64_t symmetries = 0;
    for (std::size_t reflection = 0; reflection < kReflections; ++reflection) {
      const auto order = compare_image(reflection);
      if (order < 0) return 0;
      symmetries += order == 0;
    }
    return static_cast<std::int64_t>(kReflections) / symmetries;
  }

  /// Compares the set's image under a reflection with the set, as lists in the canonical order. Images keep their
  /// levels, so that only places are compared.
  std::strong_ordering compare_image(std::size_t reflection) {
    image_.clear();
    for (const Candidate& element : set_) image_.push_back({element.level, element.place[reflection]});
    std::sort(image_.begin(), image_.end());
    for (std::size_t i = 0; i < set_.size(); ++i) {
      const auto order = image_[i].second <=> set_[i].place[0];
      if (order != 0) return order;
    }
    return std::strong_ordering::equal;
  }

  const Enumeration& enumeration_;
  const Visit& visit_;
  std::deque<RefinementTree> trees_;  ///< after each subdivision of the set; they stay where they are
  std::vector<Candidate> queue_;
  std::vector<Candidate> set_;  ///< what is subdivided, in the canonical order
  std::vector<std::int32_t> subdivided_;
  std::vector<std::pair<std::int32_t, std::int64_t>> image_;
};

}  // namespace

void enumerate_meshes(const Enumeration& enumeration, const std::function<void(const EnumeratedMesh&)>& visit) {
  require_numbers(enumeration);
  Enumerator(enumeration, visit).run();
}

Case case_of(const EnumeratedMesh& mesh) {
  const Setting& setting = mesh.tree.setting();
  Case result{setting.degree, setting.grading, setting.domain, {}, false, {}};
  for (const std::int32_t element : mesh.subdivided) {
    result.steps.push_back({Step::Kind::subdivide, {lower_corner(mesh.tree, element)}});
  }
  return result;
}

}  // namespace asts
