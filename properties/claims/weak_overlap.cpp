#include "properties/claims/weak_overlap.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "lib/mesh/pair_table.hpp"
#include "properties/describe.hpp"
#include "properties/splines_needed.hpp"

namespace asts {

namespace {

constexpr std::array<Axis, kDimension> kAllAxes{0, 1, 2};

class WeakOverlap {
 public:
  WeakOverlap(MeshUnderTest& mesh, std::span<const Axis> axes)
      : mesh_(mesh), splines_(mesh.splines()), axes_(axes), extruded_(extrusion_axis(mesh.mesh())) {
    if (extruded_)
      std::copy_if(kAllAxes.begin(), kAllAxes.end(), planar_.begin(), [&](Axis a) { return a != extruded_; });
  }

  Trial judge() {
    Trial trial;
    for (std::int32_t v = 0; v < splines_.size(); ++v) {
      for (std::int32_t w = 0; w < v; ++w) {
        const auto disagreement = compare(v, w, trial.met);
        if (!disagreement || trial.verdict.outcome == Outcome::violated) continue;
        trial.verdict = violated(v, w, *disagreement);
      }
    }
    return trial;
  }

 private:
  enum class About { any_nodes, nodes_of_a_plane };

  /// What the definitions disagree about, nothing if they agree; counts what is not a matter of course.
  std::optional<About> compare(std::int32_t v, std::int32_t w, std::int64_t& met) {
    const int overlapping = overlapping_axes(v, w, kAllAxes);
    met += overlapping == 2;
    if (overlapping >= 2 && !weak(v, w, axes_)) return About::any_nodes;
    if (!extruded_ || !in_one_plane(v, w)) return std::nullopt;
    const int in_plane = overlapping_axes(v, w, planar_);
    met += in_plane == 1;
    if ((in_plane >= 1) == weak(v, w, planar_)) return std::nullopt;
    return About::nodes_of_a_plane;
  }

  bool in_one_plane(std::int32_t v, std::int32_t w) const {
    return splines_.nodes[at(v)][at(*extruded_)] == splines_.nodes[at(w)][at(*extruded_)];
  }

  bool overlapping(std::int32_t v, std::int32_t w, Axis axis) {
    const std::int32_t a = splines_.vector_ids[at(v)][at(axis)];
    const std::int32_t b = splines_.vector_ids[at(w)][at(axis)];
    const IndexVectors& vectors = splines_.vectors[at(axis)];
    return known_[at(axis)].get(std::min(a, b), std::max(a, b), [&] { return overlap(vectors[a], vectors[b]); });
  }

  int overlapping_axes(std::int32_t v, std::int32_t w, std::span<const Axis> axes) {
    return static_cast<int>(std::count_if(axes.begin(), axes.end(), [&](Axis a) { return overlapping(v, w, a); }));
  }

  /// The general definition.
  bool weak(std::int32_t v, std::int32_t w, std::span<const Axis> axes) {
    return std::any_of(axes.begin(), axes.end(), [&](Axis axis) {
      return splines_.vector_ids[at(v)][at(axis)] != splines_.vector_ids[at(w)][at(axis)] && overlapping(v, w, axis);
    });
  }

  Verdict violated(std::int32_t v, std::int32_t w, About about) const {
    ClaimWitness witness{"definitions-disagree",
                         "the nodes overlap along two axes, but along no axis they have different, overlapping vectors",
                         {}};
    if (about == About::nodes_of_a_plane) {
      witness = {
          "definitions-disagree-in-a-plane",
          "the nodes of one plane of a planar mesh overlap along one of its axes, or have different, overlapping "
          "vectors along one of them, but not both",
          {{"extruded_along", std::string(axis_name(*extruded_))}}};
    }
    witness.values.emplace_back("v", describe_node(mesh_.mesh(), splines_, v));
    witness.values.emplace_back("w", describe_node(mesh_.mesh(), splines_, w));
    return Verdict::violated(std::move(witness));
  }

  MeshUnderTest& mesh_;
  const TSplines& splines_;
  std::span<const Axis> axes_;
  std::optional<Axis> extruded_;
  std::array<Axis, kDimension - 1> planar_{};
  PerAxis<PairTable<bool>> known_;
};

/// Every element reaches from one line of the axis to the next, and each element of one layer is in all layers.
bool is_extruded(const Mesh& mesh, Axis axis) {
  const auto layers = static_cast<std::int64_t>(mesh.coordinates[at(axis)].size()) - 1;
  std::map<std::pair<PerAxis<std::int32_t>, PerAxis<std::int32_t>>, std::int64_t> count;
  for (Box box : mesh.elements) {
    if (box.upper[at(axis)] != box.lower[at(axis)] + 1) return false;
    box.lower[at(axis)] = box.upper[at(axis)] = 0;
    ++count[{box.lower, box.upper}];
  }
  return std::all_of(count.begin(), count.end(), [&](const auto& entry) { return entry.second == layers; });
}

}  // namespace

std::optional<Axis> extrusion_axis(const Mesh& mesh) {
  for (const Axis axis : kAllAxes) {
    if (is_extruded(mesh, axis)) return axis;
  }
  return std::nullopt;
}

Trial judge_weak_overlap(MeshUnderTest& mesh, std::span<const Axis> axes) { return WeakOverlap(mesh, axes).judge(); }

Trial dc_within_weak_dc(MeshUnderTest& mesh) {
  if (auto verdict = lacks_splines(mesh)) return {*verdict};
  return judge_weak_overlap(mesh, kAllAxes);
}

}  // namespace asts
