#pragma once

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "lib/mesh/node_array.hpp"
#include "tests/benchmarks/inputs.hpp"

namespace asts::benchmarks {

inline std::size_t bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd + node_array_pages;
}

/// `things` a second, for what one pass of the loop does.
inline benchmark::Counter rate(std::int64_t things) {
  return benchmark::Counter(static_cast<double>(things), benchmark::Counter::kIsIterationInvariantRate);
}

/// Where a value can be dropped when it is time.
template <typename T>
std::unique_ptr<T> on_heap(T value) {
  return std::make_unique<T>(std::move(value));
}

/// Times `make(start)`, with a new `start = begin()` each time, which is not timed; nor is it timed how what is made
/// goes away. Counters: elements, elements a second, and bytes an element of what was made.
template <typename Begin, typename Make>
void measure(benchmark::State& state, std::int64_t elements, Begin begin, Make make) {
  std::size_t before = 0;
  std::size_t after = 0;
  for (auto _ : state) {
    state.PauseTiming();
    auto start = on_heap(begin());
    before = bytes_in_use();
    state.ResumeTiming();
    auto result = on_heap(make(*start));
    benchmark::DoNotOptimize(result);
    state.PauseTiming();
    after = bytes_in_use();
    result.reset();
    start.reset();
    state.ResumeTiming();
  }
  state.counters["elements"] = static_cast<double>(elements);
  state.counters["elements/s"] = rate(elements);
  const double bytes = (static_cast<double>(after) - static_cast<double>(before)) / static_cast<double>(elements);
  if (bytes >= 1) state.counters["bytes/element"] = bytes;  // less is no structure of the mesh's size
}

/// Registers INPUT/STAGE. `begin(prepared)` gives what `make` works on.
template <typename Begin, typename Make>
benchmark::internal::Benchmark* add(const Input& input, const std::string& stage, Begin begin, Make make) {
  return benchmark::RegisterBenchmark((input.name() + "/" + stage).c_str(),
                                      [=](benchmark::State& state) {
                                        Prepared& shared = prepared(input);
                                        measure(
                                            state, shared.elements(), [&] { return begin(shared); }, make);
                                      })
      ->Unit(benchmark::kMillisecond);
}

void measure_refine(benchmark::State& state, const Input& input);  ///< the case to the tree
void measure_replay(benchmark::State& state, const Input& input);  ///< the case's text to the tree

void add_refinement_benchmarks(const Input& input);  ///< from a case's text to the tree
void add_spline_benchmarks(const Input& input);      ///< from the tree to the verdicts
void add_lambda_benchmarks(const Input& input);      ///< lambda for the index vectors of the mesh
void add_sequence_benchmarks();                      ///< a check after each step
void add_search_benchmarks();                        ///< enumeration, campaign, minimization
void add_reference_benchmarks();                     ///< the literal code beside the library
/// p8est's refine and balance, and ours once more so that one run has both; nothing where p8est is not installed.
void add_p8est_benchmarks();

}  // namespace asts::benchmarks
