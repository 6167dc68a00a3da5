// libFuzzer's hook for mutations of the targets that read cases as bytes.

#include <algorithm>

#include "fuzz/targets/case_mutator.hpp"
#include "fuzz/targets/targets.hpp"
#include "lib/gen/case_bytes.hpp"

/// libFuzzer's own mutations. Other engines lack it, and do not call the hook.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                                              std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  asts::Draw draw(seed);
  constexpr int kTries = 8;
  if (!draw.one_in(5)) {
    const asts::ByteCaseLimits& limits = *asts::fuzz::find_target(ASTS_FUZZ_TARGET)->limits;
    const asts::Case content = asts::case_of_bytes({data, size}, limits);
    for (int i = 0; i < kTries; ++i) {
      const auto changed = asts::fuzz::mutated(content, draw);
      if (!changed || *changed == content) continue;
      const auto bytes = asts::bytes_of_case(*changed, limits);
      if (!bytes || bytes->size() > max_size) continue;
      std::copy(bytes->begin(), bytes->end(), data);
      return bytes->size();
    }
  }
  return LLVMFuzzerMutate != nullptr ? LLVMFuzzerMutate(data, size, max_size) : size;
}
