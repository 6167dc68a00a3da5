#include "properties/claims/lambda_sums.hpp"

#include <algorithm>
#include <map>

#include "lib/mesh/level_formulas.hpp"
#include "lib/refine/complexity_constants.hpp"
#include "properties/claims/distance_bound.hpp"
#include "properties/claims/family_equations.hpp"
#include "properties/claims/family_facts.hpp"

namespace asts {

namespace {

/// An exact bound with rational ones around it, which nearly all comparisons need alone.
struct Bound {
  CubeRootNumber exact;
  RationalBounds around;

  explicit Bound(CubeRootNumber number) : exact(std::move(number)), around(rational_bounds(exact, 12)) {}
  bool allows(const Rational& value) const {
    if (value <= around.lower) return true;
    return value <= around.upper && exact >= value;
  }
};

/// Element midpoints with levels: all that lambda looks at.
struct Place {
  int level;
  ExactPoint midpoint;
};

std::vector<Place> places_of(const std::vector<ElementInfo>& elements) {
  std::vector<Place> places;
  for (const ElementInfo& element : elements) places.push_back({*element.level, midpoint(element.box)});
  return places;
}

ElementInfo describe_cell(const LevelCell& cell, int grading) {
  const PerAxis<Rational> side = level_size(grading, cell.level);
  ElementInfo info{{}, cell.level};
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    info.box.lower[axis] = side[axis] * cell.index[axis];
    info.box.upper[axis] = side[axis] * (cell.index[axis] + 1);
  }
  return info;
}

/// A sum of powers m^(k/3): how often each k occurs.
using PowerSum = std::map<int, std::int64_t>;

CubeRootNumber value_of(const PowerSum& sum, int grading) {
  CubeRootNumber result(grading, 0);
  for (const auto& [exponent, count] : sum) result += cube_root_power(grading, exponent) * Rational(count);
  return result;
}

/// Where lambda(K, .) is positive, by the level of K.
class Reach {
 public:
  explicit Reach(const PerAxis<CubeRootNumber>& reach) : reach_(reach) {}

  bool includes(const Place& k, const Place& mark) {
    if (k.level > mark.level + 1) return false;
    const std::vector<Bound>& bounds = at_level(k.level);
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      if (!bounds[axis].allows(abs(Rational(k.midpoint[axis] - mark.midpoint[axis])))) return false;
    }
    return true;
  }

 private:
  const std::vector<Bound>& at_level(int level) {
    std::vector<Bound>& bounds = by_level_[level];
    if (!bounds.empty()) return bounds;
    for (const CubeRootNumber& reach : reach_) bounds.emplace_back(reach * cube_root_power(reach.m(), -level));
    return bounds;
  }

  PerAxis<CubeRootNumber> reach_;
  std::map<int, std::vector<Bound>> by_level_;
};

/// The violation when a new element's sum over the marks is below 1.
std::optional<ClaimWitness> judge_first_sum(const ElementInfo& element, const PowerSum& of_element, int grading) {
  if (!of_element.empty() && of_element.rbegin()->first >= 0) return std::nullopt;  // one term is 1 or more
  const CubeRootNumber sum = value_of(of_element, grading);
  if (sum >= Rational(1)) return std::nullopt;
  std::int64_t within = 0;
  for (const auto& [exponent, count] : of_element) within += count;
  ClaimWitness witness{"sum-below-1", "the sum of lambda(K,K~) over all marks K~ is below 1", {}};
  witness.values = {{"K", element}, {"marks K~ with lambda(K,K~) > 0", within}, {"sum", shown(sum)}};
  return witness;
}

