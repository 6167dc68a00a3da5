#include <algorithm>

#include "tests/reference/claim_witness.hpp"
#include "tests/reference/dual.hpp"
#include "tests/reference/independence_claims.hpp"
#include "tests/reference/suitability.hpp"
#include "tests/reference/validate_kinds.hpp"
#include "tests/reference/witness_elements.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

using Vector = std::vector<Rational>;

/// Degrees whose perfect B-spline the literal code makes in reasonable time.
constexpr std::size_t greatest_degree = 31;

/// A degree of the mesh, or any where there is none.
int read_degree(const ClaimSubject& subject, const json& value) {
  const std::size_t degree = read_count(value, "degree");
  if (degree < 3 || degree > greatest_degree) throw Rejected("degree: not from 3 to 31");
  const std::array<int, dimension>& own = subject.setting().degree;
  if (!subject.is_none() && std::find(own.begin(), own.end(), static_cast<int>(degree)) == own.end())
    throw Rejected("degree: no degree of the mesh");
  return static_cast<int>(degree);
}

/// p+2 strictly increasing numbers.
Vector read_vector(const json& value, const std::string& what) {
  Vector x = read_numbers(value);
  if (x.size() < 5 || x.size() > greatest_degree + 2) throw Rejected(what + ": not p+2 numbers, 3 <= p <= 31");
  for (std::size_t i = 1; i < x.size(); ++i)
    if (x[i] <= x[i - 1]) throw Rejected(what + ": not strictly increasing");
  return x;
}

/// Moved and scaled to the interval [0, 1].
Vector normalised(Vector x) {
  const Rational first = x.front(), length = x.back() - first;
  for (Rational& entry : x) entry = (entry - first) / length;
  return x;
}

/// On a mesh: all of the vectors are index vectors of active nodes along one axis, perhaps moved and scaled.
void require_index_vectors(ClaimSubject& subject, const std::vector<Vector>& vectors, bool scaled) {
  if (subject.is_none()) return;
  check_property_applies(subject.setting(), subject.mesh());
  const auto splines = active_splines(make_space<Rational>(subject.setting(), subject.mesh(), 1));
  if (!splines) throw Rejected("an active node of the mesh has no index vector");
  for (std::size_t a = 0; a < dimension; ++a) {
    const auto known = [&](const Vector& x) {
      return std::any_of(splines->begin(), splines->end(), [&](const ActiveNode<Rational>& node) {
        return node.vectors[a] == x || (scaled && normalised(node.vectors[a]) == normalised(x));
      });
    };
    if (std::all_of(vectors.begin(), vectors.end(), known)) return;
  }
  throw Rejected("the vectors are not index vectors of active nodes along one axis");
}

/// The piece of B* between these neighbouring y_j.
std::size_t read_piece(int degree, const json& lower, const json& upper) {
  const PerfectSpline& spline = perfect_spline(degree);
  const Number from = read_value(lower, spline.field, "lower"), to = read_value(upper, spline.field, "upper");
  for (std::size_t j = 0; j + 1 < spline.knots.size(); ++j)
    if (is_zero(spline.field.subtract(spline.knots[j], from)) &&
        is_zero(spline.field.subtract(spline.knots[j + 1], to)))
      return j;
  throw Rejected("lower and upper are not neighbouring y_j");
}

std::string check_integral(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"degree", "integral"});
  const PerfectSpline& spline = perfect_spline(read_degree(subject, values["degree"]));
  const Number actual = value_at(spline.field, spline.antiderivative.back(), spline.knots.back());
  if (!is_zero(spline.field.subtract(read_value(values["integral"], spline.field, "integral"), actual)))
    throw Rejected("the integral is " + text(spline.field, actual) + ", not as printed");
  if (is_rational(actual) && actual[0] == 1) throw Rejected("the integral is 1");
  return "The integral of B* over [-1, 1] is " + text(spline.field, actual) + ", not 1.";
}

std::string check_not_rising(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"degree", "lower", "upper"});
  const int degree = read_degree(subject, values["degree"]);
  const std::size_t piece = read_piece(degree, values["lower"], values["upper"]);
  if (perfect_piece_is_positive(degree, piece))
    throw Rejected("B* is positive between y_" + std::to_string(piece) + " and its neighbour, by Sturm's theorem");
  return "B* of degree " + std::to_string(degree) + " is not positive between y_" + std::to_string(piece) + " and y_" +
         std::to_string(piece + 1) + ", by Sturm's theorem: G does not rise there, though the claim says so.";
}

std::string check_density(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"degree", "vector", "lower", "upper"});
  const int degree = read_degree(subject, values["degree"]);
  const Vector x = read_vector(values["vector"], "vector");
  require_equal(x.size(), static_cast<std::size_t>(degree) + 2, "the number of entries");
  require_index_vectors(subject, {x}, true);
  const std::size_t piece = read_piece(degree, values["lower"], values["upper"]);
  if (!density_vanishes(x, piece))
    throw Rejected("D^(p+1)(G phi) is not zero between y_" + std::to_string(piece) + " and its neighbour");
  return "For X = " + text(x) + ", D^(p+1)(G phi) is 0 between the images of y_" + std::to_string(piece) + " and y_" +
         std::to_string(piece + 1) + ": the support of lambda_X is less than that of N_X.";
}

std::string check_not_delta(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"x", "x_tilde", "value", "expected"});
  const Vector x = read_vector(values["x"], "x"), other = read_vector(values["x_tilde"], "x_tilde");
  require_equal(other.size(), x.size(), "the number of entries of x_tilde");
  require_index_vectors(subject, {x, other}, false);
  if (!overlap(x, other)) throw Rejected("the vectors do not overlap");
  require_equal(read_count(values["expected"], "expected"), x == other ? 1 : 0, "delta");
  const CosineField& field = CosineField::get(static_cast<int>(x.size()) - 1);
  const Number actual = lambda(x, other);
  if (!is_zero(field.subtract(read_value(values["value"], field, "value"), actual)))
    throw Rejected("lambda_X(N_X~) is " + text(field, actual) + ", not as printed");
  if (is_zero(field.subtract(actual, field.rational(x == other ? 1 : 0))))
    throw Rejected("lambda_X(N_X~) is delta: " + text(field, actual));
  return "X = " + text(x) + " and X~ = " + text(other) + " overlap, and lambda_X(N_X~) = " + text(field, actual) +
         ", not " + (x == other ? "1." : "0.");
}

constexpr ClaimKind kinds[] = {
    {"perfect-bspline", "integral-not-one", "the integral of B* over [-1, 1] is not 1", check_integral},
    {"perfect-bspline", "not-rising",
     "B* is not shown to be positive between these neighbouring y_j: a Bernstein coefficient is negative, or all are 0",
     check_not_rising},
    {"perfect-bspline", "density-vanishes",
     "D^(p+1)(G phi) is 0 between the images of these neighbouring y_j in [x_1, x_(p+2)]", check_density},
    {"overlap-duality", "not-delta", "the vectors overlap, and lambda_X(N_X~) is not delta", check_not_delta},
};

}  // namespace

std::span<const ClaimKind> functional_kinds() { return kinds; }

}  // namespace asts::reference
