#pragma once

#include <cstdint>

#include "tests/reference/cube_root.hpp"
#include "tests/reference/mesh.hpp"

namespace asts::reference {

/// The experiment of Section 7, run with whole numbers: the element at the origin is marked in every step.
/// The counts |G_n \ G_0| for n = 0, ..., steps, by the literal Algorithms 2.8 and 2.9. REQUIRES: steps <= 24.
std::vector<std::int64_t> corner_counts(const Setting& setting, int steps);

/// Whether the meshes repeat themselves from step n_0 on, m times smaller every third step: the elements of G_(n_0) in
/// [0,v]^3, divided by m, are those of G_(n_0+3) in [0,v/m]^3, and the closures of the steps n_0+1, n_0+2, n_0+3 have
/// no element of level 0 and none whose U(K) leaves [0,v]^3. Then every step n > n_0 + 3 subdivides the image of what
/// step n - 3 does, and adds as many elements.
bool corner_repeats(const Setting& setting, int start, std::int64_t window);

}  // namespace asts::reference
