#include "properties/ledger/ledger.hpp"

#include <algorithm>
#include <string_view>

#include "lib/gen/case_stream.hpp"
#include "properties/case_meshes.hpp"

namespace asts {

namespace {

constexpr std::int64_t kShortCases = 1500;
constexpr std::int64_t kLongCases = 20'000;
/// The two inclusions of Theorem 6.6 are tried on a million random meshes each, and on larger ones than the rest, in
/// which supports also touch in an edge or a point; `./build.sh ledger` enumerates millions of small ones besides.
constexpr std::int64_t kManyCases = 650'000;

}  // namespace

std::int64_t cases_for(const Claim& claim, Extent extent) {
  if (extent == Extent::short_run) return kShortCases;
  const std::string_view id = claim.id;
  return id == "as-implies-dc" || id == "dc-implies-as" ? kManyCases : kLongCases;
}

Ledger::Ledger(LedgerPlan plan, std::string (*describe)(const Verdict&))
    : plan_(std::move(plan)),
      trials_(plan_.claims, {describe, [this](std::size_t place) { return has_cases_for(place, number_); }, {}, {}}) {
  for (const Claim* claim : plan_.claims) cases_.push_back(plan_.cases.value_or(cases_for(*claim, plan_.extent)));
}

void Ledger::run(const Watch& watch) {
  for (std::size_t place = 0; place < plan_.claims.size(); ++place) {
    const Claim& claim = *plan_.claims[place];
    if (claim.alone == nullptr || static_cast<int>(place) % plan_.shares != plan_.share) continue;
    watch(claim.id, 0, 1);
    trials_.alone(place, plan_.extent);
  }
  std::int64_t total = 0;
  for (std::size_t place = 0; place < plan_.claims.size(); ++place) {
    const Claim& claim = *plan_.claims[place];
    if (claim.on_mesh != nullptr || claim.on_sequence != nullptr) total = std::max(total, cases_[place]);
  }
  for (number_ = 0; number_ < total; ++number_) {
    watch("cases", number_, total);
    try_case(number_);
  }
}

void Ledger::try_case(std::int64_t number) {
  PlannedCase planned = plan_case(plan_.seed, number);
  const auto shares = static_cast<std::uint64_t>(plan_.shares);
  if (fingerprint_of(planned.setting).high % shares != static_cast<std::uint64_t>(plan_.share)) return;
  const RandomCase random = make_case(std::move(planned));
  TrialSubject subject(number, random.content, bias_name(random.bias));
  for_each_mesh(random.content, [&](std::size_t step, MeshUnderTest& mesh) {
    subject.step = step;
    try_mesh(subject, mesh);
  });
  if (Trials::is_sequence(random.content)) trials_.on_sequence(subject);
}

void Ledger::try_mesh(TrialSubject& subject, MeshUnderTest& mesh) {
  subject.looks_at(mesh, fingerprint_of(mesh.mesh()));
  if (seen_.insert(subject.fingerprint).second) trials_.on_mesh(subject, mesh);
}

}  // namespace asts
