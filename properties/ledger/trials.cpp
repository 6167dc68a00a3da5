#include "properties/ledger/trials.hpp"

#include <algorithm>
#include <string_view>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/case_prefix.hpp"
#include "properties/ledger/mesh_features.hpp"

namespace asts {

namespace {

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

}  // namespace

Case TrialSubject::content() const { return case_prefix(whole, step); }

void TrialSubject::looks_at(const MeshUnderTest& mesh, const Fingerprint& mesh_fingerprint) {
  const Setting& setting = mesh.mesh().setting;
  fingerprint = mesh_fingerprint;
  elements = static_cast<std::int64_t>(mesh.mesh().elements.size());
  bounds = {setting.domain, setting.degree, setting.grading, mesh.max_level().value_or(0), elements, 0};
  features_known = false;
}

Trials::Trials(std::vector<const Claim*> claims, Options options)
    : claims_(std::move(claims)), options_(std::move(options)), times_(claims_.size()) {
  for (const Claim* claim : claims_) records_.emplace_back().claim = claim->id;
}

bool Trials::is_sequence(const Case& content) {
  const auto refines = [](const Step& step) { return step.kind == Step::Kind::refine; };
  return !content.steps.empty() && std::all_of(content.steps.begin(), content.steps.end(), refines);
}

bool Trials::wants(std::size_t place, const TrialSubject& subject) const {
  if (options_.wanted && !options_.wanted(place)) return false;
  const Claim& claim = *claims_[place];
  if (subject.only != nullptr) return subject.only == &claim;
  return subject.elements <= claim.max_elements && is_chosen(claim, subject.fingerprint);
}

void Trials::on_mesh(TrialSubject& subject, MeshUnderTest& mesh) {
  for (std::size_t place = 0; place < claims_.size(); ++place) {
    const Claim& claim = *claims_[place];
    if (claim.on_mesh == nullptr || !wants(place, subject)) continue;
    if (subject.only == nullptr && !is_stated_for(claim, mesh, subject.whole.explicit_mesh)) continue;
    ++records_[place].meshes;
    count(place, timed(place, &subject, [&] { return try_on_mesh(claim, mesh); }), &subject, &mesh);
  }
}

void Trials::on_sequence(TrialSubject& subject) {
  for (std::size_t place = 0; place < claims_.size(); ++place) {
    const Claim& claim = *claims_[place];
    if (claim.on_sequence == nullptr || !wants(place, subject)) continue;
    ++records_[place].sequences;
    count(place, timed(place, &subject, [&] { return try_on_sequence(claim, subject.whole); }), &subject, nullptr);
  }
}

void Trials::alone(std::size_t place, Extent extent) {
  const Claim& claim = *claims_[place];
  ++records_[place].alone;
  count(place, timed(place, nullptr, [&] { return try_alone(claim, extent); }), nullptr, nullptr);
}

Trial Trials::timed(std::size_t place, const TrialSubject* subject, const std::function<Trial()>& decide) {
  if (options_.begins) options_.begins(place);
  const auto begin = std::chrono::steady_clock::now();
  try {
    const Trial trial = decide();
    times_[place] += std::chrono::steady_clock::now() - begin;
    return trial;
  } catch (const std::logic_error& error) {
    const std::string content = subject != nullptr ? "\n" + write_case(subject->content()) : "";
    throw InternalError(std::string(claims_[place]->id) + ": " + error.what() + content);
  }
}

void Trials::count(std::size_t place, const Trial& trial, TrialSubject* subject, MeshUnderTest* mesh) {
  LedgerRecord one;
  one.claim = claims_[place]->id;
  one.met = trial.met;
  one.trials_met = trial.met > 0;
  const Outcome outcome = trial.verdict.outcome;
  one.holds = outcome == Outcome::holds;
  one.violated = outcome == Outcome::violated;
  one.not_applicable = outcome == Outcome::not_applicable;
  one.undecided = outcome == Outcome::undecided;
  if (subject != nullptr && one.holds + one.violated > 0) count_subject(one, *subject, mesh);
  if (one.violated > 0) count_violation(place, trial.verdict, subject, one);
  merge(records_[place], one);
}

void Trials::count_subject(LedgerRecord& one, TrialSubject& subject, MeshUnderTest* mesh) const {
  one.biases[subject.bias] = 1;
  one.bounds = subject.bounds;
  if (mesh == nullptr) return;
  if (!subject.features_known) subject.features = features_of(*mesh);
  subject.features_known = true;
  for (const std::string& feature : subject.features) one.features[feature] = 1;
  one.bounds.active_nodes = mesh->splines().size();
}

void Trials::count_violation(std::size_t place, const Verdict& verdict, const TrialSubject* subject,
                             LedgerRecord& one) const {
  if (options_.violated) options_.violated(place, subject, verdict);
  if (options_.describe == nullptr) return;
  LedgerViolation violation;
  if (subject != nullptr) violation.content = subject->content();
  const auto& smallest = records_[place].smallest;
  if (smallest && !is_smaller(violation, *smallest)) return;
  violation.says = options_.describe(verdict);
  one.smallest = std::move(violation);
}

}  // namespace asts
