#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "lib/mesh/case_file.hpp"
#include "reports/collection.hpp"

namespace asts::testing {

/// Calls visit(name, case, statement) for the collection and the findings, but for the one of 1307 steps.
template <typename Visit>
void for_each_collected(const Visit& visit) {
  for (const char* folder : {"collection", "findings"}) {
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(ASTS_CASES) + "/../../reports/" + folder)) {
      if (entry.path().extension() != ".case") continue;
      const std::string name = entry.path().filename().string();
      const auto about = parse_collection_name(name);
      ASSERT_TRUE(about) << entry.path();
      if (std::string(about->statement.id()) == "lambda-sums") continue;
      visit(name, read_case_file(entry.path().string()), about->statement);
    }
  }
}

}  // namespace asts::testing
