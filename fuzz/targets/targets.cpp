#include "fuzz/targets/targets.hpp"

#include <algorithm>
#include <array>
#include <exception>

namespace asts::fuzz {

namespace {

constexpr ByteCaseLimits kSmallCases;

constexpr std::array kTargets{
    Target{"claims", claims_fault, &kSmallCases},
    Target{"differential", differential_fault, &kTinyCases},
    Target{"case_reader", case_reader_fault, nullptr},
    Target{"witness_reader", witness_reader_fault, nullptr},
};

}  // namespace

std::span<const Target> all_targets() { return kTargets; }

const Target* find_target(std::string_view name) {
  const auto found =
      std::find_if(kTargets.begin(), kTargets.end(), [&](const Target& target) { return target.name == name; });
  return found == kTargets.end() ? nullptr : &*found;
}

Fault checked_fault(const Target& target, Bytes bytes) {
  try {
    return target.fault(bytes);
  } catch (const std::exception& error) {
    return std::string("an exception that is not documented: ") + error.what();
  }
}

}  // namespace asts::fuzz
