#include "tests/reference/witness_json.hpp"

#include <gtest/gtest.h>

#include "tests/reference/example_meshes.hpp"

namespace asts::reference {
namespace {

// Enclosures of small values come with an exponent, as in "-6.86e-11": a plain decimal would have as many zeros as the
// mesh is deep.
TEST(ReferenceWitnessText, DecimalsMayHaveAnExponent) {
  EXPECT_EQ(read_decimal("5"), 5);
  EXPECT_EQ(read_decimal("-0.25"), over(-1, 4));
  EXPECT_EQ(read_decimal("1.5e3"), 1500);
  EXPECT_EQ(read_decimal("2e21"), Rational("2000000000000000000000"));
  EXPECT_EQ(read_decimal("-6.25e-2"), over(-1, 16));
}

TEST(ReferenceWitnessText, AnythingElseIsNoDecimal) {
  for (const char* text : {"", "-", "e5", "1e", "1e-", "1e+5", "1e1.5", "1e9999999", "1e05", ".5", "5.", "1/2", "1e5e5",
                           "0x10", "-0", "01"}) {
    EXPECT_THROW(read_decimal(text), Rejected) << text;
  }
}

}  // namespace
}  // namespace asts::reference
