#include "lib/mesh/fingerprint.hpp"

#include <gmp.h>

#include <span>

namespace asts {

namespace {

/// Two streams of bits that start from different constants; each takes in 64 bits at a time.
class Mixer {
 public:
  void add(std::uint64_t bits) {
    high_ = mix(high_ ^ bits, 0x9E3779B97F4A7C15ULL);
    low_ = mix(low_ + bits, 0xD1B54A32D192ED03ULL);
  }

  void add(std::int32_t number) { add(static_cast<std::uint64_t>(static_cast<std::uint32_t>(number))); }

  /// Size with sign, then the limbs.
  void add(mpz_srcptr number) {
    add(static_cast<std::uint64_t>(static_cast<std::int64_t>(mpz_sgn(number)) *
                                   static_cast<std::int64_t>(mpz_size(number))));
    for (const mp_limb_t limb : std::span(mpz_limbs_read(number), mpz_size(number))) add(std::uint64_t{limb});
  }

  Fingerprint value() const { return {high_, low_}; }

 private:
  /// The finalizer of SplitMix64 (Steele, Lea, Flood 2014) behind an addition of its own.
  static std::uint64_t mix(std::uint64_t bits, std::uint64_t increment) {
    bits += increment;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9ULL;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBULL;
    return bits ^ (bits >> 31);
  }

  std::uint64_t high_ = 0x243F6A8885A308D3ULL;
  std::uint64_t low_ = 0x13198A2E03707344ULL;
};

void add(Mixer& mixer, const Setting& setting) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    mixer.add(setting.degree[axis]);
    mixer.add(setting.domain[axis]);
  }
  mixer.add(setting.grading);
}

Fingerprint fingerprint_of(const Box& box) {
  Mixer mixer;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    mixer.add(box.lower[axis]);
    mixer.add(box.upper[axis]);
  }
  return mixer.value();
}

}  // namespace

Fingerprint fingerprint_of(const Setting& setting) {
  Mixer mixer;
  add(mixer, setting);
  return mixer.value();
}

Fingerprint fingerprint_of(const Mesh& mesh) {
  Mixer mixer;
  add(mixer, mesh.setting);
  // the lines are those in use, so that with them the ranks say all
  for (const std::vector<Rational>& lines : mesh.coordinates) {
    mixer.add(static_cast<std::uint64_t>(lines.size()));
    for (const Rational& line : lines) {
      mixer.add(mpq_numref(line.backend().data()));
      mixer.add(mpq_denref(line.backend().data()));
    }
  }
  // a sum, because the order of the elements means nothing
  Fingerprint sum;
  for (const Box& box : mesh.elements) {
    const Fingerprint one = fingerprint_of(box);
    sum.high += one.high;
    sum.low += one.low;
  }
  mixer.add(sum.high);
  mixer.add(sum.low);
  return mixer.value();
}

}  // namespace asts
