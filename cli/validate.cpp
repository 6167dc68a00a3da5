#include "tests/reference/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "tests/reference/refine.hpp"

namespace asts::cli {

namespace {

using Json = nlohmann::json;

reference::Point literal_point(const Point& point) {
  reference::Point result;
  for (std::size_t axis = 0; axis < kDimension; ++axis) result[axis] = point[axis].value();
  return result;
}

/// Replays the first steps of a case by the literal code alone: nothing of the mesh kernel is used.
reference::Mesh literal_mesh(const Case& content, const reference::Setting& setting, std::size_t steps) {
  if (content.explicit_mesh) {
    reference::Mesh mesh;
    for (const ElementLine& line : content.elements) {
      mesh.push_back({literal_point(line.lower), literal_point(line.upper)});
    }
    return mesh;
  }
  reference::Mesh mesh = reference::initial_mesh(setting);
  for (std::size_t i = 0; i < steps; ++i) {
    std::vector<std::size_t> marked;
    for (const Point& mark : content.steps[i].marks) {
      marked.push_back(reference::element_at(setting, mesh, literal_point(mark)).value());
    }
    mesh = content.steps[i].kind == Step::Kind::refine ? reference::refine(setting, mesh, marked)
                                                       : reference::subdivide(setting, mesh, marked);
  }
  return mesh;
}

/// The case of a record: the one it carries, or the file that it names.
Case case_of(const Json& record, const std::string& file, const std::string& place) {
  if (record.contains("mesh")) return parse_case(record.at("mesh").get<std::string>(), place + ": mesh");
  const std::string name = record.at("case").get<std::string>();
  const std::filesystem::path beside = std::filesystem::path(file).parent_path() / name;
  return read_case_file(std::filesystem::exists(name) ? name : beside.string());
}

/// A record's mesh, by the literal code, and what speaks against the record itself; empty when nothing does.
struct LiteralRecord {
  reference::Setting setting;
  reference::Mesh mesh;
  std::string objection;
};

LiteralRecord literal_record(const Json& record, const std::string& file, const std::string& place) {
  const Case content = case_of(record, file, place);
  LiteralRecord result{{content.degree, content.grading, content.domain}, {}, {}};
  const Json& step = record.at("step");
  const std::size_t most = content.steps.size();
  if (!step.is_number_unsigned() || step > most || (record.contains("mesh") && step != most)) {
    result.objection = fmt::format("step {} is not what the record's case of {} steps says", step.dump(), most);
    return result;
  }
  result.mesh = literal_mesh(content, result.setting, step.get<std::size_t>());
  if (!reference::tiles_domain(result.setting, result.mesh)) {
    result.objection = "the elements do not tile the domain";
  } else if (record.at("elements") != result.mesh.size()) {
    result.objection =
        fmt::format("the mesh has {} elements, not {}", result.mesh.size(), record.at("elements").dump());
  }
  return result;
}

struct Finding {
  std::string property;
  reference::Validation validation;
};

constexpr std::array kVerdicts{"holds", "violated", "not-applicable", "undecided"};

bool is_violated(const Json& entry) {
  const std::string verdict = entry.at("verdict").get<std::string>();
  if (std::find(kVerdicts.begin(), kVerdicts.end(), verdict) == kVerdicts.end()) {
    throw InputError("'" + verdict + "' is no verdict");
  }
  return verdict == "violated";
}

std::vector<Finding> validate_record(const Json& record, const std::string& file, const std::string& place) {
  std::vector<Finding> findings;
  std::optional<LiteralRecord> literal;
  for (const auto& [property, entry] : record.at("properties").items()) {
    if (!is_violated(entry)) continue;
    if (!entry.contains("witness")) {
      findings.push_back({property, {false, "the verdict is violated, but there is no witness"}});
      continue;
    }
    if (!literal) literal = literal_record(record, file, place);
    findings.push_back(
        {property, literal->objection.empty()
                       ? reference::validate_witness(literal->setting, literal->mesh, property, entry.at("witness"))
                       : reference::Validation{false, literal->objection}});
  }
  return findings;
}

std::string finding_text(const Finding& finding, const std::string& file, std::size_t line, Format format) {
  if (format == Format::json) {
    const nlohmann::ordered_json json{{"file", file},
                                      {"line", line},
                                      {"property", finding.property},
                                      {"valid", finding.validation.valid},
                                      {"report", finding.validation.report}};
    return json.dump() + "\n";
  }
  return fmt::format("{}:{}: {}: the witness is {}\n{}\n", file, line, finding.property,
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
      Json content = Json::parse(line, nullptr, false);
      if (content.is_discarded() || !content.is_object() || !content.contains("properties")) {
        throw InputError(fmt::format("{}:{}: no record of `asts check --format json`", file, number));
      }
      records.push_back({file, number, std::move(content)});
    }
    if (records.size() == before) throw InputError(file + ": no record");
  }
  return records;
}

std::vector<Finding> findings_of(const Record& record) {
  const std::string place = fmt::format("{}:{}", record.file, record.line);
  try {
    return validate_record(record.content, record.file, place);
  } catch (const Json::exception& error) {
    const std::string reason = error.what();  // "[json.exception.NAME.NUMBER] words"
    throw InputError(place + ": malformed record: " + reason.substr(reason.find("] ") + 2));
  } catch (const CaseFileError&) {
    throw;  // names its own place
  } catch (const InputError& error) {
    throw InputError(place + ": malformed record: " + error.what());
  }
}

}  // namespace

int validate(const ValidateOptions& options) {
  const std::vector<Record> records = read_records(options.files);
  std::size_t valid = 0;
  std::size_t total = 0;
  std::string output;
  for (const Record& record : records) {
    stop_if_interrupted();
    for (const Finding& finding : findings_of(record)) {
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
