// The entry of a fuzzer: libFuzzer, AFL++'s driver and others call it. ASTS_FUZZ_TARGET is the target's name.

#include <cstdio>
#include <cstdlib>

#include "fuzz/targets/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const asts::fuzz::Target* const target = asts::fuzz::find_target(ASTS_FUZZ_TARGET);
  const asts::fuzz::Fault fault = asts::fuzz::checked_fault(*target, {data, size});
  if (!fault) return 0;
  std::fprintf(stderr, "%s: %s\n", target->name, fault->c_str());
  std::abort();
}
