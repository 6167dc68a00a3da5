#include <fmt/format.h>

#include <algorithm>

#include "reports/html/campaign_sections.hpp"
#include "reports/html/histogram.hpp"

namespace asts {

namespace {

using Unit = CampaignRecords::Unit;
using Times = CampaignRecords::Times;

/// Rows of a table of units; more units are put together in groups.
constexpr std::size_t kMostRows = 200;

std::string seconds(std::int64_t microseconds) {
  return fmt::format("{}.{:06} s", microseconds / 1'000'000, microseconds % 1'000'000);
}

/// "unit 3", "units 4 to 7"
std::string range_text(std::int64_t first, std::int64_t last) {
  return first == last ? fmt::format("unit {}", first) : fmt::format("units {} to {}", first, last);
}

/// Calls row(first, last) for groups of `count` things, so many that there are at most kMostRows.
template <typename Row>
void for_groups(std::size_t count, const Row& row) {
  const std::size_t size = std::max<std::size_t>(1, (count + kMostRows - 1) / kMostRows);
  for (std::size_t first = 0; first < count; first += size) row(first, std::min(count, first + size));
}

std::vector<HtmlCell> unit_row(const std::vector<Unit>& units, std::size_t first, std::size_t last) {
  Unit sum;
  for (std::size_t i = first; i < last; ++i) {
    const Unit& unit = units[i];
    for (const auto member : {&Unit::cases, &Unit::meshes, &Unit::distinct, &Unit::trivial, &Unit::sequences}) {
      sum.*member += unit.*member;
    }
    sum.events.insert(sum.events.end(), unit.events.begin(), unit.events.end());
  }
  std::string events;
  for (const std::string& event : sum.events) events += (events.empty() ? "" : "; ") + event;
  const std::string what = first + 1 == last ? units[first].what : units[first].what + ", ..., " + units[last - 1].what;
  return {text_cell(range_text(units[first].number, units[last - 1].number)),
          text_cell(what),
          number_cell(sum.cases),
          number_cell(sum.meshes),
          number_cell(sum.distinct),
          number_cell(sum.trivial),
          number_cell(sum.sequences),
          text_cell(events.empty() ? "-" : events)};
}

void add_unit_table(HtmlNode parent, const std::vector<Unit>& units) {
  HtmlTable table{"units-table",
                  "The units of work as recorded",
                  {"unit", "what", "cases", "meshes", "distinct", "initial", "sequences", "violations and deaths"},
                  {}};
  for_groups(units.size(),
             [&](std::size_t first, std::size_t last) { table.rows.push_back(unit_row(units, first, last)); });
  add_table(add_details(parent, fmt::format("Units of work: {}", units.size())), table);
}

std::vector<HtmlCell> times_row(const std::vector<Times>& times, std::size_t first, std::size_t last) {
  std::int64_t total = 0;
  Times slowest = times[first];
  for (std::size_t i = first; i < last; ++i) {
    total += times[i].total;
    if (times[i].slowest > slowest.slowest) slowest = times[i];
  }
  return {text_cell(range_text(times[first].unit, times[last - 1].unit)),
          {seconds(total), true},
          {seconds(slowest.slowest), true},
          number_cell(slowest.slowest_number)};
}

void add_time_table(HtmlNode parent, const std::vector<Times>& times) {
  HtmlTable table{"times-table", "How long the units took", {"unit", "time", "slowest case", "its number"}, {}};
  for_groups(times.size(),
             [&](std::size_t first, std::size_t last) { table.rows.push_back(times_row(times, first, last)); });
  add_table(add_details(parent, "Time by unit"), table);
}

void add_claim_times(HtmlNode parent, const CampaignRecords& records) {
  std::vector<std::pair<std::string, std::int64_t>> counts;
  for (std::size_t i = 0; i < records.summary.claims.size(); ++i) {
    std::int64_t sum = 0;
    for (const Times& times : records.times) sum += i < times.claims.size() ? times.claims[i] : 0;
    counts.emplace_back(records.summary.claims[i], sum);
  }
  add_histogram(parent, "claim-times", "Time by claim", "claim", "microseconds", counts);
}

void add_totals(HtmlNode parent, const CampaignRecords& records) {
  std::int64_t total = 0;
  const Times* slowest = &records.times.front();
  for (const Times& times : records.times) {
    total += times.total;
    if (times.slowest > slowest->slowest) slowest = &times;
  }
  add_facts(parent, {{"time of all units", seconds(total)},
                     {"slowest case", fmt::format("case {}: {}", slowest->slowest_number, seconds(slowest->slowest))},
                     {"units with a time", std::to_string(records.times.size())}});
}

}  // namespace

void add_performance(HtmlNode parent, const CampaignRecords& records) {
  HtmlNode section = add_section(parent, 2, "performance", "Performance");
  if (records.times.empty()) {
    add_paragraph(section, "No times were recorded.");
  } else {
    add_paragraph(
        section,
        "Times of the machine that made the run, summed over its processes. Nothing else on this page depends "
        "on them; a unit that was done again after an interrupt counts again.");
    add_totals(section, records);
    add_claim_times(section, records);
    add_time_table(section, records.times);
  }
  add_unit_table(section, records.units);
}

}  // namespace asts
