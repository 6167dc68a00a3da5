#include "properties/claims/experiment.hpp"

#include <algorithm>

#include "lib/exact/errors.hpp"
#include "lib/refine/complexity_constants.hpp"
#include "properties/claims/family_equations.hpp"
#include "properties/claims/marked_sequence.hpp"

namespace asts {

namespace {

constexpr PerAxis<int> kDegree{3, 3, 3};
constexpr PerAxis<int> kDomain{5, 5, 5};
constexpr int kLeastGrading = 2;
constexpr int kLargestGrading = 5;
constexpr std::int64_t kStepsToRepeat = 40;
constexpr const char* kPrintedBound = "C/3000";
constexpr const char* kLimit = "limit stated";

CubeRootNumber printed_bound(int grading) { return experiment_constant(grading) * (Rational(1) / kExperimentDivisor); }

CubeRootNumber limit_bound(int grading) { return {grading, Rational(experiment_limit(grading))}; }

/// The domain's corner that belongs to the element, if one does.
std::optional<ExactPoint> corner_of(const ExactBox& box) {
  ExactPoint corner;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const bool low = box.lower[axis] == 0;
    if (!low && box.upper[axis] != kDomain[axis]) return std::nullopt;
    corner[axis] = low ? 0 : kDomain[axis];
  }
  return corner;
}

Trial ratios_below(const Case& sequence, CubeRootNumber (*bound)(int), const char* bound_name) {
  if (const auto reason = no_experiment(sequence)) return {Verdict::not_applicable(*reason)};
  std::vector<std::int64_t> new_elements{0};
  Trial trial;
  const auto marked = follow(sequence, NewElements::count);
  for (const MarkedSequence::Step& step : marked->steps) {
    new_elements.push_back(step.new_elements);
    trial.met += step.subdivided > step.marked;
  }
  if (auto witness = judge_ratios(new_elements, bound(sequence.grading), bound_name)) {
    trial.verdict = Verdict::violated(std::move(*witness));
  }
  return trial;
}

Trial all_ratios_below(CubeRootNumber (*bound)(int), const char* bound_name) {
  Trial trial;
  for (int m = kLeastGrading; m <= kLargestGrading; ++m) {
    ++trial.met;
    auto witness = judge_experiment(m, experiment_certificate(m), bound(m), bound_name);
    if (witness) return {Verdict::violated(std::move(*witness)), trial.met};
  }
  return trial;
}

}  // namespace

CubeRootNumber experiment_constant(int grading) { return complexity_constant(distance_constants(kDegree, grading)); }

SelfSimilarity experiment_certificate(int grading) {
  auto certificate = find_self_similarity({kDegree, grading, kDomain}, kStepsToRepeat);
  ensure(certificate.has_value(), "the experiment's meshes repeat themselves within 40 steps");
  return std::move(*certificate);
}

std::int64_t experiment_limit(int grading) {
  constexpr std::array<std::int64_t, 4> limits{3840, 1680, 1152, 924};
  return limits.at(static_cast<std::size_t>(grading - kLeastGrading));
}

std::optional<std::string> no_experiment(const Case& sequence) {
  if (sequence.domain != kDomain) return "the domain is not 5 x 5 x 5";
  if (sequence.degree != kDegree) return "the degrees are not (3,3,3)";
  if (sequence.grading > kLargestGrading) return "m is not 2, 3, 4 or 5";
  if (sequence.steps.empty()) return "there is no step";
  const auto marked = follow(sequence, NewElements::count);
  if (!marked) return "a step is a bare subdivision";
  std::optional<ExactPoint> corner;
  for (std::size_t i = 0; i < marked->steps.size(); ++i) {
    if (marked->steps[i].marked != 1) return "a step does not mark exactly one element";
    const auto own = corner_of(marked->marks[i].box);
    if (!own || (corner && *corner != *own)) return "a mark is not in the one corner's element";
    corner = own;
  }
  return std::nullopt;
}

