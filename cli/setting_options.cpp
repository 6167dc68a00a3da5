#include "cli/setting_options.hpp"

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"

namespace asts::cli {

namespace {

PerAxis<int> three(const std::vector<int>& values, const char* what) {
  if (values.size() != kDimension) throw InputError(std::string(what) + " takes three numbers");
  return {values[0], values[1], values[2]};
}

}  // namespace

Setting checked_setting(const SettingOptions& options) {
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

}  // namespace asts::cli
