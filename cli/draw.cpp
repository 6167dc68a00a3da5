#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/output_file.hpp"
#include "cli/statements.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
#include "lib/refine/replay.hpp"
#include "properties/statement.hpp"
#include "reports/slice_svg.hpp"

namespace asts::cli {

namespace {

namespace fs = std::filesystem;

std::optional<Statement> chosen_statement(const DrawOptions& options) {
  if (!options.claim.empty() && !options.property.empty()) throw InputError("draw: one --claim or one --property");
  if (!options.claim.empty()) return Statement{chosen_claims({options.claim}).front(), nullptr};
  if (!options.property.empty()) return Statement{nullptr, chosen_properties({options.property}).front()};
  return std::nullopt;
}

/// Of a statement about one mesh for the last one, of one about sequences for all steps.
Verdict decide_on(const Statement& statement, const Case& test_case, MeshUnderTest& mesh) {
  if (statement.of_sequence()) return try_on_case(statement, test_case).verdict;
  if (statement.claim != nullptr) return try_on_mesh(*statement.claim, mesh).verdict;
  return decide(*statement.property, mesh);
}

int exit_code_of(const Verdict& verdict) {
  if (verdict.outcome == Outcome::violated) return kViolated;
  return verdict.outcome == Outcome::undecided ? kFailure : kHolds;
}

void make_folder(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure || !fs::is_directory(folder)) throw InputError(folder.string() + ": cannot be made a folder");
}

std::string stem_of(const std::string& case_file) {
  return case_file == "-" ? "stdin" : fs::path(case_file).stem().string();
}

std::string line_of(const std::string& file, const Slice& slice, Format format) {
  if (format == Format::text) return file + "\n";
  const nlohmann::ordered_json json{
      {"file", file}, {"axis", axis_name(slice.axis)}, {"coordinate", to_string(slice.position)}};
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string verdict_line(const Statement& statement, const Verdict& verdict, Format format) {
  const std::string kind = verdict.witness ? kind_of(*verdict.witness) : std::string();
  if (format == Format::text) {
    return fmt::format("{}: {}{}\n", statement.id(), outcome_name(verdict.outcome), kind.empty() ? "" : ": " + kind);
  }
  nlohmann::ordered_json json{{statement.claim != nullptr ? "claim" : "property", statement.id()},
                              {"verdict", outcome_name(verdict.outcome)}};
  if (!kind.empty()) json["kind"] = kind;
  return json.dump() + "\n";
}

void refuse_input_as_output(const std::string& case_file, const std::string& file) {
  if (same_file(case_file, file)) throw InputError(file + ": is the case itself");
}

int draw_mesh(const DrawOptions& options, const std::optional<Statement>& statement, const Case& test_case,
              MeshUnderTest& mesh) {
  std::optional<Verdict> verdict;
  if (statement) verdict = decide_on(*statement, test_case, mesh);
  stop_if_interrupted();
  const bool witnessed = verdict && verdict->witness;
  const auto pictures = slice_pictures(mesh, witnessed ? &*verdict->witness : nullptr);
  const auto path_of = [&](const SlicePicture& picture) {
    return (fs::path(options.folder) / (stem_of(options.case_file) + "-" + picture.name + ".svg")).string();
  };
  for (const SlicePicture& picture : pictures) refuse_input_as_output(options.case_file, path_of(picture));
  if (verdict) print(verdict_line(*statement, *verdict, options.format));
  for (const SlicePicture& picture : pictures) {
    stop_if_interrupted();
    OutputFile(path_of(picture)).finish(picture.svg);
    print(line_of(path_of(picture), picture.slice, options.format));
  }
  return verdict ? exit_code_of(*verdict) : kHolds;
}

}  // namespace

int draw(const DrawOptions& options) {
  const std::optional<Statement> statement = chosen_statement(options);
  Input input = read_input(options.case_file);
  make_folder(options.folder);
  if (input.mesh) {
    MeshUnderTest mesh(std::move(*input.mesh));
    return draw_mesh(options, statement, input.content, mesh);
  }
  Replay replay(input.content);
  while (!replay.done()) {
    stop_if_interrupted();
    show_progress(fmt::format("step {}, {} elements", replay.counts().step + 1, replay.tree().element_count()));
    replay.advance();
  }
  show_progress({});
  MeshUnderTest mesh(replay.tree());
  return draw_mesh(options, statement, input.content, mesh);
}

}  // namespace asts::cli
