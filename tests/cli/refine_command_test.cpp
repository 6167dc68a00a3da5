#include <gtest/gtest.h>

#include "tests/cli/run_program.hpp"

namespace asts::testing {
namespace {

using Names = std::vector<std::string>;

const Names kStepKeys{"step", "marked", "subdivided", "elements", "new_elements"};

struct Example {
  const char* file;
  std::size_t steps;
  int new_elements;
};

/// One line: test discovery reads it.
void PrintTo(const Example& example, std::ostream* out) { *out << example.file; }

class PaperExample : public ::testing::TestWithParam<Example> {};

// The table of Example 2.10: m = 2, 4, 16 need 12, 6, 3 steps and make 10728, 3175, 1030 new elements.
INSTANTIATE_TEST_SUITE_P(Table, PaperExample,
                         ::testing::Values(Example{"paper/example-2.10-m2.case", 12, 10728},
                                           Example{"paper/example-2.10-m4.case", 6, 3175},
                                           Example{"paper/example-2.10-m16.case", 3, 1030}));

TEST_P(PaperExample, HasThePapersCountsInJson) {
  const Outcome outcome = run({"refine", case_path(GetParam().file), "--format", "json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const auto records = records_of(outcome.out);
  ASSERT_EQ(records.size(), GetParam().steps);
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(keys_of(records[i]), kStepKeys);
    EXPECT_EQ(records[i]["step"], i + 1);
    EXPECT_EQ(records[i]["marked"], 1);
  }
  EXPECT_EQ(records.back()["new_elements"], GetParam().new_elements);
}

TEST_P(PaperExample, HasThePapersCountsInText) {
  const Outcome outcome = run({"refine", case_path(GetParam().file)});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  const Names lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), GetParam().steps + 1);
  EXPECT_EQ(lines[0], "  step      marked  subdivided      elements  new elements");
  std::istringstream last(lines.back());
  std::size_t step = 0;
  int marked = 0, subdivided = 0, elements = 0, new_elements = 0;
  last >> step >> marked >> subdivided >> elements >> new_elements;
  EXPECT_EQ(step, GetParam().steps);
  EXPECT_EQ(new_elements, GetParam().new_elements);
}

// What --write writes is the same mesh: admissible as well, with the same counts and the same number of active nodes.
TEST_P(PaperExample, IsTheSameMeshWhenWrittenAndReadAgain) {
  const TemporaryFolder folder;
  const std::string written = folder.path("final.case");
  ASSERT_EQ(run({"refine", case_path(GetParam().file), "--write", written}).exit_code, 0);
  const auto as_steps = records_of(run({"check", "--final", "--format", "json", case_path(GetParam().file)}).out);
  const Outcome outcome = run({"check", "--format", "json", written});
  EXPECT_EQ(outcome.exit_code, 0);
  const auto as_boxes = records_of(outcome.out);
  ASSERT_EQ(as_steps.size(), 1U);
  ASSERT_EQ(as_boxes.size(), 1U);
  for (const char* key : {"elements", "new_elements", "max_level", "active_nodes", "properties"}) {
    EXPECT_EQ(as_boxes[0][key], as_steps[0][key]) << key;
  }
  EXPECT_EQ(as_boxes[0]["step"], 0);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path("")), {}), 1) << "no other file is left";
}

TEST(RefineCommand, WritesAnExplicitMeshAsItIs) {
  const TemporaryFolder folder;
  const std::string source = case_path("planar/published-bad-tmesh.case");
  const Outcome outcome = run({"refine", source, "--write", folder.path("again.case")});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "an explicit mesh of 405 elements, no steps\n");
  const auto lines = [](const std::string& path) {
    Names result;
    for (const std::string& line : lines_of(content_of(path))) {
      if (line.starts_with("element")) result.push_back(line);
    }
    return result;
  };
  EXPECT_EQ(lines(folder.path("again.case")), lines(source));
}

