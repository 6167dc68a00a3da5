#include "lib/exact/cube_root_field.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lib/exact/errors.hpp"

namespace asts {
namespace {

Rational small_fraction() { return Rational(*rc::gen::inRange(-20, 21)) / Rational(*rc::gen::inRange(1, 12)); }

CubeRootNumber any_number(int m) { return {m, small_fraction(), small_fraction(), small_fraction()}; }

int any_m() { return *rc::gen::inRange(1, 40); }

CubeRootNumber root(int m) { return {m, 0, 1}; }

TEST(CubeRootNumber, Law1TheCubeOfTheRootIsM) {
  for (int m = 1; m <= 200; ++m) {
    EXPECT_EQ(root(m) * root(m) * root(m), Rational(m)) << m;
    EXPECT_EQ(root(m) * root(m), CubeRootNumber(m, 0, 0, 1)) << m;
  }
}

TEST(CubeRootNumber, Law1QuotientsByHand) {
  const CubeRootNumber one(2, 1);
  EXPECT_EQ(one / (root(2) - Rational(1)), CubeRootNumber(2, 1, 1, 1)) << "(t - 1)(t^2 + t + 1) = t^3 - 1 = 1";
  EXPECT_EQ(one / root(2), CubeRootNumber(2, 0, 0, Rational(1) / 2));
  EXPECT_EQ(CubeRootNumber(3, 1) / (CubeRootNumber(3, 1) - cube_root_power(3, -1)),
            CubeRootNumber(3, Rational(3) / 2, Rational(1) / 2, Rational(1) / 2))
      << "1/(1 - 1/t) = t/(t - 1) = t (t^2 + t + 1)/(m - 1)";
}

RC_GTEST_PROP(CubeRootNumber, Law1FieldIdentities, ()) {
  const int m = any_m();
  const CubeRootNumber x = any_number(m), y = any_number(m), z = any_number(m);
  RC_ASSERT(x * (y + z) == x * y + x * z);
  RC_ASSERT((x * y) * z == x * (y * z));
  RC_ASSERT(x * y == y * x);
  RC_ASSERT(x - x == Rational(0));
  if (sign(x) != 0) RC_ASSERT(x * (y / x) == y);
}

TEST(CubeRootNumber, Law2OrderByHand) {
  EXPECT_GT(root(2), Rational(125) / 100);
  EXPECT_LT(root(2), Rational(126) / 100);
  EXPECT_LT(CubeRootNumber(2, -1, 0, 1), Rational(6) / 10) << "t^2 = 1.5874...";
  EXPECT_GT(CubeRootNumber(2, -1, 0, 1), Rational(58) / 100);
  EXPECT_LT(CubeRootNumber(5, 3, -1, -1), Rational(0)) << "3 - 1.70998 - 2.92402";
  EXPECT_EQ(sign(CubeRootNumber(7, 0)), 0);
}

// t is between two fractions whose difference is as small as wanted: a sign that does not look at the norm.
RC_GTEST_PROP(CubeRootNumber, Law2SignAgreesWithRationalBounds, ()) {
  const int m = any_m();
  const CubeRootNumber x = any_number(m);
  const Rational unit = Rational(Integer("1000000000000000000000000000000"));
  Rational lower = 0, upper = m;  // t^3 = m >= 1: 0 < t <= m
  while ((upper - lower) * unit > 1) {
    const Rational middle = (lower + upper) / 2;
    (middle * middle * middle <= m ? lower : upper) = middle;
  }
  const auto term = [](const Rational& c, const Rational& low, const Rational& high, bool up) {
    return c * ((c.sign() >= 0) == up ? high : low);
  };
  const auto bound = [&](bool up) {
    return Rational(x.a() + term(x.b(), lower, upper, up) + term(x.c(), lower * lower, upper * upper, up));
  };
  if (bound(false) > 0) RC_ASSERT(sign(x) == 1);
  if (bound(true) < 0) RC_ASSERT(sign(x) == -1);
  if (sign(x) == 0) RC_ASSERT(x.a() == 0 && x.b() == 0 && x.c() == 0);
}

RC_GTEST_PROP(CubeRootNumber, Law2OrderGoesWithSumsAndProducts, ()) {
  const int m = any_m();
  const CubeRootNumber x = any_number(m), y = any_number(m), z = any_number(m);
  RC_ASSERT((x < y) == (x + z < y + z));
  if (sign(z) > 0) RC_ASSERT((x < y) == (x * z < y * z));
}

TEST(CubeRootNumber, Law3CubesAreRational) {
  for (int r = 1; r <= 20; ++r) {
    EXPECT_EQ(root(r * r * r), Rational(r));
    EXPECT_EQ(CubeRootNumber(r * r * r, 1, 2, 3), Rational(1 + 2 * r + 3 * r * r));
    EXPECT_EQ(sign(CubeRootNumber(r * r * r, -r, 1)), 0);
  }
  EXPECT_FALSE(root(1332).is_rational());
  EXPECT_TRUE(root(1331).is_rational()) << "11^3";
}

TEST(CubeRootNumber, PowersOfTheRoot) {
  for (const int m : {2, 3, 8, 10}) {
    for (int k = -10; k <= 10; ++k) EXPECT_EQ(cube_root_power(m, k) * root(m), cube_root_power(m, k + 1)) << m;
    EXPECT_EQ(cube_root_power(m, 0), Rational(1));
  }
  EXPECT_EQ(cube_root_power(2, -5), CubeRootNumber(2, 0, Rational(1) / 4)) << "2^(-5/3) = 2^(1/3)/4";
}

std::string enclosure(const CubeRootNumber& x, int digits = 12) {
  const DecimalEnclosure decimal = enclose_decimal(x, digits);
  return decimal.lower + " " + decimal.upper;
}

TEST(CubeRootNumber, Law4Enclosures) {
  EXPECT_EQ(enclosure(root(2)), "1.25992104989 1.2599210499");
  EXPECT_EQ(enclosure(CubeRootNumber(2, 0, -1)), "-1.2599210499 -1.25992104989");
  EXPECT_EQ(enclosure(root(8)), "2 2");
  EXPECT_EQ(enclosure(CubeRootNumber(2, Rational("-1259921049894873"), Rational("1000000000000000")), 5),
            "0.16476 0.16477")
      << "fifteen digits cancel: 2^(1/3) = 1.25992104989487316476...";
}

RC_GTEST_PROP(CubeRootNumber, Law4RationalBounds, ()) {
  const CubeRootNumber x = any_number(any_m());
  const RationalBounds bounds = rational_bounds(x, *rc::gen::inRange(0, 30));
  RC_ASSERT(x >= bounds.lower);
  RC_ASSERT(x <= bounds.upper);
}

TEST(CubeRootNumber, AsText) {
  EXPECT_EQ(to_string(CubeRootNumber(5, Rational(5) / 2, Rational(-1) / 3, 2)), "5/2 - 1/3 5^(1/3) + 2 5^(2/3)");
  EXPECT_EQ(to_string(CubeRootNumber(5, 0, -1)), "-5^(1/3)");
  EXPECT_EQ(to_string(CubeRootNumber(5, 0, 0, 1)), "5^(2/3)");
  EXPECT_EQ(to_string(CubeRootNumber(8, 1, 1, 1)), "7");
  EXPECT_EQ(to_string(CubeRootNumber(5, 0)), "0");
}

TEST(CubeRootNumber, MisuseIsTheCallersFault) {
  EXPECT_THROW(CubeRootNumber(0, 1), InputError);
  EXPECT_THROW(root(2) + root(3), InputError);
  EXPECT_THROW(root(2) / CubeRootNumber(2, 0), InputError);
  EXPECT_THROW(enclose_decimal(root(2), 0), InputError);
  EXPECT_THROW(enclose_decimal(root(2), -20), InputError);
}

}  // namespace
}  // namespace asts
