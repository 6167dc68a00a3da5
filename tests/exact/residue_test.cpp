#include "lib/exact/residue.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace asts {
namespace {

Rational small_fraction() { return Rational(*rc::gen::inRange(-2000, 2001), *rc::gen::inRange(1, 1000)); }

Residue any_residue() { return Residue(*rc::gen::arbitrary<std::int64_t>()); }

TEST(Residue, ByHand) {
  EXPECT_EQ(Residue(-1).value(), Residue::kPrime - 1);
  EXPECT_EQ(Residue(2'147'483'648).value(), 1U) << "2^31";
  EXPECT_EQ(residue_of(Rational(1, 2))->value(), 1'073'741'824U) << "2 * 2^30 = 2^31 = 1";
  EXPECT_EQ(residue_of(Rational(-1, 2))->value(), 1'073'741'823U);
  EXPECT_EQ(residue_of(Rational(5, Residue::kPrime)), std::nullopt);
  EXPECT_TRUE(residue_of(Rational(Residue::kPrime, 5))->is_zero());
  EXPECT_THROW(Residue(1) / Residue(static_cast<std::int64_t>(Residue::kPrime)), InputError);
}

RC_GTEST_PROP(Residue, Law1Field, ()) {
  const Residue a = any_residue(), b = any_residue(), c = any_residue();
  RC_ASSERT(a + b == b + a);
  RC_ASSERT((a + b) * c == a * c + b * c);
  RC_ASSERT((a * b) * c == a * (b * c));
  RC_ASSERT((a - b) + b == a);
  RC_PRE(!b.is_zero());
  RC_ASSERT((a / b) * b == a);
}

RC_GTEST_PROP(Residue, Law2Reduction, ()) {
  const Rational a = small_fraction(), b = small_fraction();
  RC_ASSERT(residue_of(a + b) == *residue_of(a) + *residue_of(b));
  RC_ASSERT(residue_of(a * b) == *residue_of(a) * *residue_of(b));
  RC_PRE(b != 0);
  RC_ASSERT(residue_of(a / b) == *residue_of(a) / *residue_of(b));
}

}  // namespace
}  // namespace asts
