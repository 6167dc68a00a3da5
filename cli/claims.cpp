#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "reports/claims_report.hpp"

namespace asts::cli {

int claims(const ClaimsOptions& options) {
  for (const Claim& claim : all_claims()) {
    print(options.format == Format::json ? claim_json(claim) : claim_text(claim));
  }
  return kHolds;
}

}  // namespace asts::cli
