#pragma once

#include <map>

#include "properties/ledger/record.hpp"
#include "reports/html/check_page.hpp"
#include "reports/html/html.hpp"
#include "reports/html/shown_mesh.hpp"

namespace asts {

/// How the verdicts on one statement came out.
struct StatementCounts {
  Statement statement;
  std::map<Outcome, std::int64_t> trials{
      {Outcome::holds, 0}, {Outcome::violated, 0}, {Outcome::not_applicable, 0}, {Outcome::undecided, 0}};
  std::int64_t met = 0;         ///< of a claim: the sum of Trial::met
  std::int64_t trials_met = 0;  ///< of a claim: trials with met > 0
  LedgerBounds bounds;          ///< of the decided trials
};

/// In the order of the run's properties and claims.
std::vector<StatementCounts> counts_of(const CheckRun& run);

/// The sections of a check's page, each at the end of its parent.

/// The ledger: each property and claim with its counts, hypothesis coverage and bounds.
void add_statements(HtmlNode parent, const CheckRun& run);
/// For each case and each statement that it violates: the first mesh that does, with its pictures and numbers.
void add_check_findings(HtmlNode parent, const CheckRun& run, MeshGallery& gallery);
/// All meshes with their figures and verdicts; the last one of each case that nothing violates is drawn.
void add_meshes(HtmlNode parent, const CheckRun& run, MeshGallery& gallery);
/// Meshes by level and size.
void add_sizes(HtmlNode parent, const CheckRun& run);

}  // namespace asts
