#include "reports/checked_in_ledger.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "lib/exact/errors.hpp"
#include "reports/ledger_report.hpp"

namespace asts {

namespace {

using Json = nlohmann::json;

ExhaustiveRecord exhaustive_from(const Json& json) {
  return {json.at("claim"),
          {json.at("degree"), json.at("grading"), json.at("domain")},
          json.at("max_subdivisions"),
          json.at("admissible"),
          json.at("meshes"),
          json.at("applicable"),
          json.at("violations"),
          json.value("met", 0)};
}

void take_line(CheckedInLedger& ledger, const std::string& line) {
  const Json json = Json::parse(line);
  const std::string claim = json.at("claim");
  if (json.contains("max_subdivisions")) {
    ledger[claim].exhaustive.push_back(exhaustive_from(json));
  } else {
    ledger[claim].record = ledger_from_json(line);
    ledger[claim].status = json.at("status");
  }
}

std::string bounds_text(const LedgerBounds& bounds) {
  return fmt::format("degrees to {}, m to {}, domains to {}, levels to {}, up to {} elements",
                     fmt::join(bounds.degree, " "), bounds.grading, fmt::join(bounds.domain, " "), bounds.level,
                     bounds.elements);
}

std::string exhaustive_text(const ExhaustiveRecord& record) {
  return fmt::format("all {} meshes of at most {}{} subdivisions of {} (p = {}, m = {}), {} applicable, {} violating",
                     record.meshes, record.max_subdivisions, record.admissible ? " admissible" : "",
                     fmt::join(record.setting.domain, " x "), fmt::join(record.setting.degree, ","),
                     record.setting.grading, record.applicable, record.violations);
}

}  // namespace

CheckedInLedger read_ledger(std::string_view lines) {
  CheckedInLedger ledger;
  std::istringstream stream{std::string(lines)};
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    try {
      take_line(ledger, line);
    } catch (const std::exception& error) {
      throw InputError(fmt::format("{}: {}", number, error.what()));
    }
  }
  return ledger;
}

const CheckedInLedger& checked_in_ledger() {
  static const CheckedInLedger ledger = read_ledger(checked_in_lines());
  return ledger;
}

std::string tried_text(std::string_view claim) {
  const auto found = checked_in_ledger().find(claim);
  if (found == checked_in_ledger().end()) return {};
  const LedgerRecord& record = found->second.record;
  std::string text = fmt::format("{} trials", record.trials());
  if (record.meshes > 0) text += fmt::format(", {} distinct meshes", record.meshes);
  if (record.sequences > 0) text += fmt::format(", {} sequences", record.sequences);
  text += fmt::format("; met in {} of them, {} times", record.trials_met, record.met);
  if (record.bounds.grading > 0) text += "; " + bounds_text(record.bounds);
  for (const ExhaustiveRecord& exhaustive : found->second.exhaustive) text += "; " + exhaustive_text(exhaustive);
  return text;
}

}  // namespace asts
