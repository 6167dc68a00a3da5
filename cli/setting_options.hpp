#pragma once

#include "cli/commands.hpp"
#include "lib/mesh/setting.hpp"

namespace asts::cli {

/// The setting that --degree, --grading and --domain give. Throws InputError unless it is one that a case may have.
Setting checked_setting(const SettingOptions& options);

}  // namespace asts::cli
