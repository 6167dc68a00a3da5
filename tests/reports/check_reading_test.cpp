#include "reports/check_reading.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "properties/statement.hpp"
#include "tests/reports/collected_cases.hpp"

namespace asts {
namespace {

using Json = nlohmann::ordered_json;

/// What `asts check --final` writes of a case and one statement.
CheckRecord record_of(const std::string& name, const Case& content, const Statement& statement) {
  CheckRecord record;
  record.case_name = name;
  record.step = static_cast<std::int64_t>(content.steps.size());
  record.mesh = CheckRecord::Figures{82, 3, 2, 2};
  const Trial trial = try_on_case(statement, content);
  if (statement.claim != nullptr) {
    record.claims.push_back({statement.claim, trial});
  } else {
    record.entries.push_back({statement.property, trial.verdict});
  }
  if (trial.verdict.outcome == Outcome::violated) record.mesh_case = write_case(content);
  return record;
}

std::string line_of(const CheckRecord& record) {
  std::string line = check_json(record);
  EXPECT_EQ(line.back(), '\n');
  line.pop_back();
  return line;
}

// The law, on every statement and every kind of witness that the collection and the findings have.
TEST(CheckReading, GivesTheLineBack) {
  std::size_t violated = 0;
  testing::for_each_collected([&](const std::string& name, const Case& content, const Statement& statement) {
    const std::string line = line_of(record_of(name, content, statement));
    EXPECT_EQ(line_of(check_record_from_json(line)), line) << name;
    violated += line.find("\"violated\"") != std::string::npos ? 1 : 0;
  });
  EXPECT_GT(violated, 15U);
}

TEST(CheckReading, GivesWhatCanBeMissing) {
  CheckRecord record;
  record.case_name = "a \"name\".case";
  EXPECT_FALSE(check_record_from_json(line_of(record)).mesh);
  record.mesh = CheckRecord::Figures{5, 4, std::nullopt, 3};
  record.step = 7;
  const CheckRecord read = check_record_from_json(line_of(record));
  EXPECT_EQ(read.case_name, record.case_name);
  EXPECT_EQ(read.step, 7);
  ASSERT_TRUE(read.mesh);
  EXPECT_EQ(read.mesh->elements, 5);
  EXPECT_EQ(read.mesh->new_elements, 4);
  EXPECT_EQ(read.mesh->max_level, std::nullopt);
  EXPECT_EQ(read.mesh->active_nodes, 3);
}

std::string reason(const std::string& line) {
  try {
    static_cast<void>(check_record_from_json(line));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(CheckReading, RefusesWhatIsNoRecord) {
  CheckRecord record;
  record.case_name = "a.case";
  record.mesh = CheckRecord::Figures{5, 4, 1, 3};
  record.entries.push_back({find_property("dual-compatible"), {Outcome::holds, "", std::nullopt}});
  const std::string line = line_of(record);
  ASSERT_EQ(reason(line), "");
  EXPECT_EQ(reason(line.substr(0, line.size() - 1)), "the record is cut off or no JSON");
  EXPECT_EQ(reason(line + " "), "the record has other members than asts check writes");
  EXPECT_EQ(reason("3"), "there is no 'case'");
  const auto with = [&](const char* member, const Json& value) {
    Json json = Json::parse(line);
    json[member] = value;
    return reason(json.dump());
  };
  EXPECT_EQ(with("more", 1), "the record has other members than asts check writes");
  EXPECT_EQ(with("properties", {{"none", {{"verdict", "holds"}}}}), "no property is called 'none'");
  EXPECT_EQ(with("claims", {{"none", {{"verdict", "holds"}}}}), "no claim is called 'none'");
  EXPECT_NE(with("elements", "5"), "");
  EXPECT_NE(with("elements", -5), "");
  EXPECT_NE(with("max_level", 1.5), "");
  EXPECT_NE(with("properties", {{"dual-compatible", {{"verdict", "perhaps"}}}}), "");
}

}  // namespace
}  // namespace asts
