#include "lib/exact/compact_rational.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <limits>

namespace asts {
namespace {

const Integer kBorder = Integer(1) << 63;

Rational fraction(const Integer& numerator, const Integer& denominator) {
  return Rational(numerator) / Rational(denominator);
}

/// Whether parse_compact and parse_rational give equal values, or equal reasons, for the text.
bool agree(const std::string& text) {
  const auto compact = parse_compact(text);
  const auto wide = parse_rational(text);
  if (compact.index() != wide.index()) return false;
  if (compact.index() == 1) return std::get<1>(compact) == std::get<1>(wide);
  return std::get<0>(compact).value() == std::get<0>(wide) &&
         std::get<0>(compact) == CompactRational(std::get<0>(wide));
}

TEST(CompactRational, TakesThirtyTwoBytes) { EXPECT_EQ(sizeof(CompactRational), 32U); }

TEST(CompactRational, Law1RoundTripOnBothSidesOfTheBorder) {
  for (const Integer& n :
       {Integer(0), Integer(-7), Integer(kBorder - 1), kBorder, Integer(-kBorder), Integer(-kBorder - 1)}) {
    for (const Integer& d : {Integer(1), Integer(10), Integer(kBorder - 1), kBorder}) {
      EXPECT_EQ(CompactRational(fraction(n, d)).value(), fraction(n, d)) << n << "/" << d;
    }
  }
}

TEST(CompactRational, Law2SmallExactlyWhenBothPartsFit) {
  EXPECT_TRUE(CompactRational(Rational(kBorder - 1)).is_small());
  EXPECT_FALSE(CompactRational(Rational(kBorder)).is_small());
  EXPECT_TRUE(CompactRational(Rational(-kBorder)).is_small()) << "-2^63 fits into 64 bits";
  EXPECT_FALSE(CompactRational(Rational(-kBorder - 1)).is_small());
  EXPECT_TRUE(CompactRational(fraction(1, kBorder - 1)).is_small());
  EXPECT_FALSE(CompactRational(fraction(1, kBorder)).is_small());
  EXPECT_EQ(CompactRational(std::numeric_limits<std::int64_t>::min()), CompactRational(Rational(-kBorder)));
}

TEST(CompactRational, Law2OneFormANumber) {
  EXPECT_EQ(CompactRational(Rational("2/4")), CompactRational::lowest_terms(1, 2)) << "not canonical on the way in";
  EXPECT_EQ(CompactRational(fraction(kBorder * 3, kBorder * 6)), CompactRational::lowest_terms(1, 2));
  EXPECT_EQ(CompactRational(fraction(1, kBorder)), CompactRational(fraction(2, 2 * kBorder)));
  EXPECT_NE(CompactRational(fraction(1, kBorder)), CompactRational(fraction(-1, kBorder)));
  EXPECT_NE(CompactRational(1), CompactRational::lowest_terms(1, 2));
}

TEST(ParseCompact, ValuesByHand) {
  const auto parsed = [](std::string_view text) { return std::get<CompactRational>(parse_compact(text)); };
  EXPECT_EQ(parsed("6/4"), CompactRational::lowest_terms(3, 2));
  EXPECT_EQ(parsed("-6/9"), CompactRational::lowest_terms(-2, 3));
  EXPECT_EQ(parsed("0/8"), CompactRational(0));
  EXPECT_EQ(parsed("-0"), CompactRational(0));
  EXPECT_EQ(parsed("999999999999999999/1"), CompactRational(999'999'999'999'999'999));
}

TEST(ParseCompact, AgreesOnTextsAroundTheFastPathsEnds) {
  const std::string eighteen(18, '9'), nineteen(19, '9'), forty(40, '9');
  const std::string zeros(30, '0');
  for (const std::string& above : {std::string("0"), eighteen, nineteen, forty, zeros + "5", std::string("")}) {
    for (const std::string& below :
         {std::string("1"), eighteen, nineteen, forty, zeros, zeros + "15", std::string("")}) {
      for (const char* sign : {"", "-", "+"}) {
        EXPECT_TRUE(agree(sign + above)) << sign << above;
        EXPECT_TRUE(agree(sign + above + "/" + below)) << sign << above << "/" << below;
      }
    }
  }
  EXPECT_TRUE(agree(std::string("1\0", 2)));
}

/// Texts over the grammar's own letters and a few strangers.
RC_GTEST_PROP(ParseCompact, AgreesWithParseRationalOnEveryText, ()) {
  const auto letter = rc::gen::weightedElement<char>({{30, '0'},
                                                      {30, '1'},
                                                      {30, '6'},
                                                      {30, '9'},
                                                      {25, '/'},
                                                      {6, '-'},
                                                      {1, '+'},
                                                      {1, '.'},
                                                      {1, ' '},
                                                      {1, '\0'},
                                                      {1, '\xFF'},
                                                      {1, 'e'}});
  RC_ASSERT(agree(*rc::gen::container<std::string>(letter)));
}

RC_GTEST_PROP(ParseCompact, AgreesWithParseRationalOnFractions, (std::int64_t above, std::int64_t below)) {
  const auto shift_above = *rc::gen::inRange(0, 64);
  const auto shift_below = *rc::gen::inRange(0, 64);
  RC_ASSERT(agree(std::to_string(above >> shift_above) + "/" + std::to_string(below >> shift_below)));
}

}  // namespace
}  // namespace asts