// m = 3, 5 x 5 x 5 cubes, 130 calls at the origin: coordinates are multiples of 3^-44 along an axis, beyond 64 bits.
// The count is the kernel's own; the reference cannot go so deep. It is exact as long as no coordinate wraps.
TEST(RefineCommand, GoesBeyond64Bits) {
  std::string text = "asts-case 1\ndegree 3 3 3\ngrading 3\ndomain 5 5 5\n";
  for (int i = 0; i < 130; ++i) text += "refine 0 0 0\n";
  const auto records = records_of(run({"refine", "-", "--format", "json"}, text).out);
  ASSERT_EQ(records.size(), 130U);
  EXPECT_EQ(records.back()["new_elements"], 208645);
  const Outcome checked = run({"check", "--final", "--format", "json", "-"}, text);
  EXPECT_EQ(checked.exit_code, 0);
  const auto last = records_of(checked.out);
  ASSERT_EQ(last.size(), 1U);
  EXPECT_EQ(last[0]["elements"], 208645);
  EXPECT_EQ(last[0]["max_level"], 130);
}

// Replay is total: a mark on the upper faces names the last element, two marks in one element are one, a step without
// marks does nothing.
TEST(RefineCommand, CountsMarksAsElements) {
  const std::string text = kHeader + "refine 0 0 0  1/2 1/3 1/4\nrefine 4 4 4\nrefine\nsubdivide 2 2 2\n";
  const auto records = records_of(run({"refine", "-", "--format", "json"}, text).out);
  ASSERT_EQ(records.size(), 4U);
  EXPECT_EQ(records[0].dump(), R"({"step":1,"marked":1,"subdivided":1,"elements":65,"new_elements":2})");
  EXPECT_EQ(records[1].dump(), R"({"step":2,"marked":1,"subdivided":1,"elements":66,"new_elements":4})");
  EXPECT_EQ(records[2].dump(), R"({"step":3,"marked":0,"subdivided":0,"elements":66,"new_elements":4})");
  EXPECT_EQ(records[3].dump(), R"({"step":4,"marked":1,"subdivided":1,"elements":67,"new_elements":6})");
}

// 10^6 marks in one line: each of the 64 cubes is named, many times. Every cube is split once.
TEST(RefineCommand, ReadsAMillionMarksInOneLine) {
  std::string text = kHeader + "refine";
  for (int i = 0; i < 1'000'000; ++i) {
    text += " " + std::to_string(i % 4) + " " + std::to_string(i / 4 % 4) + " " + std::to_string(i / 16 % 4);
  }
  const Outcome outcome = run({"refine", "-", "--format", "json"}, text + "\n");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, R"({"step":1,"marked":64,"subdivided":64,"elements":128,"new_elements":128})"
                         "\n");
}

TEST(RefineCommand, SaysBeforeTheWorkThatAFileCannotBeWritten) {
  const TemporaryFolder folder;
  for (const std::string& path : {folder.path(""), folder.path("none/file.case")}) {
    const Outcome outcome = run({"refine", "-", "--write", path}, kHeader + "refine 0 0 0\n");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  }
}

TEST(RefineCommand, WritesToADeviceWithoutReplacingIt) {
  EXPECT_EQ(run({"refine", "-", "--write", "/dev/null"}, kHeader + "refine 0 0 0\n").exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(RefineCommand, SaysThatADeviceIsFull) {
  const Outcome outcome = run({"refine", "-", "--write", "/dev/full"}, kHeader + "refine 0 0 0\n");
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.err, "asts: /dev/full: could not be written to its end\n");
}

// The bytes do not depend on the number of threads, on a case large enough that they share the work.
TEST(Refine, PrintsAndWritesTheSameBytesForAnyNumberOfJobs) {
  const TemporaryFolder folder;
  const std::string sphere =
      folder.write("sphere.case", run({"generate", "sphere", "--domain", "8,8,8", "--elements", "20000"}).out);
  const std::string one = folder.path("one.case");
  const Outcome expected = run({"refine", sphere, "--format", "json", "--write", one});
  EXPECT_EQ(expected.exit_code, 0);
  for (const char* jobs : {"1", "2", "3"}) {
    const std::string written = folder.path(std::string("jobs-") + jobs);
    const Outcome outcome = run({"refine", sphere, "--format", "json", "--write", written, "--jobs", jobs});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, expected.out);
    EXPECT_EQ(content_of(written), content_of(one));
  }
  EXPECT_EQ(run({"refine", sphere, "--jobs", "0"}).exit_code, 2);
  EXPECT_EQ(run({"refine", sphere, "--jobs", "257"}).exit_code, 2);
}

}  // namespace
}  // namespace asts::testing