/// G_J \ G_0 as far as it consists of outer children, the lowest levels first.
std::vector<LevelCell> outer_children(const SubdividedElements& subdivided) {
  const int m = subdivided.setting().grading;
  std::vector<LevelCell> result;
  for (const LevelCell& element : subdivided.elements()) {
    for (const std::int64_t number : {0, m - 1}) {
      const LevelCell child = child_of(element, m, number);
      if (!subdivided.contains(child)) result.push_back(child);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

using Constants = PerAxis<CubeRootNumber>;

Constants reach_of(const Constants& d) { return {d[0] * Rational(2), d[1] * Rational(2), d[2] * Rational(2)}; }

Trial decide_listed(const MarkedSequence& sequence, const Constants& d) {
  Trial trial;
  auto witness = judge_lambda_sums(sequence, reach_of(d), complexity_constant(d), trial.met);
  if (witness) trial.verdict = Verdict::violated(std::move(*witness));
  return trial;
}

Trial decide_narrow(const NarrowSequence& sequence, const Constants& d) {
  Trial trial;
  auto witness = judge_outer_children(sequence, reach_of(d), trial.met);
  trial.verdict = witness ? Verdict::violated(std::move(*witness))
                          : Verdict::undecided(
                                "a mesh is too large: only sums over the marks were looked at, for outer children of "
                                "the lowest levels, and none is below 1");
  return trial;
}

/// One verdict for all of these constants: the first that is not `holds`.
template <class Sequence>
Trial decide_all(Trial (*decide)(const Sequence&, const Constants&), const Sequence& sequence,
                 const std::vector<Constants>& all) {
  Trial trial;
  for (const Constants& d : all) {
    trial = decide(sequence, d);
    if (trial.verdict.outcome != Outcome::holds) break;
  }
  return trial;
}

Trial lambda_sums_with(const Case& sequence, const std::vector<Constants>& all) {
  if (!refines_only(sequence)) return {Verdict::not_applicable("a step is a bare subdivision")};
  if (stays_below(sequence, kMostListedElements)) {
    return decide_all(decide_listed, *follow(sequence, NewElements::list), all);
  }
  return decide_all(decide_narrow, follow_narrowly(sequence), all);
}

}  // namespace

std::optional<ClaimWitness> judge_lambda_sums(const MarkedSequence& sequence, const PerAxis<CubeRootNumber>& reach,
                                              const CubeRootNumber& constant, std::int64_t& met) {
  const int m = constant.m();
  const std::vector<Place> marks = places_of(sequence.marks);
  const std::vector<Place> elements = places_of(sequence.new_elements);
  std::vector<PowerSum> of_mark(marks.size());
  Reach range(reach);
  for (std::size_t k = 0; k < elements.size(); ++k) {
    PowerSum of_element;
    for (std::size_t mark = 0; mark < marks.size(); ++mark) {
      if (!range.includes(elements[k], marks[mark])) continue;
      met += marks[mark].level >= 1;
      ++of_element[elements[k].level - marks[mark].level];
      ++of_mark[mark][elements[k].level - marks[mark].level];
    }
    if (auto witness = judge_first_sum(sequence.new_elements[k], of_element, m)) return witness;
  }
  for (std::size_t mark = 0; mark < marks.size(); ++mark) {
    const CubeRootNumber sum = value_of(of_mark[mark], m);
    if (sum <= constant) continue;
    ClaimWitness witness{"sum-above-C", "the sum of lambda(K,K~) over all new K exceeds C", {}};
    witness.values = {{"K~", sequence.marks[mark]}, {"sum", shown(sum)}, {"C", shown(constant)}};
    return witness;
  }
  return std::nullopt;
}

std::optional<ClaimWitness> judge_outer_children(const NarrowSequence& sequence, const PerAxis<CubeRootNumber>& reach,
                                                 std::int64_t& met) {
  const int m = sequence.subdivided.setting().grading;
  std::vector<ElementInfo> mark_boxes;
  for (const LevelCell& mark : sequence.marks) mark_boxes.push_back(describe_cell(mark, m));
  const std::vector<Place> marks = places_of(mark_boxes);
  Reach range(reach);
  std::int64_t pairs = 0;
  for (const LevelCell& child : outer_children(sequence.subdivided)) {
    pairs += static_cast<std::int64_t>(marks.size());
    if (pairs > kMostNarrowPairs) break;
    const ElementInfo element = describe_cell(child, m);
    const Place place{child.level, midpoint(element.box)};
    PowerSum of_element;
    for (const Place& mark : marks) {
      if (!range.includes(place, mark)) continue;
      met += mark.level >= 1;
      ++of_element[child.level - mark.level];
    }
    if (auto witness = judge_first_sum(element, of_element, m)) return witness;
  }
  return std::nullopt;
}

Trial lambda_sums_on_sequence(const Case& sequence) {
  return lambda_sums_with(sequence, {distance_constants(sequence.degree, sequence.grading)});
}

/// The printed proof of both halves stands with any d for which Lemma 7.2 is true.
Trial lambda_sums_repaired_on_sequence(const Case& sequence) {
  std::vector<Constants> all{corrected_distance_constants(sequence.degree, sequence.grading)};
  if (sequence.grading <= kLargestGradingOfPrintedConstants) {
    all.push_back(distance_constants(sequence.degree, sequence.grading));
  }
  return lambda_sums_with(sequence, all);
}

}  // namespace asts
