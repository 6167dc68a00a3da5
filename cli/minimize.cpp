#include <fmt/format.h>

#include <filesystem>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/output_file.hpp"
#include "cli/statements.hpp"
#include "cli/terminal.hpp"
#include "cli/trial_chain.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "reports/case_snippet.hpp"
#include "reports/collection.hpp"
#include "reports/minimize_report.hpp"
#include "reports/slice_svg.hpp"

namespace asts::cli {

namespace {

Statement statement_named(const MinimizeOptions& options) {
  require(options.claim.empty() != options.property.empty(), "one of --claim and --property is needed");
  if (!options.property.empty()) return {nullptr, chosen_properties({options.property}).front()};
  const Claim* claim = chosen_claims({options.claim}).front();
  if (claim->on_mesh == nullptr && claim->on_sequence == nullptr) {
    throw InputError("'" + options.claim + "' is about no case");
  }
  return {claim, nullptr};
}

/// Opens a file that must not be the input.
std::optional<OutputFile> open_beside(const std::string& path, const std::string& input) {
  if (path.empty()) return std::nullopt;
  if (same_file(path, input)) throw InputError(path + ": is the case that is to be minimized");
  return std::optional<OutputFile>(std::in_place, path);
}

/// Whether all meshes of a setting are settled by the initial one: a statement that depends on nothing but active nodes
/// and their vectors says the same of all of them when there is no active node, as the active region is empty.
bool settles_all(const MeshStatement& statement, const Setting& setting) {
  if (!statement.of_splines) return false;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (setting.domain[axis] >= setting.degree[axis] + 1) continue;
    const RefinementTree tree(setting);
    MeshUnderTest initial(tree);
    return statement.decide(initial).verdict.outcome != Outcome::violated;
  }
  return false;
}

class Minimization {
 public:
  Minimization(const MinimizeOptions& options, const Statement& statement) : options_(options), statement_(statement) {
    report_.case_name = options.case_file;
    report_.statement = statement;
  }

  MinimizedReport run(const Case& start) {
    descend_from(start);
    if (options_.prove) prove();
    report_.trial = try_on_case(statement_, report_.minimized.smallest);
    return std::move(report_);
  }

 private:
  void descend_from(const Case& start) {
    Oracle::Options oracle;
    const std::int64_t before = report_.minimized.evaluations;
    if (options_.budget > 0) oracle.budget = options_.budget - before;
    oracle.stop = interrupted;
    oracle.evaluated = [count = before]() mutable { show_progress(fmt::format("{} evaluations", ++count)); };
    const PathForm form = statement_.of_sequence() ? PathForm::sequence : PathForm::mesh;
    report_.minimized = minimize(
        start, form, [this](const Case& one) { return violation_of(statement_, one); }, oracle);
    report_.minimized.evaluations += before;
  }

  bool finished() const { return report_.minimized.guarantee == Guarantee::one_minimal; }

  void prove() {
    while (finished()) {
      const Minimized& minimized = report_.minimized;
      if (minimized.smallest.explicit_mesh || statement_.of_sequence()) {
        warn("asts: --prove enumerates meshes of subdivisions: there is nothing to enumerate here\n");
        return;
      }
      const MeshStatement tried =
          statement_.claim != nullptr ? statement_of(*statement_.claim) : statement_of(*statement_.property);
      const Excluded excluded = [&](const Setting& setting) { return settles_all(tried, setting); };
      const auto chosen = choose_scope(minimized.smallest, minimized.size, excluded, options_.prove_meshes);
      if (!chosen) return;
      const auto smaller = search(*chosen, tried, excluded);
      if (!smaller) return;
      report_.proof.reset();
      descend_from(*smaller);
    }
  }

