#include "lib/refine/refinement.hpp"
#include "properties/properties.hpp"
#include "tests/benchmarks/measure.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/reference/decide.hpp"

/// The literal code of tests/reference beside the library, on the same small cases: reference/CASE/STAGE and
/// reference/CASE/STAGE-literal.
namespace asts::benchmarks {

namespace {

/// A case of the literal code's size.
struct SmallCase {
  const char* name;
  Workload workload;
  Setting setting;
  std::int64_t elements;
  bool decided;  ///< not only refined
};

const SmallCase kCases[] = {
    {"sphere-8x8x8/1000", Workload::sphere, {{3, 3, 3}, 2, {8, 8, 8}}, 1'000, false},
    {"sphere-5x5x5/250", Workload::sphere, {{3, 3, 3}, 2, {5, 5, 5}}, 250, true},
    {"corner-5x5x5/1000", Workload::corner, {{3, 3, 3}, 2, {5, 5, 5}}, 1'000, true},
};

using Run = void (*)(const Case& content);

void refine_fast(const Case& content) { benchmark::DoNotOptimize(replayed(content)); }

void refine_literally(const Case& content) { benchmark::DoNotOptimize(literal::last_mesh(content)); }

/// Refinement and all five properties.
void check_fast(const Case& content) {
  const auto replay = replayed(content);
  MeshUnderTest mesh(replay->tree());
  for (const Property& property : all_properties()) benchmark::DoNotOptimize(decide(property, mesh));
}

void check_literally(const Case& content) {
  benchmark::DoNotOptimize(reference::decide(literal::setting(setting_of(content)), literal::last_mesh(content)));
}

void add_run(const SmallCase& small, const std::string& stage, Run run) {
  benchmark::RegisterBenchmark(("reference/" + std::string(small.name) + "/" + stage).c_str(),
                               [&small, run](benchmark::State& state) {
                                 const Case content = generate_workload(small.workload, small.setting, small.elements);
                                 for (auto _ : state) run(content);
                                 state.counters["elements"] = static_cast<double>(last_mesh(content).elements.size());
                               })
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

void add_reference_benchmarks() {
  for (const SmallCase& small : kCases) {
    add_run(small, "refine", refine_fast);
    add_run(small, "refine-literal", refine_literally);
    if (!small.decided) continue;
    add_run(small, "check", check_fast);
    add_run(small, "check-literal", check_literally);
  }
}

}  // namespace asts::benchmarks
