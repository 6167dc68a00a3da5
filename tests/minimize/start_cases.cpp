#include "tests/minimize/start_cases.hpp"

#include <algorithm>
#include <array>

#include "lib/exact/errors.hpp"
#include "properties/campaign/provoked_cases.hpp"
#include "properties/statement.hpp"
#include "tests/minimize/special_starts.hpp"
#include "tests/minimize/start_meshes.hpp"

namespace asts {

namespace {

constexpr int kMostTries = 200'000;
constexpr std::int64_t kLargestStartSize = 30;

constexpr std::array<std::string_view, 14> kClaims{
    "as-implies-dc",       "dc-implies-as",       "as-implies-dual-basis",   "case-table",
    "new-node-split",      "lambda-sums",         "perturbed-cover-hanging", "planar-equals-classical",
    "figure-proof-levels", "frame-in-index-sets", "child-distance",          "child-distance-bound",
    "distance-bound",      "experiment-constant"};

constexpr std::array<std::string_view, 8> kExplicit{"as-implies-dc",           "dc-implies-as", "as-implies-dual-basis",
                                                    "planar-equals-classical", "admissible",    "analysis-suitable",
                                                    "dual-compatible",         "dual-basis"};

/// SplitMix64's last step: neighbouring seeds, and the same seed of another claim, have unrelated streams.
Draw draw_for(std::string_view id, std::uint64_t seed) {
  std::uint64_t bits = seed * 0x9E3779B97F4A7C15ULL;
  for (const char letter : id) bits = (bits ^ static_cast<std::uint64_t>(letter)) * 0xBF58476D1CE4E5B9ULL;
  return Draw(bits ^ (bits >> 31));
}

using Make = std::function<Case(Draw&)>;

/// Draws cases until one violates the statement and is large enough, or gets large enough by random additions that keep
/// the kind of the violation.
Case violating(Draw& draw, const Statement& statement, const Make& make, const StartLimits& limits) {
  for (int tries = 0; tries < kMostTries; ++tries) {
    const Case first = make(draw);
    const auto kind = violation_of(statement, first);
    if (!kind) continue;
    const auto keeps = [&](const Case& other) { return violation_of(statement, other) == kind; };
    const std::int64_t size = draw.between(kLeastStartSize, kLargestStartSize);
    const auto start = first.explicit_mesh ? with_more_cuts(draw, first, size, keeps)
                                           : with_more_steps(draw, first, size, limits, keeps);
    if (start) return *start;
  }
  throw InternalError("no start was found");
}

/// As they are drawn, without additions, which would not keep what the claim speaks of.
Case violating_as_made(Draw& draw, const Statement& statement, Case (*make)(Draw&)) {
  for (int tries = 0; tries < kMostTries; ++tries) {
    const Case start = make(draw);
    if (size_of(start) >= kLeastStartSize && violation_of(statement, start)) return start;
  }
  throw InternalError("no start was found");
}

/// One axis at least that is shorter than the integers of its frame.
Case on_narrow_domain(Draw& draw) {
  Case result = random_steps(draw, {StartSteps::refine_only, 7, 2, 4, 250, 600});
  const std::size_t axis = draw.index(kDimension);
  result.degree[axis] = 3 + 2 * draw.between(1, 4);
  result.domain[axis] = draw.between(1, (result.degree[axis] - 3) / 2);
  for (Step& step : result.steps) {
    for (Point& mark : step.marks) {
      if (mark[axis].value() > result.domain[axis]) mark[axis] = CompactRational(result.domain[axis]);
    }
  }
  return result;
}

StartLimits limits_of(std::string_view claim) {
  StartLimits limits;
  if (claim == "new-node-split" || claim == "frame-in-index-sets") limits.steps = StartSteps::refine_only;
  if (claim == "child-distance" || claim == "child-distance-bound") limits.least_grading = 3;
  return limits;
}

Case violating_random_steps(Draw& draw, const Statement& statement, std::string_view claim) {
  const StartLimits limits = limits_of(claim);
  const bool interface = claim == "dc-implies-as" || (claim == "case-table" && draw.one_in(2));
  const Make make = [&](Draw& own) {
    if (claim == "frame-in-index-sets") return on_narrow_domain(own);
    return interface ? interface_case(own) : random_steps(own, limits);
  };
  return violating(draw, statement, make, limits);
}

/// Boxes that come from subdivisions for every other start, before boxes that do not are cut from them.
Case random_boxes(Draw& draw, std::string_view id) {
  if (id == "dc-implies-as") return as_boxes(draw, interface_case(draw));
  if (draw.one_in(2)) return as_boxes(draw, random_steps(draw, {}));
  const CaseLimits limits{draw.one_in(3) ? 7 : 3, 4, kLargestStartSide, 200, 400, 8};
  return random_box_case(draw, limits).content;
}

}  // namespace

std::span<const std::string_view> start_claims() { return kClaims; }
std::span<const std::string_view> explicit_start_ids() { return kExplicit; }

Case violating_start(std::string_view claim, std::uint64_t seed) {
  require(std::find(kClaims.begin(), kClaims.end(), claim) != kClaims.end(), "a claim without starts");
  const Statement statement = find_statement(claim).value();
  Draw draw = draw_for(claim, seed);
  if (claim == "lambda-sums") return chain_start(draw);
  if (claim == "experiment-constant") return corner_start(draw);
  if (claim == "distance-bound") return distance_start(draw);
  if (claim == "figure-proof-levels") return violating_as_made(draw, statement, figure_case);
  if (claim == "planar-equals-classical") return violating_as_made(draw, statement, planar_case_of_steps);
  return violating_random_steps(draw, statement, claim);
}

Case violating_explicit_start(std::string_view id, std::uint64_t seed) {
  require(std::find(kExplicit.begin(), kExplicit.end(), id) != kExplicit.end(), "a statement without explicit starts");
  const Statement statement = find_statement(id).value();
  Draw draw = draw_for(id, ~seed);
  if (id == "planar-equals-classical") return violating_as_made(draw, statement, planar_case_of_boxes);
  return violating(draw, statement, [&](Draw& own) { return random_boxes(own, id); }, {});
}

}  // namespace asts
