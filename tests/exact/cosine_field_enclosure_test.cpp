#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lib/exact/cosine_field.hpp"

namespace asts {
namespace {

CosineFieldPointer field_of(int n) { return std::make_shared<const CosineField>(n); }

std::string text(const FieldElement& element, int digits = 12) {
  const DecimalEnclosure decimal = enclose_decimal(element, digits);
  return decimal.lower + " " + decimal.upper;
}

std::string text(const Rational& value, int digits = 12) { return text(FieldElement(field_of(4), value), digits); }

/// Reads "-12.5e-3" exactly.
Rational decimal_value(const std::string& decimal) {
  const std::size_t e = decimal.find('e');
  std::string mantissa = decimal.substr(0, e);
  long exponent = e == std::string::npos ? 0 : std::stol(decimal.substr(e + 1));
  const std::size_t point = mantissa.find('.');
  if (point != std::string::npos) {
    exponent -= static_cast<long>(mantissa.size() - point - 1);
    mantissa.erase(point, 1);
  }
  Rational value = std::get<Rational>(parse_rational(mantissa));
  for (; exponent > 0; --exponent) value *= 10;
  for (; exponent < 0; ++exponent) value /= 10;
  return value;
}

TEST(DecimalEnclosure, Law5KnownRoots) {
  const FieldElement root_of_two = cosine(field_of(4), 1, 4) * Rational(2);
  EXPECT_EQ(text(root_of_two), "1.41421356237 1.41421356238");
  EXPECT_EQ(text(-root_of_two), "-1.41421356238 -1.41421356237");
  EXPECT_EQ(text(root_of_two * Rational(1000), 3), "1410 1420");
  EXPECT_EQ(text(root_of_two / Rational(1000), 3), "0.00141 0.00142");
  EXPECT_EQ(text(root_of_two, 1), "1 2");
  EXPECT_EQ(text(root_of_two, 40),
            "1.414213562373095048801688724209698078569 1.41421356237309504880168872420969807857");
  EXPECT_EQ(text(cosine(field_of(5), 1, 5) * Rational(2)), "1.61803398874 1.61803398875") << "the golden ratio";
}

TEST(DecimalEnclosure, Law5ExactDecimalsStayExact) {
  EXPECT_EQ(text(Rational(0)), "0 0");
  EXPECT_EQ(text(Rational(1)), "1 1");
  EXPECT_EQ(text(Rational(1200)), "1200 1200");
  EXPECT_EQ(text(Rational(-1) / 8), "-0.125 -0.125");
  EXPECT_EQ(text(Rational(-1) / 8, 2), "-0.13 -0.12");
  EXPECT_EQ(text(Rational(2) / 3, 4), "0.6666 0.6667");
}

TEST(DecimalEnclosure, Law5RoundingUpMayReachTheNextDecade) {
  EXPECT_EQ(text(Rational(9999) / 1000, 2), "9.9 10");
  EXPECT_EQ(text(Rational(-9999) / 1000, 2), "-10 -9.9");
}

TEST(DecimalEnclosure, TinyAndHugeValuesAreScientific) {
  const CosineFieldPointer field = field_of(4);
  const FieldElement small = cosine(field, 1, 4) * Rational(2) - FieldElement(field, Rational(1));
  EXPECT_EQ(text(power(small, 100), 5), "5.2775e-39 5.2776e-39");
  EXPECT_EQ(text(Rational(Integer("300000000000000000000000"))), "3e23 3e23");
}

RC_GTEST_PROP(DecimalEnclosure, Law5EnclosesTightly, ()) {
  const CosineFieldPointer field = field_of(*rc::gen::inRange(1, 20));
  std::vector<Rational> coefficients(static_cast<std::size_t>(*rc::gen::inRange(0, field->degree() + 1)));
  for (Rational& c : coefficients) c = Rational(*rc::gen::inRange(-50, 51)) / Rational(*rc::gen::inRange(1, 30));
  const FieldElement element = power(FieldElement(field, coefficients), *rc::gen::inRange(0U, 12U));
  const int digits = *rc::gen::inRange(1, 30);
  const DecimalEnclosure decimal = enclose_decimal(element, digits);
  const Rational lower = decimal_value(decimal.lower), upper = decimal_value(decimal.upper);
  RC_ASSERT(element >= lower);
  RC_ASSERT(element <= upper);
  Rational unit = abs(upper) > abs(lower) ? abs(upper) : abs(lower);  // 10^(digits-1) units make the value's decade
  for (int i = 1; i < digits; ++i) unit /= 10;
  RC_ASSERT(upper - lower <= unit);
  RC_ASSERT(element.is_rational() || lower < upper);
}

}  // namespace
}  // namespace asts
