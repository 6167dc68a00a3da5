#include "lib/zones/zoned_mesh.hpp"

#include "lib/threads/parallel_for.hpp"

namespace asts {

Proven ZonedMesh::check(const std::vector<RankBox>& boxes, int jobs) {
  while (checks_.size() < static_cast<std::size_t>(jobs)) checks_.emplace_back(zones_);
  std::vector<Proven> found(boxes.size());
  parallel_for(jobs, boxes.size(), [&](std::size_t i, int worker) {
    found[i] = checks_[static_cast<std::size_t>(worker)].decide(boxes[i]);
  });
  Proven proven;
  for (const Proven& one : found) proven &= one;
  return proven;
}

Proven ZonedMesh::decide(std::span<const std::int32_t> subdivided, int jobs) {
  if (!proven_) zones_.rebuild(jobs);
  std::vector<RankBox> boxes;
  const bool everywhere = !proven_ || !proven_->all();
  if (proven_) boxes = zones_.update(subdivided);
  if (everywhere) {
    boxes.clear();
    for (const Zone& zone : zones_.list()) boxes.push_back(box_of(zones_.tree(), zone.tree_node));
  }
  proven_ = zones_.known() ? check(boxes, jobs) : Proven{false, false, false};
  return *proven_;
}

std::optional<std::int64_t> ZonedMesh::active_nodes() const {
  if (!zones_.known()) return std::nullopt;
  return zones_.active_nodes();
}

}  // namespace asts
