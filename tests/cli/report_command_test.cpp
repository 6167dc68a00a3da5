#include <gtest/gtest.h>

#include "tests/cli/run_program.hpp"
#include "tests/reports/html_page.hpp"

namespace asts::testing {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;
using Json = nlohmann::ordered_json;

const std::string kBad = case_path("../../reports/findings/as-implies-dc.case");
const std::string kGood = case_path("paper/refinement-figure.case");

/// Exit code 2, nothing on stdout, one line on stderr.
void expect_rejected(const Names& arguments, const std::string& line) {
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "asts: " + line + "\n");
}

std::string page_of(const TemporaryFolder& folder, const std::string& directory) {
  const std::string out = folder.path("page.html");
  const Outcome outcome = run({"report", directory, "-o", out});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out + outcome.err, "");
  return content_of(out);
}

class CheckOut : public ::testing::Test {
 protected:
  void SetUp() override {
    checked_ = run({"check", kBad, kGood, "--claim", "as-implies-dc", "--property", "dual-compatible", "--property",
                    "admissible", "--out", run_});
  }

  TemporaryFolder folder_;
  std::string run_ = folder_.path("run");
  Outcome checked_;
};

TEST_F(CheckOut, PrintsAsBeforeAndRecordsWhatJsonPrints) {
  Names plain{"check",           kBad,         kGood,       "--claim", "as-implies-dc", "--property",
              "dual-compatible", "--property", "admissible"};
  const Outcome text = run(plain);
  EXPECT_EQ(checked_.exit_code, text.exit_code);
  EXPECT_EQ(checked_.out, text.out);
  plain.insert(plain.end(), {"--format", "json"});
  const Outcome json = run(plain);
  EXPECT_EQ(content_of(run_ + "/records.jsonl"), json.out);
  plain.insert(plain.end(), {"--out", folder_.path("other")});
  EXPECT_EQ(run(plain).out, json.out);
  for (const char* name :
       {"records.jsonl", "check.json", "cases/1-as-implies-dc.case", "cases/2-refinement-figure.case"}) {
    EXPECT_EQ(content_of(run_ + "/" + name), content_of(folder_.path("other/") + name)) << name;
    EXPECT_NE(content_of(run_ + "/" + name), "") << name;
  }
  EXPECT_EQ(run({"validate", run_ + "/records.jsonl"}).exit_code, 0);
}

TEST_F(CheckOut, RefusesAFolderThatIsNotEmpty) {
  const std::string before = content_of(run_ + "/records.jsonl");
  expect_rejected({"check", kGood, "--out", run_}, run_ + ": is not empty");
  EXPECT_EQ(content_of(run_ + "/records.jsonl"), before);
  const std::string file = folder_.write("file", "");
  expect_rejected({"check", kGood, "--out", file}, file + ": cannot be made a folder");
  fs::create_directory(folder_.path("empty"));
  EXPECT_EQ(run({"check", kGood, "--final", "--out", folder_.path("empty")}).exit_code, 0);
}

TEST_F(CheckOut, IsReported) {
  const std::string page = page_of(folder_, run_);
  const HtmlPage html(page);
  for (const char* words : {"as-implies-dc", "Definition 6.4", "no-partial-overlap", "Report of a check",
                            "asts check --property dual-compatible cases/1-as-implies-dc.case",
                            "asts check --property admissible --property dual-compatible --claim as-implies-dc "
                            "cases/1-as-implies-dc.case cases/2-refinement-figure.case"}) {
    EXPECT_NE(page.find(words), std::string::npos) << words;
  }
  EXPECT_EQ(html.document().select_nodes("//figure[@class='mesh-view']").size(), 4U) << "three findings, one mesh";
  EXPECT_EQ(page_of(folder_, run_), page) << "the same bytes";
  fs::rename(run_, folder_.path("moved"));
  EXPECT_EQ(page_of(folder_, folder_.path("moved")), page) << "wherever the directory is";
}

// Change a record and the report changes; what contradicts the cases and options is an error with its line.
TEST_F(CheckOut, EveryNumberOfARecordIsSeenInThePage) {
  const std::string page = page_of(folder_, run_);
  const Names lines = lines_of(content_of(run_ + "/records.jsonl"));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const char* member : {"elements", "new_elements", "max_level", "active_nodes", "step"}) {
      Json record = Json::parse(lines[i]);
      record[member] = record[member].get<int>() + 1000;
      std::string content;
      for (std::size_t j = 0; j < lines.size(); ++j) content += (i == j ? record.dump() : lines[j]) + "\n";
      folder_.write("run/records.jsonl", content);
      if (std::string(member) != "step") {
        EXPECT_NE(page_of(folder_, run_), page) << i << " " << member;
        continue;
      }
      const Outcome outcome = run({"report", run_, "-o", folder_.path("none.html")});
      EXPECT_EQ(outcome.exit_code, 2);
      EXPECT_TRUE(outcome.err.starts_with("asts: " + run_ + "/records.jsonl:" + std::to_string(i + 1) + ": "))
          << outcome.err;
    }
  }
}

