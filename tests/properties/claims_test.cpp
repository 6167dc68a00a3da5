#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "lib/mesh/case_file.hpp"
#include "properties/statement.hpp"
#include "tests/properties/claim_checks.hpp"

namespace asts {
namespace {

const std::filesystem::path kFindings =
    std::filesystem::weakly_canonical(std::filesystem::path(ASTS_CASES) / ".." / ".." / "reports" / "findings");

template <class T>
void append(std::vector<T>& all, std::vector<T> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<NegativeControl> all_controls() {
  std::vector<NegativeControl> all;
  for (const auto family : {refinement_controls, equation_controls, complexity_controls, skeleton_controls,
                            theorem_5_3_controls, suitability_controls, functional_controls, independence_controls}) {
    append(all, family());
  }
  return all;
}

std::vector<Confirmation> all_confirmations() {
  std::vector<Confirmation> all;
  for (const auto family :
       {refinement_confirmations, equation_confirmations, complexity_confirmations, skeleton_confirmations,
        theorem_5_3_confirmations, suitability_confirmations, functional_confirmations, independence_confirmations}) {
    append(all, family());
  }
  return all;
}

/// The counterexample of a finding, as the findings' folder has it.
Case counterexample_of(const Claim& claim) {
  return read_case_file((kFindings / (std::string(claim.id) + ".case")).string());
}

bool violated(const Trial& trial) { return trial.verdict.outcome == Outcome::violated; }

TEST(Claims, HaveUniqueIdsAndSomethingToDecide) {
  std::set<std::string> ids;
  for (const Claim& claim : all_claims()) {
    EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
    EXPECT_TRUE(claim.on_mesh || claim.on_sequence || claim.alone) << claim.id;
  }
}

TEST(Claims, OfTheLedgerAreAllThere) {
  EXPECT_EQ(ledger_ids().size(), 43U);
  for (const std::string_view id : ledger_ids()) EXPECT_NE(find_claim(id), nullptr) << id;
}

// The index of the findings names each of them, and nothing that is not refuted.
TEST(Claims, ThatAreRefutedStandInTheIndexOfFindings) {
  std::ifstream file(kFindings / "README.md");
  const std::string index{std::istreambuf_iterator<char>(file), {}};
  for (const Claim& claim : all_claims()) {
    const std::string link = std::string("[") + claim.id + "](" + claim.id + ".md)";
    EXPECT_EQ(index.find(link) != std::string::npos, claim.refuted) << claim.id;
  }
}

TEST(Claims, ThatAreRefutedHaveARepairedForm) {
  for (const Claim& claim : all_claims()) {
    if (claim.refuted) {
      EXPECT_NE(find_claim(std::string(claim.id) + "-repaired"), nullptr) << claim.id;
    }
  }
}

// Every planted fault is reported as a violation, and no claim is without one.
TEST(Claims, ReportPlantedFaults) {
  std::set<std::string> controlled;
  for (const NegativeControl& control : all_controls()) {
    controlled.insert(control.claim);
    EXPECT_NE(find_claim(control.claim), nullptr) << control.claim;
    EXPECT_EQ(control.run().outcome, Outcome::violated) << control.claim << ": " << control.fault;
  }
  for (const Claim& claim : all_claims()) EXPECT_TRUE(controlled.contains(claim.id)) << claim.id << " has no control";
}

// A refuted claim has a finding, its counterexample violates the claim, and the literal code says so too.
TEST(Claims, ThatAreRefutedHaveAConfirmedCounterexample) {
  const std::vector<Confirmation> confirmations = all_confirmations();
  for (const Claim& claim : all_claims()) {
    if (!claim.refuted) continue;
    EXPECT_TRUE(std::filesystem::exists(kFindings / (std::string(claim.id) + ".md"))) << claim.id;
    const Case counterexample = counterexample_of(claim);
    EXPECT_TRUE(violated(try_on_case({&claim, nullptr}, counterexample))) << claim.id;
    int confirmed = 0;
    for (const Confirmation& confirmation : confirmations) {
      if (std::string(confirmation.claim) == claim.id) confirmed += confirmation.refutes(counterexample);
    }
    EXPECT_EQ(confirmed, 1) << claim.id << ": the literal code";
  }
}

}  // namespace
}  // namespace asts
