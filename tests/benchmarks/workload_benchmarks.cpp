#include <benchmark/benchmark.h>
#include <malloc.h>

#include <memory>
#include <string>

#include "lib/gen/workloads.hpp"
#include "lib/refine/replay.hpp"
#include "properties/properties.hpp"

/// Every stage of `asts check`, one after the other, on the workloads sphere and corner at 10^4, 10^5 and 10^6 elements
/// (p = 3,3,3, m = 2, 16^3 cubes). Counters: elements a second, and bytes in use an element after a stage. Times of
/// stages are without those before: a property's time is that of its decision when splines and bricks are there.
namespace asts {
namespace {

struct Input {
  Workload workload;
  const char* name;
  std::int64_t elements;
};

constexpr Input kInputs[] = {
    {Workload::sphere, "sphere", 10'000},    {Workload::sphere, "sphere", 100'000},
    {Workload::sphere, "sphere", 1'000'000}, {Workload::corner, "corner", 10'000},
    {Workload::corner, "corner", 100'000},   {Workload::corner, "corner", 1'000'000},
};

/// The last tree, and what the stages made of it: kept for the benchmarks of one input, which run one after the other.
struct Stages {
  Case content;
  std::unique_ptr<Replay> replay;
  std::unique_ptr<MeshUnderTest> mesh;
};

std::unique_ptr<Replay> replayed(const Case& content) {
  auto replay = std::make_unique<Replay>(content);
  while (!replay->done()) replay->advance();
  return replay;
}

const Stages& stages_of(const Input& input) {
  static const Input* current = nullptr;
  static Stages stages;
  if (current == &input) return stages;
  current = &input;
  stages.mesh.reset();
  stages.replay.reset();
  stages.content = generate_workload(input.workload, {{3, 3, 3}, 2, {16, 16, 16}}, input.elements);
  stages.replay = replayed(stages.content);
  stages.mesh = std::make_unique<MeshUnderTest>(stages.replay->tree());
  stages.mesh->bricks();
  return stages;
}

std::size_t bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// Times `make`, and weighs what it returns.
template <typename Make>
void measure(benchmark::State& state, const Input& input, Make make) {
  const auto elements = static_cast<double>(stages_of(input).mesh->mesh().elements.size());
  const std::size_t before = bytes_in_use();
  std::size_t after = before;
  for (auto _ : state) {
    auto result = make(stages_of(input));
    benchmark::DoNotOptimize(result);
    state.PauseTiming();
    after = bytes_in_use();
    { const auto dropped = std::move(result); }
    state.ResumeTiming();
  }
  state.counters["elements"] = elements;
  state.counters["elements/s"] =
      benchmark::Counter(elements, benchmark::Counter::kIsIterationInvariantRate, benchmark::Counter::kIs1000);
  const double bytes = (static_cast<double>(after) - static_cast<double>(before)) / elements;
  if (bytes >= 1) state.counters["bytes/element"] = bytes;  // less is no structure of the mesh's size
}

template <typename Make>
void add(const Input& input, const std::string& stage, Make make) {
  const std::string name = std::string(input.name) + "/" + std::to_string(input.elements) + "/" + stage;
  benchmark::RegisterBenchmark(name.c_str(), [&input, make](benchmark::State& state) {
    measure(state, input, make);
  })->Unit(benchmark::kMillisecond);
}

void add_all(const Input& input) {
  add(input, "refine", [](const Stages& stages) { return replayed(stages.content); });
  add(input, "mesh_of", [](const Stages& stages) { return mesh_of(stages.replay->tree()); });
  add(input, "tsplines_of", [](const Stages& stages) { return tsplines_of(stages.mesh->mesh()); });
  add(input, "bricks_of", [](const Stages& stages) { return bricks_of(stages.mesh->splines()); });
  for (const Property& property : all_properties()) {
    add(input, property.id, [&property](const Stages& stages) { return decide(property, *stages.mesh); });
  }
}

}  // namespace
}  // namespace asts

int main(int argc, char** argv) {
  for (const asts::Input& input : asts::kInputs) asts::add_all(input);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
