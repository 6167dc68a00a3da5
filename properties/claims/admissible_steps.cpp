#include "properties/claims/admissible_steps.hpp"

#include "lib/refine/patch_search.hpp"
#include "properties/splines_needed.hpp"

namespace asts {

namespace {

/// Judges all leaves; the first violation is told, and counting goes on, so that a mesh and its mirror images agree.
template <class Judge>
Trial judge_all(const std::vector<std::int32_t>& leaves, const Judge& judge) {
  Trial trial;
  for (const std::int32_t leaf : leaves) {
    Judgement judgement = judge(leaf);
    trial.met += judgement.met;
    if (!judgement.violation || trial.verdict.outcome == Outcome::violated) continue;
    trial.verdict = Verdict::violated(std::move(*judgement.violation));
  }
  return trial;
}

const char* const kNotAdmissible = "the mesh is not admissible";

}  // namespace

std::vector<std::int32_t> admissible_leaves(const RefinementTree& tree) {
  std::vector<std::vector<std::int32_t>> by_level(at(tree.max_level()) + 1);
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (tree.is_leaf(id)) by_level[at(tree.node(id).level)].push_back(id);
  }
  std::vector<bool> hindered(at(tree.node_count()), false);
  PatchSearch search(tree);
  for (std::size_t level = 1; level < by_level.size(); ++level) {
    search.coarser_in_patches(by_level[level], static_cast<std::int32_t>(level),
                              [&](const PatchSearch::Coarser& coarser) {
                                coarser.for_each_element([&](std::int32_t k) { hindered[at(k)] = true; });
                                return true;
                              });
  }
  std::vector<std::int32_t> result;
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (tree.is_leaf(id) && !hindered[at(id)]) result.push_back(id);
  }
  return result;
}

Trial judge_steps(MeshUnderTest& before, const std::function<Judgement(const SubdivisionStep&)>& judge) {
  if (!before.admissible()) return {Verdict::not_applicable(kNotAdmissible)};
  if (auto verdict = lacks_splines(before)) return {std::move(*verdict)};
  if (before.meeting_regions()) {
    return {Verdict::not_applicable("the mesh is not analysis-suitable")};
  }
  return judge_all(admissible_leaves(before.tree()), [&](std::int32_t leaf) {
    return reaches_active_nodes(before, leaf) ? judge(subdivision_step(before, leaf)) : Judgement{};
  });
}

Trial judge_leaves(MeshUnderTest& before, const std::function<Judgement(std::int32_t leaf)>& judge) {
  if (!before.admissible()) return {Verdict::not_applicable(kNotAdmissible)};
  return judge_all(admissible_leaves(before.tree()), judge);
}

}  // namespace asts
