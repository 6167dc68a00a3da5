#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "lib/mesh/axis_grid.hpp"
#include "lib/spline/index_vectors.hpp"

namespace asts {

/// The index vectors of one axis that occur in the zones of a mesh, by the identifiers of their lines, each stored
/// once; and what each looks like up to translation and scaling: its pattern.
///
/// Every coordinate is an integer times m^-d for some depth d. The unit of a vector is m^-d for the least d that does
/// for all its entries; its pattern is the distances of its entries from the first one in that unit.
class VectorStore {
 public:
  /// What λ_X(N_X~) depends on, for X and X~: both patterns, the ratio of their units, and the distance of their first
  /// entries in the smaller unit. A common translation and scaling by a power of m does not change it.
  struct Relation {
    std::int32_t pattern;
    std::int32_t other;
    std::int32_t depths;  ///< depth of X~ less depth of X
    std::int64_t offset;  ///< first entry of X~ less that of X

    friend bool operator==(const Relation&, const Relation&) = default;
  };

  explicit VectorStore(int degree) : vectors_(degree) {}
  VectorStore(VectorStore&&) = default;  // no copies: patterns_ points into known_
  VectorStore& operator=(VectorStore&&) = default;

  /// The identifier of a vector. Cost: constant on average. REQUIRES: the lines are those of one grid always.
  std::int32_t intern(const AxisGrid& grid, std::span<const std::int32_t> lines);

  std::int32_t size() const { return vectors_.size(); }
  std::span<const std::int32_t> operator[](std::int32_t id) const { return vectors_[id]; }

  /// Nothing but false when a number leaves 62 bits: then nothing is known about the pair.
  bool relate(std::int32_t x, std::int32_t x_tilde, Relation& result) const;

  /// The distances of a pattern from its first entry, which is 0.
  std::span<const std::int64_t> pattern(std::int32_t id) const { return *patterns_[at(id)]; }
  int grading() const { return grading_; }

 private:
  struct Shape {
    std::int32_t pattern = -1;  ///< -1: too wide for 62 bits
    std::int32_t depth = 0;
    std::int64_t first = 0;  ///< the first entry in the vector's unit
  };
  Shape shape_of(const AxisGrid& grid, std::span<const std::int32_t> lines);
  bool scale(std::int64_t& value, std::int32_t levels) const;

  int grading_ = 2;
  IndexVectors vectors_;
  std::vector<Shape> shapes_;
  std::map<std::vector<std::int64_t>, std::int32_t> known_;
  std::vector<const std::vector<std::int64_t>*> patterns_;
};

}  // namespace asts
