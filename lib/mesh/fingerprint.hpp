#pragma once

#include <cstddef>
#include <cstdint>

#include "lib/mesh/mesh.hpp"

namespace asts {

/// 128 bits that stand for a mesh: for telling distinct meshes from repeated ones without keeping them.
struct Fingerprint {
  std::uint64_t high = 0;
  std::uint64_t low = 0;

  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

/// Laws (tests/mesh/fingerprint_test.cpp): (1) equal for equal meshes: the same setting and the same set of boxes,
/// whatever made them and in whatever order they stand; (2) different for different ones, but for an accident: two of n
/// meshes have the same bits with a probability of n^2 / 2^129 if the bits are as good as random, which is 10^-26 for a
/// million; so a number of distinct fingerprints is never larger than that of the meshes.
/// Cost: linear in lines and elements.
Fingerprint fingerprint_of(const Mesh& mesh);

/// The same for the setting alone.
Fingerprint fingerprint_of(const Setting& setting);

struct FingerprintHash {
  std::size_t operator()(const Fingerprint& value) const { return static_cast<std::size_t>(value.low); }
};

}  // namespace asts
