#include "fuzz/campaign/unit_work.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <ctime>

#include "lib/exact/errors.hpp"
#include "lib/mesh/fnv1a.hpp"
#include "properties/case_meshes.hpp"
#include "reports/collection.hpp"
#include "reports/ledger_report.hpp"

namespace asts {

namespace {

/// Processor time, so that what is slow does not depend on what else the machine does.
class Stopwatch {
 public:
  std::int64_t microseconds() const {
    return static_cast<std::int64_t>(std::clock() - begin_) * 1'000'000 / CLOCKS_PER_SEC;
  }

 private:
  std::clock_t begin_ = std::clock();
};

std::int64_t volume_of(const Setting& setting) {
  std::int64_t volume = 1;
  for (const int side : setting.domain) volume *= side;
  return volume;
}

/// Whether the elements are the unit cubes of the domain.
bool is_initial(const Mesh& mesh) {
  if (static_cast<std::int64_t>(mesh.elements.size()) != volume_of(mesh.setting)) return false;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const std::vector<Rational>& lines = mesh.coordinates[axis];
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i] != static_cast<int>(i)) return false;
    }
  }
  return true;
}

/// A case that was drawn for a claim about sequences alone may have meshes that are too large to be looked at.
bool wants_meshes(const CampaignCase& one) { return one.only == nullptr || one.only->on_mesh != nullptr; }

/// The lowest power of 2 that is not less. REQUIRES: value >= 1.
std::int64_t power_above(std::int64_t value) {
  return static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(value)));
}

}  // namespace

UnitWork::UnitWork(const CampaignPlan& plan, std::int64_t unit, std::int64_t cases, std::vector<Skip> skipped,
                   UnitWatch watch)
    : plan_(plan), unit_(unit_of(plan, unit)), skipped_(std::move(skipped)), watch_(std::move(watch)) {
  record_.unit = unit;
  const auto make = [&](std::int64_t number) {
    if (!skips(number, "")) make_case(number);
  };
  if (unit_.kind == Unit::Kind::stored) {
    for (std::size_t i = 0; i < plan.stored.size(); ++i) {
      const std::int64_t number = -1 - static_cast<std::int64_t>(i);
      const bool skipped_now = skips(number, "") || skips(number, plan.stored[i].claim->id);
      if (!skipped_now) stored_.push_back(number);
    }
  } else if (unit_.kind == Unit::Kind::block) {
    const std::int64_t end = std::min(unit_.first_case + kBlockCases, cases);
    for (std::int64_t number = unit_.first_case; number < end; ++number) make(number);
    record_.end = end;
  }
}

void UnitWork::make_case(std::int64_t number) {
  const Stopwatch watch;
  watch_.at_mesh(number, -1);
  MadeCase made{number, campaign_case(plan_, number), 0, {}};
  const std::uint64_t drawn_for = made.made.only == nullptr ? 0 : fnv1a(made.made.only->id);
  if (wants_meshes(made.made)) {
    for_each_mesh(made.made.content, [&](std::size_t step, const MeshUnderTest& mesh) {
      watch_.at_mesh(number, static_cast<std::int64_t>(step));
      made.meshes.push_back(place_of(fingerprint_of(mesh.mesh()).low ^ drawn_for));
    });
  }
  made.microseconds = watch.microseconds();
  times_.total += made.microseconds;
  made_.push_back(std::move(made));
}

bool UnitWork::skips(std::int64_t number, std::string_view claim) const {
  return std::find(skipped_.begin(), skipped_.end(), Skip{number, std::string(claim)}) != skipped_.end();
}

std::size_t UnitWork::place_of(std::uint64_t mesh) {
  const auto [found, is_new] = places_.try_emplace(mesh, meshes_.size());
  if (is_new) meshes_.push_back(mesh);
  return found->second;
}

UnitRecord UnitWork::try_fresh(std::vector<bool> fresh) {
  fresh_ = std::move(fresh);
  Trials trials(plan_.claims, {nullptr, [this](std::size_t place) { return !skips(number_, plan_.claims[place]->id); },
                               [this](std::size_t place) { watch_.at_claim(*plan_.claims[place]); },
                               [this](std::size_t place, const TrialSubject* subject, const Verdict& verdict) {
                                 count_violation(place, subject, verdict);
                               }});
  if (unit_.kind == Unit::Kind::alone) {
    const Stopwatch watch;
    trials.alone(unit_.place, Extent::short_run);
    times_.total += watch.microseconds();
  }
  for (const std::int64_t number : stored_) decide_again(number);
  for (const MadeCase& made : made_) {
    const Stopwatch watch;
    try_case(made, trials);
    const std::int64_t time = watch.microseconds();
    times_.total += time;
    if (made.microseconds + time > times_.slowest) {
      times_.slowest = made.microseconds + time;
      times_.slowest_number = made.number;
    }
  }
  finish(trials);
  return std::move(record_);
}

