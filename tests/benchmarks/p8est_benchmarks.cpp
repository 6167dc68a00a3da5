#include "tests/benchmarks/measure.hpp"

#ifdef ASTS_P8EST

#include <p8est_bits.h>
#include <p8est_extended.h>

#include <algorithm>
#include <cstdlib>

/// p8est's refinement and 2:1 balance on the workload `sphere`: the same sphere, from the same 16^3 cubes on, which are
/// the octants of level 4 of a unit cube. An octant is split into eight if its closed box meets the sphere, down to the
/// level at which the balanced forest comes nearest to the number of elements. Balance is that across faces, edges and
/// corners (P8EST_CONNECT_FULL).
namespace asts::benchmarks {

namespace {

constexpr int kCubesLevel = 4;

struct Target {
  int level;
};

/// In units of the finest octants, measured from the sphere's centre.
int meets_sphere(p8est_t* forest, p4est_topidx_t, p8est_quadrant_t* octant) {
  if (octant->level >= static_cast<const Target*>(forest->user_pointer)->level) return 0;
  const std::int64_t length = P8EST_QUADRANT_LEN(octant->level);
  std::int64_t nearest = 0;
  std::int64_t farthest = 0;
  for (const p4est_qcoord_t coordinate : {octant->x, octant->y, octant->z}) {
    const std::int64_t lower = coordinate - P8EST_ROOT_LEN / 2;
    const std::int64_t upper = lower + length;
    const std::int64_t distance = std::max<std::int64_t>({0, lower, -upper});
    const std::int64_t reach = std::max(-lower, upper);
    nearest += distance * distance;
    farthest += reach * reach;
  }
  const std::int64_t radius = P8EST_ROOT_LEN / 4;
  return nearest <= radius * radius && radius * radius <= farthest ? 1 : 0;
}

/// MPI must run, though one process is all there is.
void start_once() {
  static const bool started = [] {
    sc_MPI_Init(nullptr, nullptr);
    sc_init(sc_MPI_COMM_SELF, 0, 0, nullptr, SC_LP_ERROR);
    p4est_init(nullptr, SC_LP_ERROR);
    std::atexit([] { sc_MPI_Finalize(); });
    return true;
  }();
  benchmark::DoNotOptimize(started);
}

class Forest {
 public:
  explicit Forest(int level)
      : target_{level},
        cube_(p8est_connectivity_new_unitcube()),
        forest_(p8est_new_ext(sc_MPI_COMM_SELF, cube_, 0, kCubesLevel, 1, 0, nullptr, &target_)) {}
  ~Forest() {
    p8est_destroy(forest_);
    p8est_connectivity_destroy(cube_);
  }
  Forest(const Forest&) = delete;
  Forest& operator=(const Forest&) = delete;

  void refine() { p8est_refine(forest_, 1, meets_sphere, nullptr); }
  void balance() { p8est_balance(forest_, P8EST_CONNECT_FULL, nullptr); }
  std::int64_t octants() const { return forest_->global_num_quadrants; }
  std::size_t bytes() const { return p8est_memory_used(forest_); }

 private:
  Target target_;
  p8est_connectivity_t* cube_;
  p8est_t* forest_;
};

std::int64_t balanced_octants(int level) {
  Forest forest(level);
  forest.refine();
  forest.balance();
  return forest.octants();
}

/// The level whose number of octants has the lower ratio to the number of elements; a level more makes some four times
/// as many.
int level_for(std::int64_t elements) {
  std::int64_t before = balanced_octants(kCubesLevel);
  for (int level = kCubesLevel + 1;; ++level) {
    const std::int64_t octants = balanced_octants(level);
    if (octants >= elements) return octants * before <= elements * elements ? level : level - 1;
    before = octants;
  }
}

void measure_forest(benchmark::State& state, std::int64_t elements, bool balanced) {
  start_once();
  const int level = level_for(elements);
  std::int64_t octants = 0;
  double bytes = 0;
  for (auto _ : state) {
    state.PauseTiming();
    auto forest = std::make_unique<Forest>(level);
    state.ResumeTiming();
    forest->refine();
    if (balanced) forest->balance();
    state.PauseTiming();
    octants = forest->octants();
    bytes = static_cast<double>(forest->bytes());
    forest.reset();
    state.ResumeTiming();
  }
  state.counters["elements"] = static_cast<double>(octants);
  state.counters["elements/s"] = rate(octants);
  state.counters["bytes/element"] = bytes / static_cast<double>(octants);
}

}  // namespace

void add_p8est_benchmarks() {
  for (const std::int64_t elements : {10'000, 100'000, 1'000'000}) {
    const std::string name = "p8est/sphere/" + std::to_string(elements);
    const auto add_run = [&](const char* stage, auto run, auto... arguments) {
      benchmark::RegisterBenchmark((name + stage).c_str(), run, arguments...)->Unit(benchmark::kMillisecond);
    };
    add_run("/refine", measure_forest, elements, false);
    add_run("/refine+balance", measure_forest, elements, true);
    const Input input{Workload::sphere, 3, 2, elements};
    add_run("/asts-refine", measure_refine, input);
    add_run("/asts-replay", measure_replay, input);
  }
}

}  // namespace asts::benchmarks

#else

namespace asts::benchmarks {

void add_p8est_benchmarks() {}

}  // namespace asts::benchmarks

#endif
