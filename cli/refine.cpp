#include <fmt/format.h>

#include <cstdio>
#include <fstream>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
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

/// Writes beside the file and renames, so that an interrupt never leaves half a file, nor harms an old one.
void write_file(const std::string& path, const std::string& text) {
  const std::string partial = path + ".part";
  std::ofstream file(partial, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file || std::rename(partial.c_str(), path.c_str()) != 0) {
    std::remove(partial.c_str());
    throw InputError(path + ": cannot be written");
  }
}

}  // namespace

int refine(const RefineOptions& options) {
  const Case content = read_case_file(options.case_file);
  if (content.explicit_mesh) {
    const Mesh mesh = [&] {
      try {
        return mesh_of(setting_of(content), content.elements);
      } catch (const InputError& error) {
        throw InputError(options.case_file + ":" + error.what());
      }
    }();
    if (!options.write_file.empty()) write_file(options.write_file, write_case(explicit_case(content, mesh)));
    if (options.format == Format::text) {
      print(fmt::format("an explicit mesh of {} elements, no steps\n", mesh.elements.size()));
    }
    return kHolds;
  }
  Replay replay(content);
  if (options.format == Format::text) print(refine_text_header());
  while (!replay.done()) {
    stop_if_interrupted();
    show_progress(fmt::format("step {}, {} elements", replay.counts().step + 1, replay.tree().element_count()));
    replay.advance();
    const RefineRecord record{replay.counts(), replay.tree().element_count(), replay.tree().new_element_count()};
    print(options.format == Format::json ? refine_json(record) : refine_text(record));
  }
  if (!options.write_file.empty()) {
    write_file(options.write_file, write_case(explicit_case(content, mesh_of(replay.tree()))));
  }
  return kHolds;
}

}  // namespace asts::cli