TEST_F(CheckOut, SaysWhichRecordIsCutOffOrWrong) {
  const std::string path = run_ + "/records.jsonl";
  const std::string whole = content_of(path);
  const std::string last = std::to_string(lines_of(whole).size());
  const Names report{"report", run_, "-o", folder_.path("none.html")};
  folder_.write("run/records.jsonl", whole.substr(0, whole.size() - 30));
  expect_rejected(report, path + ":" + last + ": the record is cut off");
  folder_.write("run/records.jsonl", whole.substr(0, whole.size() - 30) + "\n");
  expect_rejected(report, path + ":" + last + ": the record is cut off or no JSON");
  folder_.write("run/records.jsonl", whole + "{\"case\":3}\n");
  expect_rejected(report,
                  path + ":" + std::to_string(lines_of(whole).size() + 1) + ": there are more records than meshes");
  folder_.write("run/records.jsonl", "[]\n" + whole);
  expect_rejected(report, path + ":1: there is no 'case'");
  EXPECT_FALSE(fs::exists(folder_.path("none.html")));
}

// An interrupted run is reported, and that it is one.
TEST_F(CheckOut, ReportsWhatIsThere) {
  const std::string whole = content_of(run_ + "/records.jsonl");
  folder_.write("run/records.jsonl", whole.substr(0, whole.find('\n') + 1));
  EXPECT_NE(page_of(folder_, run_).find("did not come to its end"), std::string::npos);
}

TEST_F(CheckOut, RefusesAWrongRunFile) {
  const std::string path = run_ + "/check.json";
  const Names report{"report", run_, "-o", folder_.path("none.html")};
  const std::string whole = content_of(path);
  folder_.write("run/check.json", whole.substr(0, whole.size() / 2));
  EXPECT_EQ(run(report).exit_code, 2);
  folder_.write("run/check.json", "{\"check\":2}");
  expect_rejected(report, path + ": a check of another form");
  folder_.write("run/check.json", whole);
  fs::remove(run_ + "/cases/1-as-implies-dc.case");
  EXPECT_EQ(run(report).exit_code, 2);
}

TEST(ReportCommand, ReportsACampaign) {
  const TemporaryFolder folder;
  const std::string out = folder.path("run");
  EXPECT_EQ(run({"campaign", "--claim", "as-implies-dc", "--cases", "64", "--seed", "7", "--out", out}).exit_code, 1);
  const std::string page = page_of(folder, out);
  const HtmlPage html(page);
  const auto statistics = Json::parse(content_of(out + "/statistics.json"));
  const std::string file = statistics["findings"][0]["file"];
  EXPECT_NE(page.find("asts check --final --claim as-implies-dc " + file), std::string::npos);
  EXPECT_EQ(run({"check", "--final", "--claim", "as-implies-dc", out + "/" + file}).exit_code, 1);
  EXPECT_EQ(page_of(folder, out), page);
  EXPECT_EQ(page.find(folder.path("")), std::string::npos) << "no paths of this machine";
}

TEST(ReportCommand, RefusesWhatIsNoRunDirectory) {
  const TemporaryFolder folder;
  const std::string out = folder.path("a.html");
  expect_rejected({"report", folder.path("none"), "-o", out}, folder.path("none") + ": is no folder");
  expect_rejected({"report", kGood, "-o", out}, kGood + ": is no folder");
  fs::create_directory(folder.path("empty"));
  expect_rejected({"report", folder.path("empty"), "-o", out},
                  folder.path("empty") + ": is no run directory of asts campaign or asts check");
  EXPECT_EQ(run({"report", folder.path("empty")}).exit_code, 2);
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(CheckOut, RefusesAnOutputThatCannotBeWritten) {
  for (const std::string& out : {folder_.path("none/page.html"), run_}) {
    const Outcome outcome = run({"report", run_, "-o", out});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(outcome.err.starts_with("asts: " + out + ": cannot be written")) << outcome.err;
  }
  expect_rejected({"report", run_, "-o", run_ + "/check.json"}, run_ + "/check.json: is a file of the run directory");
  EXPECT_EQ(run({"report", run_, "-o", run_ + "/page.html"}).exit_code, 0);
  EXPECT_EQ(run({"report", run_, "-o", run_ + "/page.html"}).exit_code, 0) << "an old report may be replaced";
}

// What a file is called, and bytes that are no text, get into the page as text.
TEST(ReportCommand, EscapesAHostileName) {
  const TemporaryFolder folder;
  const std::string name = "<script>alert(1)<\\x \x01\xff&amp;\".case";
  fs::copy(kBad, folder.path(name));
  EXPECT_EQ(run({"check", name, "--property", "dual-compatible", "--out", "run"}, "", folder.path("")).exit_code, 1);
  const std::string page = page_of(folder, folder.path("run"));
  const HtmlPage html(page);
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(1)"), std::string::npos);
}

}  // namespace
}  // namespace asts::testing
