#include "properties/properties.hpp"
#include "tests/benchmarks/measure.hpp"

/// From the refinement tree to the verdicts: each stage without those before it, and the whole check of one mesh.
namespace asts::benchmarks {

namespace {

using MeshPointer = std::unique_ptr<MeshUnderTest>;

/// A mesh whose properties have not been decided, with what they are decided from.
MeshPointer undecided(Prepared& prepared) {
  auto mesh = std::make_unique<MeshUnderTest>(prepared.tree());
  mesh->bricks();
  return mesh;
}

int holding(MeshUnderTest& mesh) {
  int count = 0;
  for (const Property& property : all_properties()) {
    count += decide(property, mesh).outcome == Outcome::holds ? 1 : 0;
  }
  return count;
}

/// How the nodes' bytes an element are shared out: the nodes with the numbers of their vectors and their order along
/// lines, and the vectors, each once.
void measure_nodes(benchmark::State& state, const Input& input) {
  Prepared& shared = prepared(input);
  measure(
      state, shared.elements(), [&] { return &shared.mesh().mesh(); },
      [](const Mesh* mesh) { return tsplines_of(*mesh); });
  const TSplines& splines = shared.mesh().splines();
  std::size_t entries = 0;
  std::size_t vectors = 0;
  for (const IndexVectors& one : splines.vectors) {
    vectors += static_cast<std::size_t>(one.size());
    entries += static_cast<std::size_t>(one.size()) * one.length();
  }
  const std::size_t node_bytes =
      splines.nodes.size() * (2 * sizeof(PerAxis<std::int32_t>) + kDimension * sizeof(std::int32_t));
  const auto elements = static_cast<double>(shared.elements());
  state.counters["nodes"] = static_cast<double>(splines.nodes.size());
  state.counters["vectors"] = static_cast<double>(vectors);
  state.counters["node_bytes/element"] = static_cast<double>(node_bytes) / elements;
  state.counters["vector_bytes/element"] = static_cast<double>(entries * sizeof(std::int32_t)) / elements;
}

void measure_bricks(benchmark::State& state, const Input& input) {
  Prepared& shared = prepared(input);
  measure(
      state, shared.elements(), [&] { return &shared.mesh().splines(); },
      [](const TSplines* splines) { return bricks_of(*splines); });
  const Bricks& bricks = shared.mesh().bricks();
  state.counters["bricks"] = static_cast<double>(bricks.bricks.size());
  state.counters["pairs"] = static_cast<double>(bricks.pairs.size());
}

}  // namespace

void add_spline_benchmarks(const Input& input) {
  const auto add_measured = [&](const char* stage, void (*run)(benchmark::State&, const Input&)) {
    benchmark::RegisterBenchmark((input.name() + "/" + stage).c_str(), run, input)->Unit(benchmark::kMillisecond);
  };
  add(
      input, "mesh", [](Prepared& prepared) { return &prepared.tree(); },
      [](const RefinementTree* tree) { return mesh_of(*tree); });
  add_measured("nodes", measure_nodes);
  add_measured("bricks", measure_bricks);
  for (const Property& property : all_properties()) {
    add(input, property.id, undecided, [&property](MeshPointer& mesh) { return decide(property, *mesh); });
  }
  add(
      input, "check", [](Prepared& prepared) { return &prepared.tree(); },
      [](const RefinementTree* tree) {
        auto mesh = std::make_unique<MeshUnderTest>(*tree);
        benchmark::DoNotOptimize(holding(*mesh));
        return mesh;
      });
}

}  // namespace asts::benchmarks
