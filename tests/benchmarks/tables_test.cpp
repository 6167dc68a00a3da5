#include "tests/benchmarks/tables/tables.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

namespace asts::benchmarks {
namespace {

/// A file of Google Benchmark with three repetitions of one benchmark, out of order, and another one.
const char* const kFile = R"({"context": {}, "benchmarks": [
  {"name": "a/refine", "run_name": "a/refine", "run_type": "iteration", "repetitions": 3, "iterations": 7,
   "real_time": 9, "cpu_time": 4, "time_unit": "ms", "elements": 1000, "elements/s": 250},
  {"name": "a/refine", "run_name": "a/refine", "run_type": "iteration", "repetitions": 3, "iterations": 7,
   "real_time": 9, "cpu_time": 1, "time_unit": "ms", "elements": 1000, "elements/s": 1000},
  {"name": "a/refine", "run_name": "a/refine", "run_type": "iteration", "repetitions": 3, "iterations": 7,
   "real_time": 9, "cpu_time": 2, "time_unit": "ms", "elements": 1000, "elements/s": 500},
  {"name": "a/refine_mean", "run_name": "a/refine", "run_type": "aggregate", "cpu_time": 77, "time_unit": "ms"},
  {"name": "b", "run_name": "b/iterations:3", "run_type": "iteration", "cpu_time": 5, "time_unit": "us"}]})";

Rows rows_of(const std::string& json) {
  Rows rows;
  add_rows(json, rows);
  return rows;
}

