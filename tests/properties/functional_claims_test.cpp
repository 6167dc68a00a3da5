#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "lib/spline/dual_functional.hpp"
#include "properties/claims/overlap_duality.hpp"
#include "properties/claims/perfect_bspline.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/properties/claim_checks.hpp"
#include "tests/reference/independence_claims.hpp"

namespace asts {
namespace {

using Vector = std::vector<Rational>;

Rational ratio(int a, int b) { return Rational(a, b); }

const Vector kUneven{0, 1, 4, 5, 7};

std::string kind_of(const Verdict& verdict) {
  return verdict.witness ? std::get<ClaimWitness>(*verdict.witness).kind : outcome_name(verdict.outcome);
}

/// The divided difference's factor p in the place of p+1.
PerfectBspline with_wrong_factor(int degree) {
  PerfectBspline spline = perfect_bspline(degree);
  spline.factor = spline.factor * degree / (degree + 1);
  return spline;
}

/// Without (-1)^(p+1).
PerfectBspline without_sign(int degree) {
  PerfectBspline spline = perfect_bspline(degree);
  spline.factor = degree + 1;
  return spline;
}

/// y_0 left out of the divided difference.
PerfectBspline without_first_knot(int degree) {
  PerfectBspline spline = perfect_bspline(degree);
  spline.weights.front() = 0;
  return spline;
}

/// lambda of X moved by one entry: (x_2, ..., x_(p+2), x_(p+2) + 1).
FieldElement lambda_of_next(DualFunctional& functional, std::span<const Rational> x, std::span<const Rational> other) {
  Vector next(x.begin() + 1, x.end());
  next.push_back(x.back() + 1);
  return functional.lambda(next, other);
}

Lambda lambda_of(const std::shared_ptr<DualFunctional>& functional) {
  return [functional](auto x, auto x_tilde) { return functional->lambda(x, x_tilde); };
}

Verdict run_shifted_duality() {
  DualFunctional functional(3);
  Draw draw(1);
  const Lambda shifted = [&](auto x, auto other) { return lambda_of_next(functional, x, other); };
  return judge_duality(random_vector_pairs(draw, 3), shifted).verdict;
}

TEST(PerfectBsplineClaim, HoldsForDegreesUpTo15) {
  const Trial trial = try_perfect_bspline(Extent::short_run);
  EXPECT_EQ(trial.verdict.outcome, Outcome::holds);
  EXPECT_EQ(trial.met, 13 * 5) << "degrees 3 to 15, five uneven vectors each";
}

TEST(PerfectBsplineClaim, TellsWhatIsWrong) {
  EXPECT_EQ(kind_of(judge_perfect_shape(perfect_bspline(4))), "holds");
  EXPECT_EQ(kind_of(judge_perfect_shape(with_wrong_factor(3))), "integral-not-one");
  EXPECT_EQ(kind_of(judge_perfect_shape(without_sign(3))), "holds") << "(-1)^4 = 1";
  EXPECT_EQ(kind_of(judge_perfect_shape(without_sign(4))), "not-rising");
  EXPECT_EQ(kind_of(judge_perfect_shape(without_first_knot(3))), "not-rising");
  EXPECT_EQ(kind_of(judge_dual_support(without_first_knot(3), {kUneven}).verdict), "density-vanishes");
  EXPECT_EQ(kind_of(judge_dual_support(perfect_bspline(3), {kUneven}).verdict), "holds");
  EXPECT_EQ(judge_dual_support(perfect_bspline(3), {kUneven, {0, 1, 2, 3, 4}}).met, 1) << "one is uneven";
}

// Positivity by Sturm's theorem in powers of x, where the claim has Bernstein coefficients.
TEST(PerfectBsplineClaim, AgreesWithTheLiteralCode) {
  for (int p = 3; p <= 9; ++p) {
    EXPECT_TRUE(reference::perfect_spline_rises(p)) << p;
    Vector x{0};
    while (x.size() < at(p) + 2) x.push_back(x.back() + ratio(1, static_cast<int>(x.size())));
    EXPECT_TRUE(reference::functional_fills_support(x)) << p;
    EXPECT_EQ(kind_of(judge_dual_support(perfect_bspline(p), {x}).verdict), "holds") << p;
  }
}

TEST(OverlapDualityClaim, HoldsForSeededVectors) {
  const Trial trial = try_overlap_duality(Extent::short_run);
  EXPECT_EQ(trial.verdict.outcome, Outcome::holds);
  EXPECT_GE(trial.met, 4000);
}

// By hand: (0,1,2,3,4) and (0,1,2,5/2,3) do not overlap, and lambda is no delta there (dual_functional_test has the
// number); (0,1,2,3,4) and (1,2,3,4,5) do; (4,...,8) touches in an entry, (9/2,5,...) is disjoint.
TEST(OverlapDualityClaim, JudgesOverlappingPairsAlone) {
  const auto functional = std::make_shared<DualFunctional>(3);
  const Vector x{0, 1, 2, 3, 4};
  const std::vector<VectorPair> pairs{
      {x, {0, 1, 2, ratio(5, 2), 3}}, {x, {1, 2, 3, 4, 5}}, {x, x}, {x, {4, 5, 6, 7, 8}}, {x, {5, 6, 7, 8, 9}}};
  const Trial trial = judge_duality(pairs, lambda_of(functional));
  EXPECT_EQ(trial.verdict.outcome, Outcome::holds);
  EXPECT_EQ(trial.met, 1) << "only one pair is of different vectors that share an interval";
  EXPECT_NE(functional->lambda(pairs[0].x, pairs[0].x_tilde), Rational(0)) << "the hypothesis is needed";
}

// The generator makes every kind of pair.
TEST(OverlapDualityClaim, PairsAreOfEveryKind) {
  Draw draw(3);
  int same = 0, touching = 0, disjoint = 0, shifted = 0, without_overlap = 0;
  for (const auto& [x, y] : random_vector_pairs(draw, 5)) {
    const bool overlapping = vectors_overlap(x, y);
    same += x == y;
    touching += overlapping && (x.back() == y.front() || y.back() == x.front());
    disjoint += x.back() < y.front() || y.back() < x.front();
    shifted += overlapping && x != y && x.front() < y.back() && y.front() < x.back();
    without_overlap += !overlapping;
  }
  for (const int count : {same, touching, disjoint, shifted, without_overlap}) EXPECT_GE(count, 4);
}

/// Both claims on one mesh, against the literal code on the literal mesh.
void compare_on(const Case& content, int& decided) {
  const auto literal_mesh = literal::last_mesh(content);
  const auto space = reference::make_space<Rational>(literal::setting(setting_of(content)), literal_mesh, 1);
  const auto splines = reference::active_splines(space);
  const bool defined = splines && !splines->empty();
  bool dual = true, supported = true;
  for (std::size_t a = 0; defined && a < kDimension; ++a) {
    std::set<Vector> vectors;
    for (const auto& spline : *splines) vectors.insert(spline.vectors[a]);
    dual = dual && reference::overlapping_vectors_are_dual({vectors.begin(), vectors.end()});
    supported = supported && reference::functional_fills_support(*vectors.begin());
  }
  MeshUnderTest mesh(mesh_of(setting_of(content), content.elements));
  const Trial duality = try_on_mesh(*find_claim("overlap-duality"), mesh);
  const Trial perfect = try_on_mesh(*find_claim("perfect-bspline"), mesh);
  const auto expected = [&](bool holds) { return defined ? holds ? "holds" : "violated" : "not-applicable"; };
  EXPECT_STREQ(outcome_name(duality.verdict.outcome), expected(dual));
  EXPECT_STREQ(outcome_name(perfect.verdict.outcome), expected(supported));
  decided += duality.met > 0 && perfect.met > 0;
}

TEST(FunctionalClaims, AgreeWithTheLiteralCodeOnRandomMeshes) {
  Draw draw(17);
  CaseLimits limits;
  limits.max_elements = 150;
  limits.max_cubes = 100;
  int decided = 0;
  for (int round = 0; round < 600 && !testing::Test::HasFailure(); ++round) {
    limits.max_degree = draw.one_in(6) ? 5 : 3;
    const RandomCase random = random_box_case(draw, limits);
    SCOPED_TRACE(std::string(bias_name(random.bias)) + "\n" + write_case(random.content));
    compare_on(random.content, decided);
  }
  EXPECT_GE(decided, 150);
}

}  // namespace

std::vector<NegativeControl> functional_controls() {
  return {
      {"perfect-bspline", "the factor p in the place of p+1", [] { return judge_perfect_shape(with_wrong_factor(5)); }},
      {"perfect-bspline", "the sign (-1)^(p+1) forgotten", [] { return judge_perfect_shape(without_sign(4)); }},
      {"perfect-bspline", "y_0 left out of the divided difference",
       [] { return judge_dual_support(without_first_knot(3), {kUneven}).verdict; }},
      {"overlap-duality", "the index vector of the functional shifted by one entry", run_shifted_duality}};
}

std::vector<Confirmation> functional_confirmations() { return {}; }

}  // namespace asts
