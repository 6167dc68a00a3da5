#pragma once

#include "tests/reference/suitability.hpp"
#include "tests/reference/witness_json.hpp"

/// The hypotheses of the claims of Sections 4 to 6, decided from the definitions, and what their witnesses have in
/// common. A hypothesis is said to hold in a sentence that begins with a blank; where it does not hold, Rejected is
/// thrown: then the claim says nothing about the mesh.
namespace asts::reference {

/// The mesh is made by level-directed subdivisions (Definition 2.6) of the initial mesh.
std::string made_by_subdivisions(const Setting& setting, const Mesh& mesh);
/// Definition 3.2.
std::string mesh_is_admissible(const Setting& setting, const Mesh& mesh);
/// There is an active node, and each one has its three index vectors (Definition 4.4).
std::string splines_exist(const Setting& setting, const Mesh& mesh);
/// Definition 5.2; with slices of the closed domain in place of slices of AR: suitable_in_whole_domain.
/// Both: splines exist.
std::string mesh_is_suitable(const Setting& setting, const Mesh& mesh);
std::string suitable_in_whole_domain(const Setting& setting, const Mesh& mesh);
/// Definition 6.4.
std::string mesh_is_compatible(const Setting& setting, const Mesh& mesh);
/// Any two active nodes whose closed supports meet partially overlap.
std::string touching_pairs_overlap(const Setting& setting, const Mesh& mesh);

/// The mesh's elements with the closed domain in place of AR, for slices of the domain.
template <class T>
Space<T> with_whole_domain(Space<T> space);

/// An element of the mesh, printed with its level: its position.
std::size_t position_of_element(const Setting& setting, const Mesh& mesh, const nlohmann::json& value,
                                const std::string& what);

/// A text that is one of the two words.
bool read_choice(const nlohmann::json& value, const char* yes, const char* no, const std::string& what);

/// "N_x(5/2)".
std::string slice_name(std::size_t axis, const Rational& q);
Box as_box(const BasicBox<Rational>& box);
/// "(2, 2, 2) with support [0,4] x [0,4] x [0,4]".
std::string described_node(const ActiveNode<Rational>& v);
/// The node's index vector along an axis: "xx = (0, 1, 2, 3, 4)".
std::string described_vector(const ActiveNode<Rational>& v, std::size_t axis);

/// t lies in R_axis(t_axis) because of the two nodes: in the slice of space.active, in both closed supports, `in` in
/// N_axis(t_axis) and `out` not.
std::string in_slice_perturbation(const Space<Rational>& space, std::size_t axis, const Point& t,
                                  const ActiveNode<Rational>& in, const ActiveNode<Rational>& out);

}  // namespace asts::reference
