#include "properties/claims/complexity_bounds.hpp"

#include <map>

#include "lib/refine/complexity_constants.hpp"
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

Trial not_a_sequence() { return {Verdict::not_applicable("a step is a bare subdivision")}; }

}  // namespace

std::optional<ClaimWitness> judge_complexity(const MarkedSequence& sequence, const CubeRootNumber& constant) {
  std::int64_t marks = 0;
  for (std::size_t j = 0; j < sequence.steps.size(); ++j) {
    marks += sequence.steps[j].marked;
    const CubeRootNumber bound = constant * Rational(marks);
    if (bound >= Rational(sequence.steps[j].new_elements)) continue;
    ClaimWitness witness{"too-many-elements", "the new elements exceed C times the marks", {}};
    witness.values = {{"J", static_cast<std::int64_t>(j + 1)},
                      {"new elements", sequence.steps[j].new_elements},
                      {"marks", marks},
                      {"C times marks", shown(bound)}};
    return witness;
  }
  return std::nullopt;
}

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
    if (!of_element.empty() && of_element.rbegin()->first >= 0) continue;  // one term is 1 or more
    const CubeRootNumber sum = value_of(of_element, m);
    if (sum >= Rational(1)) continue;
    ClaimWitness witness{"sum-below-1", "the sum of lambda(K,K~) over all marks K~ is below 1", {}};
    witness.values = {{"K", sequence.new_elements[k]}, {"sum", shown(sum)}};
    return witness;
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

Trial complexity_bound_on_sequence(const Case& sequence) {
  const auto marked = follow(sequence, NewElements::count);
  if (!marked) return not_a_sequence();
  Trial trial;
  for (const MarkedSequence::Step& step : marked->steps) trial.met += step.subdivided > step.marked;
  auto witness = judge_complexity(*marked, complexity_constant(distance_constants(sequence.degree, sequence.grading)));
  if (witness) trial.verdict = Verdict::violated(std::move(*witness));
  return trial;
}

Trial lambda_sums_on_sequence(const Case& sequence) {
  const auto marked = follow(sequence, NewElements::list);
  if (!marked) return not_a_sequence();
  Trial trial;
  const PerAxis<CubeRootNumber> d = distance_constants(sequence.degree, sequence.grading);
  const PerAxis<CubeRootNumber> reach{d[0] * Rational(2), d[1] * Rational(2), d[2] * Rational(2)};
  auto witness = judge_lambda_sums(*marked, reach, complexity_constant(d), trial.met);
  if (witness) trial.verdict = Verdict::violated(std::move(*witness));
  return trial;
}

}  // namespace asts
