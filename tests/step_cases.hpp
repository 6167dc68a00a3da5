#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lib/gen/case_stream.hpp"
#include "lib/mesh/case_file.hpp"

namespace asts::testing {

/// A random case of steps; nothing when the stream has an explicit mesh at this number.
inline std::optional<Case> random_steps(std::int64_t number) {
  Case content = make_case(plan_case(41, number)).content;
  if (content.explicit_mesh) return std::nullopt;
  return content;
}

/// What was found to violate claims, and the smallest such cases, as far as they are short sequences of steps.
inline std::vector<Case> found_steps() {
  namespace fs = std::filesystem;
  std::vector<Case> cases;
  for (const char* folder : {"findings", "collection"}) {
    for (const auto& entry : fs::directory_iterator(fs::path(ASTS_CASES) / ".." / ".." / "reports" / folder)) {
      if (entry.path().extension() != ".case" || fs::file_size(entry.path()) > 10'000) continue;
      Case content = read_case_file(entry.path().string());
      if (!content.explicit_mesh && content.steps.size() <= 100) cases.push_back(std::move(content));
    }
  }
  return cases;
}

}  // namespace asts::testing
