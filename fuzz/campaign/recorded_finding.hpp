#pragma once

#include <map>
#include <string>
#include <vector>

#include "fuzz/campaign/state.hpp"
#include "reports/html/campaign_page.hpp"

namespace asts {

/// What findings.jsonl says of findings beyond CampaignFinding. A finding may stand in several lines, one for each time
/// that it was found.
class FindingDetails {
 public:
  /// Takes the next line, gives its findings to the state. Throws InputError for a line that is none of this campaign,
  /// or has numbers that contradict each other.
  void add(const std::string& line, CampaignState& state);

  /// Those of the findings, in their order.
  std::vector<CampaignRecords::Details> of(const std::vector<CampaignFinding>& findings) const;

  /// Where lines about one finding contradict each other.
  const std::vector<std::string>& differences() const { return differences_; }

 private:
  void merge(const CampaignFinding& finding, CampaignRecords::Details details);

  struct Known {
    CampaignFinding finding;
    CampaignRecords::Details details;
  };
  std::map<std::string, Known> known_;  ///< by claim, kind and case
  std::vector<std::string> differences_;
};

}  // namespace asts
