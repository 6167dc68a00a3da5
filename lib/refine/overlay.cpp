#include "lib/refine/overlay.hpp"

#include <vector>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

bool same_setting(const Setting& a, const Setting& b) {
  return a.degree == b.degree && a.grading == b.grading && a.domain == b.domain;
}

}  // namespace

RefinementTree overlay(const RefinementTree& one, const RefinementTree& other) {
  require(same_setting(one.setting(), other.setting()), "an overlay needs two meshes of one setting");
  RefinementTree result = one;
  // The nodes from the domain down to the unit cubes come first, and are the same in all trees of a setting.
  std::vector<std::int32_t> place(at(other.node_count()), 0);
  for (std::int32_t id = 0; id < other.node_count(); ++id) {  // parents have lower ids than their children
    if (other.is_leaf(id)) continue;
    if (result.is_leaf(place[at(id)])) result.subdivide(place[at(id)]);
    const std::int32_t first = result.node(place[at(id)]).first_child;
    for (std::int32_t j = 0; j < other.child_count(id); ++j) place[at(other.node(id).first_child + j)] = first + j;
  }
  result.update_ranks();
  return result;
}

}  // namespace asts
