#include <algorithm>
#include <atomic>

#include "lib/exact/errors.hpp"
#include "lib/mesh/refinement_tree.hpp"
#include "lib/threads/parallel_for.hpp"

namespace asts {

namespace {

/// Leaves that a thread takes at a time.
constexpr std::size_t kChunk = 4096;
/// Nodes are asked for so many leaves ahead.
constexpr std::size_t kAhead = 16;

/// Calls work(begin, end, worker) for chunks of a range. Chunks that follow each other are from different parts of it,
/// one a thread: threads that write to fresh memory side by side would both wait for the same pages.
template <typename Work>
void for_chunks(int jobs, std::size_t count, const Work& work) {
  const std::size_t parts = at(jobs);
  const std::size_t of_part = ((count + kChunk - 1) / kChunk + parts - 1) / parts;
  parallel_for(jobs, of_part * parts, [&](std::size_t item, int worker) {
    const std::size_t begin = (item % parts * of_part + item / parts) * kChunk;
    if (begin < count) work(begin, std::min(count, begin + kChunk), worker);
  });
}

}  // namespace

void RefinementTree::subdivide(std::span<const std::int32_t> leaves, int jobs) {
  if (places_.size() + leaves.size() * at(setting_.grading) > at(std::numeric_limits<std::int32_t>::max())) {
    throw ResourceError("the refinement tree has 2^31 nodes");
  }
  prepare(leaves, jobs);
  const std::int32_t first = node_count();
  grow(leaves.size() * at(setting_.grading));
  for_chunks(jobs, leaves.size(), [&](std::size_t begin, std::size_t end, int) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i + 2 * kAhead < end) prefetch(leaves[i + 2 * kAhead]);
      if (i + kAhead < end) prefetch_parent(leaves[i + kAhead]);
      write_children(leaves[i], first + static_cast<std::int32_t>(i) * setting_.grading);
    }
  });
  element_count_ += static_cast<std::int64_t>(leaves.size()) * (setting_.grading - 1);
}

/// What a thread saw of leaves that are to be subdivided.
struct RefinementTree::Seen {
  PerAxis<std::vector<char>> split;  ///< cells whose children are missing
  std::int32_t max_level = 0;        ///< of the children
  std::int64_t unit_cubes = 0;
  bool all_marked = true;
};

/// Sees to it that the axes have the cells of the leaves' children, and that the leaves are marked.
void RefinementTree::prepare(std::span<const std::int32_t> leaves, int jobs) {
  const std::vector<Seen> seen = look_at(leaves, jobs);
  split_cells(seen);
  bool all_marked = true;
  for (const Seen& of_worker : seen) {
    max_level_ = std::max(max_level_, of_worker.max_level);
    initial_left_ -= of_worker.unit_cubes;
    all_marked = all_marked && of_worker.all_marked;
  }
  for (std::size_t i = 0; i < leaves.size() && !all_marked; ++i) {
    if (coarsest_[at(leaves[i])] != kNoLevel) mark(leaves[i]);
  }
}

std::vector<RefinementTree::Seen> RefinementTree::look_at(std::span<const std::int32_t> leaves, int jobs) const {
  Seen nothing;
  for (Axis axis = 0; axis < kDimension; ++axis) nothing.split[at(axis)].assign(at(grid(axis).cell_count()), 0);
  std::vector<Seen> seen(at(jobs), nothing);
  for_chunks(jobs, leaves.size(), [&](std::size_t begin, std::size_t end, int worker) {
    Seen& mine = seen[at(worker)];
    std::int32_t max_level = 0;  // these apart from those of other threads
    std::int64_t unit_cubes = 0;
    bool all_marked = true;
    for (std::size_t i = begin; i < end; ++i) {
      if (i + kAhead < end) prefetch(leaves[i + kAhead]);
      ensure(is_leaf(leaves[i]) && level(leaves[i]) >= 0, "only a leaf is subdivided");
      const Axis axis = split_axis(leaves[i]);
      const std::int32_t side = cell(leaves[i], axis);
      if (!grid(axis).has_children(side)) mine.split[at(axis)][at(side)] = 1;
      max_level = std::max(max_level, level(leaves[i]) + 1);
      unit_cubes += level(leaves[i]) == 0 ? 1 : 0;
      all_marked = all_marked && coarsest_[at(leaves[i])] == kNoLevel;
    }
    mine.max_level = std::max(mine.max_level, max_level);
    mine.unit_cubes += unit_cubes;
    mine.all_marked = mine.all_marked && all_marked;
  });
  return seen;
}

/// New cells are numbered in the order of their parents, whatever the order of the leaves.
void RefinementTree::split_cells(const std::vector<Seen>& seen) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    for (std::size_t id = 0; id < seen.front().split[at(axis)].size(); ++id) {
      const auto is_to_be_split = [&](const Seen& of_worker) { return of_worker.split[at(axis)][id] != 0; };
      if (std::any_of(seen.begin(), seen.end(), is_to_be_split))
        grids_[at(axis)].children(static_cast<std::int32_t>(id));
    }
  }
}

/// Makes room for nodes and leaves them as they are; the nodes before them are moved rarely.
void RefinementTree::grow(std::size_t count) {
  const std::size_t nodes = places_.size() + count;
  if (nodes > places_.capacity()) {
    const std::size_t room = std::max(nodes, 2 * places_.capacity());  // many small steps stay linear in all
    places_.reserve(room);
    links_.reserve(room);
    coarsest_.reserve(room);
  }
  places_.resize_unset(nodes);
  links_.resize_unset(nodes);
  coarsest_.resize_unset(nodes);
}

/// REQUIRES: the cells of the children are there, and room for them.
void RefinementTree::write_children(std::int32_t leaf, std::int32_t first) {
  const Axis axis = split_axis(leaf);
  Place child{places_[at(leaf)].cell, kNone};
  child.cell[at(axis)] = grid(axis).known_children(child.cell[at(axis)]);
  const std::int32_t level = links_[at(leaf)].level + 1;
  for (std::int32_t id = first; id < first + setting_.grading; ++id, ++child.cell[at(axis)]) {
    places_[at(id)] = child;
    links_[at(id)] = {leaf, level};
    coarsest_[at(id)] = level;
  }
  places_[at(leaf)].first_child = first;
  lower_coarsest(leaf, level);
}

/// Tells a node and those above it of a leaf below that is new to searches. The leaf's level only lowers the minima, so
/// that threads may do this at the same time, in any order.
void RefinementTree::lower_coarsest(std::int32_t id, std::int32_t level) {
  for (; id != kNone; id = links_[at(id)].parent) {
    const std::atomic_ref coarsest(coarsest_[at(id)]);
    std::int32_t known = coarsest.load(std::memory_order_relaxed);
    while (level < known && !coarsest.compare_exchange_weak(known, level, std::memory_order_relaxed)) {
    }
    if (level >= known) return;
  }
}

}  // namespace asts
