#pragma once

#include "tests/reference/mesh.hpp"

namespace asts::reference {

/// Algorithm 2.8: the closure, as a sorted set of positions in the mesh. Repeats until the set stops growing.
std::vector<std::size_t> closure(const Setting& setting, const Mesh& mesh, const std::vector<std::size_t>& marked);

/// Algorithm 2.9: subdivides the closure of the marked elements.
Mesh refine(const Setting& setting, const Mesh& mesh, const std::vector<std::size_t>& marked);

/// Definition 3.1, one element: all K' in the patch of K satisfy l(K') >= l(K). REQUIRES: every element has a level.
bool admissible_subdivision(const Setting& setting, const Mesh& mesh, std::size_t element);

/// Definition 3.1, several elements: is there an order that makes every single subdivision admissible? Tries every
/// order: at most 8 elements (throws std::invalid_argument).
bool admissible_subdivision(const Setting& setting, const Mesh& mesh, std::vector<std::size_t> marked);

}  // namespace asts::reference
