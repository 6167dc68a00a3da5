#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/last_mesh.hpp"
#include "cli/output_file.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
#include "reports/slice_svg.hpp"

namespace asts::cli {

namespace {

namespace fs = std::filesystem;

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

void refuse_input_as_output(const std::string& case_file, const std::string& file) {
  if (same_file(case_file, file)) throw InputError(file + ": is the case itself");
}

int draw_mesh(const DrawOptions& options, const std::optional<Statement>& statement, LastMesh& last) {
  std::optional<Verdict> verdict;
  if (statement) verdict = last.decide(*statement);
  stop_if_interrupted();
  const bool witnessed = verdict && verdict->witness;
  const auto pictures = slice_pictures(last.mesh(), witnessed ? &*verdict->witness : nullptr);
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
  const std::optional<Statement> statement = chosen_statement(options.claim, options.property);
  Input input = read_input(options.case_file);
  make_folder(options.folder);
  LastMesh last(input);
  return draw_mesh(options, statement, last);
}

}  // namespace asts::cli
