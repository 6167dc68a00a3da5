#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "properties/mesh_under_test.hpp"
#include "properties/verdict.hpp"

namespace asts {

class SequenceUnderTest;

/// A property of a mesh: what `asts check` decides.
struct Property {
  const char* id;
  const char* source;     ///< the paper's number
  const char* statement;  ///< what a mesh that has it satisfies
  Verdict (*decide)(MeshUnderTest& mesh);
  /// The same verdict on the mesh that a sequence is at, where it is known without the whole mesh; nothing otherwise.
  std::optional<Verdict> (*decide_in_sequence)(SequenceUnderTest& sequence);
};

/// The five properties, in the order of the interface contract.
std::span<const Property> all_properties();

/// The property of an id; nullptr if there is none.
const Property* find_property(std::string_view id);

/// Decides a property; turns BudgetExhausted into `undecided`.
Verdict decide(const Property& property, MeshUnderTest& mesh);

Verdict decide_admissible(MeshUnderTest& mesh);         ///< Definition 3.2
Verdict decide_nested_patches(MeshUnderTest& mesh);     ///< Lemma 3.4's conclusion
Verdict decide_analysis_suitable(MeshUnderTest& mesh);  ///< Definition 5.2
Verdict decide_dual_compatible(MeshUnderTest& mesh);    ///< Definition 6.4
Verdict decide_dual_basis(MeshUnderTest& mesh);         ///< lambda_v(B_w) = delta_vw, Definition 6.2

std::optional<Verdict> admissible_in_sequence(SequenceUnderTest& sequence);
std::optional<Verdict> nested_patches_in_sequence(SequenceUnderTest& sequence);
std::optional<Verdict> analysis_suitable_in_sequence(SequenceUnderTest& sequence);
std::optional<Verdict> dual_compatible_in_sequence(SequenceUnderTest& sequence);
std::optional<Verdict> dual_basis_in_sequence(SequenceUnderTest& sequence);

}  // namespace asts
