#pragma once

#include <optional>
#include <string>

#include "lib/mesh/case.hpp"

/// Statements on the last mesh or the steps of a case, each with a fault in how it is decided, or without. They answer
/// with a word for the violation, or nothing.
namespace asts {

enum class Planted { no, yes };
using Violation = std::optional<std::string>;

/// Refining makes admissible meshes. Fault: environments reach p+1/2 of an element's sizes from its midpoint.
Violation short_environment(const Case& test_case, Planted fault);
/// The same. Fault: what joins the closure is not asked for its own patch.
Violation single_round(const Case& test_case, Planted fault);
/// An admissible mesh has no coarser element in the patch of a subdivided one. Fault: closed environments.
Violation closed_environment(const Case& test_case, Planted fault);
/// The size of an element is that of its level. Fault: the level counts one split along z only.
Violation level_of_few_splits(const Case& test_case, Planted fault);
/// A node is the middle entry of its index vectors. Fault: off the initial lattice those along y are one entry late.
Violation late_index_vector(const Case& test_case, Planted fault);
/// Active nodes lie in the active region. Fault: its frame along y is as wide as p along z says, as far as it is asked
/// about nodes that are not on the initial lattice.
Violation mixed_frame(const Case& test_case, Planted fault);
/// Admissible meshes are dual-compatible. Fault: overlap is asked for along all three axes.
Violation overlap_along_all_axes(const Case& test_case, Planted fault);
/// No two perturbed regions of an analysis-suitable mesh meet. Fault: their slices are cut from the closed domain.
Violation slices_of_domain(const Case& test_case, Planted fault);

}  // namespace asts
