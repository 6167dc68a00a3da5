#include "properties/claims/second_patch.hpp"

#include <algorithm>

#include "properties/describe.hpp"

namespace asts {

namespace {

using Element = PatchElements::Element;

Rational size_along(const RefinementTree& tree, std::int32_t element, Axis axis) {
  const AxisGrid& grid = tree.grid(axis);
  const RankInterval extent = tree.extent(element, axis);
  return grid.coordinate(grid.line_of_rank(extent.upper)) - grid.coordinate(grid.line_of_rank(extent.lower));
}

/// The place of each size among all sizes, ascending: comparing places is comparing sizes.
std::vector<std::size_t> places_of(const std::vector<Rational>& sizes) {
  std::vector<Rational> distinct = sizes;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  std::vector<std::size_t> places;
  for (const Rational& size : sizes) {
    places.push_back(
        static_cast<std::size_t>(std::lower_bound(distinct.begin(), distinct.end(), size) - distinct.begin()));
  }
  return places;
}

/// Definition 2.4: whether an element is in the patch of another: the closed box meets the open environment.
bool in_patch(const Element& element, const Element& of) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (element.extent.lower[axis] >= of.environment.upper[axis]) return false;
    if (element.extent.upper[axis] <= of.environment.lower[axis]) return false;
  }
  return true;
}

bool larger_anywhere(const Element& one, const Element& other) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (one.size[axis] > other.size[axis]) return true;
  }
  return false;
}

/// An element of the second-order patch of K, and one of the patch of K whose patch it is in.
struct Larger {
  const Element* element;
  const Element* through;
};

/// The elements of the second-order patch of K that are larger than K along some axis. K is in its own patch, and each
/// element in its own, so that the patch of K is a part of the second-order patch.
std::vector<Larger> larger_in_second_patch(const PatchElements& all, const Element& element) {
  std::vector<const Element*> candidates;
  for (const Element& other : all.elements) {
    if (larger_anywhere(other, element)) candidates.push_back(&other);
  }
  std::vector<Larger> result;
  if (candidates.empty()) return result;
  std::vector<const Element*> patch;
  for (const Element& inner : all.elements) {
    if (in_patch(inner, element)) patch.push_back(&inner);
  }
  for (const Element* candidate : candidates) {
    const auto reaches = [&](const Element* inner) { return in_patch(*candidate, *inner); };
    const auto through = std::find_if(patch.begin(), patch.end(), reaches);
    if (through != patch.end()) result.push_back({candidate, *through});
  }
  return result;
}

ClaimWitness larger_element(const RefinementTree& tree, const Element& element, const Larger& larger, Axis axis) {
  return {"larger-in-second-patch",
          "an element of the second-order patch is larger than the element along the axis",
          {{"axis", std::string(axis_name(axis))},
           {"element", describe_tree_element(tree, element.leaf)},
           {"through", describe_tree_element(tree, larger.through->leaf)},
           {"larger", describe_tree_element(tree, larger.element->leaf)}}};
}

}  // namespace

PatchElements patch_elements(const RefinementTree& tree) {
  PatchElements all;
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (!tree.is_leaf(id)) continue;
    Element element{id, {}, {}, {}};
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const RankInterval extent = tree.extent(id, axis);
      const RankInterval environment = tree.environment(id, axis);
      element.extent.lower[at(axis)] = extent.lower;
      element.extent.upper[at(axis)] = extent.upper;
      element.environment.lower[at(axis)] = environment.lower;
      element.environment.upper[at(axis)] = environment.upper;
    }
    all.elements.push_back(element);
  }
  for (Axis axis = 0; axis < kDimension; ++axis) {
    std::vector<Rational> sizes;
    for (const Element& element : all.elements) sizes.push_back(size_along(tree, element.leaf, axis));
    const std::vector<std::size_t> places = places_of(sizes);
    for (std::size_t i = 0; i < places.size(); ++i) all.elements[i].size[at(axis)] = places[i];
  }
  return all;
}

Judgement judge_second_patch(const RefinementTree& tree, const PatchElements& all, std::size_t element) {
  Judgement judgement;
  const Element& own = all.elements[element];
  const Axis x = tree.split_axis(own.leaf);
  for (const Larger& larger : larger_in_second_patch(all, own)) {
    for (int role = 0; role < kDimension; ++role) {
      const Axis axis = (x + role) % kDimension;
      if (larger.element->size[at(axis)] <= own.size[at(axis)]) continue;
      if (role == 2) {
        ++judgement.met;
      } else if (!judgement.violation) {
        judgement.violation = larger_element(tree, own, larger, axis);
      }
    }
  }
  return judgement;
}

Trial judge_second_patches(MeshUnderTest& mesh) {
  const PatchElements all = patch_elements(mesh.tree());
  return judge_leaves(mesh, [&](std::int32_t leaf) {
    const auto place = std::find_if(all.elements.begin(), all.elements.end(),
                                    [&](const Element& element) { return element.leaf == leaf; });
    return judge_second_patch(mesh.tree(), all, static_cast<std::size_t>(place - all.elements.begin()));
  });
}

}  // namespace asts
