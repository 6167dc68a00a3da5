#include <numeric>

#include "cli/trial_chain.hpp"
#include "fuzz/campaign/unit_work.hpp"
#include "lib/gen/draw.hpp"
#include "lib/gen/growing_case.hpp"
#include "lib/minimize/minimize.hpp"
#include "tests/benchmarks/measure.hpp"

/// What campaigns consist of: enumerations, blocks of random cases, minimizations.
namespace asts::benchmarks {

namespace {

/// As `asts enumerate` does it.
void measure_enumeration(benchmark::State& state, const Enumeration& enumeration,
                         const std::vector<cli::MeshStatement>& statements) {
  std::int64_t meshes = 0;
  std::vector<const cli::MeshStatement*> tried;
  for (const cli::MeshStatement& statement : statements) tried.push_back(&statement);
  for (auto _ : state) {
    meshes = 0;
    cli::TrialChain chain(tried);
    enumerate_meshes(enumeration, [&](const EnumeratedMesh& mesh) {
      benchmark::DoNotOptimize(chain.results(mesh));
      meshes += mesh.reflections;
    });
  }
  state.counters["meshes"] = static_cast<double>(meshes);
  state.counters["meshes/s"] = rate(meshes);
}

void add_enumeration(int max_subdivisions, bool up_to_reflection, const std::string& what,
                     const std::vector<cli::MeshStatement>& statements) {
  const Enumeration enumeration{{{3, 3, 3}, 2, {4, 4, 5}}, max_subdivisions, false, up_to_reflection};
  const std::string name = "enumerate/4x4x5/p3/m2/K" + std::to_string(max_subdivisions) + "/" + what +
                           (up_to_reflection ? "" : "/every-mesh");
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    measure_enumeration(state, enumeration, statements);
  })->Unit(benchmark::kMillisecond);
}

void add_enumerations() {
  const std::vector<cli::MeshStatement> one{cli::statement_of(*find_claim("as-implies-dc"))};
  for (const int subdivisions : {2, 3}) {
    for (const bool symmetry : {true, false}) add_enumeration(subdivisions, symmetry, "as-implies-dc", one);
  }
  std::vector<cli::MeshStatement> all;
  for (const Claim& claim : all_claims()) {
    if (claim.on_mesh != nullptr) all.push_back(cli::statement_of(claim));
  }
  add_enumeration(1, false, "all-claims", all);  // most of them must be tried on every mesh
}

CampaignPlan plan_of_all_claims() {
  CampaignPlan plan;
  for (const Claim& claim : all_claims()) plan.claims.push_back(&claim);
  return plan;
}

/// One block of 64 random cases, as a worker of `asts campaign` does it: the cases are made, and all claims tried on
/// their meshes. An evaluation is a trial of one claim.
void measure_campaign(benchmark::State& state, std::int64_t block) {
  const CampaignPlan plan = plan_of_all_claims();
  const UnitWatch watch{[](std::int64_t, std::int64_t) {}, [](const Claim&) {}};
  std::int64_t unit = 0;
  while (unit_of(plan, unit).kind != Unit::Kind::block) ++unit;
  std::int64_t meshes = 0;
  std::int64_t evaluations = 0;
  for (auto _ : state) {
    UnitWork work(plan, unit + block, (block + 1) * kBlockCases, {}, watch);
    meshes = static_cast<std::int64_t>(work.meshes().size());
    const UnitRecord record = work.try_fresh(std::vector<bool>(work.meshes().size(), true));
    evaluations = 0;
    for (const auto& [claim, one] : record.records) evaluations += one.trials();
  }
  state.counters["meshes"] = static_cast<double>(meshes);
  state.counters["meshes/s"] = rate(meshes);
  state.counters["evaluations/s"] = rate(evaluations);
}

/// The two subdivisions of reports/findings/as-implies-dc.case, and after them, anywhere, up to 24 more that leave the
/// claim violated.
Case grown_violation(const Statement& statement) {
  GrowingCase growing({{3, 3, 3}, 2, {4, 4, 5}}, 250);
  const auto subdivide_at = [&](const Rational& x) {
    const std::int32_t leaf = growing.tree().leaf_at({CompactRational(x), CompactRational(1), CompactRational(1)});
    growing.add(Step::Kind::subdivide, std::span(&leaf, 1));
  };
  subdivide_at(1);
  subdivide_at(Rational(3) / 2);
  Draw draw(1);
  for (int tries = 0; tries < 200 && growing.content().steps.size() < 26; ++tries) {
    GrowingCase next = growing;
    const std::int32_t leaf = draw.choose(leaves_of(next.tree()));
    next.add(Step::Kind::subdivide, std::span(&leaf, 1));
    if (violation_of(statement, next.content())) growing = std::move(next);
  }
  return growing.content();
}

void measure_minimization(benchmark::State& state) {
  const Statement statement = *find_statement("as-implies-dc");
  const Case start = grown_violation(statement);
  std::int64_t evaluations = 0;
  for (auto _ : state) {
    const Minimized minimized =
        minimize(start, PathForm::mesh, [&](const Case& one) { return violation_of(statement, one); }, {});
    evaluations = minimized.evaluations;
  }
  state.counters["steps"] = static_cast<double>(start.steps.size());
  state.counters["evaluations"] = static_cast<double>(evaluations);
  state.counters["evaluations/s"] = rate(evaluations);
}

}  // namespace

void add_search_benchmarks() {
  add_enumerations();
  for (const std::int64_t block : {0, 1, 2}) {
    benchmark::RegisterBenchmark(("campaign/block-" + std::to_string(block)).c_str(), measure_campaign, block)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::RegisterBenchmark("minimize/as-implies-dc", measure_minimization)->Unit(benchmark::kMillisecond);
}

}  // namespace asts::benchmarks
