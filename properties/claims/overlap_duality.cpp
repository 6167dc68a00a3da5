#include "properties/claims/overlap_duality.hpp"

#include <algorithm>

#include "lib/exact/errors.hpp"
#include "lib/spline/axis_factors.hpp"
#include "lib/spline/dual_functional.hpp"
#include "properties/splines_needed.hpp"

namespace asts {
namespace {

constexpr int kRounds = 12;
constexpr int kRoundsLong = 400;
constexpr std::uint64_t kSeed = 61;

using Vector = std::vector<Rational>;

bool share_an_interval(const Vector& x, const Vector& x_tilde) {
  return x.front() < x_tilde.back() && x_tilde.front() < x.back();
}

Witness not_delta(const VectorPair& pair, const FieldElement& value) {
  return ClaimWitness{
      "not-delta",
      "the vectors overlap, and lambda_X(N_X~) is not delta",
      {{"x", pair.x}, {"x_tilde", pair.x_tilde}, {"value", value}, {"expected", std::int64_t{pair.x == pair.x_tilde}}}};
}

/// p+2 points of the grid 0, 1/4, ..., (p+6)/4, uneven steps by chance.
Vector grid_vector(Draw& draw, int degree) {
  std::vector<int> points;
  for (int i = 0; i <= degree + 6; ++i) points.push_back(i);
  draw.shuffle(points);
  points.resize(at(degree) + 2);
  std::sort(points.begin(), points.end());
  Vector result;
  for (const int point : points) result.emplace_back(point, 4);
  return result;
}

/// 2p+7 points with steps a/b, so that the first and the last windows are disjoint.
Vector sequence(Draw& draw, int degree) {
  Vector points{Rational(draw.between(-50, 50), 7)};
  while (points.size() < 2 * at(degree) + 7) {
    points.push_back(points.back() + Rational(draw.between(1, 40), draw.between(1, 12)));
  }
  return points;
}

Vector window(const Vector& points, std::size_t first, int degree) {
  const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + degree + 2};
}

/// One inner entry moved half way to the next one.
Vector moved(Draw& draw, Vector x) {
  const std::size_t i = 1 + draw.index(x.size() - 2);
  x[i] = (x[i] + x[i + 1]) / 2;
  return x;
}

}  // namespace

Trial judge_duality(const std::vector<VectorPair>& pairs, const Lambda& lambda) {
  Trial trial;
  for (const VectorPair& pair : pairs) {
    if (!vectors_overlap(pair.x, pair.x_tilde)) continue;
    const bool same = pair.x == pair.x_tilde;
    const FieldElement value = lambda(pair.x, pair.x_tilde);
    if (value != Rational(same ? 1 : 0)) {
      trial.verdict = Verdict::violated(not_delta(pair, value));
      return trial;
    }
    trial.met += !same && share_an_interval(pair.x, pair.x_tilde) ? 1 : 0;
  }
  return trial;
}

std::vector<VectorPair> random_vector_pairs(Draw& draw, int degree) {
  std::vector<VectorPair> result;
  const Vector points = sequence(draw, degree);
  const std::size_t windows = points.size() - at(degree) - 1;
  for (std::size_t i = 0; i < windows; ++i) {
    for (std::size_t j = 0; j < windows; ++j) {
      const Vector x = window(points, i, degree);
      const Vector x_tilde = window(points, j, degree);
      result.push_back({x, x_tilde});
      if (draw.one_in(4)) result.push_back({x, moved(draw, x_tilde)});
    }
  }
  for (int i = 0; i < 40; ++i) result.push_back({grid_vector(draw, degree), grid_vector(draw, degree)});
  return result;
}

Trial try_overlap_duality(Extent extent) {
  const bool brief = extent == Extent::short_run;
  Trial total;
  for (int degree = 3; degree <= (brief ? 9 : 15); degree += 2) {
    DualFunctional functional(degree);
    const Lambda lambda = [&](auto x, auto x_tilde) { return functional.lambda(x, x_tilde); };
    Draw draw(kSeed + static_cast<std::uint64_t>(degree));
    for (int round = 0; round < (brief ? kRounds : kRoundsLong); ++round) {
      Trial trial = judge_duality(random_vector_pairs(draw, degree), lambda);
      total.met += trial.met;
      if (trial.verdict.outcome != Outcome::holds) return {std::move(trial.verdict), total.met};
    }
  }
  return total;
}

Trial try_overlap_duality_on(MeshUnderTest& mesh) {
  if (auto verdict = lacks_splines(mesh)) return {*verdict};
  Trial total;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const std::int32_t count = mesh.splines().vectors[at(axis)].size();
    if (at(count) * at(count) > mesh.pair_budget) throw BudgetExhausted("the pairs of index vectors exceed the budget");
    std::vector<Vector> vectors;
    for (std::int32_t id = 0; id < count; ++id) {
      vectors.push_back(vector_coordinates(mesh.mesh(), mesh.splines(), axis, id));
    }
    DualFunctional functional(mesh.mesh().setting.degree[at(axis)]);
    const Lambda lambda = [&](auto x, auto x_tilde) { return functional.lambda(x, x_tilde); };
    for (const Vector& x : vectors) {
      std::vector<VectorPair> pairs;
      for (const Vector& x_tilde : vectors) pairs.push_back({x, x_tilde});
      Trial trial = judge_duality(pairs, lambda);
      total.met += trial.met;
      if (trial.verdict.outcome != Outcome::holds) return {std::move(trial.verdict), total.met};
    }
  }
  return total;
}

}  // namespace asts
