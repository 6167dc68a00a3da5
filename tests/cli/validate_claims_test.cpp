#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "properties/claims/claim.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/reference/claim_witness.hpp"

namespace asts::testing {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

const fs::path kRoot = fs::path(ASTS_CASES) / ".." / "..";

/// The first two are sequences of 1302 and 117 calls of refine; the mesh of the third has 10728 elements, which the
/// literal Algorithm 2.9 needs half a minute for.
const std::set<std::string> kTooLarge{"lambda-sums.case", "experiment-constant.case", "example-2.10-m2.case"};

Names case_files() {
  Names files;
  for (const fs::path& folder : {fs::path(ASTS_CASES), kRoot / "reports" / "findings"}) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      const fs::path& path = entry.path();
      if (path.extension() == ".case" && !kTooLarge.contains(path.filename().string())) files.push_back(path.string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// The last mesh of every case against every claim about meshes.
std::string records_of_all_claims() {
  Names arguments{"check", "--final", "--format", "json"};
  for (const Claim& claim : all_claims()) {
    if (claim.on_mesh == nullptr) continue;
    arguments.emplace_back("--claim");
    arguments.emplace_back(claim.id);
  }
  for (const std::string& file : case_files()) arguments.push_back(file);
  return run(arguments).out;
}

// Whatever the program says against a claim of the paper, the literal code says too.
TEST(ValidateClaims, FindsEveryWitnessOfEveryCaseValid) {
  const TemporaryFolder folder;
  const std::string file = folder.write("records", records_of_all_claims());
  std::set<std::string> refuted;
  std::size_t witnesses = 0;
  for (const auto& record : records_of(content_of(file))) {
    for (const auto& [id, entry] : record["claims"].items()) {
      if (entry["verdict"] != "violated") continue;
      ++witnesses;
      refuted.insert(id);
    }
  }
  std::set<std::string> expected;
  for (const Claim& claim : all_claims()) {
    if (claim.refuted && claim.on_mesh != nullptr) expected.insert(claim.id);
  }
  EXPECT_EQ(refuted, expected);
  const auto findings = records_of(run({"validate", "--format", "json", file}).out);
  EXPECT_EQ(findings.size(), witnesses);
  for (const auto& finding : findings) EXPECT_EQ(finding["valid"], true) << finding.dump();
}

/// The texts "word-word" in the sources of the claims: their ids, and the kinds of their witnesses.
std::set<std::string> hyphenated_texts() {
  std::set<std::string> texts;
  const std::regex pattern("\"([a-z0-9]+(-[a-z0-9]+)+)\"");
  for (const auto& entry : fs::directory_iterator(kRoot / "properties" / "claims")) {
    const std::string content = content_of(entry.path().string());
    for (std::sregex_iterator match(content.begin(), content.end(), pattern); match != std::sregex_iterator();
         ++match) {
      texts.insert((*match)[1]);
    }
  }
  return texts;
}

// A kind that somebody adds without a form for it would make witnesses that nobody can validate.
TEST(ValidateClaims, HasAFormForEveryKindThatTheClaimsSourcesName) {
  std::set<std::string> kinds;
  for (const reference::ClaimKind& form : reference::all_claim_kinds()) kinds.insert(form.kind);
  const std::set<std::string> texts = hyphenated_texts();
  EXPECT_TRUE(texts.contains("wrong-slice-node"));
  for (const std::string& text : texts) {
    if (find_claim(text) != nullptr || text == "analysis-suitable") continue;  // the latter is a figure's caption
    EXPECT_TRUE(kinds.contains(text)) << text;
  }
}

TEST(ValidateClaims, HasAFormForEveryClaimAndNoOther) {
  std::set<std::string> claims;
  for (const reference::ClaimKind& form : reference::all_claim_kinds()) {
    EXPECT_NE(find_claim(form.claim), nullptr) << form.claim;
    claims.insert(form.claim);
  }
  for (const Claim& claim : all_claims()) EXPECT_TRUE(claims.contains(claim.id)) << claim.id;
}

// reports/WITNESS.md has every kind and every sentence.
TEST(ValidateClaims, DocumentsEveryForm) {
  const std::string document = content_of((kRoot / "reports" / "WITNESS.md").string());
  for (const reference::ClaimKind& form : reference::all_claim_kinds()) {
    EXPECT_NE(document.find("`" + std::string(form.claim) + "`"), std::string::npos) << form.claim;
    EXPECT_NE(document.find("`" + std::string(form.kind) + "`"), std::string::npos) << form.kind;
    if (form.says == nullptr) continue;
    EXPECT_NE(document.find(form.says), std::string::npos) << form.claim << ": " << form.says;
  }
}

}  // namespace
}  // namespace asts::testing
