#pragma once

#include <span>

#include "properties/ledger/record.hpp"
#include "reports/html/html.hpp"

namespace asts {

/// The ledger of claims: a table with each claim's status, result, source, counts, hypothesis coverage and bounds, the
/// statements as they are tested, and where decided trials came from.
void add_claim_tables(HtmlNode parent, std::span<const LedgerRecord> records);

/// How far the decided trials of claims and properties went, as a table.
using BoundsByName = std::vector<std::pair<std::string, LedgerBounds>>;
void add_bounds_table(HtmlNode parent, const BoundsByName& bounds);

/// "statement-ID", where a claim's statement stands on the page.
std::string statement_id(const std::string& claim);

/// The source and the statement of a claim or a property, and what its hypothesis coverage counts.
void add_statement(HtmlNode list, const std::string& id);

/// "4 x 4 x 5", or "-" of nothing.
std::string sizes_text(const PerAxis<int>& sizes, const char* between);

}  // namespace asts
