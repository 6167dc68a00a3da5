#include <fmt/format.h>

#include <array>
#include <optional>

#include "tests/benchmarks/tables/tables.hpp"

namespace asts::benchmarks {

namespace {

constexpr const char* kSphere = "sphere/p3/m2";

/// What `refine` and `check` consist of.
constexpr std::array kGrowing{
    "read",       "refine", "replay", "zones", "admissible", "nested-patches", "analysis-suitable", "dual-compatible",
    "dual-basis", "check"};

using Figure = std::optional<double>;

/// What was measured, by names; nothing where something was not.
class Measured {
 public:
  Measured(const Rows& rows, const Processes& processes) : rows_(rows), processes_(processes) {}

  Figure counter(const std::string& name, const std::string& counter) const {
    const auto row = rows_.find(name);
    if (row == rows_.end() || !row->second.counters.contains(counter)) return std::nullopt;
    return row->second.counters.at(counter);
  }
  Figure row_seconds(const std::string& name) const {
    const auto row = rows_.find(name);
    return row == rows_.end() ? Figure() : row->second.seconds;
  }
  /// Of a command that came to its end: on the clock on the wall, and of the processor.
  Figure seconds(const std::string& name) const {
    return has(name) ? Figure(processes_.at(name).seconds) : std::nullopt;
  }
  Figure cpu_seconds(const std::string& name) const {
    return has(name) ? Figure(processes_.at(name).cpu_seconds) : std::nullopt;
  }
  Figure peak(const std::string& name) const {
    return has(name) ? Figure(processes_.at(name).peak_bytes) : std::nullopt;
  }

 private:
  bool has(const std::string& name) const { return processes_.contains(name) && processes_.at(name).exit_code == 0; }