/// Reports what is otherwise than a collection says.
void UnitWork::decide_again(std::int64_t number) {
  const StoredCase& stored = plan_.stored[static_cast<std::size_t>(-1 - number)];
  const auto steps = static_cast<std::int64_t>(stored.content.steps.size());
  watch_.at_mesh(number, steps);
  watch_.at_claim(*stored.claim);
  ++record_.cases;
  ++record_.biases[kStoredBias];
  const Statement statement{stored.claim, nullptr};
  const Verdict verdict = try_on_case(statement, stored.content).verdict;
  const std::string kind = verdict.witness ? kind_of(*verdict.witness) : std::string(kNotViolated);
  const bool as_recorded = expected_violated(statement)
                               ? verdict.witness && (stored.kind.empty() || stored.kind == kind)
                               : !verdict.witness && verdict.outcome != Outcome::undecided;
  if (as_recorded) return;
  record_.violations.push_back(
      {stored.claim->id, kind, number, steps, 1, stored.name + " was recorded otherwise: " + violation_text(verdict)});
}

void UnitWork::try_case(const MadeCase& made, Trials& trials) {
  const Case& content = made.made.content;
  number_ = made.number;
  ++record_.cases;
  ++record_.biases[made.made.bias];
  record_.meshes += static_cast<std::int64_t>(made.meshes.size());
  TrialSubject subject(made.number, content, made.made.bias.c_str());
  subject.only = made.made.only;
  const bool sequence = Trials::is_sequence(content);
  if (!wants_meshes(made.made)) return try_sequence(subject, trials);
  const auto is_fresh = [this](std::size_t place) { return static_cast<bool>(fresh_[place]); };
  if (!sequence && std::none_of(made.meshes.begin(), made.meshes.end(), is_fresh)) return;
  for_each_mesh(content, [&](std::size_t step, MeshUnderTest& mesh) {
    watch_.at_mesh(made.number, static_cast<std::int64_t>(step));
    subject.step = step;
    try_mesh(subject, mesh, made.meshes[step], trials);
  });
  if (sequence) try_sequence(subject, trials);
}

void UnitWork::try_sequence(TrialSubject& subject, Trials& trials) {
  ++record_.sequences;
  if (subject.bounds.grading == 0) {  // no mesh was looked at
    const Case& content = subject.whole;
    subject.bounds = {content.domain, content.degree, content.grading, 0, 0, 0};
    watch_.at_mesh(subject.number, static_cast<std::int64_t>(content.steps.size()));
  }
  subject.step = subject.whole.steps.size();
  trials.on_sequence(subject);
}

void UnitWork::try_mesh(TrialSubject& subject, MeshUnderTest& mesh, std::size_t place, Trials& trials) {
  const bool last = subject.step == subject.whole.steps.size();
  if (!fresh_[place] && !last) return;
  subject.looks_at(mesh, fingerprint_of(mesh.mesh()));
  if (!fresh_[place]) return;
  fresh_[place] = false;
  count_mesh(mesh);
  trials.on_mesh(subject, mesh);
}

void UnitWork::count_mesh(const MeshUnderTest& mesh) {
  const Setting& setting = mesh.mesh().setting;
  if (is_initial(mesh.mesh())) ++record_.trivial;
  ++record_.generated["level"][mesh.max_level().value_or(0)];
  ++record_.generated["elements"][power_above(static_cast<std::int64_t>(mesh.mesh().elements.size()))];
  ++record_.generated["grading"][setting.grading];
  ++record_.generated["degree"][*std::max_element(setting.degree.begin(), setting.degree.end())];
  ++record_.generated["volume"][power_above(volume_of(setting))];
}

void UnitWork::count_violation(std::size_t place, const TrialSubject* subject, const Verdict& verdict) {
  const std::string kind = kind_of(verdict.witness.value());
  UnitViolation& violation = violations_[{place, kind}];
  if (violation.count++ > 0) return;
  violation.claim = plan_.claims[place]->id;
  violation.kind = kind;
  if (subject == nullptr) {
    violation.says = violation_text(verdict);
  } else {
    violation.number = subject->number;
    violation.step = static_cast<std::int64_t>(subject->step);
  }
}

void UnitWork::finish(const Trials& trials) {
  for (const LedgerRecord& record : trials.records()) {
    if (record.trials() > 0) record_.records[record.claim] = record;
  }
  for (auto& [key, violation] : violations_) record_.violations.push_back(std::move(violation));
  for (const auto& time : trials.times()) {
    times_.claims.push_back(std::chrono::duration_cast<std::chrono::microseconds>(time).count());
  }
}

}  // namespace asts