Processes processes_of(const std::string& lines) {
  Processes processes;
  add_processes(lines, processes);
  return processes;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The one line that begins so.
std::string line_with(const std::string& table, const std::string& beginning) {
  std::string found = "none";
  for (const std::string& line : lines_of(table)) {
    if (line.starts_with(beginning)) found = found == "none" ? line : "several";
  }
  return found;
}

TEST(MeasuredRows, AreMediansOfTheRepetitionsInSeconds) {
  const Rows rows = rows_of(kFile);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_DOUBLE_EQ(rows.at("a/refine").seconds, 2e-3);
  EXPECT_EQ(rows.at("a/refine").counters, (std::map<std::string, double>{{"elements", 1000}, {"elements/s", 500}}));
  EXPECT_DOUBLE_EQ(rows.at("b").seconds, 5e-6);
}

TEST(MeasuredRows, TheFirstFileThatHasANameCounts) {
  Rows rows = rows_of(kFile);
  add_rows(R"({"benchmarks": [{"run_name": "b", "run_type": "iteration", "cpu_time": 1, "time_unit": "s"}]})", rows);
  EXPECT_DOUBLE_EQ(rows.at("b").seconds, 5e-6);
}

TEST(MeasuredRows, WhatIsNoneIsRefused) {
  EXPECT_THROW(rows_of("no JSON"), std::invalid_argument);
  EXPECT_THROW(rows_of("{}"), std::invalid_argument);
  EXPECT_THROW(rows_of(R"({"benchmarks": [{"run_name": "b", "run_type": "iteration", "error_occurred": true}]})"),
               std::invalid_argument);
  EXPECT_THROW(
      rows_of(R"({"benchmarks": [{"run_name": "b", "run_type": "iteration", "cpu_time": 1, "time_unit": "d"}]})"),
      std::invalid_argument);
  EXPECT_THROW(processes_of("{}\n"), std::invalid_argument);
}

TEST(MeasuredProcesses, AreMediansOfTheRounds) {
  const Processes processes =
      processes_of(R"({"name":"x","seconds":[3,1,2],"cpu_seconds":[0.5],"peak_kilobytes":2,"exit_code":1})"
                   "\n");
  EXPECT_EQ(processes.at("x").seconds, 2);
  EXPECT_EQ(processes.at("x").cpu_seconds, 0.5);
  EXPECT_EQ(processes.at("x").peak_bytes, 2048);
  EXPECT_EQ(processes.at("x").exit_code, 1);
}

TEST(Median, IsOneOfTheValues) {
  EXPECT_EQ(median({5}), 5);
  EXPECT_EQ(median({4, 1}), 1);
  EXPECT_EQ(median({9, 1, 5}), 5);
}

TEST(Numbers, HaveThreeDigits) {
  EXPECT_EQ(three_digits(0), "0");
  EXPECT_EQ(three_digits(12345.6), "12346");
  EXPECT_EQ(three_digits(123.4), "123");
  EXPECT_EQ(three_digits(12.34), "12.3");
  EXPECT_EQ(three_digits(1), "1.00");
  EXPECT_EQ(three_digits(0.01234), "0.0123");
  EXPECT_EQ(with_prefix(2'345'678), "2.35 M");
  EXPECT_EQ(with_prefix(23'456), "23.5 k");
  EXPECT_EQ(with_prefix(9'999), "9999");
}

/// A row of a mesh's stage.
Row row(double seconds, double elements) {
  return {seconds, {{"elements", elements}, {"elements/s", elements / seconds}}};
}

const Rows kSphere{{"sphere/p3/m2/100000/refine", row(0.1, 120'000)},
                   {"sphere/p3/m2/1000000/refine", row(1, 1'200'000)},
                   {"sphere/p3/m2/100000/check", row(0.2, 120'000)},
                   {"sphere/p3/m2/1000000/check", row(2.4, 1'200'000)},
                   {"sphere/p3/m2/1000000/closure", {0.5, {}}},
                   {"p8est/sphere/1000000/refine+balance", row(0.5, 1'500'000)},
                   {"p8est/sphere/1000000/asts-refine", row(2, 1'200'000)},
                   {"enumerate/4x4x5/p3/m2/K3/as-implies-dc", {1, {{"meshes/s", 199'999}}}}};

const Processes kProcesses{{"refine, 10^6", {1.5, 1.25, 120e6, 0}},
                           {"check --final, 10^6", {12, 10, 720e6, 0}},
                           {"check --final --jobs 2, 10^6", {8, 11, 720e6, 0}},
                           {"refine, 10^5", {9, 0.5, 1, 0}},
                           {"check --final, 10^5", {9, 1.5, 1, 0}},
                           {"check, 10^5, before", {9, 2, 1, 0}},
                           {"check, 10^6", {9, 13, 1, 0}},
                           {"check --jobs 2, 10^6", {5, 14, 1, 0}},
                           {"check, 10^5, 200 steps more", {9, 8, 1, 0}}};

TEST(PromisesTable, ComparesWithTheBounds) {
  const std::string table = promises_table(kSphere, kProcesses);
  // 0.6 million a second beside 3 million
  EXPECT_TRUE(line_with(table, "| refine, elements").ends_with("| >= 0.250 | 0.200 | missed |")) << table;
  EXPECT_TRUE(line_with(table, "| the same, reading").ends_with("| >= 0.250 | - | not measured |")) << table;
  // 10 s of the processor beside 1.25 s
  EXPECT_TRUE(line_with(table, "| `check --final`").ends_with("| <= 8.00 | 8.00 | kept |")) << table;
  // 720 and 120 MB for 1.2 million elements
  EXPECT_TRUE(line_with(table, "| peak memory of `check").ends_with("| <= 512 | 600 | missed |")) << table;
  EXPECT_TRUE(line_with(table, "| peak memory of `refine").ends_with("| <= 512 | 100 | kept |")) << table;
  // 6 s for 200 steps beside 1.5 s, of which 1 s decides
  EXPECT_TRUE(line_with(table, "| `check` of a step").ends_with("| <= 0.0200 | 0.0200 | kept |")) << table;
  EXPECT_TRUE(line_with(table, "| the same, as a share").ends_with("| <= 0.0200 | 0.0300 | missed |")) << table;
  // 1.25 s beside 0.5 s, 10 s beside 1.5 s, and nothing beside 13 s
  EXPECT_TRUE(line_with(table, "| growth of `refine`").ends_with("| <= 11.5 | 2.50 | kept |")) << table;
  EXPECT_TRUE(line_with(table, "| growth of `check --final`").ends_with("| <= 11.5 | 6.67 | kept |")) << table;
  EXPECT_TRUE(line_with(table, "| growth of `check`").ends_with("| - | not measured |")) << table;
  EXPECT_TRUE(line_with(table, "| growth of a stage from 10^5 to 10^6, `sphere/p3/m2`; the worst is check")
                  .ends_with("| <= 11.5 | 12.0 | missed |"))
      << table;
  EXPECT_TRUE(line_with(table, "| growth of a stage from 10^5 to 10^6, `corner").ends_with("| - | not measured |"));
  // 9 s beside 5 s and 12 s beside 8 s, on the wall
  EXPECT_TRUE(line_with(table, "| `check --jobs 2`").ends_with("| >= 1.70 | 1.80 | kept |")) << table;
  EXPECT_TRUE(line_with(table, "| `check --final --jobs 2`").ends_with("| >= 1.70 | 1.50 | missed |")) << table;
  EXPECT_TRUE(line_with(table, "| distinct meshes").ends_with("| >= 200 k | 200 k | missed |")) << table;
}

TEST(ProcessTable, ShowsNoTimesOfWhatFailed) {
  const std::string table = process_table({{"a", {1.5, 1.25, 12e6, 0}}, {"b", {1, 1, 1, 2}}});
  EXPECT_EQ(line_with(table, "| a"), "| a | 1.50 | 1.25 | 12.0 |");
  EXPECT_EQ(line_with(table, "| b"), "| b | - | - | - |");
}

TEST(StageTable, HasSizesAndGrowth) {
  const std::string table = stage_table(kSphere, "sphere/p3/m2");
  EXPECT_EQ(lines_of(table).size(), 6U) << "head, elements, refine, closure, check";
  EXPECT_EQ(line_with(table, "| elements"), "| elements | - | 120000 | 1200000 | 10.0 | | |");
  EXPECT_EQ(line_with(table, "| refine"), "| refine | - | 100 | 1000 | 10.0 | 1.20 M | - |");
  EXPECT_EQ(line_with(table, "| check"), "| check | - | 200 | 2400 | 12.0 | 500 k | - |");
}

TEST(MatrixTable, HasALineForEachInput) {
  const std::string table = matrix_table(kSphere);
  EXPECT_EQ(lines_of(table).size(), 3U) << table;
  EXPECT_EQ(line_with(table, "| sphere"),
            "| sphere/p3/m2/1000000 | 1200000 | 1000 | 500 | - | - | - | - | - | - | 2400 | - | - | - | - |");
}

TEST(PlainTable, ShowsAllCounters) {
  EXPECT_EQ(line_with(plain_table(kSphere, "p8est/"), "| p8est/sphere/1000000/refine+"),
            "| p8est/sphere/1000000/refine+balance | 500 | 1.50 M elements, 3.00 M elements/s |");
}

TEST(ReferenceTable, SetsTheLiteralCodeBeside) {
  const Rows rows{{"reference/c/check", row(0.001, 250)}, {"reference/c/check-literal", row(2, 250)}};
  EXPECT_EQ(line_with(reference_table(rows), "| reference"), "| reference/c/check | 250 | 1.00 | 2000 | 2000 |");
}

}  // namespace
}  // namespace asts::benchmarks
