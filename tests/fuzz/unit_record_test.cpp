#include "fuzz/campaign/unit_record.hpp"

#include <gtest/gtest.h>

#include "fuzz/campaign/unit_work.hpp"
#include "lib/exact/errors.hpp"

namespace asts::testing {
namespace {

CampaignPlan plan_of(std::initializer_list<const char*> ids) {
  CampaignPlan plan;
  for (const char* id : ids) plan.claims.push_back(find_claim(id));
  return plan;
}

UnitRecord work_on(const CampaignPlan& plan, std::int64_t unit, std::int64_t cases,
                   const std::vector<Skip>& skipped = {}) {
  UnitWork work(plan, unit, cases, skipped, {[](std::int64_t, std::int64_t) {}, [](const Claim&) {}});
  const std::vector<std::uint64_t> meshes = work.meshes();
  UnitRecord record = work.try_fresh(std::vector<bool>(meshes.size(), true));
  record.fresh = meshes;
  return record;
}

// Law: reading what was written gives the record.
TEST(UnitRecord, IsReadAsItWasWritten) {
  const CampaignPlan plan = plan_of({"as-implies-dc", "child-distance", "lambda-sums"});
  UnitRecord record = work_on(plan, 0, 64);
  record.deaths.push_back({"child-distance", "crash", 17, 2, "signal 11 (\"x\")\n"});
  record.deaths.push_back({"", "memory", std::nullopt, -1, ""});
  ASSERT_FALSE(record.violations.empty());
  const std::string text = unit_json(record);
  const UnitRecord back = unit_from_json(text);
  EXPECT_EQ(back.violations, record.violations);
  EXPECT_EQ(back.deaths, record.deaths);
  EXPECT_EQ(back.fresh, record.fresh);
  EXPECT_EQ(back.generated, record.generated);
  EXPECT_EQ(unit_json(back), text);
}

TEST(UnitRecord, RefusesWhatIsNone) {
  const std::string text = unit_json({});
  EXPECT_EQ(unit_from_json(text).unit, 0);
  const auto with = [&](const std::string& old, const std::string& other) {
    std::string changed = text;
    changed.replace(changed.find(old), old.size(), other);
    return changed;
  };
  EXPECT_THROW(unit_from_json("{}"), InputError);
  EXPECT_THROW(unit_from_json("none"), InputError);
  EXPECT_THROW(unit_from_json(with("\"fresh\":\"\"", "\"fresh\":\"12\"")), InputError);
  EXPECT_THROW(unit_from_json(with("\"fresh\":\"\"", "\"fresh\":\"000000000000000g\"")), InputError);
  EXPECT_THROW(unit_from_json(with("\"generated\":{}", "\"generated\":{\"level\":{\"one\":1}}")), InputError);
}

TEST(UnitWork, TriesEachMeshOnce) {
  const CampaignPlan plan = plan_of({"as-implies-dc"});
  UnitWork work(plan, 0, 64, {}, {[](std::int64_t, std::int64_t) {}, [](const Claim&) {}});
  const std::size_t meshes = work.meshes().size();
  std::vector<bool> fresh(meshes, true);
  fresh[0] = fresh[5] = false;
  const UnitRecord record = work.try_fresh(fresh);
  EXPECT_EQ(record.cases, 64);
  EXPECT_GT(record.meshes, static_cast<std::int64_t>(meshes));
  EXPECT_EQ(record.generated.at("level").size() > 2, true);
  std::int64_t counted = 0;
  for (const auto& [level, count] : record.generated.at("level")) counted += count;
  EXPECT_EQ(counted, static_cast<std::int64_t>(meshes) - 2);
}

TEST(UnitWork, LeavesOutWhatDidNotComeBack) {
  const CampaignPlan plan = plan_of({"as-implies-dc"});
  const UnitRecord all = work_on(plan, 1, 1000);
  const UnitRecord fewer = work_on(plan, 1, 1000, {{64, ""}, {70, ""}, {3, ""}});
  EXPECT_EQ(all.end, 128);
  EXPECT_EQ(fewer.end, 128);
  EXPECT_EQ(all.cases, 64);
  EXPECT_EQ(fewer.cases, 62);
  const UnitRecord without_claim = work_on(plan, 1, 1000, {{64, "as-implies-dc"}, {70, "lambda-sums"}});
  EXPECT_EQ(without_claim.cases, 64);
  EXPECT_EQ(without_claim.meshes, all.meshes);
  const auto meshes = [](const UnitRecord& record) { return record.records.at("as-implies-dc").meshes; };
  EXPECT_LT(meshes(without_claim), meshes(all));
  EXPECT_EQ(meshes(without_claim), meshes(work_on(plan, 1, 1000, {{64, ""}})));
  EXPECT_EQ(work_on(plan, 1, 70).cases, 6);
  EXPECT_EQ(work_on(plan, 1, 70).end, 70);
}

// dc-implies-as: in every block; distance-bound: in one of 16.
TEST(CampaignCase, EndsBlocksWithCasesDrawnForTheClaims) {
  const CampaignPlan plan = plan_of({"dc-implies-as", "distance-bound", "as-implies-dc"});
  std::map<std::string, std::int64_t> drawn;
  for (std::int64_t number = 0; number < 16 * kBlockCases; ++number) {
    const CampaignCase one = campaign_case(plan, number);
    if (one.only == nullptr) continue;
    ++drawn[one.bias];
    EXPECT_GE(number % kBlockCases, kBlockCases - 7) << number;
    EXPECT_EQ(one.bias, std::string("provoke-") + one.only->id);
    EXPECT_EQ(one.content, campaign_case(plan, number).content);
  }
  EXPECT_EQ(drawn, (std::map<std::string, std::int64_t>{{"provoke-dc-implies-as", 96}, {"provoke-distance-bound", 1}}));
  const std::vector<std::string> biases = campaign_biases(plan);
  EXPECT_EQ(std::count(biases.begin(), biases.end(), "provoke-distance-bound"), 1);
  EXPECT_EQ(std::count(biases.begin(), biases.end(), "provoke-case-table"), 0);
}

TEST(Units, AreNumberedInOneOrder) {
  CampaignPlan plan = plan_of({"as-implies-dc", "figure-slices", "experiment-constant"});
  plan.stored.push_back({"a.case", plan.claims[0], "", {}});
  ASSERT_NE(plan.claims[1]->alone, nullptr);
  ASSERT_NE(plan.claims[2]->alone, nullptr);
  EXPECT_EQ(unit_of(plan, 0).kind, Unit::Kind::alone);
  EXPECT_EQ(unit_of(plan, 0).place, 1U);
  EXPECT_EQ(unit_of(plan, 1).place, 2U);
  EXPECT_EQ(unit_of(plan, 2).kind, Unit::Kind::stored);
  EXPECT_EQ(unit_of(plan, 3).kind, Unit::Kind::block);
  EXPECT_EQ(unit_of(plan, 3).first_case, 0);
  EXPECT_EQ(unit_of(plan, 5).first_case, 128);
  EXPECT_EQ(units_for(plan, 0), 3);
  EXPECT_EQ(units_for(plan, 1), 4);
  EXPECT_EQ(units_for(plan, 64), 4);
  EXPECT_EQ(units_for(plan, 65), 5);
  // without a claim about cases there are none
  EXPECT_EQ(units_for(plan_of({"figure-slices"}), 1000), 1);
}

}  // namespace
}  // namespace asts::testing
