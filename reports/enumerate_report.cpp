#include "reports/enumerate_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace asts {

namespace {

constexpr const char* kRow = "{:<32} {:>12} {:>12} {:>12} {:>15} {:>10} {:>14}\n";

}  // namespace

std::string enumeration_json(const EnumerationRecord& record) {
  nlohmann::ordered_json json{
      {record.kind, record.id}, {"meshes", record.meshes}, {"violations", record.violations}, {"smallest", nullptr}};
  if (record.smallest) json["smallest"] = *record.smallest;
  json["applicable"] = record.applicable();
  json["not_applicable"] = record.not_applicable;
  json["undecided"] = record.undecided;
  if (record.met) json["met"] = *record.met;
  return json.dump() + "\n";
}

std::string enumeration_text_header() {
  return fmt::format(fmt::runtime(kRow), "claim", "meshes", "violations", "applicable", "not-applicable", "undecided",
                     "met");
}

std::string enumeration_text(const EnumerationRecord& record) {
  return fmt::format(fmt::runtime(kRow), record.id, record.meshes, record.violations, record.applicable(),
                     record.not_applicable, record.undecided, record.met ? std::to_string(*record.met) : "-");
}

std::string smallest_text(const EnumerationRecord& record) {
  if (!record.smallest) return {};
  return fmt::format("\n# {} is violated; with the fewest subdivisions by\n{}", record.id, *record.smallest);
}

}  // namespace asts
