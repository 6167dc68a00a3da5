#include "lib/refine/admissibility.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <vector>

#include "lib/refine/node_table.hpp"
#include "lib/refine/patch_search.hpp"
#include "lib/threads/parallel_for.hpp"

namespace asts {

namespace {

/// The first element of those of one level that has a coarser one in its patch.
std::optional<CoarserInPatch> first_of_level(PatchSearch& search, std::span<const std::int32_t> elements,
                                             std::size_t level) {
  std::optional<CoarserInPatch> result;
  search.coarser_in_patches(elements, static_cast<std::int32_t>(level), [&](const PatchSearch::Coarser& coarser) {
    result = CoarserInPatch{coarser.element(), coarser.leaf};
    return false;
  });
  return result;
}

/// The subdivided elements by level. Each thread lists those of some ranges of nodes; the ranges stay in their order.
std::vector<std::vector<std::int32_t>> inner_elements(const RefinementTree& tree, int jobs) {
  constexpr std::size_t kChunk = 1 << 15;
  const std::size_t nodes = at(tree.node_count());
  using ByLevel = std::vector<std::vector<std::int32_t>>;
  std::vector<ByLevel> parts((nodes + kChunk - 1) / kChunk);
  parallel_for(jobs, parts.size(), [&](std::size_t chunk, int) {
    ByLevel own(at(tree.max_level()) + 1);
    const std::size_t end = std::min(nodes, (chunk + 1) * kChunk);
    for (std::size_t node = chunk * kChunk; node < end; ++node) {
      const auto id = static_cast<std::int32_t>(node);
      if (tree.level(id) > 0 && !tree.is_leaf(id)) own[at(tree.level(id))].push_back(id);
    }
    parts[chunk] = std::move(own);
  });
  ByLevel inner = std::move(parts.front());
  for (std::size_t chunk = 1; chunk < parts.size(); ++chunk) {
    for (std::size_t level = 0; level < inner.size(); ++level) {
      inner[level].insert(inner[level].end(), parts[chunk][level].begin(), parts[chunk][level].end());
    }
  }
  return inner;
}

}  // namespace

std::optional<CoarserInPatch> find_inadmissible(const RefinementTree& tree, int jobs) {
  const std::vector<std::vector<std::int32_t>> inner = inner_elements(tree, jobs);
  if (jobs == 1) {
    PatchSearch search(tree);
    for (std::size_t level = 1; level < inner.size(); ++level) {
      if (const auto found = first_of_level(search, inner[level], level)) return found;
    }
    return std::nullopt;
  }
  std::vector<std::optional<CoarserInPatch>> found(inner.size());
  parallel_for(jobs, inner.size() - 1, [&](std::size_t i, int) {  // mostly the largest first
    const std::size_t level = inner.size() - 1 - i;
    PatchSearch search(tree);
    found[level] = first_of_level(search, inner[level], level);
  });
  const auto first = std::find_if(found.begin(), found.end(), [](const auto& one) { return one.has_value(); });
  return first == found.end() ? std::nullopt : *first;
}

bool is_admissible_subdivision(const RefinementTree& tree, std::span<const std::int32_t> leaves) {
  PatchSearch search(tree);
  std::vector<std::vector<std::int32_t>> by_level(at(tree.max_level()) + 1);
  for (const std::int32_t leaf : leaves) by_level[at(tree.level(leaf))].push_back(leaf);
  NodeTable in_set;
  for (const std::int32_t leaf : leaves) in_set.insert(leaf);
  for (std::size_t level = 1; level < by_level.size(); ++level) {
    const bool clear = search.coarser_in_patches(
        by_level[level], static_cast<std::int32_t>(level), [&](const PatchSearch::Coarser& coarser) {
          const std::int32_t after = tree.level(coarser.leaf) + (in_set.contains(coarser.leaf) ? 1 : 0);
          return after >= static_cast<std::int32_t>(level);
        });
    if (!clear) return false;
  }
  return true;
}

bool stays_admissible(const RefinementTree& tree, std::span<const std::int32_t> subdivided, int jobs) {
  std::map<std::int32_t, std::vector<std::int32_t>> by_level;
  for (const std::int32_t id : subdivided) by_level[tree.level(id)].push_back(id);
  using Level = std::pair<const std::int32_t, std::vector<std::int32_t>>;
  std::vector<const Level*> levels;
  for (const Level& level : by_level) levels.push_back(&level);
  std::sort(levels.begin(), levels.end(),
            [](const Level* a, const Level* b) { return a->second.size() > b->second.size(); });
  std::atomic<bool> good = true;
  parallel_for(jobs, levels.size(), [&](std::size_t i, int) {
    if (!good) return;
    PatchSearch search(tree);
    const auto& [level, elements] = *levels[i];
    if (!search.coarser_in_patches(elements, level, [](const PatchSearch::Coarser&) { return false; })) good = false;
  });
  return good;
}

}  // namespace asts
