#include "lib/exact/rational.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace asts {
namespace {

std::string reread(std::string_view text) {
  const auto result = parse_rational(text);
  if (const auto* reason = std::get_if<std::string>(&result)) return "rejected: " + *reason;
  return to_string(std::get<Rational>(result));
}

bool rejects(std::string_view text) { return std::holds_alternative<std::string>(parse_rational(text)); }

TEST(ParseRational, ReadsAndWritesTheCanonicalForm) {
  EXPECT_EQ(reread("5/2"), "5/2");
  EXPECT_EQ(reread("3"), "3");
  EXPECT_EQ(reread("-7/4"), "-7/4");
  EXPECT_EQ(reread("2/4"), "1/2");
  EXPECT_EQ(reread("-6/3"), "-2");
  EXPECT_EQ(reread("-0"), "0");
  EXPECT_EQ(reread("0/5"), "0");
}

TEST(ParseRational, TheValueItselfIsInLowestTermsNotOnlyItsText) {
  const auto half = std::get<Rational>(parse_rational("2/4"));
  EXPECT_EQ(numerator(half), 1);
  EXPECT_EQ(denominator(half), 2);
}

TEST(ParseRational, LeadingZerosAreDecimalNotOctal) {
  EXPECT_EQ(reread("010"), "10");
  EXPECT_EQ(reread("-09/012"), "-3/4");
}

TEST(ParseRational, HugeNumbersAreExact) {
  const std::string thousand_nines(1000, '9');
  EXPECT_EQ(reread(thousand_nines), thousand_nines);
  EXPECT_EQ(reread("-" + thousand_nines + "/" + thousand_nines + "0"), "-1/10");
  EXPECT_EQ(reread("9223372036854775808"), "9223372036854775808");  // 2^63
}

TEST(ParseRational, RejectsWhatIsNoFraction) {
  for (const char* text : {"", "-", "+3", "0.5", " 1", "1 ", "1/", "/2", "/", "1/-2", "--1", "1/2/3", "0x10", "1e3",
                           "a", "1\n", "1/ 2", "-/2", "\xD9\xA3"}) {  // the last is an Arabic digit three
    EXPECT_TRUE(rejects(text)) << '"' << text << '"';
  }
  EXPECT_TRUE(rejects(std::string_view("1\0002", 3))) << "a zero byte ends no number";
}

TEST(ParseRational, RejectsAZeroDenominatorAndSaysSo) {
  EXPECT_EQ(reread("1/0"), "rejected: \"1/0\" has a zero denominator");
  EXPECT_EQ(reread("0/000"), "rejected: \"0/000\" has a zero denominator");
}

TEST(ParseRational, ReasonsStayShortOnLongTexts) { EXPECT_LT(reread(std::string(100'000, 'x')).size(), 200U); }

TEST(ToString, CanonicalisesWhatDidNotComeFromTheParser) { EXPECT_EQ(to_string(Rational("2/4")), "1/2"); }

RC_GTEST_PROP(ParseRational, ReadsBackEveryFraction, (int numerator)) {
  const int denominator = *rc::gen::positive<int>();
  const Rational value = Rational(numerator) / Rational(denominator);
  const auto parsed = parse_rational(to_string(value));
  RC_ASSERT(std::get<Rational>(parsed) == value);
  const auto unreduced = parse_rational(std::to_string(numerator) + "/" + std::to_string(denominator));
  RC_ASSERT(boost::multiprecision::denominator(std::get<Rational>(unreduced)) ==
            boost::multiprecision::denominator(value));  // == and printing may hide it
  RC_ASSERT(std::get<Rational>(unreduced) == value);
}

}  // namespace
}  // namespace asts
