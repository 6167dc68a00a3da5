#include "fuzz/campaign/worker_process.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "fuzz/campaign/optional_number.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kMeshes = "meshes ";
constexpr std::string_view kFresh = "fresh ";
constexpr std::string_view kUnit = "unit ";
constexpr std::string_view kTask = "task ";
constexpr std::string_view kFinding = "finding ";

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string task_json(const FindingTask& task) {
  Json json{{"index", task.index}, {"claim", task.claim}, {"kind", task.kind}, {"number", number_json(task.number)},
            {"step", task.step},   {"says", task.says},   {"died", task.died}};
  if (task.spoiled) {
    json["spoiled"] = {{"kind", task.spoiled->kind}, {"says", task.spoiled->says}, {"by", task.spoiled_by}};
  }
  return dumped(json);
}

FindingTask task_from(std::string_view text) {
  const Json json = Json::parse(text);
  FindingTask task{json.at("index"),
                   json.at("claim"),
                   json.at("kind"),
                   number_from(json.at("number")),
                   json.at("step"),
                   json.at("says"),
                   json.at("died"),
                   {},
                   {}};
  if (!json.contains("spoiled")) return task;
  const Json& spoiled = json.at("spoiled");
  task.spoiled = UnitDeath{task.claim, spoiled.at("kind"), std::nullopt, -1, spoiled.at("says")};
  task.spoiled_by = spoiled.at("by");
  return task;
}

std::string order_json(const UnitOrder& order) {
  Json json{{"unit", order.unit}, {"cases", order.cases}, {"skipped", Json::array()}};
  for (const Skip& skip : order.skipped) json["skipped"].push_back({skip.number, skip.claim});
  return dumped(json);
}

UnitOrder order_from(std::string_view text) {
  const Json json = Json::parse(text);
  UnitOrder order{json.at("unit"), json.at("cases"), {}};
  for (const Json& skip : json.at("skipped")) order.skipped.push_back({skip.at(0), skip.at(1)});
  return order;
}

/// "TOTAL,SLOWEST,NUMBER,CLAIM...", microseconds.
std::string times_text(const UnitTimes& times) {
  return fmt::format("{},{},{},{}", times.total, times.slowest, times.slowest_number, fmt::join(times.claims, ","));
}

UnitTimes times_from(const std::string& text) {
  std::istringstream numbers(text);
  UnitTimes times;
  char comma;
  numbers >> times.total >> comma >> times.slowest >> comma >> times.slowest_number;
  for (std::int64_t time; numbers >> comma >> time;) times.claims.push_back(time);
  return times;
}

UnitWatch watch_by(Beacon& beacon) {
  return {[&beacon](std::int64_t number, std::int64_t step) {
            beacon.has_case = true;
            beacon.number = number;
            beacon.step = step;
            beacon.claim = nullptr;
            ++beacon.ticks;
          },
          [&beacon](const Claim& claim) {
            beacon.claim = &claim;
            ++beacon.ticks;
          }};
}

class Service {
 public:
  Service(const CampaignPlan& plan, std::int64_t timeout_seconds, int file, Beacon& beacon)
      : plan_(plan), timeout_seconds_(timeout_seconds), file_(file), beacon_(beacon) {}

  void run() {
    while (const auto line = read_line(file_, rest_)) {
      beacon_.has_case = false;
      beacon_.claim = nullptr;
      if (line->starts_with(kUnit)) {
        do_unit(order_from(std::string_view(*line).substr(kUnit.size())));
      } else {
        do_task(task_from(std::string_view(*line).substr(kTask.size())));
      }
    }
  }

 private:
  void do_unit(const UnitOrder& order) {
    UnitWork work(plan_, order.unit, order.cases, order.skipped, watch_by(beacon_));
    write_line(file_, std::string(kMeshes) + hex_of(work.meshes()));
    const auto answer = read_line(file_, rest_);
    if (!answer) return;
    std::vector<bool> fresh;
    for (const char bit : answer->substr(kFresh.size())) fresh.push_back(bit == '1');
    const UnitRecord record = work.try_fresh(std::move(fresh));
    write_line(file_, fmt::format("{}{} {}", kUnit, times_text(work.times()), unit_json(record)));
  }

  void do_task(const FindingTask& task) {
    const auto watch = [this](const Case& tried) {
      const std::string text = write_case(tried);
      const bool fits = text.size() < Beacon::kMostCase;
      std::memcpy(beacon_.tried, fits ? text.c_str() : "", fits ? text.size() + 1 : 1);
      ++beacon_.ticks;
    };
    beacon_.tried[0] = 0;
    write_line(file_, std::string(kFinding) + work_out(plan_, task, timeout_seconds_, watch));
  }

  const CampaignPlan& plan_;
  std::int64_t timeout_seconds_;
  int file_;
  Beacon& beacon_;
  std::string rest_;
};

}  // namespace

void serve(const CampaignPlan& plan, std::int64_t timeout_seconds, int file, Beacon& beacon) {
  Service(plan, timeout_seconds, file, beacon).run();
}

std::string order_line(const UnitOrder& order) { return std::string(kUnit) + order_json(order); }

std::string order_line(const FindingTask& task) { return std::string(kTask) + task_json(task); }

std::string fresh_line(const std::vector<bool>& fresh) {
  std::string line(kFresh);
  for (const bool bit : fresh) line += bit ? '1' : '0';
  return line;
}

Worker::Message parse_message(const std::string& line) {
  using Kind = Worker::Message::Kind;
  if (line.starts_with(kMeshes)) {
    return {Kind::meshes, words_of(line.substr(kMeshes.size())), {}, {}};
  }
  if (line.starts_with(kFinding)) return {Kind::finding, {}, line.substr(kFinding.size()), {}};
  require(line.starts_with(kUnit), "a worker says what is no message");
  const std::size_t space = line.find(' ', kUnit.size());
  const std::string times = line.substr(kUnit.size(), space - kUnit.size());
  return {Kind::unit, {}, line.substr(space + 1), times_from(times)};
}

std::optional<std::string> read_line(int file, std::string& rest) {
  while (true) {
    const std::size_t end = rest.find('\n');
    if (end != std::string::npos) {
      std::string line = rest.substr(0, end);
      rest.erase(0, end + 1);
      return line;
    }
    char buffer[1 << 14];
    const ssize_t count = read(file, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return std::nullopt;
    rest.append(buffer, static_cast<std::size_t>(count));
  }
}

void write_line(int file, std::string line) {
  line += '\n';
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t written = send(file, line.data() + done, line.size() - done, MSG_NOSIGNAL);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw ResourceError("the other process is gone");
    done += static_cast<std::size_t>(written);
  }
}

}  // namespace asts
