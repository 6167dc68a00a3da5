#pragma once

#include <optional>

#include "lib/gen/draw.hpp"
#include "lib/mesh/case.hpp"

namespace asts::fuzz {

/// One random change of a case, for the fuzzers' mutator: of the setting, or of steps or boxes. Nothing when the change
/// that was drawn cannot be made of this case. The result is valid (parse_case can give it, boxes tile the domain), but
/// it may be larger than case_bytes.hpp allows.
std::optional<Case> mutated(const Case& content, Draw& draw);

/// The parts: changes of m, p and the domain; of steps; of boxes. REQUIRES: a case of steps, a case of boxes.
std::optional<Case> with_other_setting(const Case& content, Draw& draw);
std::optional<Case> with_other_steps(const Case& content, Draw& draw);
std::optional<Case> with_other_boxes(const Case& content, Draw& draw);

/// The last mesh of a case of steps as explicit boxes.
Case written_out(const Case& content);

}  // namespace asts::fuzz
