#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cli/check_directory.hpp"
#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/statements.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/case_prefix.hpp"
#include "lib/refine/replay.hpp"
#include "properties/sequence_under_test.hpp"
#include "reports/check_report.hpp"

namespace asts::cli {

namespace {

/// Longer cases are not repeated in every record of a violated mesh.
constexpr std::size_t kLongestMeshText = std::size_t{1} << 20;
/// Where only sequences are looked at, meshes are made for their figures as long as they are not larger.
constexpr std::int64_t kMostElementsForSequences = 1'000'000;
/// A point takes at least so many bytes of text, so that a case with too many of them need not be written to know.
constexpr std::size_t kLeastPointText = 6;

std::vector<const Property*> properties_to_decide(const CheckOptions& options) {
  if (!options.properties.empty() || !options.claims.empty()) return chosen_properties(options.properties);
  std::vector<const Property*> all;
  for (const Property& property : all_properties()) all.push_back(&property);
  return all;
}

/// A claim about meshes is decided for the mesh, one about sequences for the sequence up to it.
Trial decide_claim(const Claim& claim, const Case& test_case, std::int64_t step, MeshUnderTest& mesh) {
  if (claim.on_mesh != nullptr || claim.on_sequence == nullptr) return try_on_mesh(claim, mesh);
  return try_on_sequence(claim, case_prefix(test_case, static_cast<std::size_t>(step)));
}

/// The same as text; empty when it is too long.
std::string text_up_to(const Case& test_case, std::int64_t step) {
  const Case prefix = case_prefix(test_case, static_cast<std::size_t>(step));
  std::size_t points = 2 * prefix.elements.size();
  for (const Step& one : prefix.steps) points += one.marks.size();
  if (points > kLongestMeshText / kLeastPointText) return {};
  std::string text = write_case(prefix);
  return text.size() > kLongestMeshText ? std::string() : text;
}

class Checker {
 public:
  explicit Checker(const CheckOptions& options)
      : options_(options), properties_(properties_to_decide(options)), claims_(chosen_claims(options.claims)) {}

  /// Records what follows in a folder. Throws what CheckDirectory throws.
  void record_in(const std::string& folder, const std::vector<Input>& inputs) {
    directory_.emplace(folder,
                       CheckRun{ASTS_VERSION, options_.final_only, options_.pair_budget, properties_, claims_, {}, {}},
                       inputs);
  }

  void check_case(Input& input) {
    if (input.mesh) {
      MeshUnderTest mesh(std::move(*input.mesh));
      report(input, 0, mesh);
      return;
    }
    Replay replay(input.content, options_.jobs);
    SequenceUnderTest sequence(replay, options_.jobs);
    if (!options_.final_only || replay.done()) report(input, replay, sequence);
    while (!replay.done()) {
      stop_if_interrupted();
      show_progress(
          fmt::format("{}: step {}, {} elements", input.name, replay.counts().step + 1, replay.tree().element_count()));
      if (only_sequences() && replay.tree().element_count() > kMostElementsForSequences) {
        report_without_meshes(input, replay.counts().step + 1);
        return;
      }
      replay.advance();
      sequence.after_step();
      if (!options_.final_only || replay.done()) report(input, replay, sequence);
    }
  }

  /// For a person: how often each property came out how.
  std::string summary() const {
    std::string result = fmt::format("\n{:<20} {:>8} {:>9} {:>15} {:>10}\n", "property", "holds", "violated",
                                     "not-applicable", "undecided");
    const auto add = [&](const char* id) {
      const auto count = [&](Outcome outcome) {
        const auto found = tally_.find({id, outcome});
        return found == tally_.end() ? 0 : found->second;
      };
      result += fmt::format("{:<20} {:>8} {:>9} {:>15} {:>10}\n", id, count(Outcome::holds), count(Outcome::violated),
                            count(Outcome::not_applicable), count(Outcome::undecided));
    };
    for (const Property* property : properties_) add(property->id);
    for (const Claim* claim : claims_) add(claim->id);
    return result;
  }

  int exit_code() const {
    const auto any = [&](Outcome outcome) {
      return std::any_of(tally_.begin(), tally_.end(),
                         [&](const auto& entry) { return entry.first.second == outcome; });
    };
    return any(Outcome::violated) ? kViolated : any(Outcome::undecided) ? kFailure : kHolds;
  }

