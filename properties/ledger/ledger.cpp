#include "properties/ledger/ledger.hpp"

#include <algorithm>
#include <string_view>

#include "lib/exact/errors.hpp"
#include "lib/gen/case_stream.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "properties/ledger/mesh_features.hpp"

namespace asts {

namespace {

constexpr std::int64_t kShortCases = 1500;
constexpr std::int64_t kLongCases = 20'000;
/// The two inclusions of Theorem 6.6 are tried on a million random meshes each, and on larger ones than the rest, in
/// which supports also touch in an edge or a point; `./build.sh ledger` enumerates millions of small ones besides.
constexpr std::int64_t kManyCases = 650'000;

bool has_class(const Claim& claim, char letter) {
  return std::string_view(claim.meshes).find(letter) != std::string_view::npos;
}

/// Whether a claim is stated for meshes like this one. Every admissible mesh is one that subdivisions make, and each of
/// these is one of boxes.
bool is_stated_for(const Claim& claim, MeshUnderTest& mesh, bool explicit_boxes) {
  const bool only_boxes = std::string_view(claim.meshes) == "e";
  if (only_boxes) return explicit_boxes;
  if (std::string_view(claim.meshes).empty() || has_class(claim, 'e')) return true;
  if (mesh.outside_class()) return false;
  return has_class(claim, 'r') || mesh.admissible();
}

bool is_chosen(const Claim& claim, const Fingerprint& fingerprint) {
  return fingerprint.high % static_cast<std::uint64_t>(std::max(claim.stride, 1)) == 0;
}

LedgerBounds bounds_of(const Setting& setting, std::int32_t level, std::int64_t elements) {
  return {setting.domain, setting.degree, setting.grading, level, elements, 0};
}

}  // namespace

std::int64_t cases_for(const Claim& claim, Extent extent) {
  if (extent == Extent::short_run) return kShortCases;
  const std::string_view id = claim.id;
  return id == "as-implies-dc" || id == "dc-implies-as" ? kManyCases : kLongCases;
}

/// A random case, up to the mesh that is being tried.
struct Ledger::Subject {
  std::int64_t number;
  RandomCase random;
  std::size_t step = 0;
  Fingerprint fingerprint{};
  std::int64_t elements = 0;
  LedgerBounds bounds{};
  std::vector<std::string> features{};
  bool features_known = false;

