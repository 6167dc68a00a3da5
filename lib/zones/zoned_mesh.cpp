#include "lib/zones/zoned_mesh.hpp"

#include "lib/threads/parallel_for.hpp"

namespace asts {

namespace {

/// A changed element costs about as much as so many others from scratch.
constexpr std::int64_t kWorthRebuilding = 12;

/// A measure of what is in a box; nothing when it is too large for 64 bits.
std::optional<std::int64_t> size_of(const RankBox& box) {
  std::int64_t size = 1;
  for (const RankInterval& side : box.side) {
    if (__builtin_mul_overflow(size, std::int64_t{side.upper} - side.lower + 1, &size)) return std::nullopt;
  }
  return size;
}

bool worth_merging(const RankBox& one, const RankBox& other) {
  const auto both = size_of(hull(one, other));
  return both && *both - *size_of(one) <= *size_of(other);  // no box is larger than the hull
}

/// Boxes that overlap so much that their hull is no larger than the two become one.
std::vector<RankBox> merged(const std::vector<RankBox>& boxes) {
  std::vector<RankBox> result;
  for (RankBox box : boxes) {
    for (std::size_t i = 0; i < result.size();) {
      if (!worth_merging(result[i], box)) {
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
    boxes = merged(zones_.update(subdivided));
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
