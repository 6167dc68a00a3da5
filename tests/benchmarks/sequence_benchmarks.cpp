#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>
#include <vector>

#include "properties/sequence_under_test.hpp"
#include "tests/benchmarks/measure.hpp"

/// A check after each of 200 steps that mark one element each, from 10^5 elements on.
namespace asts::benchmarks {

namespace {

constexpr int kSteps = 200;
/// From scratch each step costs a whole check: a few are enough to know.
constexpr int kStepsFromScratch = 4;

/// The replay before the first of the single marks.
std::unique_ptr<Replay> replay_before_marks(const Case& content) {
  auto replay = std::make_unique<Replay>(content);
  while (replay->counts().step + kSteps < static_cast<std::int64_t>(content.steps.size())) replay->advance();
  return replay;
}

/// Counters: what half of the steps take at most, nine of ten, and all, in milliseconds.
void add_quantiles(benchmark::State& state, std::vector<double> milliseconds) {
  std::sort(milliseconds.begin(), milliseconds.end());
  state.counters["ms median"] = milliseconds[milliseconds.size() / 2];
  state.counters["ms for 9 of 10"] = milliseconds[9 * milliseconds.size() / 10];
  state.counters["ms at most"] = milliseconds.back();
}

/// Calls visit(sequence) after each of the first `steps` single marks. Counter: steps a second.
template <typename Visit>
void measure_steps(benchmark::State& state, const Input& input, int steps, Visit visit) {
  using Clock = std::chrono::steady_clock;
  const Case content = with_single_marks(input, kSteps);
  std::vector<double> milliseconds;  // of the last pass
  for (auto _ : state) {
    state.PauseTiming();
    const auto replay = replay_before_marks(content);
    SequenceUnderTest sequence(*replay);
    visit(*replay, sequence);
    milliseconds.clear();
    state.ResumeTiming();
    for (int step = 0; step < steps; ++step) {
      const Clock::time_point begin = Clock::now();
      replay->advance();
      sequence.after_step();
      visit(*replay, sequence);
      milliseconds.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    }
  }
  add_quantiles(state, std::move(milliseconds));
  state.counters["steps"] = steps;
  state.counters["steps/s"] = rate(steps);
}

using Visit = void (*)(const Replay&, SequenceUnderTest&);

void only_refine(const Replay&, SequenceUnderTest&) {}

/// As `asts check` does it: what a step leaves as it was is not decided again.
void check_what_changed(const Replay&, SequenceUnderTest& sequence) {
  for (const Property& property : all_properties()) benchmark::DoNotOptimize(sequence.decide(property));
}

void check_from_scratch(const Replay& replay, SequenceUnderTest&) {
  SequenceUnderTest mesh(replay);
  for (const Property& property : all_properties()) benchmark::DoNotOptimize(mesh.decide(property));
}

}  // namespace

void add_sequence_benchmarks() {
  for (const Workload workload : {Workload::sphere, Workload::corner, Workload::random}) {
    const Input input{workload, 3, 2, 100'000};
    const auto add_steps = [&](const char* stage, int steps, Visit visit) {
      benchmark::RegisterBenchmark((input.name() + "/" + stage).c_str(), [=](benchmark::State& state) {
        measure_steps(state, input, steps, visit);
      })->Unit(benchmark::kMillisecond);
    };
    add_steps("steps-refine", kSteps, only_refine);
    add_steps("steps-check", kSteps, check_what_changed);
    add_steps("steps-check-from-scratch", kStepsFromScratch, check_from_scratch);
  }
}

}  // namespace asts::benchmarks
