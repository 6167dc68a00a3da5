#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
#include "lib/gen/workloads.hpp"
#include "lib/mesh/case_file.hpp"

namespace asts::cli {

namespace {

constexpr std::int64_t kMostElements = 100'000'000;

PerAxis<int> three(const std::vector<int>& values, const char* what) {
  if (values.size() != kDimension) throw InputError(std::string(what) + " takes three numbers");
  return {values[0], values[1], values[2]};
}

Setting checked_setting(const GenerateOptions& options) {
  const Setting setting{three(options.degree, "--degree"), options.grading, three(options.domain, "--domain")};
  // the case reader knows what a setting must satisfy: ask it, so that there is one such place
  const Case header{setting.degree, setting.grading, setting.domain, {}, false, {}};
  try {
    parse_case(write_case(header), {});
  } catch (const CaseFileError& error) {
    const std::string reason = error.what();  // ":LINE: reason", of a text that nobody sees
    throw InputError(reason.substr(reason.find(": ") + 2));
  }
  return setting;
}

}  // namespace

int generate(const GenerateOptions& options) {
  const Setting setting = checked_setting(options);
  if (options.elements < 1 || options.elements > kMostElements) {
    throw InputError("--elements takes a number from 1 to " + std::to_string(kMostElements));
  }
  const Workload workload = options.workload == "corner" ? Workload::corner : Workload::sphere;
  const std::string text = write_case(generate_workload(workload, setting, options.elements));
  stop_if_interrupted();
  print(text);
  return kHolds;
}

}  // namespace asts::cli
