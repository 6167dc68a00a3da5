#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/zones/rank_box.hpp"

namespace asts {

/// The active nodes (Definition 4.1) of a part of a mesh with their local index vectors (Definition 4.4). Vectors are
/// p+2 identifiers of lines (AxisGrid), which stay when the mesh is refined, while ranks do not.
struct ZoneNodes {
  bool empty = true;                           ///< the zone does not meet the active region
  PerAxis<std::vector<std::int32_t>> vectors;  ///< distinct ones, one behind the other
  std::vector<PerAxis<std::uint16_t>> nodes;   ///< for each node the number of its vector along each axis
  PerAxis<RankInterval> window;                ///< the lines, not ranks, between which the vectors are decided
};

/// Finds the nodes of a zone and their index vectors.
///
/// A zone is the box of a node of the refinement tree. To it belong the vertices on its faces but for the upper ones,
/// so that each vertex belongs to one zone of a partition.
///
/// How. The lines in use in a window around the zone are numbered, at most as many as a word has bits. X(y,z)
/// (Definition 4.3) is a word with a bit for each x, one for each pair of lines (y,z) of the zone: a closed
/// x-orthogonal face of an element contains (x,y,z) exactly if x is an end of the element and (y,z) lies in its closed
/// rectangle, so that every element adds two bits to the words of its rectangle. An index vector is the node's own bit
/// and the (p+1)/2 next ones on either side.
///
/// The window. Along an axis it has (p+1)/2 entries outside the zone on each line of the zone parallel to the axis. Let
/// end(1) be the farthest end of the elements that touch the zone, and end(i+1) that of the elements that touch the
/// window up to end(i). By induction the i-th entry of each line outside the zone lies before end(i) or on it: the
/// elements around the line behind the i-th entry touch the window up to end(i), and one of them ends at the next
/// entry. So the elements that touch the window up to end((p+1)/2 - 1) have all entries that are needed as their ends.
/// Across the axis the window is the zone's own.
///
/// Cost: linear in the elements that touch the zone and its three windows, plus, for each, the pairs of lines that
/// cross its rectangles.
class ZoneScanner {
 public:
  /// REQUIRES: the tree outlives it; its ranks are up to date at every scan.
  explicit ZoneScanner(const RefinementTree& tree, std::size_t most_lines = 64)
      : tree_(&tree), most_lines_(most_lines) {}

  /// The nodes of a zone, in the lexicographic order of (y,z,x), with their vectors. False when a window has more lines
  /// than fit into a word.
  bool scan(std::int32_t zone, ZoneNodes& result) { return scan(zone, box_of(*tree_, zone), result); }
  /// The same of those in a closed box of ranks alone, at the cost of a zone that is this part.
  bool scan(std::int32_t zone, const RankBox& part, ZoneNodes& result);

 private:
  /// The lines in use along an axis, numbered in their order.
  struct Lines {
    std::int32_t begin = 0;           ///< the first rank of the window
    std::vector<std::uint8_t> below;  ///< how many lines in use are below a rank, from `begin` to one past the window
    std::vector<std::int32_t> rank;   ///< of a number
    std::int32_t first = 0;           ///< the numbers of the zone's own lines
    std::int32_t last = 0;
    std::size_t own() const { return at(last - first + 1); }
    /// The number of the first line in use at a rank or above it.
    std::int32_t number_from(std::int32_t of) const { return below[at(of - begin)]; }
  };
  /// Index vectors as words of bits; numbers of words.
  struct WordTable {
    std::vector<std::uint64_t> words;
    std::vector<std::int32_t> slots;
    std::size_t number_of(std::uint64_t word);
    std::size_t slot_of(std::uint64_t word) const;
    void clear();
  };

  /// A node of the tree on the way down, and what would have to be read of it.
  struct Reached {
    std::int32_t node;
    std::int32_t level;
    PerAxis<std::int32_t> cell;
  };

  void gather(const RankBox& box, std::vector<RankBox>& leaves);
  void reach_children(const Reached& one, const RankBox& box);
  std::int32_t extend(Axis axis, int direction);
  bool number_lines(Axis axis);
  void mark_ends(Axis axis, const std::vector<RankBox>& leaves);
  void add_entries(Axis axis, const std::vector<RankBox>& leaves);
  void add_vertices();
  RankInterval clipped(Axis axis, const RankInterval& side) const;
  std::uint64_t bit(Axis axis, std::int32_t rank) const;
  std::size_t place(Axis across, std::int32_t one, std::int32_t other) const;
  std::uint64_t vector_around(std::uint64_t entries, std::int32_t number, int reach) const;
  void collect(ZoneNodes& result);

  const RefinementTree* tree_;
  std::size_t most_lines_;
  std::int32_t zone_ = 0;
  RankBox own_;  ///< closed; the nodes that are looked for lie in it
  PerAxis<RankInterval> window_;
  std::vector<RankBox> core_;            ///< elements that touch own_
  PerAxis<std::vector<RankBox>> slabs_;  ///< and those of the windows' other parts
  PerAxis<Lines> lines_;
  PerAxis<std::vector<std::uint64_t>> entries_;  ///< X: words by the numbers of the lines of the next two axes
  std::vector<std::uint64_t> vertices_;          ///< x-bits of vertices, placed as entries_[0]
  PerAxis<WordTable> known_;
  std::vector<RankBox> outside_;
  std::vector<Reached> reached_;
  std::vector<Reached> deeper_;
};

}  // namespace asts
