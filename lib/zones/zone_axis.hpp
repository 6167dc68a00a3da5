#pragma once

#include <cstdint>
#include <vector>

#include "lib/zones/bits.hpp"
#include "lib/zones/factor_table.hpp"
#include "lib/zones/rank_box.hpp"

namespace asts {

/// The index vectors of one axis that reach a box, numbered, with what pairs of them have to do with each other.
///
/// A line q shows that X and X~ do not overlap (Equation (6.1)) exactly if q lies in the closed ranges of both and is
/// an entry of one alone. Here only lines in the box's closed range are asked: where a mesh is cut into boxes, each
/// line is in one.
class ZoneAxis {
 public:
  static constexpr std::size_t kMostLines = 64;

  explicit ZoneAxis(int degree) : factors_(degree) {}

  void begin(const RankInterval& box) {
    box_ = box;
    vectors_.clear();
    ids_.clear();
  }
  /// Numbers a vector that touches the box. REQUIRES: it has no number yet.
  std::int32_t add(std::int32_t id, const RankInterval& range) {
    ids_.push_back(id);
    vectors_.push_back({range, 0, 0});
    return static_cast<std::int32_t>(ids_.size() - 1);
  }
  /// Numbers the lines of the box: its ends, those of the vectors and of the active region. When they are more than
  /// `most_lines`, returns a rank strictly inside the box where it can be cut; -1 otherwise.
  std::int32_t number_lines(const VectorStore& store, const AxisGrid& grid, const RankInterval& active,
                            std::size_t most_lines);
  /// Finds the pairs that fail to overlap. False when there are none: every line is an entry of all vectors around it.
  bool find_failures();

  std::size_t size() const { return ids_.size(); }
  std::int32_t id(std::size_t number) const { return ids_[number]; }
  std::size_t line_count() const { return ranks_.size(); }
  bool fails(std::size_t one, std::size_t other) const { return failures_.test(one, other); }
  bool fails_anywhere(std::size_t one) const { return failing_[one]; }

  /// Whether the interiors of the ranges meet.
  bool meet(std::size_t one, std::size_t other) const {
    const RankInterval& a = vectors_[one].range;
    const RankInterval& b = vectors_[other].range;
    return a.lower < b.upper && b.lower < a.upper;
  }
  /// The lines of the box that are entries of a vector, and those in its closed range, as bits.
  std::uint64_t entries(std::size_t number) const { return vectors_[number].entries; }
  std::uint64_t reached(std::size_t number) const { return vectors_[number].reached; }
  /// The lines of the box in the active region.
  std::uint64_t active() const { return active_; }

  /// Whether lambda_X(N_X~) differs from 0, or is not known to be 0. Evaluated when first asked for.
  bool nonzero(const VectorStore& store, std::size_t x, std::size_t x_tilde) {
    if (!meet(x, x_tilde)) return false;  // DualFunctional, law 3
    const std::uint8_t known = asked_[x * ids_.size() + x_tilde];
    return known == 0 ? evaluate(store, x, x_tilde) : known == 2;
  }
  bool is_one(const VectorStore& store, std::size_t x) { return factors_.of(store, ids_[x], ids_[x]).one; }
  void forget_factors() { asked_.assign(ids_.size() * ids_.size(), 0); }

 private:
  struct Vector {
    RankInterval range;
    std::uint64_t entries;
    std::uint64_t reached;
  };
  bool evaluate(const VectorStore& store, std::size_t x, std::size_t x_tilde);
  std::uint64_t between(const RankInterval& ranks) const;

  RankInterval box_;
  std::vector<std::int32_t> ids_;
  std::vector<Vector> vectors_;
  std::vector<std::int32_t> ranks_;   ///< of the lines
  std::vector<std::uint8_t> in_use_;  ///< by rank from the box's lower end on; then how many are below
  std::uint64_t active_ = 0;
  BitRows failures_;
  BitRows having_;
  BitRows lacking_;
  std::vector<bool> failing_;
  std::vector<std::uint8_t> asked_;  ///< 0: not asked; 1: zero; 2: not zero
  FactorTable factors_;
};

}  // namespace asts
