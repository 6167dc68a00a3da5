#include <filesystem>

#include "cli/check_directory.hpp"
#include "cli/commands.hpp"
#include "cli/output_file.hpp"
#include "cli/terminal.hpp"
#include "fuzz/campaign/recorded_run.hpp"
#include "lib/exact/errors.hpp"

namespace asts::cli {

namespace {

std::string page_of(const std::string& folder) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) throw InputError(folder + ": is no folder");
  if (has_campaign(folder)) return campaign_page(read_recorded_run(folder), ASTS_VERSION);
  if (has_check(folder)) return check_page(read_check_directory(folder), ASTS_VERSION);
  throw InputError(folder + ": is no run directory of asts campaign or asts check");
}

/// What is read must not be written over; an old report in the folder may be.
void refuse_input_as_output(const ReportOptions& options) {
  std::error_code none;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(options.folder, none)) {
    if (entry.path().extension() == ".html" || !same_file(entry.path().string(), options.out)) continue;
    throw InputError(options.out + ": is a file of the run directory");
  }
}

}  // namespace

int report(const ReportOptions& options) {
  const std::string page = page_of(options.folder);
  stop_if_interrupted();
  refuse_input_as_output(options);
  OutputFile(options.out).finish(page);
  return kHolds;
}

}  // namespace asts::cli
