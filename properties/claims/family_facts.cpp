#include "properties/claims/family_facts.hpp"

#include "properties/describe.hpp"

namespace asts {

namespace {

constexpr int kLeastGrading = 2;
constexpr int kLargestGrading = 20;
constexpr int kHighestLevel = 12;

/// The j-th child of an element of that level, Definitions 2.5 and 2.6.
ElementInfo child_of(const ElementInfo& parent, int grading, int j) {
  ElementInfo child = parent;
  const auto axis = at(*parent.level % kDimension);
  const Rational side = parent.box.upper[axis] - parent.box.lower[axis];
  child.box.lower[axis] = parent.box.lower[axis] + side * (j - 1) / grading;
  child.box.upper[axis] = parent.box.lower[axis] + side * j / grading;
  child.level = *parent.level + 1;
  return child;
}

}  // namespace

std::vector<ParentAndChild> families_of(const MeshUnderTest& mesh) {
  std::vector<ParentAndChild> families;
  const RefinementTree& tree = mesh.tree();
  for (const std::int32_t id : mesh.tree_elements()) {
    const std::int32_t parent = tree.node(id).parent;
    if (tree.node(id).level == 0) continue;
    families.push_back({tree.setting(), describe_tree_element(tree, parent), describe_tree_element(tree, id),
                        id - tree.node(parent).first_child + 1});
  }
  return families;
}

std::vector<ParentAndChild> families_at(const Setting& setting, int parent_level) {
  ElementInfo parent{{{0, 0, 0}, {1, 1, 1}}, 0};
  while (*parent.level < parent_level) parent = child_of(parent, setting.grading, setting.grading);
  std::vector<ParentAndChild> families;
  for (int j = 1; j <= setting.grading; ++j) {
    families.push_back({setting, parent, child_of(parent, setting.grading, j), j});
  }
  return families;
}

std::vector<ParentAndChild> families_of_every_grading() {
  std::vector<ParentAndChild> families;
  for (int m = kLeastGrading; m <= kLargestGrading; ++m) {
    for (int level = 0; level <= kHighestLevel; ++level) {
      for (const PerAxis<int>& degree : {PerAxis<int>{3, 3, 3}, {3, 5, 9}, {7, 3, 5}, {9, 9, 7}}) {
        std::vector<ParentAndChild> more = families_at({degree, m, {1, 1, 1}}, level);
        families.insert(families.end(), more.begin(), more.end());
      }
    }
  }
  return families;
}

Trial judge_families(const std::vector<ParentAndChild>& families, FamilyJudge judge) {
  if (families.empty()) return {Verdict::not_applicable("no element of the mesh has a parent")};
  std::int64_t met = 0;
  for (const ParentAndChild& family : families) {
    ++met;
    if (auto witness = judge(family)) return {Verdict::violated(std::move(*witness)), met};
  }
  return {Verdict::holds(), met};
}

ExactPoint to_point(const PerAxis<int>& degree) { return {degree[0], degree[1], degree[2]}; }

ExactPoint midpoint(const ExactBox& box) {
  ExactPoint result;
  for (std::size_t axis = 0; axis < kDimension; ++axis) result[axis] = (box.lower[axis] + box.upper[axis]) / 2;
  return result;
}

ExactPoint distance(const ExactBox& a, const ExactBox& b) {
  const ExactPoint x = midpoint(a);
  const ExactPoint y = midpoint(b);
  ExactPoint result;
  for (std::size_t axis = 0; axis < kDimension; ++axis) result[axis] = abs(Rational(x[axis] - y[axis]));
  return result;
}

ExactPoint sides(const ExactBox& box) {
  ExactPoint result;
  for (std::size_t axis = 0; axis < kDimension; ++axis) result[axis] = box.upper[axis] - box.lower[axis];
  return result;
}

}  // namespace asts
