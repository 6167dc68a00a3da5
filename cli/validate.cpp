#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "fuzz/validation/validate_record.hpp"
#include "lib/exact/errors.hpp"

namespace asts::cli {

namespace {

using Json = nlohmann::json;

std::string finding_text(const ValidatedWitness& finding, const std::string& file, std::size_t line, Format format) {
  if (format == Format::json) {
    const nlohmann::ordered_json json{{"file", file},
                                      {"line", line},
                                      {finding.statement, finding.id},
                                      {"valid", finding.validation.valid},
                                      {"report", finding.validation.report}};
    return json.dump() + "\n";
  }
  return fmt::format("{}:{}: {}: the witness is {}\n{}\n", file, line, finding.id,
                     finding.validation.valid ? "valid" : "NOT VALID", finding.validation.report);
}

std::vector<std::string> read_lines(const std::string& path) {
  if (std::filesystem::is_directory(path)) throw InputError(path + ": is a directory");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": cannot be opened");
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

struct Record {
  std::string file;
  std::size_t line;
  Json content;
};

/// All records of all files, before anything is written.
std::vector<Record> read_records(const std::vector<std::string>& files) {
  std::vector<Record> records;
  for (const std::string& file : files) {
    const std::size_t before = records.size();
    std::size_t number = 0;
    for (const std::string& line : read_lines(file)) {
      ++number;
      if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
      auto content = parse_record(line);
      if (!content) throw InputError(fmt::format("{}:{}: no record of `asts check --format json`", file, number));
      records.push_back({file, number, std::move(*content)});
    }
    if (records.size() == before) throw InputError(file + ": no record");
  }
  return records;
}

}  // namespace

int validate(const ValidateOptions& options) {
  const std::vector<Record> records = read_records(options.files);
  std::size_t valid = 0;
  std::size_t total = 0;
  std::string output;
  for (const Record& record : records) {
    stop_if_interrupted();
    const std::string place = fmt::format("{}:{}", record.file, record.line);
    for (const ValidatedWitness& finding : validate_record(record.content, record.file, place)) {
      ++total;
      valid += finding.validation.valid ? 1 : 0;
      output += finding_text(finding, record.file, record.line, options.format);
    }
  }
  print(output);
  if (options.format == Format::text) print(fmt::format("{} of {} witnesses are valid\n", valid, total));
  return valid == total ? kHolds : kViolated;
}

}  // namespace asts::cli
