#include "properties/statement.hpp"

#include <gtest/gtest.h>

#include "lib/mesh/case_file.hpp"

namespace asts {
namespace {

const char* const kNotCompatible =
    "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 5\nsubdivide 3/2 3/2 3/2\nsubdivide 7/4 3/2 3/2\n";

std::optional<std::string> violation(const char* id, const std::string& text) {
  return violation_of(find_statement(id).value(), parse_case(text, "test"));
}

TEST(Statement, IsFoundAmongClaimsAndProperties) {
  EXPECT_STREQ(find_statement("as-implies-dc")->id(), "as-implies-dc");
  EXPECT_STREQ(find_statement("dual-basis")->id(), "dual-basis");
  EXPECT_FALSE(find_statement("none"));
  EXPECT_TRUE(find_statement("lambda-sums")->of_sequence());
  EXPECT_FALSE(find_statement("admissible")->of_sequence());
  for (const Property& property : all_properties()) EXPECT_EQ(find_claim(property.id), nullptr);
}

TEST(Statement, IsViolatedByALastMeshInTheWayOfTheWitness) {
  EXPECT_EQ(violation("as-implies-dc", kNotCompatible), "no-partial-overlap");
  EXPECT_EQ(violation("dual-compatible", kNotCompatible), "no-partial-overlap");
  EXPECT_EQ(violation("admissible", kNotCompatible), "coarser-in-patch");
  EXPECT_EQ(violation("analysis-suitable", kNotCompatible), std::nullopt);
  EXPECT_EQ(violation("lambda-sums", kNotCompatible), std::nullopt) << "not applicable: bare subdivisions";
}

TEST(Statement, IsDecidedForExplicitMeshesToo) {
  const std::string thirds =
      "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 1 1 1\nelement 0 0 0  1/3 1 1\nelement 1/3 0 0  1 1 1\n";
  EXPECT_EQ(violation("admissible", thirds), "outside-class");
  EXPECT_EQ(violation("experiment-constant", thirds), std::nullopt);
}

}  // namespace
}  // namespace asts
