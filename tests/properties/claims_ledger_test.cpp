#include <gtest/gtest.h>

#include <iostream>

#include "lib/mesh/case_file.hpp"
#include "properties/ledger/ledger.hpp"
#include "reports/checked_in_ledger.hpp"
#include "reports/ledger_report.hpp"

namespace asts {
namespace {

/// The claims are dealt out, so that several cores have work.
constexpr int kShares = 6;

class ClaimsLedger : public testing::TestWithParam<int> {};

std::vector<const Claim*> claims_of(int share) {
  std::vector<const Claim*> claims;
  for (std::size_t i = 0; i < all_claims().size(); ++i) {
    if (static_cast<int>(i) % kShares == share) claims.push_back(&all_claims()[i]);
  }
  return claims;
}

// The ledger in short: no claim that is not refuted is violated, and no claim is without a trial that met its
// hypothesis. `asts ledger` does the same with another seed.
TEST_P(ClaimsLedger, HasNoViolationAndNoSilentClaim) {
  LedgerPlan plan;
  plan.claims = claims_of(GetParam());
  Ledger ledger(plan, violation_text);
  ledger.run([](const char*, std::int64_t, std::int64_t) {});
  std::cout << ledger_text(ledger.records());
  for (const LedgerRecord& record : ledger.records()) {
    EXPECT_NE(record.result(), LedgerResult::undecided) << record.claim;
    if (find_claim(record.claim)->refuted || record.violated == 0) continue;
    ADD_FAILURE() << record.claim << " is violated by\n"
                  << (record.smallest->content ? write_case(*record.smallest->content) : "") << record.smallest->says;
  }
}

INSTANTIATE_TEST_SUITE_P(Shares, ClaimsLedger, testing::Range(0, kShares));

}  // namespace
}  // namespace asts
