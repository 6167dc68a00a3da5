#include "reports/html/histogram.hpp"

#include <algorithm>

#include "lib/exact/rational.hpp"

namespace asts {

void add_histogram(HtmlNode parent, const std::string& id, const std::string& caption, const std::string& what,
                   const std::string& unit, const std::vector<std::pair<std::string, std::int64_t>>& counts) {
  std::int64_t largest = 1;
  std::int64_t total = 0;
  for (const auto& [name, count] : counts) {
    largest = std::max(largest, count);
    total += count;
  }
  HtmlTable table{id, caption, {what, unit, "of all"}, {}};
  for (const auto& [name, count] : counts) {
    const Integer thousandths = Integer(count) * 1000 / largest;
    table.rows.push_back({text_cell(name),
                          {std::to_string(count), true, {}, thousandths.convert_to<int>()},
                          {percent(count, total), true}});
  }
  add_table(parent, table);
}

}  // namespace asts
