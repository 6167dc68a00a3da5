#pragma once

#include "lib/mesh/case.hpp"
#include "tests/reference/claim_subject.hpp"

namespace asts::fuzz {

/// A case as the literal code has it, which makes the mesh of it by its own means.
reference::ClaimSubject literal_subject(const Case& content);

}  // namespace asts::fuzz
