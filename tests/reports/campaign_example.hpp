#pragma once

#include "properties/campaign/summary.hpp"

namespace asts::testing {

/// A campaign with one of each: a claim without a violation, one whose violation is expected, one with a violation that
/// is not, one that died, one whose hypothesis was never met, and a death outside of claims.
struct CampaignExample {
  CampaignSummary summary;
  std::vector<HealthProblem> problems;
};

inline LedgerRecord example_record(const char* claim, std::int64_t met, std::int64_t violated) {
  LedgerRecord record;
  record.claim = claim;
  record.meshes = 40;
  record.violated = violated;
  record.holds = met > 0 ? 40 - violated : 0;
  record.not_applicable = met > 0 ? 0 : 40;
  record.met = met;
  record.trials_met = met > 0 ? 40 : 0;
  return record;
}

inline Case example_case() {
  Case content{{3, 3, 3}, 2, {4, 4, 5}, {}, false, {}};
  const CompactRational one(1);
  content.steps = {{Step::Kind::subdivide, {Point{one, one, one}}},
                   {Step::Kind::subdivide, {Point{CompactRational(Rational(3) / 2), one, one}}}};
  return content;
}

inline CampaignFinding example_finding(const char* claim, const char* kind, bool expected) {
  CampaignFinding finding;
  finding.claim = claim;
  finding.kind = kind;
  finding.expected = expected;
  finding.number = 17;
  finding.step = 2;
  finding.content = example_case();
  finding.minimized = FindingSize{{false, 2, 2, 80, 9, 2, 2}, Guarantee::one_minimal, 123};
  finding.file = std::string("findings/") + (*claim ? claim : "none") + "-" + kind + "-00ff.case";
  finding.says = "v and w share volume\nand do not overlap";
  finding.valid = true;
  return finding;
}

inline CampaignFinding example_death(const char* claim, const char* kind) {
  CampaignFinding finding = example_finding(claim, kind, false);
  finding.minimized.reset();
  finding.valid.reset();
  finding.says = "no end within 60 s";
  return finding;
}

inline CampaignExample campaign_example() {
  CampaignExample example;
  CampaignSummary& summary = example.summary;
  summary.version = "1.2.3";
  summary.claims = {"patches-nested", "as-implies-dc", "as-implies-dc-repaired", "closure-least", "sigma-unperturbed"};
  summary.seed = 7;
  summary.cases = 20;
  summary.meshes = 60;
  summary.distinct = 50;
  summary.trivial = 9;
  summary.sequences = 6;
  summary.biases = {{"boxes-cut", 0}, {"marks-deep", 20}};
  summary.generated = {{"elements", {{128, 20}, {1024, 30}}}, {"level", {{0, 9}, {2, 41}}}};
  summary.records = {example_record("patches-nested", 100, 0), example_record("as-implies-dc", 200, 3),
                     example_record("as-implies-dc-repaired", 200, 1), example_record("closure-least", 90, 0),
                     example_record("sigma-unperturbed", 0, 0)};
  summary.findings = {example_finding("as-implies-dc", "no-partial-overlap", true),
                      example_finding("as-implies-dc-repaired", "no-partial-overlap", false),
                      example_death("closure-least", "timeout"), example_death("", "crash")};
  example.problems = {{"hypothesis-never-met", "sigma-unperturbed", "its hypothesis was met in none of 40 trials"},
                      {"trivial-meshes", "", "30 of 50"}};
  return example;
}

/// Bytes that are no text: a control character, a byte that begins no character, an overlong one, half of a surrogate
/// pair, and what XML and JSON escape; in the words of a finding, its kind and a health problem.
inline CampaignExample hostile_example() {
  CampaignExample example = campaign_example();
  const std::string hostile =
      std::string("\x01\x1b[31m \xff \xc0\x80 \xed\xa0\x80 \xef\xbf\xbe <a b=\"c\">&]]> \\ ") + '\0' + "\xc3";
  example.summary.version += hostile;
  for (CampaignFinding& finding : example.summary.findings) {
    finding.says += hostile;
    finding.validation = hostile;
  }
  example.problems[1].says += hostile;
  return example;
}

}  // namespace asts::testing