  Case content() const {
    Case prefix = random.content;
    if (!prefix.explicit_mesh) prefix.steps.resize(step);
    return prefix;
  }
};

Ledger::Ledger(LedgerPlan plan, std::string (*describe)(const Verdict&))
    : plan_(std::move(plan)), describe_(describe), times_(plan_.claims.size()) {
  for (const Claim* claim : plan_.claims) {
    cases_.push_back(plan_.cases.value_or(cases_for(*claim, plan_.extent)));
    records_.emplace_back().claim = claim->id;
  }
}

void Ledger::run(const Watch& watch) {
  for (std::size_t place = 0; place < plan_.claims.size(); ++place) {
    const Claim& claim = *plan_.claims[place];
    if (claim.alone == nullptr || static_cast<int>(place) % plan_.shares != plan_.share) continue;
    watch(claim.id, 0, 1);
    ++records_[place].alone;
    count(place, timed(place, nullptr, [&] { return asts::try_alone(claim, plan_.extent); }), nullptr, nullptr);
  }
  std::int64_t total = 0;
  for (std::size_t place = 0; place < plan_.claims.size(); ++place) {
    const Claim& claim = *plan_.claims[place];
    if (claim.on_mesh != nullptr || claim.on_sequence != nullptr) total = std::max(total, cases_[place]);
  }
  for (std::int64_t number = 0; number < total; ++number) {
    watch("cases", number, total);
    try_case(number);
  }
}

void Ledger::try_case(std::int64_t number) {
  PlannedCase planned = plan_case(plan_.seed, number);
  const auto shares = static_cast<std::uint64_t>(plan_.shares);
  if (fingerprint_of(planned.setting).high % shares != static_cast<std::uint64_t>(plan_.share)) return;
  Subject subject{number, make_case(std::move(planned))};
  const Case& content = subject.random.content;
  if (content.explicit_mesh) {
    MeshUnderTest mesh(mesh_of(setting_of(content), content.elements));
    return try_mesh(subject, mesh);
  }
  Replay replay(content);
  while (true) {
    MeshUnderTest mesh(replay.tree());
    try_mesh(subject, mesh);
    if (replay.done()) break;
    replay.advance();
    ++subject.step;
  }
  const bool refines = std::all_of(content.steps.begin(), content.steps.end(),
                                   [](const Step& step) { return step.kind == Step::Kind::refine; });
  if (refines && !content.steps.empty()) try_sequence(subject);
}

void Ledger::try_mesh(Subject& subject, MeshUnderTest& mesh) {
  subject.fingerprint = fingerprint_of(mesh.mesh());
  subject.elements = static_cast<std::int64_t>(mesh.mesh().elements.size());
  if (!seen_.insert(subject.fingerprint).second) return;
  subject.bounds = bounds_of(mesh.mesh().setting, mesh.max_level().value_or(0), subject.elements);
  subject.features_known = false;
  for (std::size_t place = 0; place < plan_.claims.size(); ++place) {
    const Claim& claim = *plan_.claims[place];
    if (claim.on_mesh == nullptr || subject.number >= cases_[place] || subject.elements > claim.max_elements) continue;
    if (!is_chosen(claim, subject.fingerprint)) continue;
    if (!is_stated_for(claim, mesh, subject.random.content.explicit_mesh)) continue;
    ++records_[place].meshes;
    count(place, timed(place, &subject, [&] { return try_on_mesh(claim, mesh); }), &subject, &mesh);
  }
}

void Ledger::try_sequence(Subject& subject) {
  for (std::size_t place = 0; place < plan_.claims.size(); ++place) {
    const Claim& claim = *plan_.claims[place];
    if (claim.on_sequence == nullptr || subject.number >= cases_[place] || subject.elements > claim.max_elements) {
      continue;
    }
    if (!is_chosen(claim, subject.fingerprint)) continue;
    ++records_[place].sequences;
    const auto decide = [&] { return try_on_sequence(claim, subject.random.content); };
    count(place, timed(place, &subject, decide), &subject, nullptr);
  }
}

Trial Ledger::timed(std::size_t place, const Subject* subject, const std::function<Trial()>& decide) {
  const auto begin = std::chrono::steady_clock::now();
  try {
    const Trial trial = decide();
    times_[place] += std::chrono::steady_clock::now() - begin;
    return trial;
  } catch (const std::logic_error& error) {
    const std::string content = subject != nullptr ? "\n" + write_case(subject->content()) : "";
    throw InternalError(std::string(plan_.claims[place]->id) + ": " + error.what() + content);
  }
}

void Ledger::count(std::size_t place, const Trial& trial, Subject* subject, MeshUnderTest* mesh) {
  LedgerRecord one;
  one.claim = plan_.claims[place]->id;
  one.met = trial.met;
  one.trials_met = trial.met > 0;
  const Outcome outcome = trial.verdict.outcome;
  one.holds = outcome == Outcome::holds;
  one.violated = outcome == Outcome::violated;
  one.not_applicable = outcome == Outcome::not_applicable;
  one.undecided = outcome == Outcome::undecided;
  if (subject != nullptr && one.holds + one.violated > 0) {
    one.biases[bias_name(subject->random.bias)] = 1;
    one.bounds = subject->bounds;
    if (mesh != nullptr) {
      if (!subject->features_known) subject->features = features_of(*mesh);
      subject->features_known = true;
      for (const std::string& feature : subject->features) one.features[feature] = 1;
      one.bounds.active_nodes = mesh->splines().size();
    }
  }
  if (one.violated > 0) {
    LedgerViolation violation;
    if (subject != nullptr) violation.content = subject->content();
    const auto& smallest = records_[place].smallest;
    if (!smallest || is_smaller(violation, *smallest)) {
      violation.says = describe_(trial.verdict);
      one.smallest = std::move(violation);
    }
  }
  merge(records_[place], one);
}

}  // namespace asts
