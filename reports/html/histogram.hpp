#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "reports/html/html.hpp"

namespace asts {

/// Counts by what is counted: a table with a bar for each, the largest one as wide as its column.
void add_histogram(HtmlNode parent, const std::string& id, const std::string& caption, const std::string& what,
                   const std::string& unit, const std::vector<std::pair<std::string, std::int64_t>>& counts);

}  // namespace asts
