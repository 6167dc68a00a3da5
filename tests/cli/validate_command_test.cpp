#include <gtest/gtest.h>

#include <set>

#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

using nlohmann::ordered_json;
using Names = std::vector<std::string>;

const std::string kBadMesh = case_path("planar/published-bad-tmesh.case");

/// Cases of bare subdivisions that are not admissible, and violate more than that.
const Names kBareCases{
    "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 6 6 6\nsubdivide 2 2 2\nsubdivide 2 2 2\nsubdivide 2 2 2\n"
    "subdivide 2 2 2  5/2 5/2 5/2\nsubdivide 2 2 2\n",
    "asts-case 1\ndegree 3 5 3\ngrading 3\ndomain 6 8 7\nsubdivide 3 4 3\nsubdivide 3 4 3\nsubdivide 3 4 3  2 3 2\n"
    "subdivide 2 3 2\n",
    "asts-case 1\ndegree 5 3 3\ngrading 2\ndomain 8 6 6\nsubdivide 3 3 3  4 2 2\nsubdivide 3 3 3  4 2 2\nsubdivide 3 3 "
    "3\n",
};

/// The records of all example cases and of the bare ones, one a line.
std::string all_records(const TemporaryFolder& folder) {
  Names arguments{"check", "--format", "json"};
  for (const std::string& path : all_case_paths()) arguments.push_back(path);
  for (std::size_t i = 0; i < kBareCases.size(); ++i) {
    arguments.push_back(folder.write("bare" + std::to_string(i) + ".case", kBareCases[i]));
  }
  return run(arguments).out;
}

TEST(ValidateCommand, FindsEveryWitnessOfEveryCaseValid) {
  const TemporaryFolder folder;
  const std::string file = folder.write("records", all_records(folder));
  std::set<std::string> kinds;
  std::size_t witnesses = 0;
  for (const auto& record : records_of(content_of(file))) {
    for (const auto& [id, entry] : record["properties"].items()) {
      if (entry["verdict"] != "violated") continue;
      ++witnesses;
      kinds.insert(entry["witness"]["kind"].get<std::string>());
    }
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"coarser-in-patch", "lambda-not-delta", "no-partial-overlap", "outside-class",
                                          "perturbed-regions-meet"}));
  const Outcome outcome = run({"validate", "--format", "json", file});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto findings = records_of(outcome.out);
  EXPECT_EQ(findings.size(), witnesses);
  for (const auto& finding : findings) {
    EXPECT_EQ(keys_of(finding), (Names{"file", "line", "property", "valid", "report"}));
    EXPECT_EQ(finding["valid"], true) << finding.dump();
  }
  const Names text = lines_of(run({"validate", file}).out);
  EXPECT_EQ(text.back(), std::to_string(witnesses) + " of " + std::to_string(witnesses) + " witnesses are valid");
}

TEST(ValidateCommand, OpensTheCaseOfARecordWithoutMesh) {
  const TemporaryFolder folder;
  std::filesystem::copy(kBadMesh, folder.path("bad.case"));
  ordered_json record = records_of(run({"check", "--format", "json", "bad.case"}, {}, folder.path("")).out)[0];
  record.erase("mesh");
  const std::string file = folder.write("records", record.dump());
  EXPECT_EQ(run({"validate", file}, {}, "/").exit_code, 0) << "beside the file";
  EXPECT_EQ(run({"validate", "records"}, {}, folder.path("")).exit_code, 0) << "in the working folder";
  std::filesystem::remove(folder.path("bad.case"));
  EXPECT_EQ(run({"validate", file}).exit_code, 2);
}

// A sequence of 6 * 10^7 elements is decided, and its witness too, without its mesh; one of 186805 elements with it.
TEST(ValidateCommand, DecidesWitnessesAboutLongSequences) {
  const TemporaryFolder folder;
  const std::string findings = std::string(ASTS_CASES) + "/../../reports/findings/";
  for (const std::string id : {"lambda-sums", "experiment-constant"}) {
    const Outcome checked = run({"check", "--final", "--format", "json", "--claim", id, findings + id + ".case"});
    EXPECT_EQ(checked.exit_code, 1) << checked.err;
    ordered_json record = records_of(checked.out).at(0);
    EXPECT_EQ(record.contains("elements"), id != "lambda-sums");
    const std::string file = folder.write(id, checked.out);
    EXPECT_EQ(run({"validate", file}).exit_code, 0) << id;
  }
}

