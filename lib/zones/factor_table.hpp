#pragma once

#include <cstdint>
#include <vector>

#include "lib/spline/dual_functional.hpp"
#include "lib/zones/vector_store.hpp"

namespace asts {

/// Whether the factors lambda_X(N_X~) of Definition 6.2 along one axis are 0, and 1: every one is evaluated exactly the
/// first time that its relation occurs, and known from then on (DualFunctional, law 2: affine invariance). Nothing is
/// inferred from overlap. Not safe to share between threads. Cost: a look-up mostly.
class FactorTable {
 public:
  struct Factor {
    bool known = false;  ///< false: numbers too wide; nothing is known
    bool zero = false;
    bool one = false;
  };

  explicit FactorTable(int degree) : functional_(degree), slots_(1024) {}

  Factor of(const VectorStore& vectors, std::int32_t x, std::int32_t x_tilde);

 private:
  struct Slot {
    VectorStore::Relation relation{-1, -1, 0, 0};
    Factor factor;
  };
  std::size_t slot_of(const VectorStore::Relation& relation) const;
  Factor evaluate(const VectorStore& vectors, const VectorStore::Relation& relation);

  DualFunctional functional_;
  std::vector<Slot> slots_;
  std::size_t used_ = 0;
};

}  // namespace asts
