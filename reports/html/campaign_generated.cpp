#include <array>

#include "reports/html/campaign_sections.hpp"
#include "reports/html/histogram.hpp"

namespace asts {

namespace {

/// How a feature of CampaignSummary::generated is called on the page.
struct Feature {
  const char* name;
  const char* caption;
  const char* value;
  bool up_to;  ///< values are the lowest powers of 2 that are not less
};

constexpr std::array kFeatures{
    Feature{"level", "Distinct meshes by their highest level", "level", false},
    Feature{"elements", "Distinct meshes by size", "elements", true},
    Feature{"grading", "Distinct meshes by m", "m", false},
    Feature{"degree", "Distinct meshes by their highest degree", "highest of p1, p2, p3", false},
    Feature{"volume", "Distinct meshes by domain", "unit cubes of the domain", true},
};

using Counts = std::vector<std::pair<std::string, std::int64_t>>;

Counts counts_of(const std::map<std::int64_t, std::int64_t>& values, bool up_to) {
  Counts counts;
  for (const auto& [value, count] : values) counts.emplace_back((up_to ? "up to " : "") + std::to_string(value), count);
  return counts;
}

}  // namespace

void add_generated(HtmlNode parent, const CampaignSummary& summary) {
  HtmlNode section = add_section(parent, 2, "generated", "What was generated");
  for (const Feature& feature : kFeatures) {
    const auto found = summary.generated.find(feature.name);
    if (found == summary.generated.end() || found->second.empty()) continue;
    add_histogram(section, std::string("generated-") + feature.name, feature.caption, feature.value, "distinct meshes",
                  counts_of(found->second, feature.up_to));
  }
  add_histogram(section, "generated-biases", "Cases by what they were drawn to provoke", "bias", "cases",
                {summary.biases.begin(), summary.biases.end()});
}

}  // namespace asts
