#include "cli/commands.hpp"
#include "cli/setting_options.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
#include "lib/gen/workloads.hpp"
#include "lib/mesh/case_file.hpp"

namespace asts::cli {

namespace {

constexpr std::int64_t kMostElements = 100'000'000;

}  // namespace

int generate(const GenerateOptions& options) {
  const Setting setting = checked_setting(options.setting);
  if (options.elements < 1 || options.elements > kMostElements) {
    throw InputError("--elements takes a number from 1 to " + std::to_string(kMostElements));
  }
  const Workload workload = workload_named(options.workload);
  const std::string text = write_case(generate_workload(workload, setting, options.elements));
  stop_if_interrupted();
  print(text);
  return kHolds;
}

}  // namespace asts::cli
