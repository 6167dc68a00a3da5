#include <fmt/format.h>

#include "lib/exact/errors.hpp"
#include "lib/refine/complexity_constants.hpp"
#include "properties/claims/experiment.hpp"
#include "reports/paper/paper.hpp"
#include "reports/paper/text.hpp"

namespace asts {

namespace {

constexpr int kLeastGrading = 2;
constexpr int kLargestGrading = 16;    ///< of the constants in theory
constexpr int kLargestExperiment = 8;  ///< of the experiment; the paper's is 5
constexpr std::int64_t kSteps = 150;   ///< of the estimation
constexpr std::int64_t kFewSteps = 16;
constexpr std::array kDegrees{3, 5, 7};  ///< p1 = p2 = p3
constexpr int kDigits = 9;

/// The experiment of Section 7 for one grading: what it adds after any number of steps, and what it tends to.
struct Experiment {
  int grading;
  SelfSimilarity certificate;
  CubeRootNumber constant;

  explicit Experiment(int m) : grading(m), certificate(experiment_certificate(m)), constant(experiment_constant(m)) {}

  /// |G_n \ G_0| / n tends to what three late steps add, divided by 3.
  Rational limit() const { return Rational(certificate.growth[0] + certificate.growth[1] + certificate.growth[2]) / 3; }
  Rational ratio(std::int64_t steps) const { return Rational(new_elements_after(certificate, steps)) / steps; }
};

CubeRootNumber constant_of(int degree, int grading) {
  return complexity_constant(distance_constants({degree, degree, degree}, grading));
}

std::string theory_data() {
  std::string text =
      fmt::format("# Theorem 7.1: m, then C for p = (3,3,3), (5,5,5), (7,7,7), rounded down to {} digits\n", kDigits);
  for (int m = kLeastGrading; m <= kLargestGrading; ++m) {
    text += std::to_string(m);
    for (const int degree : kDegrees) text += " " + decimal_text(constant_of(degree, m), kDigits);
    text += "\n";
  }
  return text;
}

std::string experiment_data(const std::vector<Experiment>& experiments) {
  std::string text =
      "# Section 7, 5 x 5 x 5, p = (3,3,3): m, the limit of the ratio of new to marked elements, C/3000 rounded down\n";
  for (const Experiment& one : experiments) {
    text += fmt::format("{} {} {}\n", one.grading, to_string(one.limit()),
                        decimal_text(one.constant * Rational(1, kExperimentDivisor), kDigits));
  }
  return text;
}

std::string steps_data(const std::vector<Experiment>& experiments) {
  std::string text = fmt::format(
      "# Section 7, 5 x 5 x 5, p = (3,3,3): step n, then for m = {}, ..., {} the new elements after n steps\n"
      "# and their ratio to n, rounded down to {} digits\n",
      experiments.front().grading, experiments.back().grading, kDigits);
  for (std::int64_t n = 1; n <= kSteps; ++n) {
    text += std::to_string(n);
    for (const Experiment& one : experiments) {
      text += fmt::format(" {} {}", new_elements_after(one.certificate, n).str(), decimal_text(one.ratio(n), kDigits));
    }
    text += "\n";
  }
  return text;
}

std::string exceeded(const Experiment& experiment) {
  const auto step = first_step_not_below(experiment.certificate, experiment.constant * Rational(1, kExperimentDivisor));
  return step ? "at step " + step->str() : "never";
}

std::vector<std::string> row_of(const Experiment& one) {
  const Rational limit = one.limit();
  return {std::to_string(one.grading),
          decimal_text(one.constant, kDigits),
          decimal_text(one.constant * Rational(1, kExperimentDivisor), kDigits),
          decimal_text(one.ratio(kFewSteps), 6),
          decimal_text(one.ratio(kSteps), 6),
          to_string(limit),
          std::to_string(one.certificate.start),
          decimal_text(one.constant * (1 / limit), 6),
          exceeded(one)};
}

}  // namespace

void add_complexity(Paper& paper) {
  std::vector<Experiment> experiments;
  std::vector<std::vector<std::string>> rows{{"m", "C", "C/3000", fmt::format("ratio after {} steps", kFewSteps),
                                              fmt::format("after {}", kSteps), "limit", "each step adds it after step",
                                              "C / limit", "ratio reaches C/3000"}};
  for (int m = kLeastGrading; m <= kLargestExperiment; ++m) {
    experiments.emplace_back(m);
    rows.push_back(row_of(experiments.back()));
  }
  paper.files.push_back({"complexity-theory.dat", theory_data()});
  paper.files.push_back({"complexity-experiment.dat", experiment_data(experiments)});
  const std::vector<Experiment> drawn(experiments.begin(), experiments.begin() + 4);
  paper.files.push_back({"complexity-steps.dat", steps_data(drawn)});
  paper.tables["complexity"] = markdown_table(rows);
}

}  // namespace asts
