#include "fuzz/campaign/open_units.hpp"

#include <gtest/gtest.h>

namespace asts::testing {
namespace {

using Answers = std::vector<std::pair<std::int64_t, std::vector<bool>>>;

class OpenUnitsTest : public ::testing::Test {
 protected:
  UnitRecord record_of(std::int64_t unit) {
    UnitRecord record;
    record.unit = unit;
    return record;
  }

  CampaignPlan plan_{.version = {}, .claims = {find_claim("as-implies-dc")}, .stored = {}};
  CampaignState state_{plan_};
  OpenUnits units_{plan_, state_, 150};
};

// Whoever is faster: a mesh is new in the first unit that has it.
TEST_F(OpenUnitsTest, TellsWhatIsNewInTheOrderOfTheUnits) {
  EXPECT_EQ(units_.begin(), 0);
  EXPECT_EQ(units_.begin(), 1);
  units_.has_meshes(1, {7, 8});
  EXPECT_EQ(units_.answers(), Answers{});
  units_.has_meshes(0, {6, 7});
  EXPECT_EQ(units_.answers(), (Answers{{0, {true, true}}, {1, {false, true}}}));
}

TEST_F(OpenUnitsTest, AreRecordedInTheirOrder) {
  for (std::int64_t unit = 0; unit < 2; ++unit)
    units_.has_meshes(units_.begin(), {10 + static_cast<std::uint64_t>(unit)});
  units_.answers();
  units_.is_done(1, record_of(1), {});
  EXPECT_FALSE(units_.take_complete());
  units_.is_done(0, record_of(0), {});
  const auto first = units_.take_complete();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->record.unit, 0);
  EXPECT_EQ(first->record.fresh, std::vector<std::uint64_t>{10});
  state_.add_unit(first->record);
  EXPECT_EQ(units_.take_complete()->record.fresh, std::vector<std::uint64_t>{11});
}

// The claim is left out there, and what the unit was told stays.
TEST_F(OpenUnitsTest, AreDoneAgainWithoutAClaimOnACaseThatDied) {
  units_.begin();
  units_.begin();
  units_.has_meshes(0, {1, 2, 3});
  units_.has_meshes(1, {3, 4});
  units_.answers();
  units_.has_died(0, {"as-implies-dc", "crash", 5, 1, "signal 11"});
  EXPECT_EQ(units_.take_again(), 0);
  EXPECT_EQ(units_.take_again(), std::nullopt);
  EXPECT_EQ(units_.order(0).skipped, (std::vector<Skip>{{5, "as-implies-dc"}}));
  units_.has_meshes(0, {1, 3});
  EXPECT_EQ(units_.answers(), (Answers{{0, {true, true}}}));
  units_.is_done(0, record_of(0), {});
  const auto done = units_.take_complete();
  ASSERT_TRUE(done);
  EXPECT_EQ(done->record.deaths.size(), 1U);
  EXPECT_EQ(done->record.fresh, (std::vector<std::uint64_t>{1, 2, 3}));
}

TEST_F(OpenUnitsTest, AreGivenUpWhenNoCaseIsToBlame) {
  for (int unit = 0; unit < 3; ++unit) units_.begin();
  units_.has_meshes(1, {1});
  units_.has_died(0, {"", "crash", std::nullopt, -1, "signal 9"});
  EXPECT_EQ(units_.take_again(), std::nullopt);
  EXPECT_EQ(units_.answers(), (Answers{{1, {true}}}));
  const auto given_up = units_.take_complete();
  ASSERT_TRUE(given_up);
  EXPECT_EQ(given_up->record.cases, 0);
  EXPECT_EQ(given_up->record.end, 64);
  EXPECT_EQ(given_up->record.deaths.size(), 1U);
  // a case that dies although it is left out
  state_.add_unit(given_up->record);
  units_.has_died(2, {"", "crash", 130, -1, ""});
  units_.take_again();
  units_.has_died(2, {"", "crash", 130, -1, ""});
  EXPECT_EQ(units_.take_again(), std::nullopt);
}

}  // namespace
}  // namespace asts::testing
