#pragma once

#include "properties/witness.hpp"
#include "reports/html/html.hpp"

namespace asts {

/// All numbers and texts of a witness by name, as in its JSON (reports/WITNESS.md): a table with the caption's id.
void add_witness_numbers(HtmlNode parent, const std::string& id, const Witness& witness);

}  // namespace asts
