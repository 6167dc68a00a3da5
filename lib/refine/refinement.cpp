#include "lib/refine/refinement.hpp"

#include "lib/refine/patch_search.hpp"

namespace asts {

std::vector<std::int32_t> mark_closure(RefinementTree& tree, std::span<const std::int32_t> marks) {
  std::vector<std::vector<std::int32_t>> by_level(at(tree.max_level()) + 1);
  const auto mark = [&](std::int32_t leaf) {
    if (tree.is_marked(leaf)) return;
    by_level[at(tree.node(leaf).level)].push_back(leaf);
    tree.mark(leaf);
  };
  for (const std::int32_t leaf : marks) mark(leaf);

  PatchSearch search(tree);
  std::vector<std::int32_t> closure;
  for (std::size_t level = by_level.size(); level-- > 0;) {
    // only levels below this one grow during the search
    search.coarser_in_patches(by_level[level], static_cast<std::int32_t>(level),
                              [&](std::int32_t, std::int32_t coarser) {
                                mark(coarser);
                                return true;
                              });
    closure.insert(closure.end(), by_level[level].begin(), by_level[level].end());
  }
  return closure;
}

void subdivide_all(RefinementTree& tree, std::span<const std::int32_t> leaves) {
  for (const std::int32_t leaf : leaves) tree.subdivide(leaf);
  tree.update_ranks();
}

std::vector<std::int32_t> refine(RefinementTree& tree, std::span<const std::int32_t> marks) {
  std::vector<std::int32_t> closure = mark_closure(tree, marks);
  subdivide_all(tree, closure);
  return closure;
}

}  // namespace asts