  const Rows& rows_;
  const Processes& processes_;
};

Figure quotient(Figure one, Figure other) { return one && other ? Figure(*one / *other) : std::nullopt; }
Figure difference(Figure one, Figure other) { return one && other ? Figure(*one - *other) : std::nullopt; }

struct Growth {
  std::string stage = "-";
  Figure worst;
};

Growth worst_growth(const Measured& measured, const std::string& workload) {
  Growth result;
  for (const std::string stage : kGrowing) {
    const Figure growth = quotient(measured.row_seconds(workload + "/1000000/" + stage),
                                   measured.row_seconds(workload + "/100000/" + stage));
    if (growth && (!result.worst || *growth > *result.worst)) result = {stage, growth};
  }
  return result;
}

/// What a step of one mark costs, replayed and decided: the mean of those that print_steps adds to sphere with 10^5
/// elements.
Figure seconds_of_step(const Measured& measured) {
  const Figure steps =
      difference(measured.cpu_seconds("check, 10^5, 200 steps more"), measured.cpu_seconds("check, 10^5, before"));
  return steps ? Figure(*steps / 200) : std::nullopt;
}

/// A whole check of a mesh of 10^5 elements that is there already.
Figure seconds_of_decision(const Measured& measured) {
  return difference(measured.cpu_seconds("check --final, 10^5"), measured.cpu_seconds("refine, 10^5"));
}

Figure growth_of_process(const Measured& measured, const std::string& command) {
  return quotient(measured.cpu_seconds(command + ", 10^6"), measured.cpu_seconds(command + ", 10^5"));
}

Figure gain_of_two_jobs(const Measured& measured, const std::string& command) {
  return quotient(measured.seconds(command + ", 10^6"), measured.seconds(command + " --jobs 2, 10^6"));
}

std::string at_least(const std::string& what, Figure figure, double bound) {
  if (!figure) return fmt::format("| {} | >= {} | - | not measured |\n", what, with_prefix(bound));
  return fmt::format("| {} | >= {} | {} | {} |\n", what, with_prefix(bound), with_prefix(*figure),
                     *figure >= bound ? "kept" : "missed");
}

std::string at_most(const std::string& what, Figure figure, double bound) {
  if (!figure) return fmt::format("| {} | <= {} | - | not measured |\n", what, with_prefix(bound));
  return fmt::format("| {} | <= {} | {} | {} |\n", what, with_prefix(bound), with_prefix(*figure),
                     *figure <= bound ? "kept" : "missed");
}

}  // namespace

std::string promises_table(const Rows& rows, const Processes& processes) {
  const Measured measured(rows, processes);
  const Figure p8est = measured.counter("p8est/sphere/1000000/refine+balance", "elements/s");
  const Figure elements = measured.counter(std::string(kSphere) + "/1000000/refine", "elements");
  const Figure refine = measured.cpu_seconds("refine, 10^6");
  const Figure check = measured.cpu_seconds("check --final, 10^6");
  std::string result = "| promise | bound | measured | |\n|---|---|---|---|\n";
  result += at_least("refine, elements a second, as a share of p8est's refine and balance, `sphere` at 10^6",
                     quotient(measured.counter("p8est/sphere/1000000/asts-refine", "elements/s"), p8est), 0.25);
  result += at_least("the same, reading the case's text included",
                     quotient(measured.counter("p8est/sphere/1000000/asts-replay", "elements/s"), p8est), 0.25);
  result +=
      at_most("`check --final` of all five properties, as a multiple of `refine`, 10^6", quotient(check, refine), 8);
  result += at_most("peak memory of `check --final`, bytes an element, 10^6",
                    quotient(measured.peak("check --final, 10^6"), elements), 512);
  result += at_most("peak memory of `refine`, bytes an element, 10^6",
                    quotient(measured.peak("refine, 10^6"), elements), 512);
  const Figure step = seconds_of_step(measured);
  result += at_most("`check` of a step of one mark, as a share of `check --final`, 10^5",
                    quotient(step, measured.cpu_seconds("check --final, 10^5")), 0.02);
  result += at_most("the same, as a share of deciding the mesh without replaying it",
                    quotient(step, seconds_of_decision(measured)), 0.02);
  for (const char* command : {"refine", "check --final", "check"}) {
    result += at_most(fmt::format("growth of `{}` from 10^5 to 10^6, `sphere`", command),
                      growth_of_process(measured, command), 11.5);
  }
  for (const char* workload : {"sphere/p3/m2", "corner/p3/m2", "random/p3/m2"}) {
    const Growth growth = worst_growth(measured, workload);
    result += at_most(fmt::format("growth of a stage from 10^5 to 10^6, `{}`; the worst is {}", workload, growth.stage),
                      growth.worst, 11.5);
  }
  result += at_least("`check --jobs 2` beside one job, 10^6", gain_of_two_jobs(measured, "check"), 1.7);
  result += at_least("`check --final --jobs 2` beside one job, 10^6", gain_of_two_jobs(measured, "check --final"), 1.7);
  result += at_least("distinct meshes a second, 4 x 4 x 5 cubes, p = 3, m = 2, `as-implies-dc`",
                     measured.counter("enumerate/4x4x5/p3/m2/K3/as-implies-dc", "meshes/s"), 200'000);
  result += at_least("the same, each mesh of a reflection by itself",
                     measured.counter("enumerate/4x4x5/p3/m2/K3/as-implies-dc/every-mesh", "meshes/s"), 200'000);
  return result;
}

std::string process_table(const Processes& processes) {
  std::string result = "| command | seconds | processor seconds | peak, MB |\n|---|---|---|---|\n";
  for (const auto& [name, process] : processes) {
    if (process.exit_code != 0) {
      result += fmt::format("| {} | - | - | - |\n", name);
      continue;
    }
    result += fmt::format("| {} | {} | {} | {} |\n", name, three_digits(process.seconds),
                          three_digits(process.cpu_seconds), three_digits(process.peak_bytes / 1e6));
  }
  return result;
}

}  // namespace asts::benchmarks
