#include "properties/claims/perfect_bspline.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "lib/exact/errors.hpp"
#include "lib/gen/draw.hpp"
#include "lib/spline/axis_factors.hpp"
#include "lib/spline/bspline.hpp"
#include "properties/splines_needed.hpp"

namespace asts {
namespace {

constexpr int kLeastDegree = 3;
constexpr int kGreatestDegree = 15;
constexpr int kGreatestDegreeLong = 31;

using Vector = std::vector<Rational>;

Witness not_one(const PerfectBspline& spline, const FieldElement& integral) {
  return ClaimWitness{"integral-not-one",
                      "the integral of B* over [-1, 1] is not 1",
                      {{"degree", std::int64_t{spline.degree}}, {"integral", integral}}};
}

Witness not_rising(const PerfectBspline& spline, int piece) {
  return ClaimWitness{"not-rising",
                      "B* is not shown to be positive between these neighbouring y_j: a Bernstein coefficient is "
                      "negative, or all are 0",
                      {{"degree", std::int64_t{spline.degree}},
                       {"lower", spline.knots[at(piece)]},
                       {"upper", spline.knots[at(piece) + 1]}}};
}

Witness no_support(const PerfectBspline& spline, const Vector& x, int piece) {
  return ClaimWitness{"density-vanishes",
                      "D^(p+1)(G phi) is 0 between the images of these neighbouring y_j in [x_1, x_(p+2)]",
                      {{"degree", std::int64_t{spline.degree}},
                       {"vector", x},
                       {"lower", spline.knots[at(piece)]},
                       {"upper", spline.knots[at(piece) + 1]}}};
}

bool positive_inside(const PerfectBspline& spline, int piece) {
  const FieldElement length = spline.knots[at(piece) + 1] - spline.knots[at(piece)];
  const auto coefficients = bernstein_coefficients(perfect_piece(spline, piece), length);
  const auto has_sign = [](int wanted) { return [wanted](const FieldElement& c) { return sign(c) == wanted; }; };
  return std::none_of(coefficients.begin(), coefficients.end(), has_sign(-1)) &&
         std::any_of(coefficients.begin(), coefficients.end(), has_sign(1));
}

/// N_X is positive in the middle of each of its pieces.
bool fills_its_support(const Vector& x) {
  for (std::size_t piece = 0; piece + 1 < x.size(); ++piece) {
    const Rational middle = (x[piece] + x[piece + 1]) / 2;
    if (bspline_piece_value<Rational>(x, piece, middle) <= 0) return false;
  }
  return true;
}

bool evenly_spaced(const Vector& x) {
  for (std::size_t i = 2; i < x.size(); ++i) {
    if (x[i] - x[i - 1] != x[1] - x[0]) return false;
  }
  return true;
}

/// Entry i+1 comes steps[i] after entry i.
Vector with_steps(const std::vector<Rational>& steps) {
  Vector x{0};
  for (const Rational& step : steps) x.push_back(x.back() + step);
  return x;
}

std::vector<Vector> sample_vectors(int degree) {
  const int count = degree + 1;
  std::vector<std::vector<Rational>> steps(6);
  Draw draw(static_cast<std::uint64_t>(degree));
  for (int i = 0; i < count; ++i) {
    const int from_end = std::min(i, count - 1 - i);
    steps[0].emplace_back(1);
    steps[1].emplace_back(Integer(1) << i);
    steps[2].emplace_back(Integer(1) << (count - i));
    steps[3].emplace_back(Integer(1) << from_end);
    steps[4].emplace_back(Integer(1) << (count - from_end));
    steps[5].emplace_back(draw.between(1, 1000), draw.between(1, 1000));
  }
  std::vector<Vector> result;
  for (const auto& list : steps) result.push_back(with_steps(list));
  return result;
}

/// The vectors of an axis, each moved and scaled to the interval [0, 1]: lambda_X does not see more of them.
std::vector<Vector> normalised_vectors(MeshUnderTest& mesh, Axis axis) {
  std::set<Vector> result;
  for (std::int32_t id = 0; id < mesh.splines().vectors[at(axis)].size(); ++id) {
    Vector x = vector_coordinates(mesh.mesh(), mesh.splines(), axis, id);
    const Rational first = x.front();
    const Rational length = x.back() - first;
    for (Rational& entry : x) entry = (entry - first) / length;
    result.insert(std::move(x));
  }
  return {result.begin(), result.end()};
}

/// Both parts.
Trial judge(const PerfectBspline& spline, const std::vector<Vector>& vectors) {
  Verdict shape = judge_perfect_shape(spline);
  if (shape.outcome != Outcome::holds) return {std::move(shape)};
  return judge_dual_support(spline, vectors);
}

}  // namespace

Verdict judge_perfect_shape(const PerfectBspline& spline) {
  for (int j = 0; j < spline.pieces(); ++j) {
    if (!positive_inside(spline, j)) return Verdict::violated(not_rising(spline, j));
  }
  const FieldElement last_length = spline.knots.back() - spline.knots[spline.knots.size() - 2];
  const FieldElement integral = value_at(perfect_antiderivative(spline).back(), last_length);
  if (integral != Rational(1)) return Verdict::violated(not_one(spline, integral));
  return Verdict::holds();
}

Trial judge_dual_support(const PerfectBspline& spline, const std::vector<Vector>& vectors) {
  Trial trial;
  for (const Vector& x : vectors) {
    const auto density = dual_density(spline, x);
    const auto gap = std::find_if(density.begin(), density.end(), is_zero);
    if (gap != density.end()) {
      trial.verdict = Verdict::violated(no_support(spline, x, static_cast<int>(gap - density.begin())));
      return trial;
    }
    ensure(fills_its_support(x), "a B-spline is positive inside its support");
    trial.met += evenly_spaced(x) ? 0 : 1;
  }
  return trial;
}

Trial try_perfect_bspline(Extent extent) {
  const int greatest = extent == Extent::short_run ? kGreatestDegree : kGreatestDegreeLong;
  Trial total;
  for (int degree = kLeastDegree; degree <= greatest; ++degree) {
    Trial trial = judge(perfect_bspline(degree), sample_vectors(degree));
    total.met += trial.met;
    if (trial.verdict.outcome != Outcome::holds) return {std::move(trial.verdict), total.met};
  }
  return total;
}

Trial try_perfect_bspline_on(MeshUnderTest& mesh) {
  if (auto verdict = lacks_splines(mesh)) return {*verdict};
  Trial total;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const PerfectBspline spline = perfect_bspline(mesh.mesh().setting.degree[at(axis)]);
    Trial trial = judge(spline, normalised_vectors(mesh, axis));
    total.met += trial.met;
    if (trial.verdict.outcome != Outcome::holds) return {std::move(trial.verdict), total.met};
  }
  return total;
}

}  // namespace asts
