#include "lib/zones/zoned_mesh.hpp"

#include "lib/threads/parallel_for.hpp"

namespace asts {

namespace {

/// A changed element costs about as much as so many others from scratch.
constexpr std::int64_t kWorthRebuilding = 12;

/// An estimate of how many nodes' supports touch a box, in nodes of the finest kind. The nodes lie in it or up to half
/// a support beyond either end, and a support is p+1 intervals wide, of some two lines each. Nothing when it is too
/// large for 64 bits.
std::optional<std::int64_t> nodes_around(const RankBox& box, const PerAxis<int>& degree) {
  std::int64_t size = 1;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const std::int64_t lines = std::int64_t{box[axis].upper} - box[axis].lower + 1 + 2 * (degree[at(axis)] + 1);
    if (__builtin_mul_overflow(size, lines, &size)) return std::nullopt;
  }
  return size;
}

bool worth_merging(const RankBox& one, const RankBox& other, const PerAxis<int>& degree) {
  const auto both = nodes_around(hull(one, other), degree);
  return both && *both - *nodes_around(one, degree) <= *nodes_around(other, degree);  // no box is larger than the hull
}

/// Boxes become one where no more nodes have to be looked at for their hull than for the two.
std::vector<RankBox> merged(const std::vector<RankBox>& boxes, const PerAxis<int>& degree) {
  std::vector<RankBox> result;
  for (RankBox box : boxes) {
    for (std::size_t i = 0; i < result.size();) {
      if (!worth_merging(result[i], box, degree)) {
        ++i;
        continue;
      }
      box = hull(result[i], box);
      result[i] = result.back();
      result.pop_back();
      i = 0;
    }
    result.push_back(box);
  }
  return result;
}

}  // namespace

Proven ZonedMesh::check(const std::vector<RankBox>& boxes, bool changed_only, int jobs) {
  while (checks_.size() < static_cast<std::size_t>(jobs)) checks_.push_back({BoxCheck(zones_)});
  std::vector<Proven> found(boxes.size());
  parallel_for(jobs, boxes.size(), [&](std::size_t i, int worker) {
    found[i] = checks_[static_cast<std::size_t>(worker)].own.decide(boxes[i], changed_only);
  });
  Proven proven;
  for (const Proven& one : found) proven &= one;
  return proven;
}

Proven ZonedMesh::decide(std::span<const std::int32_t> subdivided, int jobs) {
  const bool anew =
      !proven_ || kWorthRebuilding * static_cast<std::int64_t>(subdivided.size()) > zones_.tree().element_count();
  const bool everywhere = anew || !proven_->all();
  std::vector<RankBox> boxes;
  if (anew) {
    zones_.rebuild(jobs);
  } else {
    boxes = merged(zones_.update(subdivided), zones_.tree().setting().degree);
  }
  if (everywhere) {
    boxes.clear();
    for (const Zone& zone : zones_.list()) boxes.push_back(box_of(zones_.tree(), zone.tree_node));
  }
  proven_ = zones_.known() ? check(boxes, !everywhere, jobs) : Proven{false, false, false};
  return *proven_;
}

std::optional<std::int64_t> ZonedMesh::active_nodes() const {
  if (!zones_.known()) return std::nullopt;
  return zones_.active_nodes();
}

}  // namespace asts