std::optional<Integer> first_step_not_below(const SelfSimilarity& certificate, const CubeRootNumber& bound) {
  const auto reaches = [&](const Integer& n, const Integer& elements) {
    return bound * Rational(n) <= Rational(elements);
  };
  const auto known = static_cast<std::int64_t>(certificate.new_elements.size()) - 1;
  for (std::int64_t n = 1; n <= known; ++n) {
    if (reaches(n, certificate.new_elements[static_cast<std::size_t>(n)])) return Integer(n);
  }
  // On each residue modulo 3 the counts grow by equal amounts: excess(n + 3) = excess(n) + gain.
  const CubeRootNumber period(bound.m(), certificate.growth[0] + certificate.growth[1] + certificate.growth[2]);
  const CubeRootNumber gain = period - bound * Rational(3);
  std::optional<Integer> first;
  for (std::int64_t n = known + 1; n <= known + 3; ++n) {
    const CubeRootNumber missing =
        bound * Rational(n) - CubeRootNumber(bound.m(), Rational(new_elements_after(certificate, n)));
    if (missing > Rational(0) && gain <= Rational(0)) continue;
    Integer periods = 0;
    if (missing > Rational(0)) {
      const Rational least = rational_bounds(missing / gain, 12).lower;
      mpz_fdiv_q(periods.backend().data(), mpq_numref(least.backend().data()), mpq_denref(least.backend().data()));
      while (gain * Rational(periods) < missing) ++periods;
    }
    const Integer step = n + 3 * periods;
    if (!first || step < *first) first = step;
  }
  return first;
}

std::optional<ClaimWitness> judge_ratios(const std::vector<std::int64_t>& new_elements, const CubeRootNumber& bound,
                                         const char* bound_name) {
  for (std::size_t n = 1; n < new_elements.size(); ++n) {
    if (bound * Rational(n) > Rational(new_elements[n])) continue;
    ClaimWitness witness{"ratio-not-below", "the ratio of new elements to marks is not below the bound", {}};
    witness.values = {{"steps", static_cast<std::int64_t>(n)},
                      {"new elements", new_elements[n]},
                      {"ratio", Rational(new_elements[n]) / Rational(n)},
                      {bound_name, shown(bound)}};
    return witness;
  }
  return std::nullopt;
}

std::optional<ClaimWitness> judge_experiment(int grading, const SelfSimilarity& certificate,
                                             const CubeRootNumber& bound, const char* bound_name) {
  const auto first = first_step_not_below(certificate, bound);
  if (!first) return std::nullopt;
  ClaimWitness witness{"ratio-not-below", "the ratio of new elements to marks is not below the bound", {}};
  const Rational period = certificate.growth[0] + certificate.growth[1] + certificate.growth[2];
  witness.values = {{"m", std::int64_t{grading}},
                    {"first step", Rational(*first)},
                    {"limit of the ratio", Rational(period / 3)},
                    {"n_0 of the certificate", certificate.start},
                    {bound_name, shown(bound)}};
  return witness;
}

Trial experiment_on_sequence(const Case& sequence) { return ratios_below(sequence, printed_bound, kPrintedBound); }

Trial experiment_alone(Extent) { return all_ratios_below(printed_bound, kPrintedBound); }

Trial experiment_repaired_on_sequence(const Case& sequence) { return ratios_below(sequence, limit_bound, kLimit); }

/// Also that the limits are what late steps add, and that they are below C/2849.
Trial experiment_repaired_alone(Extent) {
  for (int m = kLeastGrading; m <= kLargestGrading; ++m) {
    const std::int64_t limit = experiment_limit(m);
    const PerAxis<std::int64_t> growth = experiment_certificate(m).growth;
    const bool certified = growth == PerAxis<std::int64_t>{limit, limit, limit};
    if (certified && experiment_constant(m) * (Rational(1) / 2849) > Rational(limit)) continue;
    ClaimWitness witness{"other-limit", "what late steps add is not the limit stated, or not below C/2849", {}};
    witness.values = {{"m", std::int64_t{m}},
                      {"limit stated", limit},
                      {"late steps", ExactPoint{growth[0], growth[1], growth[2]}},
                      {"C/2849", shown(experiment_constant(m) * (Rational(1) / 2849))}};
    return {Verdict::violated(std::move(witness)), m - kLeastGrading + 1};
  }
  return all_ratios_below(limit_bound, kLimit);
}

}  // namespace asts
