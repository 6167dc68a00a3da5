#include "tests/reference/dual.hpp"

#include <gtest/gtest.h>

#include "tests/reference/example_meshes.hpp"

namespace asts::reference {
namespace {

using Vector = std::vector<Rational>;

TEST(ReferenceField, MinimalPolynomials) {
  EXPECT_EQ(minimal_polynomial(8), (RationalPolynomial{-2, 0, 1}));         // 2 cos(pi/4) = sqrt 2
  EXPECT_EQ(minimal_polynomial(12), (RationalPolynomial{-3, 0, 1}));        // 2 cos(pi/6) = sqrt 3
  EXPECT_EQ(minimal_polynomial(5), (RationalPolynomial{-1, 1, 1}));         // 2 cos(2 pi/5)
  EXPECT_EQ(minimal_polynomial(16), (RationalPolynomial{2, 0, -4, 0, 1}));  // 2 cos(pi/8) = sqrt(2 + sqrt 2)
}

TEST(ReferenceField, SignsInversesAndEmbeddings) {
  const CosineField& field = CosineField::get(4);  // g = sqrt 2
  EXPECT_EQ(field.sign({-1, 1}), 1);
  EXPECT_EQ(field.sign({over(-141421356, 100000000), 1}), 1);
  EXPECT_EQ(field.sign({over(-141421357, 100000000), 1}), -1);
  EXPECT_EQ(field.sign({0, 0}), 0);
  EXPECT_EQ(field.inverse({1, 1}), (Number{-1, 1}));  // 1/(1 + sqrt 2) = sqrt 2 - 1
  const CosineField& larger = CosineField::get(12);   // 2 cos(pi/12) = (sqrt 6 + sqrt 2)/2
  const Number root2 = field.embed({0, 1}, larger), root3 = CosineField::get(6).embed({0, 1}, larger);
  EXPECT_EQ(larger.multiply(root2, root2), larger.rational(2));
  EXPECT_EQ(larger.multiply(root3, root3), larger.rational(3));
  EXPECT_EQ(larger.scale(over(1, 2), larger.multiply(root2, larger.add(root3, larger.rational(1)))), (Number{0, 1, 0, 0}));
}

TEST(ReferenceDual, PerfectSplineIntegratesToOneAndIsSmooth) {
  for (const int p : {3, 5, 7}) {
    const PerfectSpline& spline = perfect_spline(p);
    ASSERT_EQ(spline.knots.size(), static_cast<std::size_t>(p + 2));
    EXPECT_EQ(spline.knots.front(), spline.field.rational(-1));
    EXPECT_EQ(spline.knots.back(), spline.field.rational(1));
    EXPECT_EQ(value_at(spline.field, spline.antiderivative.back(), spline.knots.back()), spline.field.rational(1));
    EXPECT_TRUE(is_zero(value_at(spline.field, spline.pieces.back(), spline.knots.back())));
    const Number half = value_at(spline.field, spline.antiderivative[static_cast<std::size_t>(p / 2)],
                                 spline.field.rational(0));
    EXPECT_EQ(half, spline.field.rational(over(1, 2)));  // B* is even, the middle piece ends at 0
  }
}

TEST(ReferenceDual, BSplineValues) {
  // The uniform cubic on [0,4]: 1/6, 4/6, 1/6 at its inner knots; its first piece is x^3/6.
  const auto pieces = b_spline({0, 1, 2, 3, 4});
  EXPECT_EQ(pieces[0], (RationalPolynomial{0, 0, 0, over(1, 6)}));
  Rational at2 = 0;
  for (auto c = pieces[1].rbegin(); c != pieces[1].rend(); ++c) at2 = at2 * 2 + *c;
  EXPECT_EQ(at2, over(2, 3));
}

TEST(ReferenceDual, OverlappingVectorsGiveDelta) {
  for (const int p : {3, 5, 7}) {
    Vector knots;  // strictly increasing, not uniform
    for (int i = 0; i < p + 6; ++i) knots.push_back(over(i * i + 3 * i, 2) + over(1, i + 1));
    const auto window = [&](int i) { return Vector(knots.begin() + i, knots.begin() + i + p + 2); };
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const Number value = lambda(window(i), window(j));
        EXPECT_EQ(value, CosineField::get(p + 1).rational(i == j ? 1 : 0)) << p << " " << i << " " << j;
      }
  }
}

// On [0,4] the B-spline of (-4,0,4,8,12) is one cubic: (1 + 3u + 3u^2 - 3u^3)/6 with u = x/4. Integrating by parts
// four times, G being flat at both ends, leaves the cubic's polar form at the inner knots 1, 2, 3:
// u -> 1/2, u^2 -> (2 + 3 + 6)/48 = 11/48, u^3 -> 6/64, so (1 + 3/2 + 11/16 - 9/32)/6 = 31/64.
TEST(ReferenceDual, WithoutKnotsInsideTheValueIsThePolarForm) {
  EXPECT_EQ(lambda({0, 1, 2, 3, 4}, {-4, 0, 4, 8, 12}), (Number{over(31, 64), 0}));
}

// On [0,4] the B-spline of (5/2,4,5,6,7) is (x - 5/2)_+^3 / (3/2 * 5/2 * 7/2). By parts, lambda of (x-k)_+^3 is
// (1-k)(2-k)(3-k) (1 - G(k)) = 3/8 (1 - G(1/4)), the argument 1/4 = (2k - 4)/4. The divided difference has the weights
// 1, -2, 2, -2, 1 and 1 - G(t) = (1-t)^4 - 2 (s-t)^4 for 0 <= t <= s = sqrt(2)/2, so 1 - G(1/4) = 81/256 -
// 2 (113/256 - 9 s/16) = -145/256 + 9 g/16 with g = sqrt 2. Together (-145/256 + 9 g/16)/35.
TEST(ReferenceDual, AKnotInsideGivesAnIrrationalValue) {
  EXPECT_EQ(lambda({0, 1, 2, 3, 4}, {over(5, 2), 4, 5, 6, 7}), (Number{over(-29, 1792), over(9, 560)}));
}

TEST(ReferenceDual, TranslationAndScalingChangeNothing) {
  const Vector x{0, 1, 2, 3, 4}, y{over(3, 2), 2, over(5, 2), 3, 5};
  Vector x2, y2;
  for (const Rational& c : x) x2.push_back(c * over(5, 7) - over(11, 3));
  for (const Rational& c : y) y2.push_back(c * over(5, 7) - over(11, 3));
  const Number value = lambda(x, y);
  EXPECT_FALSE(is_rational(value));
  EXPECT_EQ(lambda(x2, y2), value);
  EXPECT_EQ(lambda_remembered(x2, y2), value);
  EXPECT_EQ(lambda_remembered<Grid>({0, 2, 4, 6, 8}, {3, 4, 5, 6, 10}), value);
}

// Degrees 3, 5, 3: factors sqrt 2, sqrt 3, sqrt 2 in their own fields; the product 2 sqrt 3 in the field of 2 cos(pi/12).
TEST(ReferenceDual, FactorsOfMixedDegreesMeetInOneField) {
  const std::array<int, dimension> degree{3, 5, 3};
  const CosineField& field = common_field(degree);
  EXPECT_EQ(field.n(), 12);
  const Number value = product_of_factors(degree, {Number{0, 1}, Number{0, 1}, Number{0, 1}});
  EXPECT_EQ(value, field.scale(2, CosineField::get(6).embed({0, 1}, field)));
  EXPECT_EQ(field.multiply(value, value), field.rational(12));
  EXPECT_EQ(common_field({3, 5, 7}).n(), 24);
}

TEST(ReferenceDual, NothingRemainsOutsideTheSupport) {
  EXPECT_TRUE(is_zero(lambda({0, 1, 2, 3, 4}, {4, 5, 6, 7, 8})));
  EXPECT_TRUE(is_zero(lambda({0, 1, 2, 3, 4}, {-9, -8, -7, -6, -5})));
}

}  // namespace
}  // namespace asts::reference
