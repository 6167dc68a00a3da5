#include "lib/exact/cosine_field.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>
#include <set>

#include "lib/exact/errors.hpp"

namespace asts {
namespace {

CosineFieldPointer field_of(int n) { return std::make_shared<const CosineField>(n); }

FieldElement generator(const CosineFieldPointer& field) { return {field, std::vector<Rational>{0, 1}}; }

/// sqrt(2) = 2 cos(pi/4), which the field of every multiple of 4 contains.
FieldElement root_of_two(const CosineFieldPointer& field) { return cosine(field, 1, 4) * Rational(2); }

Rational small_fraction() { return Rational(*rc::gen::inRange(-20, 21)) / Rational(*rc::gen::inRange(1, 12)); }

FieldElement any_element(const CosineFieldPointer& field) {
  std::vector<Rational> coefficients(static_cast<std::size_t>(*rc::gen::inRange(0, field->degree() + 1)));
  for (Rational& c : coefficients) c = small_fraction();
  return {field, coefficients};
}

int any_n() { return *rc::gen::inRange(1, 33); }

TEST(CosineField, DegreeIsHalfOfPhi) {
  for (int n = 2; n <= 64; ++n) {
    int phi = 0;
    for (int k = 1; k <= 2 * n; ++k) phi += std::gcd(k, 2 * n) == 1 ? 1 : 0;
    EXPECT_EQ(field_of(n)->degree(), phi / 2) << n;
    EXPECT_EQ(field_of(n)->minimal_polynomial().size(), static_cast<std::size_t>(phi / 2) + 1) << n;
    EXPECT_EQ(field_of(n)->minimal_polynomial().back(), 1) << "monic, n = " << n;
  }
}

TEST(CosineField, MinimalPolynomialsByHand) {
  using Polynomial = std::vector<Integer>;
  EXPECT_EQ(field_of(1)->minimal_polynomial(), (Polynomial{2, 1})) << "2 cos(pi) = -2";
  EXPECT_EQ(field_of(2)->minimal_polynomial(), (Polynomial{0, 1})) << "2 cos(pi/2) = 0";
  EXPECT_EQ(field_of(3)->minimal_polynomial(), (Polynomial{-1, 1})) << "2 cos(pi/3) = 1";
  EXPECT_EQ(field_of(4)->minimal_polynomial(), (Polynomial{-2, 0, 1})) << "the root of 2";
  EXPECT_EQ(field_of(5)->minimal_polynomial(), (Polynomial{-1, -1, 1})) << "the golden ratio";
  EXPECT_EQ(field_of(6)->minimal_polynomial(), (Polynomial{-3, 0, 1})) << "the root of 3";
  EXPECT_EQ(field_of(8)->minimal_polynomial(), (Polynomial{2, 0, -4, 0, 1})) << "(x^2-2)^2 = 2";
}

TEST(CosineField, Law1GeneratorIsARoot) {
  for (int n = 1; n <= 40; ++n) {
    const CosineFieldPointer field = field_of(n);
    FieldElement value(field, Rational(0));
    for (std::size_t i = 0; i < field->minimal_polynomial().size(); ++i) {
      value += power(generator(field), static_cast<unsigned>(i)) * Rational(field->minimal_polynomial()[i]);
    }
    EXPECT_TRUE(value.is_zero()) << n;
  }
}

RC_GTEST_PROP(CosineField, Law1Arithmetic, ()) {
  const CosineFieldPointer field = field_of(any_n());
  const FieldElement a = any_element(field), b = any_element(field), c = any_element(field);
  const Rational r = small_fraction();
  RC_ASSERT((a * b) * c == a * (b * c));
  RC_ASSERT(a * b == b * a);
  RC_ASSERT((a + b) * c == a * c + b * c);
  RC_ASSERT((a - b) + b == a);
  RC_ASSERT(a * r == a * FieldElement(field, r));
  if (r != 0) RC_ASSERT((a / r) * r == a);
  RC_ASSERT((a - a).is_zero() && (a + -a).is_zero());
  RC_ASSERT(power(a, 5) == a * a * a * a * a);
  RC_ASSERT(power(a, 0) == Rational(1));
}

TEST(CosineField, Law1RationalsAreRecognised) {
  const CosineFieldPointer field = field_of(4);
  EXPECT_TRUE(power(root_of_two(field), 2).is_rational());
  EXPECT_EQ(power(root_of_two(field), 2).to_rational(), 2);
  EXPECT_FALSE(root_of_two(field).is_rational());
  EXPECT_THROW(root_of_two(field).to_rational(), InputError);
  EXPECT_EQ(FieldElement(field, Rational(0)).to_rational(), 0);
  EXPECT_TRUE(generator(field_of(3)).is_rational()) << "g = 1 there";
}

RC_GTEST_PROP(CosineField, Law2Order, ()) {
  const CosineFieldPointer field = field_of(any_n());
  const FieldElement a = any_element(field), b = any_element(field), c = any_element(field);
  RC_ASSERT(sign(a) * sign(b) == sign(a * b));
  RC_ASSERT(((a <=> b) == 0) == (a == b));
  RC_ASSERT((a < b) == (a + c < b + c));
  RC_ASSERT(!(a < b && b < c) || a < c);
  RC_ASSERT(sign(a * a) == (a.is_zero() ? 0 : 1));
}

TEST(CosineField, Law2CosinesDecreaseOnTheHalfCircle) {
  for (int n = 1; n <= 24; ++n) {
    const CosineFieldPointer field = field_of(n);
    for (int k = 0; k < n; ++k) EXPECT_GT(cosine(field, k, n), cosine(field, k + 1, n)) << k << "/" << n;
  }
}

TEST(CosineField, Law2SignsOfTinyElements) {
  const CosineFieldPointer field = field_of(8);
  const FieldElement tiny = root_of_two(field) - FieldElement(field, Rational(1));  // 0.41...
  // (root - 1)^1000 is a + b root with a, b of 383 digits that cancel but for 10^-383.
  EXPECT_EQ(sign(power(tiny, 1000)), 1);
  EXPECT_EQ(sign(-power(tiny, 1001)), -1);
  EXPECT_LT(power(tiny, 1001), power(tiny, 1000));
  // The root of 2 lies between its neighbouring convergents: 665857^2 - 2*470832^2 = 1.
  EXPECT_LT(root_of_two(field), Rational(665857) / Rational(470832));
  EXPECT_GT(root_of_two(field), Rational(941664) / Rational(665857));
  EXPECT_TRUE((power(tiny, 50) * power(root_of_two(field) + FieldElement(field, Rational(1)), 50)) == Rational(1));
}

TEST(CosineField, Law3ValuesByHand) {
  EXPECT_EQ(power(cosine(field_of(4), 1, 4), 2), Rational(1) / 2);
  EXPECT_EQ(power(cosine(field_of(6), 1, 6), 2), Rational(3) / 4);
  EXPECT_EQ(cosine(field_of(15), 1, 3), Rational(1) / 2);
  EXPECT_EQ(cosine(field_of(15), 2, 3), Rational(-1) / 2);
  EXPECT_EQ(cosine(field_of(7), 5, 1), Rational(-1)) << "cos(5 pi)";
  EXPECT_EQ(cosine(field_of(1), -2, 1), Rational(1));
  EXPECT_EQ(cosine(field_of(2), 1, 2), Rational(0));
  EXPECT_EQ(cosine(field_of(5), 1, 5) - cosine(field_of(5), 2, 5), Rational(1) / 2) << "the pentagon's identity";
  const FieldElement heptagon = cosine(field_of(7), 1, 7) * cosine(field_of(7), 2, 7) * cosine(field_of(7), 3, 7);
  EXPECT_EQ(heptagon, Rational(1) / 8);
}

RC_GTEST_PROP(CosineField, Law3AnglesAddUp, ()) {
  const int n = any_n();
  const CosineFieldPointer field = field_of(2 * n);
  const int k = *rc::gen::inRange(-100, 100);
  const FieldElement c = cosine(field, k, 2 * n), s = cosine(field, n - k, 2 * n);  // sin(a) = cos(pi/2 - a)
  RC_ASSERT(c * c + s * s == Rational(1));
  RC_ASSERT(cosine(field, k, n) == c * c * Rational(2) - FieldElement(field, Rational(1)));
  RC_ASSERT(cosine(field, k + 4 * n, 2 * n) == c);
  RC_ASSERT(cosine(field, -k, 2 * n) == c);
}

RC_GTEST_PROP(CosineField, Law4EmbeddingIsAHomomorphismOfOrderedFields, ()) {
  const int n = *rc::gen::inRange(1, 13);
  const CosineFieldPointer field = field_of(n), larger = field_of(n * *rc::gen::inRange(1, 6));
  const FieldElement a = any_element(field), b = any_element(field);
  RC_ASSERT(embed(a * b, larger) == embed(a, larger) * embed(b, larger));
  RC_ASSERT(embed(a + b, larger) == embed(a, larger) + embed(b, larger));
  RC_ASSERT((embed(a, larger) <=> embed(b, larger)) == (a <=> b));
  const int k = *rc::gen::inRange(-30, 30);
  RC_ASSERT(embed(cosine(field, k, n), larger) == cosine(larger, k, n));
}

TEST(CosineField, AHugeFieldCostsNothingWhileItsElementsAreRational) {
  const CosineFieldPointer field = field_of(1'000'002);
  EXPECT_EQ(sign(FieldElement(field, Rational(-2)) * FieldElement(field, Rational(3))), -1);
}

TEST(CosineField, GoesIntoContainers) {
  const CosineFieldPointer field = field_of(4);
  const std::set<FieldElement> ordered{cosine(field, 3, 4), cosine(field, 1, 4), cosine(field, 2, 4),
                                       -cosine(field, 1, 4)};
  EXPECT_EQ(ordered.size(), 3U) << "cos(3pi/4) = -cos(pi/4)";
  EXPECT_EQ(*ordered.begin(), cosine(field, 3, 4));
}

TEST(CosineField, RefusesWhatHasNoMeaning) {
  const CosineFieldPointer four = field_of(4), six = field_of(6);
  EXPECT_THROW(CosineField(0), InputError);
  EXPECT_THROW(cosine(four, 1, 3), InputError) << "3 does not divide 4";
  EXPECT_THROW(cosine(four, 1, 0), InputError);
  EXPECT_THROW(embed(generator(four), six), InputError);
  EXPECT_THROW(generator(four) + generator(six), InputError);
  EXPECT_THROW(generator(four) / Rational(0), InputError);
  EXPECT_THROW(enclose_decimal(generator(four), 0), InputError);
  EXPECT_EQ(generator(field_of(4)) - generator(field_of(4)), Rational(0)) << "two objects for the same field";
}

}  // namespace
}  // namespace asts
