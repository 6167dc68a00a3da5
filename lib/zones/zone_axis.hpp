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
  /// The vectors that one fails to overlap. REQUIRES: find_failures() has found some.
  BitSet failures(std::size_t one) const { return failures_[one]; }
  bool fails_anywhere(std::size_t one) const { return failing_[one]; }

  /// The gaps between neighbouring lines of the box that a vector's range contains, as the bits of their upper lines.
  /// In the box, two ranges' interiors meet exactly if they have a gap in common.
  std::uint64_t gaps(std::size_t number) const { return reached(number) & (reached(number) - 1); }
  /// The lines of the box that are entries of a vector, and those in its closed range, as bits.
  std::uint64_t entries(std::size_t number) const { return vectors_[number].entries; }
  std::uint64_t reached(std::size_t number) const { return vectors_[number].reached; }
  /// The lines of the box in the active region.
  std::uint64_t active() const { return active_; }

  /// Whether all of visit(X~) are true, for the X~ of a set for which lambda_X(N_X~) differs from 0, or is not known to
  /// be 0. Evaluated when first asked for.
  template <typename Visit>
  bool all_nonzero(const VectorStore& store, std::size_t x, BitSet set, const Visit& visit) {
    for (std::size_t word = 0; word < set.size(); ++word) {
      for_each_bit(set[word] & ~asked_[x][word], [&](std::size_t bit) { evaluate(store, x, 64 * word + bit); });
      for (std::uint64_t left = set[word] & nonzero_[x][word]; left != 0; left &= left - 1) {
        if (!visit(64 * word + static_cast<std::size_t>(std::countr_zero(left)))) return false;
      }
    }
    return true;
  }
  bool is_one(const VectorStore& store, std::size_t x) { return factors_.of(store, ids_[x], ids_[x]).one; }
  void forget_factors() {
    asked_.reset(ids_.size(), ids_.size());
    nonzero_.reset(ids_.size(), ids_.size());
  }

 private:
  struct Vector {
    RankInterval range;
    std::uint64_t entries;
    std::uint64_t reached;
  };
  void evaluate(const VectorStore& store, std::size_t x, std::size_t x_tilde);
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
  BitRows asked_;    ///< for each X the X~ whose factor was asked for
  BitRows nonzero_;  ///< and is not known to be 0
  FactorTable factors_;
};

}  // namespace asts
