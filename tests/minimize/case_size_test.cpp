#include "lib/minimize/case_size.hpp"

#include <gtest/gtest.h>

#include "lib/mesh/case_file.hpp"

namespace asts {
namespace {

// Each figure outweighs all that come after it.
TEST(CaseSize, IsComparedFigureByFigure) {
  const CaseSize base{false, 2, 2, 80, 9, 2, 2};
  const std::vector<CaseSize> larger{
      {false, 2, 2, 80, 9, 2, 3}, {false, 2, 2, 80, 9, 3, 0}, {false, 2, 2, 80, 11, 2, 0}, {false, 2, 2, 81, 9, 2, 0},
      {false, 2, 3, 1, 9, 2, 0},  {false, 3, 0, 1, 9, 2, 0},  {true, 1, 0, 1, 9, 2, 0}};
  for (std::size_t i = 0; i < larger.size(); ++i) {
    EXPECT_LT(base, larger[i]) << i;
    for (std::size_t j = 0; j < i; ++j) EXPECT_LT(larger[j], larger[i]) << j << " " << i;
  }
}

TEST(CaseSize, OfBoxesCountsBoxesAndFractions) {
  const Case boxes = parse_case(
      "asts-case 1\ndegree 3 5 3\ngrading 4\ndomain 2 1 1\nelement 0 0 0  1/3 1 1\nelement 1/3 0 0  2 1/2 1\n"
      "element 1/3 1/2 0  2 1 1\n",
      "test");
  EXPECT_EQ(size_of_boxes(boxes), (CaseSize{true, 3, 0, 2, 11, 4, 2}));
}

Case with_steps(const std::string& steps) {
  return parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 2 2 2\n" + steps, "test");
}

TEST(CaseNumbers, AreComparedAsNumbersInTheirOrder) {
  const std::vector<std::string> ascending{"refine 0 0 0\n",       "subdivide 0 0 0\n",   "subdivide 0 0 0  1 1 1\n",
                                           "subdivide 0 0 1/10\n", "subdivide 0 0 1/2\n", "subdivide 0 1 0\n",
                                           "subdivide 1 0 0\n"};
  for (std::size_t i = 0; i < ascending.size(); ++i) {
    for (std::size_t j = 0; j < ascending.size(); ++j) {
      EXPECT_TRUE(compare_numbers(with_steps(ascending[i]), with_steps(ascending[j])) == (i <=> j)) << i << " " << j;
    }
  }
  Case wider = with_steps("refine 0 0 0\n");
  wider.domain = {3, 1, 1};
  EXPECT_TRUE(compare_numbers(with_steps("subdivide 1 0 0\n"), wider) < 0) << "the domain comes first";
}

}  // namespace
}  // namespace asts