TEST(ValidateCommand, KnowsItsOwnVersionOfTheFormAlone) {
  const TemporaryFolder folder;
  ordered_json record = records_of(run({"check", "--format", "json", kBadMesh}).out)[0];
  EXPECT_EQ(record["witness_format"], 1);
  record["witness_format"] = 2;
  const Outcome other = run({"validate", folder.write("other", record.dump())});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("witness_format is 2, and only 1 is known"), std::string::npos) << other.err;
  record.erase("witness_format");
  EXPECT_EQ(run({"validate", folder.write("none", record.dump())}).exit_code, 0);
}

struct Corruption {
  const char* pointer;  ///< into the record
  const char* value;    ///< JSON; empty: the key is removed
};

/// One line: test discovery reads it.
void PrintTo(const Corruption& corruption, std::ostream* out) { *out << corruption.pointer << corruption.value; }

class CorruptedRecord : public ::testing::TestWithParam<Corruption> {};

// What the record says is under /properties/dual-compatible/witness and so on; see the case's own hand calculation.
#define WITNESS(property) "/properties/" property "/witness"
const Corruption kCorruptions[] = {
    {"/elements", "404"},
    {"/step", "1"},
    {WITNESS("admissible"), ""},
    {WITNESS("admissible"), "[]"},
    {WITNESS("admissible") "/kind", "\"coarser-in-patch\""},
    {WITNESS("admissible") "/kind", ""},
    {WITNESS("admissible") "/element/upper/1", "\"4\""},
    {WITNESS("admissible") "/element/upper/1", "\"7/0\""},
    {WITNESS("admissible") "/element/upper/1", "3.5"},
    {WITNESS("admissible") "/element/level", "2"},
    {WITNESS("admissible") "/element", "{\"lower\":[\"7\",\"8\",\"4\"],\"upper\":[\"8\",\"9\",\"5\"],\"level\":0}"},
    {WITNESS("admissible") "/more", "1"},
    {WITNESS("analysis-suitable") "/kind", "\"no-partial-overlap\""},
    {WITNESS("analysis-suitable") "/point/0", "\"4\""},
    {WITNESS("analysis-suitable") "/point/2", "\"9/2\""},
    {WITNESS("analysis-suitable") "/point/2", ""},
    {WITNESS("analysis-suitable") "/first/axis", "\"y\""},
    {WITNESS("analysis-suitable") "/first/axis", "\"t\""},
    {WITNESS("analysis-suitable") "/first/slice", "\"3\""},
    {WITNESS("analysis-suitable") "/first/slice", "\"14/4\""},
    {WITNESS("analysis-suitable") "/first/in/node/1", "\"3/2\""},
    {WITNESS("analysis-suitable") "/first/in/index_vectors/x/0", "\"1/2\""},
    {WITNESS("analysis-suitable") "/second/out/support/upper/2", "\"5\""},
    {WITNESS("analysis-suitable") "/second/out", ""},
    {WITNESS("dual-compatible") "/axes/0/coordinate", "\"5\""},
    {WITNESS("dual-compatible") "/axes/0/in", "\"w\""},
    {WITNESS("dual-compatible") "/axes/0/axis", "\"z\""},
    {WITNESS("dual-compatible") "/axes/1", ""},
    {WITNESS("dual-compatible") "/axes", "[]"},
    {WITNESS("dual-compatible") "/v/index_vectors/x/4", "\"4\""},
    {WITNESS("dual-compatible") "/w/node/2", "\"1\""},
    {WITNESS("dual-basis") "/value", "\"1/37\""},
    {WITNESS("dual-basis") "/expected", "\"1\""},
    {WITNESS("dual-basis") "/factors/0", "\"1/7\""},
    {WITNESS("dual-basis") "/factors/2", ""},
    {WITNESS("dual-basis") "/failures", "33"},
    {WITNESS("dual-basis") "/pairs", "3821"},
    {WITNESS("dual-basis") "/w/index_vectors/y/1", "\"7/2\""},
};
#undef WITNESS

INSTANTIATE_TEST_SUITE_P(Corruptions, CorruptedRecord, ::testing::ValuesIn(kCorruptions));

