#include "fuzz/targets/small_case.hpp"

namespace asts::fuzz {

bool is_small(const Case& content, std::int64_t most_elements) {
  std::int64_t elements = 1;
  for (const int side : content.domain) elements *= side;  // at most 10^8
  elements += static_cast<std::int64_t>(content.elements.size());
  for (const Step& step : content.steps) {
    if (elements > most_elements) return false;
    if (!step.marks.empty()) elements *= content.grading;  // at most 10^6 times the bound
  }
  return elements <= most_elements;
}

}  // namespace asts::fuzz