  /// A smaller mesh that violates in the same way, if there is one.
  std::optional<Case> search(const ChosenScope& chosen, const MeshStatement& tried, const Excluded& excluded) {
    std::int64_t meshes = 0;
    const auto new_trial = [&]() -> MeshTrial {
      auto chain = std::make_shared<TrialChain>(std::vector<const MeshStatement*>{&tried});
      return [&, chain](const EnumeratedMesh& mesh) {
        if (interrupted()) throw Interrupted{};
        if ((meshes += mesh.reflections) % kProgress < mesh.reflections) {
          show_progress(fmt::format("{} meshes: {}", meshes, scope_text(chosen.scope)));
        }
        return chain->results(mesh).front().outcome == Outcome::violated &&
               violation_of(statement_, case_of(mesh)) == report_.minimized.kind;
      };
    };
    try {
      const Exhausted found = exhaust(chosen.scope, report_.minimized.smallest, report_.minimized.size, tried.reflects,
                                      excluded, new_trial);
      report_.proof = {chosen.scope, chosen.complete, found.meshes, found.excluded, found.violating};
      return found.smaller;
    } catch (const Interrupted&) {
      report_.minimized.guarantee = Guarantee::interrupted;
      return std::nullopt;
    }
  }

  static constexpr std::int64_t kProgress = 4096;

  const MinimizeOptions& options_;
  const Statement statement_;
  MinimizedReport report_;
};

/// Writes a file of a folder, but never the input: a case of the collection may be minimized for it again.
void write_beside(const std::filesystem::path& file, const std::string& text, const std::string& input) {
  if (same_file(file.string(), input)) {
    warn("asts: " + file.string() + ": is the case that was minimized, and left as it is\n");
  } else {
    OutputFile(file.string()).finish(text);
  }
}

/// Adds the smallest case, and the first one of each other kind, to a collection.
void collect(const std::string& folder, const MinimizedReport& report) {
  const auto add = [&](const std::string& kind, const Case& test_case, const std::string& text) {
    const std::string name = collection_name(report.statement.id(), kind, test_case);
    write_beside(std::filesystem::path(folder) / name, text, report.case_name);
  };
  add(report.minimized.kind, report.minimized.smallest, minimized_case_text(report));
  for (const auto& [kind, other] : report.minimized.others) add(kind, other, write_case(other));
}

/// The slices that the witness is about; nothing for a sequence, whose meshes may be too large to be made.
void draw(const std::string& folder, const MinimizedReport& report) {
  if (report.statement.of_sequence()) return;
  const auto write = [&](MeshUnderTest& mesh) {
    const auto& witness = report.trial.verdict.witness;
    for (const SlicePicture& picture : slice_pictures(mesh, witness ? &*witness : nullptr)) {
      const std::string name = fmt::format("{}-{}-{}.svg", report.statement.id(), report.minimized.kind, picture.name);
      write_beside(std::filesystem::path(folder) / name, picture.svg, report.case_name);
    }
  };
  const Case& smallest = report.minimized.smallest;
  if (smallest.explicit_mesh) {
    MeshUnderTest mesh(mesh_of(setting_of(smallest), smallest.elements));
    write(mesh);
    return;
  }
  Replay replay(smallest);
  while (!replay.done()) replay.advance();
  MeshUnderTest mesh(replay.tree());
  write(mesh);
}

void require_folder(const std::string& folder) {
  if (!folder.empty() && !std::filesystem::is_directory(folder)) throw InputError(folder + ": is no folder");
}

}  // namespace

int minimize(const MinimizeOptions& options) {
  const Statement statement = statement_named(options);
  const Input input = read_input(options.case_file);
  auto out = open_beside(options.out, options.case_file);
  auto snippet = open_beside(options.snippet, options.case_file);
  require_folder(options.collect);
  require_folder(options.draw);
  MinimizedReport report;
  try {
    report = Minimization(options, statement).run(input.content);
  } catch (const InputError& error) {
    throw InputError(input.name + ": " + error.what());
  }
  const std::string text = minimized_case_text(report);
  if (out) out->finish(text);
  if (snippet) snippet->finish(case_snippet(report.minimized.smallest, statement));
  if (options.format == Format::json) {
    print(minimized_json(report));
  } else if (!out) {
    print(text);
  }
  if (!options.collect.empty()) collect(options.collect, report);
  if (!options.draw.empty()) draw(options.draw, report);
  warn(minimized_summary(report));
  switch (report.minimized.guarantee) {
    case Guarantee::interrupted:
      return kInterrupted;
    case Guarantee::budget:
      return kFailure;
    case Guarantee::one_minimal:
      return kHolds;
  }
  return kHolds;
}

}  // namespace asts::cli
