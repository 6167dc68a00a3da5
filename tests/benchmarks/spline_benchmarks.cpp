#include "properties/sequence_under_test.hpp"
#include "tests/benchmarks/measure.hpp"

/// From the refinement tree to the verdicts: as `asts check` decides them, and plainly, on the whole mesh and stage by
/// stage, as it decides what does not hold, explicit meshes and claims.
namespace asts::benchmarks {

namespace {

using MeshPointer = std::unique_ptr<MeshUnderTest>;

/// A mesh whose properties have not been decided, with what they are decided from.
MeshPointer undecided(Prepared& prepared) {
  auto mesh = std::make_unique<MeshUnderTest>(prepared.tree());
  mesh->bricks();
  return mesh;
}

template <typename Subject, typename Decide>
int count_holding(Subject& subject, Decide decide) {
  int count = 0;
  for (const Property& property : all_properties()) {
    count += decide(subject, property).outcome == Outcome::holds ? 1 : 0;
  }
  return count;
}

/// Everything that is made on the way stays, so that it is weighed.
std::unique_ptr<SequenceUnderTest> checked(const Replay* replay) {
  auto sequence = std::make_unique<SequenceUnderTest>(*replay);
  benchmark::DoNotOptimize(count_holding(
      *sequence, [](SequenceUnderTest& subject, const Property& property) { return subject.decide(property); }));
  return sequence;
}

MeshPointer checked_plainly(const RefinementTree* tree) {
  auto mesh = std::make_unique<MeshUnderTest>(*tree);
  benchmark::DoNotOptimize(
      count_holding(*mesh, [](MeshUnderTest& subject, const Property& property) { return decide(property, subject); }));
  return mesh;
}

/// The active nodes with their index vectors, zone by zone.
std::unique_ptr<Zones> zones_of(const RefinementTree* tree) {
  auto zones = std::make_unique<Zones>(*tree);
  zones->rebuild(1);
  return zones;
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
  const auto tree = [](Prepared& prepared) { return &prepared.tree(); };
  const auto replay = [](Prepared& prepared) { return &prepared.replay(); };
  add(input, "zones", tree, zones_of);
  for (const Property& property : all_properties()) {
    add(input, property.id, replay,
        [&property](const Replay* sequence) { return SequenceUnderTest(*sequence).decide(property); });
  }
  add(input, "check", replay, checked);
  add(input, "mesh", tree, [](const RefinementTree* of) { return mesh_of(*of); });
  add_measured("nodes", measure_nodes);
  add_measured("bricks", measure_bricks);
  for (const Property& property : all_properties()) {
    auto* const plain = add(input, std::string("plain-") + property.id, undecided,
                            [&property](MeshPointer& mesh) { return decide(property, *mesh); });
    // What is not timed, the mesh with its nodes, takes up to a thousand times longer than what is.
    if (input.elements >= 100'000) plain->Iterations(3);
  }
  add(input, "plain-check", tree, checked_plainly);
}

}  // namespace asts::benchmarks
