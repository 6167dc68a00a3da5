#include "lib/spline/perfect_bspline.hpp"

#include <gtest/gtest.h>

#include "lib/exact/errors.hpp"
#include "lib/spline/dual_functional.hpp"
#include "tests/reference/dual.hpp"

namespace asts {
namespace {

constexpr int kDegrees = 15;

Rational ratio(int a, int b) { return Rational(a, b); }

FieldElement length_of(const PerfectBspline& spline, int piece) {
  const auto j = static_cast<std::size_t>(piece);
  return spline.knots[j + 1] - spline.knots[j];
}

/// The k-th derivative at h.
FieldElement derivative_at(LocalPolynomial polynomial, int k, const FieldElement& h) {
  for (int round = 0; round < k; ++round) {
    for (std::size_t i = 1; i < polynomial.size(); ++i) polynomial[i - 1] = polynomial[i] * Rational(i);
    polynomial.pop_back();
  }
  return value_at(polynomial, h);
}

// p = 1: knots -1, 0, 1; B*_2 is the hat of height 1. Its antiderivative ends in 1/2 and 1.
TEST(PerfectBspline, OfDegreeOneByHand) {
  const PerfectBspline hat = perfect_bspline(1);
  EXPECT_EQ(hat.knots[1], Rational(0));
  EXPECT_EQ(hat.weights, (std::vector<Rational>{ratio(1, 2), -1, ratio(1, 2)}));
  const FieldElement half(hat.field, ratio(1, 2));
  EXPECT_EQ(value_at(perfect_piece(hat, 0), half), ratio(1, 2)) << "B*(-1/2)";
  EXPECT_EQ(value_at(perfect_piece(hat, 1), half), ratio(1, 2)) << "B*(1/2)";
  EXPECT_EQ(value_at(perfect_antiderivative(hat)[1], half), ratio(7, 8)) << "G(1/2)";
}

// p = 2: y = -1, -1/2, 1/2, 1, and (p+1) (-1)^(p+1) = -3: B* is -3 * -2/3 (x+1)^2 = 2 (x+1)^2 on the first piece.
TEST(PerfectBspline, OfDegreeTwoByHand) {
  const PerfectBspline spline = perfect_bspline(2);
  EXPECT_EQ(spline.knots[1], ratio(-1, 2));
  EXPECT_EQ(spline.weights, (std::vector<Rational>{ratio(-2, 3), ratio(4, 3), ratio(-4, 3), ratio(2, 3)}));
  EXPECT_EQ(value_at(perfect_piece(spline, 0), FieldElement(spline.field, ratio(1, 2))), ratio(1, 2)) << "B*(-1/2)";
  EXPECT_EQ(value_at(perfect_piece(spline, 1), FieldElement(spline.field, ratio(1, 2))), Rational(1)) << "B*(0)";
}

TEST(PerfectBspline, Law1WeightsAreReciprocalProducts) {
  for (int p = 1; p <= kDegrees; ++p) {
    const PerfectBspline spline = perfect_bspline(p);
    for (std::size_t j = 0; j < spline.knots.size(); ++j) {
      FieldElement product(spline.field, spline.weights[j]);
      for (std::size_t i = 0; i < spline.knots.size(); ++i) {
        if (i != j) product *= spline.knots[j] - spline.knots[i];
      }
      EXPECT_EQ(product, Rational(1)) << "p = " << p << ", j = " << j;
    }
  }
}

TEST(PerfectBspline, Law2PiecesFitTogether) {
  for (int p = 1; p <= 9; ++p) {
    const PerfectBspline spline = perfect_bspline(p);
    const FieldElement zero(spline.field, Rational(0));
    for (int k = 0; k < p; ++k) {
      for (int piece = 0; piece < spline.pieces(); ++piece) {
        const FieldElement end = derivative_at(perfect_piece(spline, piece), k, length_of(spline, piece));
        const bool last = piece + 1 == spline.pieces();
        EXPECT_EQ(end, last ? zero : derivative_at(perfect_piece(spline, piece + 1), k, zero)) << p << " " << k;
      }
    }
  }
}

TEST(PerfectBspline, Law3TheAntiderivativeIsThatOfTheDualFunctional) {
  for (int p = 1; p <= kDegrees; p += 2) {
    const PerfectBspline spline = perfect_bspline(p);
    DualFunctional functional(p);
    const auto g = perfect_antiderivative(spline);
    EXPECT_TRUE(g.front().front().is_zero()) << "G(-1)";
    for (int i = -7; i <= 7; ++i) {
      const Rational u = ratio(i, 8);
      std::size_t piece = 0;
      while (spline.knots[piece + 1] <= u) ++piece;
      const FieldElement h = FieldElement(spline.field, u) - spline.knots[piece];
      EXPECT_EQ(value_at(g[piece], h), functional.perfect_antiderivative(u)) << p << " " << u;
    }
  }
}

/// The literal code's number as an element of a field of lib: coefficients of powers of g.
FieldElement element(const PerfectBspline& spline, const reference::Number& number) { return {spline.field, number}; }

// The literal pieces come from the divided difference with inverses in the field, in powers of x.
TEST(PerfectBspline, EqualsTheLiteralOne) {
  for (int p = 3; p <= 11; ++p) {
    const PerfectBspline spline = perfect_bspline(p);
    const reference::PerfectSpline& literal = reference::perfect_spline(p);
    for (int piece = 0; piece < spline.pieces(); ++piece) {
      const auto j = static_cast<std::size_t>(piece);
      ASSERT_EQ(spline.knots[j], element(spline, literal.knots[j]));
      for (int i = 0; i <= p; ++i) {  // p + 1 points decide a polynomial of degree p
        const reference::Number h = literal.field.rational(ratio(i, p));
        const reference::Number x = literal.field.add(literal.knots[j], h);
        EXPECT_EQ(value_at(perfect_piece(spline, piece), element(spline, h)),
                  element(spline, reference::value_at(literal.field, literal.pieces[j], x)))
            << p << " " << piece;
      }
    }
  }
}

TEST(PerfectBspline, BernsteinCoefficientsByHand) {
  const PerfectBspline spline = perfect_bspline(3);
  const auto number = [&](const Rational& value) { return FieldElement(spline.field, value); };
  // 1 - 3h + 3h^2 over [0, 2]: 1 - 6s + 12s^2 in s = h/2, Bernstein 1, 1 - 3, 1 - 6 + 12
  const LocalPolynomial polynomial{number(1), number(-3), number(3)};
  EXPECT_EQ(bernstein_coefficients(polynomial, number(2)),
            (std::vector<FieldElement>{number(1), number(-2), number(7)}));
}

// X = (0, 1, 2), p = 1: D^2(G(u) u) = 3u + 2 left and 2 - 3u right of 0.
TEST(PerfectBspline, DensityByHand) {
  const PerfectBspline hat = perfect_bspline(1);
  const auto density = dual_density(hat, std::vector<Rational>{0, 1, 2});
  ASSERT_EQ(density.size(), 2U);
  EXPECT_EQ(value_at(density[0], FieldElement(hat.field, Rational(0))), Rational(-1)) << "at u = -1";
  EXPECT_EQ(value_at(density[0], FieldElement(hat.field, ratio(1, 2))), ratio(1, 2)) << "at u = -1/2";
  EXPECT_EQ(value_at(density[1], FieldElement(hat.field, ratio(1, 2))), ratio(1, 2)) << "at u = 1/2";
  EXPECT_FALSE(is_zero(density[0]));
  EXPECT_TRUE(is_zero(LocalPolynomial{FieldElement(hat.field, Rational(0))}));
}

TEST(PerfectBspline, RefusesWhatHasNoMeaning) {
  EXPECT_THROW(perfect_bspline(0), InputError);
  EXPECT_THROW(dual_density(perfect_bspline(3), std::vector<Rational>{0, 1, 2}), InputError);
}

}  // namespace
}  // namespace asts