void corrupt(ordered_json& record, const Corruption& corruption) {
  const ordered_json::json_pointer pointer(corruption.pointer);
  if (*corruption.value != '\0') {
    record[pointer] = ordered_json::parse(corruption.value);
    return;
  }
  ordered_json& parent = record[pointer.parent_pointer()];
  if (parent.is_array()) {
    parent.erase(std::stoul(pointer.back()));
  } else {
    parent.erase(pointer.back());
  }
}

TEST_P(CorruptedRecord, IsNotValid) {
  const TemporaryFolder folder;
  ordered_json record = records_of(run({"check", "--format", "json", kBadMesh}).out)[0];
  const ordered_json before = record;
  corrupt(record, GetParam());
  ASSERT_NE(record, before);
  const Outcome outcome = run({"validate", folder.write("records", record.dump())});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.out.find("NOT VALID"), std::string::npos);
}

// A record's step is the mesh's number in its case; an earlier mesh is another mesh.
TEST(ValidateCommand, RejectsARecordWithAnotherStep) {
  const TemporaryFolder folder;
  ordered_json record = records_of(run({"check", "--final", "--format", "json", "-"}, kBareCases[0]).out)[0];
  ASSERT_EQ(record["step"], 5);
  for (const char* step : {"4", "6", "-1", "\"5\"", "5.0"}) {
    record["step"] = ordered_json::parse(step);
    EXPECT_EQ(run({"validate", folder.write("records", record.dump())}).exit_code, 1) << step;
  }
}

// The witnesses are true of the mesh that the record carries, not of another one.
TEST(ValidateCommand, RejectsAWitnessOfAnotherMesh) {
  const TemporaryFolder folder;
  ordered_json record = records_of(run({"check", "--format", "json", kBadMesh}).out)[0];
  const std::string other = case_path("planar/published-good-tmesh.case");
  record["mesh"] = content_of(other);
  record["elements"] =
      records_of(run({"check", "--property", "admissible", "--format", "json", other}).out)[0]["elements"];
  const auto findings = records_of(run({"validate", "--format", "json", folder.write("records", record.dump())}).out);
  ASSERT_EQ(findings.size(), 4U);
  for (const auto& finding : findings) {
    // the one box that both meshes have refutes both
    EXPECT_EQ(finding["valid"], finding["property"] == "admissible") << finding.dump();
  }
}

TEST(ValidateCommand, RejectsFilesThatAreNoRecords) {
  const TemporaryFolder folder;
  const std::string good = "{\"case\":\"a\",\"step\":0,\"elements\":8,\"properties\":{}}\n";
  const std::pair<const char*, std::string> files[] = {
      {"empty", ""},
      {"blank", " \n\n"},
      {"malformed", "{\"properties\":"},
      {"malformed-later", good + "{]\n"},
      {"binary", std::string("\0\1\2", 3)},
      {"array", "[1]\n"},
      {"no-properties", "{\"case\":\"a\"}\n"},
      {"properties-a-number", "{\"properties\":1}\n"},
      {"verdict-missing", "{\"properties\":{\"admissible\":{}}}\n"},
      {"verdict-unknown", "{\"properties\":{\"admissible\":{\"verdict\":\"violate\"}}}\n"},
      {"case-missing", "{\"properties\":{\"admissible\":{\"verdict\":\"violated\",\"witness\":{}}}}\n"},
      {"mesh-no-case", "{\"mesh\":\"x\",\"properties\":{\"admissible\":{\"verdict\":\"violated\",\"witness\":{}}}}\n"},
  };
  for (const auto& [name, content] : files) {
    const Outcome outcome = run({"validate", folder.write(name, content)});
    EXPECT_EQ(outcome.exit_code, 2) << name;
    EXPECT_EQ(outcome.out, "") << name;
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("asts: " + folder.path(name) + ":")) << outcome.err;
  }
  for (const std::string& path : {folder.path("missing"), folder.path("")}) {
    const Outcome outcome = run({"validate", path});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
  }
}

TEST(ValidateCommand, HasNothingToSayAboutRecordsThatHold) {
  const TemporaryFolder folder;
  const std::string records = run({"check", "--format", "json", case_path("paper/example-2.10-m16.case")}).out;
  const Outcome outcome = run({"validate", folder.write("records", records)});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "0 of 0 witnesses are valid\n");
}

}  // namespace
}  // namespace asts::testing
