#pragma once

#include "reports/html/campaign_page.hpp"
#include "reports/html/html.hpp"

namespace asts {

/// The sections of a campaign's page, each at the end of its parent.

/// Links to the findings, the unexpected ones first.
void add_finding_list(HtmlNode parent, const CampaignRecords& records);
/// Each finding with its statement, pictures, numbers, size and how sure that is, and the commands that decide it
/// again.
void add_findings(HtmlNode parent, const CampaignRecords& records);
/// Distinct meshes by level, size, m, degree and domain; cases by bias.
void add_generated(HtmlNode parent, const CampaignSummary& summary);
/// How long units, claims and cases took; units of work in a table, many of them in groups.
void add_performance(HtmlNode parent, const CampaignRecords& records);

}  // namespace asts
