#include "tests/benchmarks/tables/measured.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>

namespace asts::benchmarks {

namespace {

using Json = nlohmann::json;

/// What Google Benchmark writes beside counters.
const std::set<std::string> kNoCounters{"family_index", "per_family_instance_index",
                                        "repetitions",  "repetition_index",
                                        "threads",      "iterations",
                                        "real_time",    "cpu_time"};

double unit_in_seconds(const std::string& unit) {
  if (unit == "ns") return 1e-9;
  if (unit == "us") return 1e-6;
  if (unit == "ms") return 1e-3;
  if (unit == "s") return 1;
  throw std::invalid_argument("no unit of time: " + unit);
}

/// The repetitions of one name.
struct Repetitions {
  std::vector<double> seconds;
  std::map<std::string, std::vector<double>> counters;

  void add(const Json& one) {
    seconds.push_back(one.at("cpu_time").get<double>() * unit_in_seconds(one.at("time_unit")));
    for (const auto& [key, value] : one.items()) {
      if (value.is_number() && !kNoCounters.contains(key)) counters[key].push_back(value);
    }
  }

  Row row() const {
    Row result{median(seconds), {}};
    for (const auto& [key, values] : counters) result.counters[key] = median(values);
    return result;
  }
};

std::map<std::string, Repetitions> repetitions_of(const Json& file) {
  std::map<std::string, Repetitions> all;
  for (const Json& one : file.at("benchmarks")) {
    if (one.at("run_type") != "iteration") continue;
    std::string name = one.at("run_name");
    name.resize(std::min(name.find("/iterations:"), name.size()));  // added where their number is fixed
    if (one.value("error_occurred", false)) throw std::invalid_argument(name + " ended with an error");
    all[name].add(one);
  }
  return all;
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[(values.size() - 1) / 2];
}

void add_rows(std::string_view json, Rows& rows) try {
  for (const auto& [name, repetitions] : repetitions_of(Json::parse(json))) rows.try_emplace(name, repetitions.row());
} catch (const Json::exception& error) {
  throw std::invalid_argument(error.what());
}

void add_processes(std::string_view lines, Processes& processes) try {
  std::istringstream stream{std::string(lines)};
  for (std::string line; std::getline(stream, line);) {
    const Json one = Json::parse(line);
    processes[one.at("name")] = {median(one.at("seconds")), median(one.at("cpu_seconds")),
                                 one.at("peak_kilobytes").get<double>() * 1024, one.at("exit_code")};
  }
} catch (const Json::exception& error) {
  throw std::invalid_argument(error.what());
}

}  // namespace asts::benchmarks
