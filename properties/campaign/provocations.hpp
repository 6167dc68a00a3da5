#pragma once

#include <cstdint>
#include <span>

#include "lib/gen/draw.hpp"
#include "lib/mesh/case.hpp"

namespace asts {

/// Random cases of a campaign are done in blocks: what is done at once, recorded at once, and done again when it is
/// lost.
inline constexpr std::int64_t kBlockCases = 64;

/// Random cases for one claim, whose hypothesis or violation the general stream of cases (lib/gen/case_stream) never or
/// hardly ever meets.
struct Provocation {
  const char* claim;    ///< its id. The case is for this claim alone, whatever its size and class
  const char* name;     ///< among the biases: "provoke-" and the id
  Case (*draw)(Draw&);  ///< depends on the state of the Draw alone
  int rarity;           ///< drawn in one of so many blocks of the stream
  int cases = 1;        ///< how many of that block's cases
};

/// In the order of the ledger of claims; each name once. `rarity` is so large that a provocation takes 5 parts in 100
/// of the time at most: a block of 64 cases with all claims takes 0.3 to 1 seconds.
/// Laws (tests/properties/provocations_test.cpp): (1) cases are valid, and the same for the same state; (2) where the
/// claim is refuted, one of the first 200 cases violates it; elsewhere one of them meets the hypothesis.
/// lambda-sums is missing: its shortest known sequence has 1307 steps and a mesh of 61 million elements.
std::span<const Provocation> all_provocations();

}  // namespace asts
