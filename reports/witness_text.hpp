#pragma once

#include <string>

#include "properties/verdict.hpp"

namespace asts {

/// A witness in words and numbers, for a person who wants to check it by hand: what is violated, where, which elements
/// or nodes, which index vectors, and why. Several indented lines, each with a line end.
std::string witness_text(const Witness& witness);

}  // namespace asts
