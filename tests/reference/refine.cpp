#include "tests/reference/refine.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace asts::reference {

std::vector<std::size_t> closure(const Setting& setting, const Mesh& mesh, const std::vector<std::size_t>& marked) {
  std::set<std::size_t> result(marked.begin(), marked.end());
  for (std::size_t before = 0; before != result.size();) {
    before = result.size();
    const std::set<std::size_t> current = result;
    for (const std::size_t k : current)
      for (const std::size_t other : patch(setting, mesh, mesh[k]))
        if (level(setting, mesh[other]).value() < level(setting, mesh[k]).value()) result.insert(other);
  }
  return {result.begin(), result.end()};
}

Mesh refine(const Setting& setting, const Mesh& mesh, const std::vector<std::size_t>& marked) {
  return subdivide(setting, mesh, closure(setting, mesh, marked));
}

bool admissible_subdivision(const Setting& setting, const Mesh& mesh, std::size_t element) {
  const int own = level(setting, mesh[element]).value();
  for (const std::size_t other : patch(setting, mesh, mesh[element]))
    if (level(setting, mesh[other]).value() < own) return false;
  return true;
}

namespace {

bool admissible_in_order(const Setting& setting, Mesh mesh, const std::vector<Box>& order) {
  for (const Box& box : order) {
    const auto position = static_cast<std::size_t>(std::find(mesh.begin(), mesh.end(), box) - mesh.begin());
    if (!admissible_subdivision(setting, mesh, position)) return false;
    mesh = subdivide(setting, mesh, {position});
  }
  return true;
}

}  // namespace

bool admissible_subdivision(const Setting& setting, const Mesh& mesh, std::vector<std::size_t> marked) {
  if (marked.size() > 8) throw std::invalid_argument("too many elements to try every order");
  std::sort(marked.begin(), marked.end());
  do {
    std::vector<Box> order;
    for (const std::size_t i : marked) order.push_back(mesh[i]);
    if (admissible_in_order(setting, mesh, order)) return true;
  } while (std::next_permutation(marked.begin(), marked.end()));
  return false;
}

}  // namespace asts::reference
