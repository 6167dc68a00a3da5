#include "lib/refine/parallel_marks.hpp"

#include <algorithm>

#include "lib/refine/patch_search.hpp"
#include "lib/threads/apart.hpp"
#include "lib/threads/parallel_for.hpp"

namespace asts {

namespace {

struct Find {
  std::int32_t entry;
  int bit;
  std::int32_t leaf;
};

/// At least so many nodes that tile the domain, in the order of the tree, unless the mesh has fewer elements.
std::vector<std::int32_t> blocks_of(const RefinementTree& tree, std::size_t wanted) {
  std::vector<std::int32_t> blocks(1, 0);
  const auto is_leaf = [&](std::int32_t id) { return tree.is_leaf(id); };
  while (blocks.size() < wanted && !std::all_of(blocks.begin(), blocks.end(), is_leaf)) {
    std::vector<std::int32_t> parts;
    for (const std::int32_t id : blocks) {
      if (tree.is_leaf(id)) parts.push_back(id);
      for (std::int32_t j = 0; !tree.is_leaf(id) && j < tree.child_count(id); ++j) {
        parts.push_back(tree.first_child(id) + j);
      }
    }
    blocks.swap(parts);
  }
  return blocks;
}

/// Merges the finds of the blocks by entry, bit and block. A distribution by entries, of which there are about as many
/// as finds.
std::vector<std::int32_t> merged(const std::vector<std::vector<Find>>& of_blocks, std::size_t entries) {
  std::vector<std::size_t> begin(entries + 1, 0);
  for (const std::vector<Find>& finds : of_blocks) {
    for (const Find& find : finds) ++begin[at(find.entry) + 1];
  }
  for (std::size_t entry = 0; entry < entries; ++entry) begin[entry + 1] += begin[entry];
  std::vector<Find> all(begin.back());
  std::vector<std::size_t> next = begin;
  for (const std::vector<Find>& finds : of_blocks) {
    for (const Find& find : finds) all[next[at(find.entry)]++] = find;
  }
  const auto by_bit = [](const Find& a, const Find& b) { return a.bit < b.bit; };
  const auto iterator = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t entry = 0; entry < entries; ++entry) {
    const auto first = iterator(begin[entry]);
    const auto last = iterator(begin[entry + 1]);
    if (!std::is_sorted(first, last, by_bit)) std::stable_sort(first, last, by_bit);
  }
  std::vector<std::int32_t> leaves;
  leaves.reserve(all.size());
  for (const Find& find : all) leaves.push_back(find.leaf);
  return leaves;
}

}  // namespace

std::vector<std::int32_t> mark_coarser(RefinementTree& tree, std::span<const std::int32_t> elements, std::int32_t level,
                                       int jobs) {
  constexpr std::size_t kBlocksPerJob = 8;  // enough that a slow one does not keep the others waiting
  const ClusterShape shape(tree.setting().grading, level);
  const Clusters clusters(tree, shape, elements, jobs);
  const std::vector<std::int32_t> blocks = blocks_of(tree, kBlocksPerJob * at(jobs));
  std::vector<std::vector<Find>> finds(blocks.size());
  std::vector<Apart<PatchSearch>> searches(at(jobs), {PatchSearch(tree)});
  parallel_for(jobs, blocks.size(), [&](std::size_t i, int worker) {
    std::vector<Find> own;
    searches[at(worker)].own.coarser_below(blocks[i], shape, clusters, [&](const PatchSearch::Coarser& coarser) {
      own.push_back({coarser.entry, coarser.first_bit(), coarser.leaf});
      tree.mark_below(blocks[i], coarser.leaf);
      return true;
    });
    finds[i] = std::move(own);
  });
  for (const std::int32_t block : blocks) tree.carry_up(block);
  return merged(finds, clusters.entries().size());
}

}  // namespace asts
