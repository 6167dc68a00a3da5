#include "tests/reference/validate_kinds.hpp"
#include "tests/reference/witness_elements.hpp"

namespace asts::reference {

namespace {

std::string described(const TreeElement& element) {
  return text(element.box) + " of level " + std::to_string(element.level);
}

}  // namespace

std::string validate_coarser_in_patch(const Setting& setting, const Mesh& mesh, const nlohmann::json& witness) {
  require_keys(witness, {"kind", "element", "environment", "coarser"}, "the witness");
  const RefinementTree tree = refinement_tree(setting, mesh);
  const TreeElement e = element_of_tree(setting, tree, witness["element"], "element");
  if (e.position) throw Rejected("element: it is an element of the mesh, so it was not subdivided");
  if (!(read_box(witness["environment"], "environment") == e.environment))
    throw Rejected("environment: U(E) within the domain is " + text(e.environment));
  const ElementText c = element_of_mesh(setting, mesh, witness["coarser"], "coarser");
  if (!c.level || *c.level >= e.level)
    throw Rejected("coarser: its level is not lower than " + std::to_string(e.level));
  if (!closed_meets_open(c.box, e.environment)) throw Rejected("coarser: it does not meet the open environment");
  return "E = " + described(e) + " was subdivided: elements of the mesh lie strictly inside it. C = " + text(c.box) +
         " is an element of the mesh and meets the open environment U(E) = " + text(e.environment) +
         " (without its boundary). Definition 3.1 asks for level(C) >= level(E), but " + std::to_string(*c.level) +
         " < " + std::to_string(e.level) + ". C, or an even coarser element around it, was there when E was "
         "subdivided: the mesh is not admissible.";
}

std::string validate_outside_class(const Setting& setting, const Mesh& mesh, const nlohmann::json& witness) {
  require_keys(witness, {"kind", "element"}, "the witness");
  const ElementText element = element_of_mesh(setting, mesh, witness["element"], "element");
  if (in_class(setting, element.box))
    throw Rejected("element: level-directed subdivisions of a unit cube do make it");
  return text(element.box) + " is an element of the mesh, and no sequence of level-directed subdivisions (Definition "
         "2.6) of a unit cube makes it: the mesh is no refinement of the initial mesh in the paper's sense, hence not "
         "admissible.";
}

std::string validate_patch_not_nested(const Setting& setting, const Mesh& mesh, const nlohmann::json& witness) {
  require_keys(witness, {"kind", "inner", "outer", "element"}, "the witness");
  const RefinementTree tree = refinement_tree(setting, mesh);
  const TreeElement k = element_of_tree(setting, tree, witness["inner"], "inner");
  const TreeElement l = element_of_tree(setting, tree, witness["outer"], "outer");
  const ElementText c = element_of_mesh(setting, mesh, witness["element"], "element");
  if (!contains(l.box, k.box)) throw Rejected("inner does not lie in outer");
  if (!closed_meets_open(c.box, k.environment)) throw Rejected("the element is not in the patch of inner");
  if (closed_meets_open(c.box, l.environment)) throw Rejected("the element is in the patch of outer");
  return "K = " + described(k) + " lies in L = " + described(l) + ". The element " + text(c.box) + " meets U(K) = " +
         text(k.environment) + " and does not meet U(L) = " + text(l.environment) +
         " (both open): the patch of K is not within the patch of L, against the conclusion of Lemma 3.4.";
}

}  // namespace asts::reference
