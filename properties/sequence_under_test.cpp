#include "properties/sequence_under_test.hpp"

#include "lib/refine/admissibility.hpp"
#include "properties/splines_needed.hpp"

namespace asts {

void SequenceUnderTest::after_step() {
  const std::vector<std::int32_t>& subdivided = replay_.subdivided();
  if (zones_in_use_) since_proven_.insert(since_proven_.end(), subdivided.begin(), subdivided.end());
  if (admissible_) {
    was_admissible_ = *admissible_;
    since_admissible_.clear();
  }
  if (was_admissible_) since_admissible_.insert(since_admissible_.end(), subdivided.begin(), subdivided.end());
  mesh_.reset();
  proven_.reset();
  admissible_.reset();
}

MeshUnderTest& SequenceUnderTest::mesh() {
  if (!mesh_) mesh_.emplace(tree_);
  return *mesh_;
}

const Proven& SequenceUnderTest::proven() {
  if (!proven_) {
    proven_ = zones_.decide(since_proven_, jobs_);
    since_proven_.clear();
    zones_in_use_ = true;
  }
  return *proven_;
}

bool SequenceUnderTest::admissible() {
  constexpr std::size_t kFew = 4096;  // subdivided elements: not worth a thread
  if (!admissible_) {
    const int step_jobs = since_admissible_.size() < kFew ? 1 : jobs_;
    admissible_ =
        was_admissible_ ? stays_admissible(tree_, since_admissible_, step_jobs) : !find_inadmissible(tree_, jobs_);
  }
  return *admissible_;
}

std::int64_t SequenceUnderTest::active_nodes() {
  if (!mesh_) {
    proven();
    if (const auto count = zones_.active_nodes()) return *count;
  }
  return mesh().splines().size();
}

std::optional<Verdict> SequenceUnderTest::decide_proven(bool Proven::*property) {
  if (!(proven().*property)) return std::nullopt;
  if (zones_.active_nodes() == 0) return without_active_nodes(active_region_is_empty(tree_));
  return Verdict::holds();
}

Verdict SequenceUnderTest::decide(const Property& property) {
  const auto known = property.decide_in_sequence(*this);
  return known ? *known : asts::decide(property, mesh());
}

}  // namespace asts
