#include <fmt/format.h>

#include <optional>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/output_file.hpp"
#include "cli/terminal.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/refine/replay.hpp"
#include "reports/check_report.hpp"

namespace asts::cli {

namespace {

/// The mesh as an explicit case: one `element` line a leaf.
Case explicit_case(const Case& source, const Mesh& mesh) {
  Case result = source;
  result.steps.clear();
  result.explicit_mesh = true;
  result.elements.clear();
  PerAxis<std::vector<CompactRational>> numbers;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    for (const Rational& value : mesh.coordinates[axis]) numbers[axis].emplace_back(value);
  }
  for (const Box& box : mesh.elements) {
    ElementLine line;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      line.lower[axis] = numbers[axis][static_cast<std::size_t>(box.lower[axis])];
      line.upper[axis] = numbers[axis][static_cast<std::size_t>(box.upper[axis])];
    }
    result.elements.push_back(std::move(line));
  }
  return result;
}

void print_steps(Replay& replay, Format format) {
  if (format == Format::text) print(refine_text_header());
  while (!replay.done()) {
    stop_if_interrupted();
    show_progress(fmt::format("step {}, {} elements", replay.counts().step + 1, replay.tree().element_count()));
    replay.advance();
    const RefineRecord record{replay.counts(), replay.tree().element_count(), replay.tree().new_element_count()};
    print(format == Format::json ? refine_json(record) : refine_text(record));
  }
}

}  // namespace

int refine(const RefineOptions& options) {
  const Input input = read_input(options.case_file);
  std::optional<OutputFile> file;
  if (!options.write_file.empty()) file.emplace(options.write_file);
  if (input.mesh) {
    if (options.format == Format::text) {
      print(fmt::format("an explicit mesh of {} elements, no steps\n", input.mesh->elements.size()));
    }
    if (file) file->finish(write_case(explicit_case(input.content, *input.mesh)));
    return kHolds;
  }
  Replay replay(input.content, options.jobs);
  print_steps(replay, options.format);
  if (file) file->finish(write_case(explicit_case(input.content, mesh_of(replay.tree()))));
  return kHolds;
}

}  // namespace asts::cli
