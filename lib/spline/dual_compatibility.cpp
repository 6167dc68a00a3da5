#include "lib/spline/dual_compatibility.hpp"

#include <algorithm>

namespace asts {

namespace {

std::size_t at(std::int32_t id) { return static_cast<std::size_t>(id); }

class IncompatiblePairs {
 public:
  IncompatiblePairs(const TSplines& splines, const LineRuns& runs)
      : splines_(splines), runs_(runs), order_(splines.line_order[at(runs.axis)]) {}

  void ask(const LineRun& one, const LineRun& other) {
    int failing = 0;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      if (axis == runs_.axis) continue;
      if (one.support.lower[at(axis)] >= other.support.upper[at(axis)]) return;
      if (other.support.lower[at(axis)] >= one.support.upper[at(axis)]) return;
      failing += overlaps_along(order_[at(one.begin)], order_[at(other.begin)], axis) ? 0 : 1;
    }
    if (failing == 0) return;
    for (std::int32_t i = one.begin; i < one.end; ++i) {
      for (std::int32_t j = other.begin; j < other.end; ++j) ask_nodes(order_[at(i)], order_[at(j)], failing);
    }
  }

  std::optional<NodePair> least() const { return least_; }

 private:
  bool overlaps_along(std::int32_t v, std::int32_t w, Axis axis) const {
    const std::int32_t a = splines_.vector_ids[at(v)][at(axis)];
    const std::int32_t b = splines_.vector_ids[at(w)][at(axis)];
    return a == b || overlap(splines_.vectors[at(axis)][a], splines_.vectors[at(axis)][b]);
  }

  void ask_nodes(std::int32_t v, std::int32_t w, int failing) {
    if (!interiors_meet(splines_.support(v, runs_.axis), splines_.support(w, runs_.axis))) return;
    if (failing < 2 && overlaps_along(v, w, runs_.axis)) return;
    const NodePair pair{std::min(v, w), std::max(v, w)};
    if (!least_ || pair < *least_) least_ = pair;
  }

  const TSplines& splines_;
  const LineRuns& runs_;
  const std::vector<std::int32_t>& order_;
  std::optional<NodePair> least_;
};

}  // namespace

std::optional<NodePair> find_incompatible(const TSplines& splines, const LineRuns& runs) {
  // nodes of one run overlap across it, so only pairs of different runs can fail
  IncompatiblePairs pairs(splines, runs);
  for (const auto& [i, j] : runs.pairs) pairs.ask(runs.runs[at(i)], runs.runs[at(j)]);
  return pairs.least();
}

}  // namespace asts
