#include "lib/gen/growing_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/patch_search.hpp"
#include "lib/refine/refinement.hpp"
#include "tests/benchmarks/measure.hpp"

/// From a case's text to the refinement tree, and the two queries that refinement consists of.
namespace asts::benchmarks {

namespace {

/// A case as `asts refine` comes by its last mesh.
struct ReadAndReplayed {
  explicit ReadAndReplayed(const std::string& text) : content(parse_case(text, "text")), replay(replayed(content)) {}

  Case content;
  std::unique_ptr<Replay> replay;
};

/// One element in so many of the finest level asks for the coarser ones of its patch.
constexpr std::size_t kAskOneIn = 64;

std::vector<std::int32_t> finest_leaves(const RefinementTree& tree) {
  std::vector<std::int32_t> result;
  std::size_t place = 0;
  for (const std::int32_t leaf : leaves_of(tree)) {
    if (tree.node(leaf).level == tree.max_level() && place++ % kAskOneIn == 0) result.push_back(leaf);
  }
  return result;
}

/// The coarser elements in the patches of the finest elements: what Algorithm 2.8 and Definition 3.1 ask. The counters
/// are the elements that ask, a second, and how many are found for each.
void measure_patches(benchmark::State& state, const Input& input) {
  const RefinementTree& tree = prepared(input).tree();
  const std::vector<std::int32_t> asking = finest_leaves(tree);
  std::int64_t found = 0;
  for (auto _ : state) {
    found = 0;
    PatchSearch search(tree);
    search.coarser_in_patches(asking, tree.max_level(), [&](const PatchSearch::Coarser& coarser) {
      found += std::popcount(coarser.too_fine.members);
      return true;
    });
    benchmark::DoNotOptimize(found);
  }
  state.counters["patches/s"] = rate(static_cast<std::int64_t>(asking.size()));
  state.counters["coarser/patch"] = static_cast<double>(found) / static_cast<double>(asking.size());
}

/// The closure of the last step's marks, alone (Algorithm 2.8).
void measure_closure(benchmark::State& state, const Input& input) {
  Prepared& shared = prepared(input);
  std::vector<std::int32_t> marks;
  for (const Point& mark : shared.content().steps.back().marks) marks.push_back(shared.tree_before().leaf_at(mark));
  std::int64_t closed = 0;
  for (auto _ : state) {
    state.PauseTiming();
    RefinementTree tree = shared.tree_before();
    state.ResumeTiming();
    closed = static_cast<std::int64_t>(mark_closure(tree, marks).size());
    state.PauseTiming();
    { const RefinementTree dropped = std::move(tree); }
    state.ResumeTiming();
  }
  state.counters["marks"] = static_cast<double>(marks.size());
  state.counters["closed"] = static_cast<double>(closed);
  state.counters["closed/s"] = rate(closed);
}

}  // namespace

void measure_refine(benchmark::State& state, const Input& input) {
  Prepared& shared = prepared(input);
  measure(
      state, shared.elements(), [&] { return &shared.content(); },
      [](const Case* content) { return replayed(*content); });
}

void measure_replay(benchmark::State& state, const Input& input) {
  Prepared& shared = prepared(input);
  measure(
      state, shared.elements(), [&] { return &shared.text(); },
      [](const std::string* text) { return std::make_unique<ReadAndReplayed>(*text); });
}

void add_refinement_benchmarks(const Input& input) {
  add(
      input, "read", [](Prepared& prepared) { return &prepared.text(); },
      [](const std::string* text) { return parse_case(*text, "text"); });
  const auto add_measured = [&](const char* stage, void (*run)(benchmark::State&, const Input&)) {
    benchmark::RegisterBenchmark((input.name() + "/" + stage).c_str(), run, input)->Unit(benchmark::kMillisecond);
  };
  add_measured("refine", measure_refine);
  add_measured("replay", measure_replay);
  add_measured("closure", measure_closure);
  add_measured("patches", measure_patches);
}

}  // namespace asts::benchmarks
