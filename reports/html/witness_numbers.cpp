#include "reports/html/witness_numbers.hpp"

#include <algorithm>

#include "reports/witness_json.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

std::string scalar_text(const Json& json) {
  if (json.is_string()) return json.get<std::string>();
  return json.is_null() ? "-" : json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_list_of_scalars(const Json& json) {
  return json.is_array() && std::none_of(json.begin(), json.end(), [](const Json& one) { return one.is_structured(); });
}

std::string list_text(const Json& json) {
  std::string result;
  for (const Json& one : json) result += (result.empty() ? "(" : ", ") + scalar_text(one);
  return result.empty() ? "()" : result + ")";
}

/// "index_vectors" as people write it.
std::string spaced(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

void add_rows(HtmlTable& table, const std::string& name, const Json& json) {
  if (is_list_of_scalars(json)) {
    table.rows.push_back({text_cell(name), text_cell(list_text(json))});
    return;
  }
  if (!json.is_structured()) {
    table.rows.push_back({text_cell(name), text_cell(scalar_text(json))});
    return;
  }
  std::size_t place = 0;
  for (const auto& [key, value] : json.items()) {
    const std::string member = json.is_array() ? std::to_string(++place) : spaced(key);
    add_rows(table, name.empty() ? member : name + ", " + member, value);
  }
}

}  // namespace

void add_witness_numbers(HtmlNode parent, const std::string& id, const Witness& witness) {
  HtmlTable table{id, "The witness, in index coordinates", {"what", "value"}, {}};
  add_rows(table, "", witness_json(witness));
  add_table(parent, table);
}

}  // namespace asts
