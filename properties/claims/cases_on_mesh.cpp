#include "properties/claims/case_table.hpp"
#include "properties/describe.hpp"
#include "properties/splines_needed.hpp"

namespace asts {

namespace {

/// Slices along two axes that tell the same two nodes apart.
struct CasePair {
  TellingSlice first;
  TellingSlice second;
};

class Cases {
 public:
  Cases(MeshUnderTest& mesh, const SliceNodes& slice_nodes, CaseConclusion conclusion)
      : mesh_(mesh), splines_(mesh.splines()), slice_nodes_(slice_nodes), conclusion_(conclusion) {}

  Trial judge() {
    Trial trial;
    for (std::int32_t v = 0; v < splines_.size(); ++v) {
      for (std::int32_t w = 0; w < v; ++w) {
        trial.met += situations(v, w);
        if (trial.verdict.outcome == Outcome::violated || !situation_ || conclusion_holds(v, w)) continue;
        trial.verdict = Verdict::violated(describe(*situation_));
      }
    }
    return trial;
  }

 private:
  /// How many situations (pairs of slices) two nodes are a case's pair in; keeps one.
  std::int64_t situations(std::int32_t v, std::int32_t w) {
    PerAxis<std::vector<TellingSlice>> slices;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      slices[at(axis)] = telling_slices(splines_, slice_nodes_, axis, v, w);
    }
    situation_.reset();
    std::int64_t count = 0;
    for (std::size_t first = 0; first < kDimension; ++first) {
      for (std::size_t second = first + 1; second < kDimension; ++second) {
        if (slices[first].empty() || slices[second].empty()) continue;
        count += static_cast<std::int64_t>(slices[first].size() * slices[second].size());
        if (!situation_) situation_ = CasePair{slices[first].front(), slices[second].front()};
      }
    }
    return count;
  }

  bool conclusion_holds(std::int32_t v, std::int32_t w) const {
    int overlapping = 0;
    bool share_volume = true;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      overlapping += overlap(splines_.index_vector(v, axis), splines_.index_vector(w, axis)) ? 1 : 0;
      share_volume = share_volume && interiors_meet(splines_.support(v, axis), splines_.support(w, axis));
    }
    return overlapping < 2 && (share_volume || conclusion_ == CaseConclusion::no_partial_overlap);
  }

  ClaimWitness describe(const CasePair& pair) const {
    const auto slice = [&](const TellingSlice& one) { return mesh_.mesh().coordinate(one.axis, one.rank); };
    const auto node = [&](std::int32_t id) { return describe_node(mesh_.mesh(), splines_, id); };
    return {
        "case-without-conclusion",
        conclusion_ == CaseConclusion::no_partial_overlap
            ? "the nodes are as a case of the proof has them, but they partially overlap"
            : "the nodes are as a case of the proof has them, but they partially overlap, or their supports share no "
              "volume",
        {{"first_axis", std::string(axis_name(pair.first.axis))},
         {"first_slice", slice(pair.first)},
         {"second_axis", std::string(axis_name(pair.second.axis))},
         {"second_slice", slice(pair.second)},
         {"v1", node(pair.first.in)},
         {"v2", node(pair.first.out)},
         {"v3", node(pair.second.in)},
         {"v4", node(pair.second.out)}}};
  }

  MeshUnderTest& mesh_;
  const TSplines& splines_;
  const SliceNodes& slice_nodes_;
  CaseConclusion conclusion_;
  std::optional<CasePair> situation_;
};

Trial cases_of(MeshUnderTest& mesh, CaseConclusion conclusion) {
  if (auto verdict = lacks_splines(mesh)) return {*verdict};
  if (!mesh.meeting_regions()) return {Verdict::not_applicable("no two perturbed regions meet")};
  return judge_cases(mesh, SliceNodes(mesh), conclusion);
}

/// REQUIRES: two perturbed regions meet.
ClaimWitness no_case(MeshUnderTest& mesh) {
  const RegionsMeetWitness meeting = describe_meeting(mesh, mesh.meeting_regions().value());
  return {"no-case",
          "two perturbed regions meet in the point because of v1, v2 and v3, v4, but none of the cases occurs",
          {{"point", meeting.point},
           {"first_axis", std::string(axis_name(meeting.first.axis))},
           {"first_slice", meeting.first.slice},
           {"second_axis", std::string(axis_name(meeting.second.axis))},
           {"second_slice", meeting.second.slice},
           {"v1", meeting.first.in},
           {"v2", meeting.first.out},
           {"v3", meeting.second.in},
           {"v4", meeting.second.out}}};
}

}  // namespace

Trial judge_cases(MeshUnderTest& mesh, const SliceNodes& slice_nodes, CaseConclusion conclusion) {
  const Trial trial = Cases(mesh, slice_nodes, conclusion).judge();
  if (trial.met > 0) return trial;
  return {Verdict::violated(no_case(mesh))};
}

Trial cases(MeshUnderTest& mesh) { return cases_of(mesh, CaseConclusion::not_dual_compatible); }

Trial cases_repaired(MeshUnderTest& mesh) { return cases_of(mesh, CaseConclusion::no_partial_overlap); }

}  // namespace asts
