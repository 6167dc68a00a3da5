#pragma once

#include "tests/reference/claim_subject.hpp"
#include "tests/reference/tree.hpp"
#include "tests/reference/witness_json.hpp"

/// What the checks of witnesses have in common: elements that must be where the witness says, and hypotheses. Every
/// function throws Rejected, with the reason, where something does not hold.
namespace asts::reference {

/// Rejects the value unless the box has the level that it is printed with (null: none).
void check_level(const Setting& setting, const ElementText& claimed, const std::string& what);

/// An element of the mesh, with its level.
ElementText element_of_mesh(const Setting& setting, const Mesh& mesh, const nlohmann::json& value,
                            const std::string& what);
/// The same, as a position in the mesh.
std::size_t position_in_mesh(const Setting& setting, const Mesh& mesh, const nlohmann::json& value,
                             const std::string& what);

/// An element of the refinement tree, with its level.
TreeElement element_of_tree(const Setting& setting, const RefinementTree& tree, const nlohmann::json& value,
                            const std::string& what);

/// The values "NAME 1", "NAME 2", ... as far as they are there.
std::vector<nlohmann::json> numbered(const nlohmann::json& values, const std::string& name);

/// The `values` of a witness, which must have exactly these names, and numbered ones of the second list's names.
const nlohmann::json& values_with_lists(const nlohmann::json& witness, std::initializer_list<const char*> names,
                                        std::initializer_list<const char*> lists);

/// Every box of the mesh is made by level-directed subdivisions (Definition 2.6).
void require_class(const Setting& setting, const Mesh& mesh);

/// Definition 3.2.
void require_admissible(const Setting& setting, const Mesh& mesh, const std::string& what = "the mesh");

/// A witness's value that must be this.
void require_equal(const Rational& claimed, const Rational& actual, const std::string& what);
void require_equal(const Point& claimed, const Point& actual, const std::string& what);
void require_equal(std::size_t claimed, std::size_t actual, const std::string& what);

/// "[0, 1] x [0, 1] x [0, 1/2] of level 1". REQUIRES: it has one.
std::string described(const Setting& setting, const Box& box);

}  // namespace asts::reference
