#pragma once

#include <cstddef>

#include "lib/mesh/case.hpp"

namespace asts {

/// The case as far as one mesh of its sequence: its first `steps` steps, at most as many as it has. A case that gives
/// its mesh as boxes has no other mesh and stays as it is.
inline Case case_prefix(Case content, std::size_t steps) {
  if (steps < content.steps.size()) content.steps.resize(steps);
  return content;
}

}  // namespace asts
