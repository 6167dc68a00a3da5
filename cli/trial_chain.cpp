#include "cli/trial_chain.hpp"

namespace asts::cli {

/// Whether the last link's mesh keeps its active nodes and index vectors when an element is subdivided.
bool TrialChain::leaves_splines(std::int32_t subdivided) {
  MeshUnderTest& before = links_.back().mesh_under_test();
  const Mesh& mesh = before.mesh();
  const Box& element = mesh.elements[at(mesh.locator.nodes[at(subdivided)].first)];
  return !may_change_splines(before.splines(), element, before.tree().split_axis(subdivided));
}

const std::vector<TrialResult>& TrialChain::results(const EnumeratedMesh& enumerated) {
  const std::size_t depth = enumerated.subdivided.size();
  links_.resize(depth);
  const bool same_splines = depth > 0 && leaves_splines(enumerated.subdivided.back());
  const std::vector<TrialResult>* before = depth > 0 ? &links_.back().results : nullptr;
  Link link{&enumerated.tree, nullptr, {}};
  for (std::size_t i = 0; i < statements_.size(); ++i) {
    if (same_splines && statements_[i]->of_splines) {
      link.results.push_back((*before)[i]);
    } else {
      const Trial trial = statements_[i]->decide(link.mesh_under_test());
      link.results.push_back({trial.verdict.outcome, trial.met});
    }
  }
  links_.push_back(std::move(link));
  return links_.back().results;
}

}  // namespace asts::cli
