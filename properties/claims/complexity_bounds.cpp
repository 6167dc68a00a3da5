#include "properties/claims/complexity_bounds.hpp"

#include "lib/refine/complexity_constants.hpp"
#include "properties/claims/family_equations.hpp"

namespace asts {

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

Trial complexity_bound_on_sequence(const Case& sequence) {
  const auto marked = follow(sequence, NewElements::count);
  if (!marked) return {Verdict::not_applicable("a step is a bare subdivision")};
  Trial trial;
  for (const MarkedSequence::Step& step : marked->steps) trial.met += step.subdivided > step.marked;
  auto witness = judge_complexity(*marked, complexity_constant(distance_constants(sequence.degree, sequence.grading)));
  if (witness) trial.verdict = Verdict::violated(std::move(*witness));
  return trial;
}

}  // namespace asts
