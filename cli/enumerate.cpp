#include "lib/gen/enumerate.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.hpp"
#include "cli/setting_options.hpp"
#include "cli/statements.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "reports/enumerate_report.hpp"

namespace asts::cli {

namespace {

/// A line of progress for every so many meshes.
constexpr std::int64_t kProgress = 256;

std::vector<const Claim*> claims_to_decide(const EnumerateOptions& options) {
  std::vector<const Claim*> claims = chosen_claims(options.claims);
  for (const Claim* claim : claims) {
    if (claim->on_mesh == nullptr) throw InputError(fmt::format("claim '{}' is not about one mesh", claim->id));
  }
  if (!options.claims.empty() || !options.properties.empty()) return claims;
  for (const Claim& claim : all_claims()) {
    if (claim.on_mesh != nullptr) claims.push_back(&claim);
  }
  return claims;
}

/// Counts the verdicts of one claim or property.
class Tally {
 public:
  Tally(const char* kind, const char* id) { record_.kind = kind, record_.id = id; }

  const EnumerationRecord& record() const { return record_; }

  void count(const EnumeratedMesh& mesh, Outcome outcome) {
    record_.meshes += mesh.reflections;
    if (outcome == Outcome::not_applicable) record_.not_applicable += mesh.reflections;
    if (outcome == Outcome::undecided) record_.undecided += mesh.reflections;
    if (outcome != Outcome::violated) return;
    record_.violations += mesh.reflections;
    // meshes with as many subdivisions come in the canonical order: the first one stays
    if (record_.smallest && mesh.subdivided.size() >= fewest_) return;
    fewest_ = mesh.subdivided.size();
    record_.smallest = write_case(case_of(mesh));
  }

  void count(const EnumeratedMesh& mesh, const Trial& trial) {
    record_.met = record_.met.value_or(0) + trial.met * mesh.reflections;
    count(mesh, trial.verdict.outcome);
  }

 private:
  EnumerationRecord record_;
  std::size_t fewest_ = 0;
};

class Enumerator {
 public:
  explicit Enumerator(const EnumerateOptions& options)
      : properties_(chosen_properties(options.properties)), claims_(claims_to_decide(options)) {
    for (const Property* property : properties_) tallies_.emplace_back("property", property->id);
    for (const Claim* claim : claims_) tallies_.emplace_back("claim", claim->id);
  }

  void visit(const EnumeratedMesh& enumerated) {
    stop_if_interrupted();
    meshes_ += enumerated.reflections;
    if (++visits_ % kProgress == 0) show_progress(fmt::format("{} meshes", meshes_));
    MeshUnderTest mesh(enumerated.tree);
    auto tally = tallies_.begin();
    for (const Property* property : properties_) (tally++)->count(enumerated, decide(*property, mesh).outcome);
    for (const Claim* claim : claims_) (tally++)->count(enumerated, try_on_mesh(*claim, mesh));
  }

  void report(Format format) const {
    if (format == Format::json) {
      for (const Tally& tally : tallies_) print(enumeration_json(tally.record()));
      return;
    }
    print(enumeration_text_header());
    for (const Tally& tally : tallies_) print(enumeration_text(tally.record()));
    for (const Tally& tally : tallies_) print(smallest_text(tally.record()));
  }

  int exit_code() const {
    const auto any = [&](auto count) {
      return std::any_of(tallies_.begin(), tallies_.end(),
                         [&](const Tally& tally) { return tally.record().*count > 0; });
    };
    return any(&EnumerationRecord::violations) ? kViolated : any(&EnumerationRecord::undecided) ? kFailure : kHolds;
  }

 private:
  std::vector<const Property*> properties_;
  std::vector<const Claim*> claims_;
  std::vector<Tally> tallies_;
  std::int64_t visits_ = 0;
  std::int64_t meshes_ = 0;
};

}  // namespace

int enumerate(const EnumerateOptions& options) {
  const Enumeration enumeration{checked_setting(options.setting), options.max_subdivisions, options.admissible,
                                !options.no_symmetry};
  Enumerator enumerator(options);
  enumerate_meshes(enumeration, [&](const EnumeratedMesh& mesh) { enumerator.visit(mesh); });
  enumerator.report(options.format);
  return enumerator.exit_code();
}

}  // namespace asts::cli
