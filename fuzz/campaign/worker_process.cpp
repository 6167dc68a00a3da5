#include "fuzz/campaign/worker_process.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kMeshes = "meshes ";
constexpr std::string_view kFresh = "fresh ";
constexpr std::string_view kUnit = "unit ";
constexpr std::string_view kTask = "task ";
constexpr std::string_view kFinding = "finding ";

std::string task_json(const FindingTask& task) {
  const Json json{task.index, task.claim, task.kind, task.number ? Json(*task.number) : Json(nullptr),
                  task.step,  task.says,  task.died};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

FindingTask task_from(std::string_view text) {
  const Json json = Json::parse(text);
  FindingTask task{json.at(0), json.at(1), json.at(2), std::nullopt, json.at(4), json.at(5), json.at(6)};
  if (!json.at(3).is_null()) task.number = json.at(3).get<std::int64_t>();
  return task;
}

UnitOrder order_from(const std::string& text) {
  std::istringstream words(text);
  UnitOrder order;
  words >> order.unit >> order.cases;
  for (std::int64_t number; words >> number;) order.skipped.push_back(number);
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
  Service(const CampaignPlan& plan, int file, Beacon& beacon) : plan_(plan), file_(file), beacon_(beacon) {}

  void run() {
    while (const auto line = read_line(file_, rest_)) {
      beacon_.has_case = false;
      beacon_.claim = nullptr;
      if (line->starts_with(kUnit)) {
        do_unit(order_from(line->substr(kUnit.size())));
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
    write_line(file_, std::string(kFinding) + work_out(plan_, task, [this] { ++beacon_.ticks; }));
  }

  const CampaignPlan& plan_;
  int file_;
  Beacon& beacon_;
  std::string rest_;
};

}  // namespace

void serve(const CampaignPlan& plan, int file, Beacon& beacon) { Service(plan, file, beacon).run(); }

std::string order_line(const UnitOrder& order) {
  return fmt::format("{}{} {} {}", kUnit, order.unit, order.cases, fmt::join(order.skipped, " "));
}

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
