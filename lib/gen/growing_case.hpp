#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// Degree, grading and domain within the limits.
Setting random_setting(Draw& draw, const CaseLimits& limits);

/// A case that grows by steps, with its tree, within a number of elements.
class GrowingCase {
 public:
  /// The number gives way so far that two subdivisions are always possible.
  GrowingCase(const Setting& setting, std::int64_t max_elements)
      : case_{setting.degree, setting.grading, setting.domain, {}, false, {}},
        tree_(setting),
        max_elements_(std::max(max_elements, tree_.element_count() + 2 * (setting.grading - 1))) {}

  const RefinementTree& tree() const { return tree_; }
  const Case& content() const { return case_; }

  /// Appends a step that names these distinct leaves by their lower corners; does nothing and returns false when there
  /// are none or the mesh would get too large.
  bool add(Step::Kind kind, std::span<const std::int32_t> leaves);

 private:
  Case case_;
  RefinementTree tree_;
  std::int64_t max_elements_;
};

/// A point that names an element of the tree. REQUIRES: ranks are up to date.
Point lower_corner(const RefinementTree& tree, std::int32_t element);

/// The tree's leaves, ascending.
std::vector<std::int32_t> leaves_of(const RefinementTree& tree);

/// A random point of the domain with small denominators, so that it lies on elements' faces often.
Point random_point(Draw& draw, const Setting& setting);

}  // namespace asts
