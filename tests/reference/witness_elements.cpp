#include "tests/reference/witness_elements.hpp"

#include <algorithm>

namespace asts::reference {

using nlohmann::json;

void check_level(const Setting& setting, const ElementText& claimed, const std::string& what) {
  const std::optional<int> actual = level(setting, claimed.box);
  const bool equal = actual.has_value() == claimed.level.has_value() && (!actual || *actual == *claimed.level);
  if (!equal)
    throw Rejected(what + ": its level is " + (actual ? std::to_string(*actual) : "no integer") + ", not as printed");
}

ElementText element_of_mesh(const Setting& setting, const Mesh& mesh, const json& value, const std::string& what) {
  const ElementText element = read_element(value, what);
  if (std::find(mesh.begin(), mesh.end(), element.box) == mesh.end())
    throw Rejected(what + ": " + text(element.box) + " is no element of the mesh");
  check_level(setting, element, what);
  return element;
}

std::size_t position_in_mesh(const Setting& setting, const Mesh& mesh, const json& value, const std::string& what) {
  const Box box = element_of_mesh(setting, mesh, value, what).box;
  return static_cast<std::size_t>(std::find(mesh.begin(), mesh.end(), box) - mesh.begin());
}

TreeElement element_of_tree(const Setting& setting, const RefinementTree& tree, const json& value,
                            const std::string& what) {
  const ElementText element = read_element(value, what);
  const auto found = std::find_if(tree.elements.begin(), tree.elements.end(),
                                  [&](const TreeElement& known) { return known.box == element.box; });
  if (found == tree.elements.end())
    throw Rejected(what + ": " + text(element.box) + " is not in the mesh's refinement tree");
  check_level(setting, element, what);
  return *found;
}

std::vector<json> numbered(const json& values, const std::string& name) {
  std::vector<json> result;
  for (std::size_t i = 1;; ++i) {
    const auto value = values.find(name + " " + std::to_string(i));
    if (value == values.end()) return result;
    result.push_back(*value);
  }
}

const json& values_with_lists(const json& witness, std::initializer_list<const char*> names,
                              std::initializer_list<const char*> lists) {
  const json& values = witness.at("values");
  if (!values.is_object()) throw Rejected("values is not an object");
  std::size_t count = names.size();
  for (const char* list : lists) count += numbered(values, list).size();
  for (const char* name : names)
    if (!values.contains(name)) throw Rejected(std::string("values lacks the key \"") + name + "\"");
  if (values.size() != count) throw Rejected("values has a key that is none of its kind");
  return values;
}

void require_class(const Setting& setting, const Mesh& mesh) {
  if (!refinement_tree(setting, mesh).outside.empty())
    throw Rejected("the mesh is no refinement of the initial mesh (Definition 2.6): the claim says nothing about it");
}

void require_admissible(const Setting& setting, const Mesh& mesh, const std::string& what) {
  if (!admissible_mesh(setting, mesh, refinement_tree(setting, mesh)))
    throw Rejected(what + " is not admissible: the claim says nothing about it");
}

namespace {

[[noreturn]] void another_value(const std::string& what, const std::string& actual, const std::string& claimed) {
  throw Rejected(what + " is " + actual + ", not " + claimed);
}

}  // namespace

void require_equal(const Rational& claimed, const Rational& actual, const std::string& what) {
  if (claimed != actual) another_value(what, text(actual), text(claimed));
}

void require_equal(const Point& claimed, const Point& actual, const std::string& what) {
  if (claimed != actual) another_value(what, text(actual), text(claimed));
}

void require_equal(std::size_t claimed, std::size_t actual, const std::string& what) {
  if (claimed != actual) another_value(what, std::to_string(actual), std::to_string(claimed));
}

std::string described(const Setting& setting, const Box& box) {
  return text(box) + " of level " + std::to_string(level(setting, box).value());
}

}  // namespace asts::reference
