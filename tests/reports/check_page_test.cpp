#include "reports/html/check_page.hpp"

#include <gtest/gtest.h>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/case_prefix.hpp"
#include "reports/check_reading.hpp"
#include "tests/reports/html_page.hpp"
#include "tests/reports/record_numbers.hpp"

namespace asts::testing {
namespace {

using Json = nlohmann::ordered_json;
using Lines = std::vector<std::string>;

/// Three cases: a pair of nodes without overlap, violated by two meshes; regions that meet; nothing violated.
class CheckPage : public ::testing::Test {
 protected:
  void SetUp() override {
    run_.version = "test";
    run_.properties = {find_property("dual-compatible"), find_property("analysis-suitable")};
    run_.claims = {find_claim("as-implies-dc"), find_claim("dc-implies-as")};
    add_case("twice", kHead + "4 4 5\nsubdivide 1 1 1\nsubdivide 3/2 1 1\nsubdivide 7/2 7/2 9/2\n");
    add_case("meet", kHead + "5 5 8\nsubdivide 2 2 1  2 2 2  2 2 4\nsubdivide 2 2 1\n");
    add_case("good", kHead + "4 4 4\nrefine 2 2 2\n");
    for (std::size_t i = 0; i < run_.cases.size(); ++i) {
      for (const std::int64_t step : checked_steps(run_.cases[i].content, false)) lines_.push_back(line_of(i, step));
    }
  }

  void add_case(const std::string& name, const std::string& text) {
    run_.cases.push_back({name, "cases/" + name + ".case", parse_case(text, name)});
  }

  std::string line_of(std::size_t place, std::int64_t step) {
    const Case content = case_prefix(run_.cases[place].content, static_cast<std::size_t>(step));
    CheckRecord record;
    record.case_name = run_.cases[place].name;
    record.step = step;
    record.mesh = CheckRecord::Figures{82 + step, 3, 2, 2};
    for (const Property* property : run_.properties) {
      record.entries.push_back({property, try_on_case({nullptr, property}, content).verdict});
    }
    for (const Claim* claim : run_.claims) record.claims.push_back({claim, try_on_case({claim, nullptr}, content)});
    std::string line = check_json(record);
    line.pop_back();
    places_.push_back(place);
    return line;
  }

  std::string page_of(const Lines& lines) const {
    CheckRun run = run_;
    for (std::size_t i = 0; i < lines.size(); ++i) run.meshes.push_back({places_[i], check_record_from_json(lines[i])});
    return check_page(run, "test");
  }

  const std::string kHead = "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain ";
  CheckRun run_;
  Lines lines_;
  std::vector<std::size_t> places_;  ///< the case of each line
};

// The law: whatever number of a record is changed, the page is another one, or the record is refused.
TEST_F(CheckPage, EveryNumberOfARecordIsSeen) {
  const std::string page = page_of(lines_);
  std::size_t tried = 0;
  std::set<std::string> rejected;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Json record = Json::parse(lines_[i]);
    for (const auto& place : numbers_of(record)) {
      Json other = record;
      other[place] = changed_number(record[place]);
      Lines lines = lines_;
      lines[i] = other.dump();
      ++tried;
      try {
        EXPECT_TRUE(page_of(lines) != page) << i << ": " << place.to_string();
      } catch (const InputError&) {
        rejected.insert(place.to_string());
      }
    }
  }
  EXPECT_GT(tried, 300U);
  EXPECT_EQ(rejected, std::set<std::string>{"/witness_format"});
}

TEST_F(CheckPage, ShowsTheFirstMeshAndTheWitnessesOnLaterOnes) {
  const std::string page = page_of(lines_);
  const HtmlPage html(page);
  const auto words = [&](const char* query) {
    std::vector<std::string> found;
    for (const auto& one : html.document().select_nodes(query)) found.emplace_back(one.node().text().get());
    return found;
  };
  EXPECT_EQ(words("//section[@id='findings']/section/h3"),
            (std::vector<std::string>{"dual-compatible: twice", "as-implies-dc: twice", "analysis-suitable: meet",
                                      "dc-implies-as: meet"}));
  EXPECT_EQ(words("//section[@id='finding-1']//summary"),
            (std::vector<std::string>{"The witnesses on the later meshes"}));
  EXPECT_EQ(words("//section[@id='finding-1']//details/p"), (std::vector<std::string>{"After step 3:"}));
  EXPECT_EQ(words("//section[@id='finding-3']//summary"), std::vector<std::string>{});
}

TEST_F(CheckPage, HasAsManyMeshesAsThereAre) {
  EXPECT_NE(page_of(lines_).find("3 cases decided by asts test: 9 meshes."), std::string::npos);
  lines_.resize(1);
  EXPECT_NE(page_of(lines_).find("3 cases decided by asts test: 1 mesh."), std::string::npos);
}

}  // namespace
}  // namespace asts::testing
