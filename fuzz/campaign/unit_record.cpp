#include "fuzz/campaign/unit_record.hpp"

#include <fmt/format.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "fuzz/campaign/optional_number.hpp"
#include "lib/exact/errors.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kDigits = 16;  ///< hexadecimal, of 64 bits

/// Of a claim: counts, bounds, biases, features, each in the order of its struct.
Json record_json(const LedgerRecord& record) {
  const LedgerBounds& bounds = record.bounds;
  return {
      {"trials",
       {record.meshes, record.sequences, record.alone, record.holds, record.violated, record.not_applicable,
        record.undecided, record.met, record.trials_met}},
      {"bounds", {bounds.domain, bounds.degree, bounds.grading, bounds.level, bounds.elements, bounds.active_nodes}},
      {"biases", record.biases},
      {"features", record.features}};
}

LedgerRecord record_from(const std::string& claim, const Json& json) {
  LedgerRecord record;
  record.claim = claim;
  std::size_t place = 0;
  for (std::int64_t* count : {&record.meshes, &record.sequences, &record.alone, &record.holds, &record.violated,
                              &record.not_applicable, &record.undecided, &record.met, &record.trials_met}) {
    *count = json.at("trials").at(place++);
  }
  const Json& bounds = json.at("bounds");
  record.bounds = {bounds.at(0), bounds.at(1), bounds.at(2), bounds.at(3), bounds.at(4), bounds.at(5)};
  record.biases = json.at("biases");
  record.features = json.at("features");
  return record;
}

Json violation_json(const UnitViolation& one) {
  return {{"claim", one.claim}, {"kind", one.kind},   {"number", number_json(one.number)},
          {"step", one.step},   {"count", one.count}, {"says", one.says}};
}

Json death_json(const UnitDeath& one) {
  return {{"claim", one.claim},
          {"kind", one.kind},
          {"number", number_json(one.number)},
          {"step", one.step},
          {"says", one.says}};
}

/// Counts by number, with the numbers as texts.
Json generated_json(const UnitRecord& record) {
  Json json = Json::object();
  for (const auto& [what, counts] : record.generated) {
    for (const auto& [value, count] : counts) json[what][std::to_string(value)] = count;
  }
  return json;
}

UnitRecord record_from(const Json& json) {
  UnitRecord record;
  record.unit = json.at("unit");
  record.end = json.at("end");
  record.cases = json.at("cases");
  record.meshes = json.at("meshes");
  record.trivial = json.at("trivial");
  record.sequences = json.at("sequences");
  record.fresh = words_of(json.at("fresh").get<std::string>());
  record.biases = json.at("biases");
  for (const auto& [what, counts] : json.at("generated").items()) {
    for (const auto& [value, count] : counts.items()) record.generated[what][std::stoll(value)] = count;
  }
  for (const auto& [claim, one] : json.at("claims").items()) record.records[claim] = record_from(claim, one);
  for (const Json& one : json.at("violations")) {
    record.violations.push_back({one.at("claim"), one.at("kind"), number_from(one.at("number")), one.at("step"),
                                 one.at("count"), one.at("says")});
  }
  for (const Json& one : json.at("deaths")) {
    record.deaths.push_back(
        {one.at("claim"), one.at("kind"), number_from(one.at("number")), one.at("step"), one.at("says")});
  }
  return record;
}

}  // namespace

std::string hex_of(const std::vector<std::uint64_t>& words) {
  std::string text;
  for (const std::uint64_t word : words) text += fmt::format("{:016x}", word);
  return text;
}

std::vector<std::uint64_t> words_of(std::string_view text) {
  std::vector<std::uint64_t> words;
  require(text.size() % kDigits == 0, "meshes are not in 16 digits each");
  for (std::size_t begin = 0; begin < text.size(); begin += kDigits) {
    const char* end = text.data() + begin + kDigits;
    const auto [stop, error] = std::from_chars(text.data() + begin, end, words.emplace_back(), 16);
    require(error == std::errc() && stop == end, "meshes are not in hexadecimal digits");
  }
  return words;
}

std::string unit_json(const UnitRecord& record) {
  Json json{{"unit", record.unit},           {"end", record.end},         {"cases", record.cases},
            {"meshes", record.meshes},       {"trivial", record.trivial}, {"sequences", record.sequences},
            {"fresh", hex_of(record.fresh)}, {"biases", record.biases},   {"generated", generated_json(record)}};
  json["claims"] = Json::object();
  for (const auto& [claim, one] : record.records) json["claims"][claim] = record_json(one);
  json["violations"] = Json::array();
  for (const UnitViolation& one : record.violations) json["violations"].push_back(violation_json(one));
  json["deaths"] = Json::array();
  for (const UnitDeath& one : record.deaths) json["deaths"].push_back(death_json(one));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

UnitRecord unit_from_json(std::string_view text) {
  try {
    return record_from(Json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("no record of a unit: ") + error.what());
  } catch (const std::logic_error&) {  // of std::stoll
    throw InputError("no record of a unit: a key is no number");
  }
}

}  // namespace asts
