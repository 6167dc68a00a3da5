#include <set>

#include "lib/spline/dual_functional.hpp"
#include "tests/benchmarks/measure.hpp"

/// lambda_X(N_X~) for pairs of index vectors that occur in a mesh: cold, by a functional that has no value yet, and
/// warm, when it has them all.
namespace asts::benchmarks {

namespace {

constexpr std::size_t kMostPairs = 2'000;

using Vector = std::vector<Rational>;
using Pair = std::pair<Vector, Vector>;

Vector coordinates_of(MeshUnderTest& mesh, std::int32_t node, Axis axis) {
  Vector result;
  for (const std::int32_t rank : mesh.splines().index_vector(node, axis)) {
    result.push_back(mesh.mesh().coordinate(axis, rank));
  }
  return result;
}

/// Pairs along x of which none is the affine image of another one, of nodes one to eight places apart in the order of
/// the lines: most have supports that meet.
std::vector<Pair> pairs_of(MeshUnderTest& mesh, int degree) {
  DualFunctional functional(degree);
  const TSplines& splines = mesh.splines();
  const std::vector<std::int32_t>& order = splines.line_order[0];
  std::set<std::pair<std::int32_t, std::int32_t>> seen;
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < order.size() && pairs.size() < kMostPairs; ++i) {
    const std::size_t j = i + 1 + i % 8;
    if (j >= order.size()) break;
    const std::pair ids{splines.vector_ids[at(order[i])][0], splines.vector_ids[at(order[j])][0]};
    if (!seen.insert(ids).second) continue;
    Pair pair{coordinates_of(mesh, order[i], 0), coordinates_of(mesh, order[j], 0)};
    const std::size_t kept = functional.kept();
    functional.lambda(pair.first, pair.second);
    if (functional.kept() > kept) pairs.push_back(std::move(pair));
  }
  return pairs;
}

void evaluate_all(DualFunctional& functional, const std::vector<Pair>& pairs) {
  for (const auto& [x, x_tilde] : pairs) benchmark::DoNotOptimize(functional.lambda(x, x_tilde));
}

void measure_lambda(benchmark::State& state, const Input& input, bool warm) {
  const std::vector<Pair> pairs = pairs_of(prepared(input).mesh(), input.degree);
  auto functional = std::make_unique<DualFunctional>(input.degree);
  if (warm) evaluate_all(*functional, pairs);
  for (auto _ : state) {
    if (!warm) {
      state.PauseTiming();
      functional = std::make_unique<DualFunctional>(input.degree);
      state.ResumeTiming();
    }
    evaluate_all(*functional, pairs);
  }
  state.counters["pairs"] = static_cast<double>(pairs.size());
  state.counters["lambda/s"] = rate(static_cast<std::int64_t>(pairs.size()));
}

}  // namespace

void add_lambda_benchmarks(const Input& input) {
  for (const bool warm : {false, true}) {
    benchmark::RegisterBenchmark((input.name() + (warm ? "/lambda-warm" : "/lambda-cold")).c_str(), measure_lambda,
                                 input, warm)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace asts::benchmarks
