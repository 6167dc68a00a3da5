#pragma once

#include "properties/mesh_under_test.hpp"
#include "properties/witness.hpp"

namespace asts {

/// From ranks and identifiers to the exact numbers of a witness.
ElementInfo describe_element(const Mesh& mesh, std::int32_t element);
ElementInfo describe_tree_element(const RefinementTree& tree, std::int32_t id);
ExactBox describe_environment(const RefinementTree& tree, std::int32_t id);
/// Appends elements of a tree to a witness's values as "NAME 1", "NAME 2", ...: a name stands for one value.
void append_elements(ClaimWitness& witness, const std::string& name, const RefinementTree& tree,
                     const std::vector<std::int32_t>& elements);
ActiveNodeInfo describe_node(const Mesh& mesh, const TSplines& splines, std::int32_t node);

/// A point of two perturbed regions with the nodes behind them.
RegionsMeetWitness describe_meeting(MeshUnderTest& mesh, const RegionsMeet& meeting);

/// The coordinate of a position on a line, or of the active region's lower side where no line runs along it.
Rational coordinate_of(const Mesh& mesh, Axis axis, HalfRank position);

}  // namespace asts
