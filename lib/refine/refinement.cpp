#include "lib/refine/refinement.hpp"

#include "lib/refine/parallel_marks.hpp"
#include "lib/refine/patch_search.hpp"

namespace asts {

namespace {

/// Not worth a thread.
constexpr std::size_t kFewElements = 4096;

}  // namespace

std::vector<std::int32_t> mark_closure(RefinementTree& tree, std::span<const std::int32_t> marks, int jobs) {
  std::vector<std::vector<std::int32_t>> by_level(at(tree.max_level()) + 1);
  for (const std::int32_t leaf : marks) {
    if (tree.is_marked(leaf)) continue;
    by_level[at(tree.level(leaf))].push_back(leaf);
    tree.mark(leaf);
  }
  PatchSearch search(tree);
  std::vector<std::int32_t> closure;
  for (std::size_t level = by_level.size(); level-- > 0;) {
    // only levels below this one grow during the search
    const std::vector<std::int32_t>& elements = by_level[level];
    if (jobs > 1 && elements.size() >= kFewElements) {
      for (const std::int32_t leaf : mark_coarser(tree, elements, static_cast<std::int32_t>(level), jobs)) {
        by_level[at(tree.level(leaf))].push_back(leaf);
      }
    } else {
      search.coarser_in_patches(elements, static_cast<std::int32_t>(level), [&](const PatchSearch::Coarser& coarser) {
        by_level[at(tree.level(coarser.leaf))].push_back(coarser.leaf);
        tree.mark(coarser.leaf);
        return true;
      });
    }
    closure.insert(closure.end(), elements.begin(), elements.end());
  }
  return closure;
}

void subdivide_all(RefinementTree& tree, std::span<const std::int32_t> leaves, int jobs) {
  tree.subdivide(leaves, leaves.size() < kFewElements ? 1 : jobs);
  tree.update_ranks();
}

std::vector<std::int32_t> refine(RefinementTree& tree, std::span<const std::int32_t> marks) {
  std::vector<std::int32_t> closure = mark_closure(tree, marks);
  subdivide_all(tree, closure);
  return closure;
}

}  // namespace asts