 private:
  /// A budget is counted in pairs of the whole mesh: with one, nothing is proven by other means.
  void report(const Input& input, const Replay& replay, SequenceUnderTest& sequence) {
    if (options_.pair_budget > 0) {
      report(input, replay.counts().step, sequence.mesh());
      return;
    }
    CheckRecord record;
    record.case_name = input.name;
    record.step = replay.counts().step;
    for (const Property* property : properties_) {
      stop_if_interrupted();
      record.entries.push_back({property, sequence.decide(*property)});
    }
    for (const Claim* claim : claims_) {
      stop_if_interrupted();
      record.claims.push_back({claim, decide_claim(*claim, input.content, record.step, sequence.mesh())});
    }
    record.mesh = {{replay.tree().element_count(), replay.tree().new_element_count(), replay.tree().max_level(),
                    sequence.active_nodes()}};
    finish(record, input);
  }

  /// Whether no mesh is needed for what was asked.
  bool only_sequences() const {
    return properties_.empty() &&
           std::all_of(claims_.begin(), claims_.end(), [](const Claim* claim) { return claim->on_mesh == nullptr; });
  }

  /// The remaining steps of a sequence whose meshes get too large to be made just for their figures.
  void report_without_meshes(const Input& input, std::int64_t first) {
    const auto last = static_cast<std::int64_t>(input.content.steps.size());
    for (std::int64_t step = options_.final_only ? last : first; step <= last; ++step) {
      stop_if_interrupted();
      show_progress(fmt::format("{}: step {}", input.name, step));
      CheckRecord record;
      record.case_name = input.name;
      record.step = step;
      for (const Claim* claim : claims_) {
        record.claims.push_back(
            {claim, try_on_sequence(*claim, case_prefix(input.content, static_cast<std::size_t>(step)))});
      }
      finish(record, input);
    }
  }

  void report(const Input& input, std::int64_t step, MeshUnderTest& mesh) {
    if (options_.pair_budget > 0) mesh.pair_budget = options_.pair_budget;
    CheckRecord record;
    record.case_name = input.name;
    record.step = step;
    for (const Property* property : properties_) {
      stop_if_interrupted();
      record.entries.push_back({property, decide(*property, mesh)});
    }
    for (const Claim* claim : claims_) {
      stop_if_interrupted();
      record.claims.push_back({claim, decide_claim(*claim, input.content, step, mesh)});
    }
    record.mesh = {{static_cast<std::int64_t>(mesh.mesh().elements.size()), mesh.new_elements(), mesh.max_level(),
                    static_cast<std::int64_t>(mesh.splines().size())}};
    finish(record, input);
  }

  /// Counts the verdicts and prints the record.
  void finish(CheckRecord& record, const Input& input) {
    bool violated = false;
    const auto count = [&](const char* id, Outcome outcome) {
      ++tally_[{id, outcome}];
      violated = violated || outcome == Outcome::violated;
    };
    for (const auto& entry : record.entries) count(entry.property->id, entry.verdict.outcome);
    for (const auto& entry : record.claims) count(entry.claim->id, entry.trial.verdict.outcome);
    const bool json = options_.format == Format::json;
    if (violated && (json || directory_)) record.mesh_case = text_up_to(input.content, record.step);
    const std::string line = json || directory_ ? check_json(record) : std::string();
    if (directory_) directory_->add(line);
    print(json ? line : check_text(record));
  }

  const CheckOptions& options_;
  std::vector<const Property*> properties_;
  std::vector<const Claim*> claims_;
  std::map<std::pair<std::string, Outcome>, std::int64_t> tally_;
  std::optional<CheckDirectory> directory_;
};

}  // namespace

int check(const CheckOptions& options) {
  Checker checker(options);
  std::vector<Input> inputs;
  for (const std::string& path : options.cases) inputs.push_back(read_input(path));
  if (!options.folder.empty()) checker.record_in(options.folder, inputs);
  for (Input& input : inputs) checker.check_case(input);
  if (options.format == Format::text) print(checker.summary());
  return checker.exit_code();
}

}  // namespace asts::cli
