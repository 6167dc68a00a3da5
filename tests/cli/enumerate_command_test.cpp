#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <set>
#include <thread>

#include "lib/gen/enumerate.hpp"
#include "lib/mesh/case_file.hpp"
#include "properties/claims/claim.hpp"
#include "properties/properties.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/reference/decide.hpp"
#include "tests/reference/refine.hpp"

namespace asts::testing {
namespace {

using Names = std::vector<std::string>;
using Json = nlohmann::ordered_json;

const Names kProperties{"admissible", "nested-patches", "analysis-suitable", "dual-compatible", "dual-basis"};

Names with_properties(Names arguments) {
  arguments.insert(arguments.begin(), {"enumerate", "--format", "json"});
  for (const std::string& property : kProperties) arguments.insert(arguments.end(), {"--property", property});
  return arguments;
}

std::map<std::string, Json> records_by_id(const Outcome& outcome) {
  std::map<std::string, Json> records;
  for (const Json& record : records_of(outcome.out)) records[record.begin().value()] = record;
  return records;
}

/// All meshes that at most so many literal subdivisions make, and with how many.
std::map<std::size_t, std::set<reference::Mesh>> literal_meshes(const reference::Setting& setting, std::size_t most) {
  std::map<std::size_t, std::set<reference::Mesh>> meshes{{0, {reference::initial_mesh(setting)}}};
  for (std::size_t subdivisions = 1; subdivisions <= most; ++subdivisions) {
    for (const reference::Mesh& mesh : meshes[subdivisions - 1]) {
      for (std::size_t k = 0; k < mesh.size(); ++k) {
        reference::Mesh next = reference::subdivide(setting, mesh, {k});
        std::sort(next.begin(), next.end());
        meshes[subdivisions].insert(std::move(next));
      }
    }
  }
  return meshes;
}

struct LiteralCount {
  std::int64_t meshes = 0, violations = 0, not_applicable = 0;
  std::optional<std::size_t> fewest;  ///< subdivisions of a violating mesh
};

std::map<std::string, LiteralCount> literal_counts(const reference::Setting& setting, std::size_t most) {
  std::map<std::string, LiteralCount> counts;
  for (const auto& [subdivisions, meshes] : literal_meshes(setting, most)) {
    for (const reference::Mesh& mesh : meshes) {
      const reference::Verdicts verdicts = reference::decide(setting, mesh);
      const reference::Verdict all[] = {verdicts.admissible, verdicts.nested_patches, verdicts.analysis_suitable,
                                        verdicts.dual_compatible, verdicts.dual_basis};
      for (std::size_t i = 0; i < kProperties.size(); ++i) {
        LiteralCount& count = counts[kProperties[i]];
        ++count.meshes;
        count.not_applicable += all[i] == reference::Verdict::not_applicable;
        if (all[i] != reference::Verdict::violated) continue;
        ++count.violations;
        if (!count.fewest) count.fewest = subdivisions;
      }
    }
  }
  return counts;
}

void expect_counts(const Json& record, const LiteralCount& count) {
  EXPECT_EQ(record["meshes"], count.meshes);
  EXPECT_EQ(record["violations"], count.violations);
  EXPECT_EQ(record["not_applicable"], count.not_applicable);
  EXPECT_EQ(record["applicable"], count.meshes - count.not_applicable);
  EXPECT_EQ(record["undecided"], 0);
  ASSERT_EQ(record["smallest"].is_null(), count.violations == 0);
  if (!count.fewest) return;
  const std::string text = record["smallest"];
  EXPECT_EQ(parse_case(text, "smallest").steps.size(), *count.fewest);
  const auto checked = records_of(run({"check", "-", "--final", "--format", "json"}, text).out);
  EXPECT_EQ(checked[0]["properties"][std::string(record["property"])]["verdict"], "violated");
}

struct Scope {
  reference::Setting setting;
  std::size_t subdivisions;
};

// Domains on which the literal code is quick: one active node, none, and lines of nodes.
TEST(EnumerateCommand, CountsVerdictsAsTheLiteralCodeDoes) {
  const Scope scopes[] = {
      {{{3, 3, 3}, 2, {4, 4, 4}}, 1}, {{{3, 3, 3}, 3, {4, 4, 5}}, 1}, {{{3, 3, 3}, 2, {3, 1, 1}}, 3}};
  for (const auto& [setting, subdivisions] : scopes) {
    const auto list = [](const std::array<int, 3>& values) {
      return std::to_string(values[0]) + "," + std::to_string(values[1]) + "," + std::to_string(values[2]);
    };
    const Outcome outcome =
        run(with_properties({"--degree", list(setting.degree), "--grading", std::to_string(setting.grading), "--domain",
                             list(setting.domain), "--max-subdivisions", std::to_string(subdivisions)}));
    const auto records = records_by_id(outcome);
    for (const auto& [property, count] : literal_counts(setting, subdivisions)) {
      SCOPED_TRACE(property + " on " + list(setting.domain));
      expect_counts(records.at(property), count);
    }
  }
}

// The counts of the scopes that findings refer to.
TEST(EnumerateCommand, CountsDistinctMeshes) {
  const auto meshes = [](const Names& arguments) {
    return records_of(run(with_properties(arguments)).out).front()["meshes"].get<std::int64_t>();
  };
  EXPECT_EQ(meshes({"--domain", "4,4,5", "--max-subdivisions", "3"}), 98'601);
  EXPECT_EQ(meshes({"--domain", "5,5,8", "--max-subdivisions", "2"}), 20'501);
}

TEST(EnumerateCommand, AdmissibleMeshesAreThoseThatHoldAdmissible) {
  for (const char* grading : {"2", "3"}) {
    const Names arguments{"--grading", grading, "--domain", "1,2,7", "--max-subdivisions", "4"};
    Names admissible = arguments;
    admissible.emplace_back("--admissible");
    const Json all = records_by_id(run(with_properties(arguments)))["admissible"];
    const Json part = records_by_id(run(with_properties(admissible)))["admissible"];
    EXPECT_EQ(part["meshes"], all["meshes"].get<std::int64_t>() - all["violations"].get<std::int64_t>());
    EXPECT_GT(all["violations"], 0);
    EXPECT_EQ(part["violations"], 0);
  }
}

/// Properties, and claims of which one mesh is tried for all its reflections.
Names with_reflecting_statements(const Names& scope) {
  Names arguments = with_properties(scope);
  for (const Claim& claim : all_claims()) {
    if (claim.reflects) arguments.insert(arguments.end(), {"--claim", claim.id});
  }
  return arguments;
}

// One mesh for all its reflections gives the same bytes as every mesh.
TEST(EnumerateCommand, SymmetryDoesNotChangeTheResult) {
  const Names scopes[] = {{"--domain", "4,4,5", "--max-subdivisions", "2"},
                          {"--domain", "4,5,4", "--grading", "3", "--max-subdivisions", "1"},
                          {"--domain", "4,4,6", "--max-subdivisions", "2", "--admissible"},
                          {"--domain", "1,2,2", "--max-subdivisions", "3"}};
  for (const Names& scope : scopes) {
    Names arguments = with_reflecting_statements(scope);
    const Outcome with = run(arguments);
    arguments.emplace_back("--no-symmetry");
    const Outcome without = run(arguments);
    EXPECT_EQ(with.out, without.out) << ::testing::PrintToString(scope);
    EXPECT_EQ(with.exit_code, without.exit_code);
  }
}

struct Total {
  std::int64_t violations = 0, not_applicable = 0, met = 0;
};

void add(Total& total, const Trial& trial) {
  total.violations += trial.verdict.outcome == asts::Outcome::violated;
  total.not_applicable += trial.verdict.outcome == asts::Outcome::not_applicable;
  total.met += trial.met;
}

/// Each mesh by itself, without regard to the meshes before it: the properties, and the claims that a mesh need not be
/// tried for again when its splines have not changed.
std::map<std::string, Total> totals_mesh_by_mesh(const Enumeration& enumeration) {
  std::map<std::string, Total> totals;
  enumerate_meshes(enumeration, [&](const EnumeratedMesh& enumerated) {
    MeshUnderTest mesh(enumerated.tree);
    for (const Property& property : all_properties()) add(totals[property.id], Trial{decide(property, mesh)});
    for (const Claim& claim : all_claims()) {
      if (claim.of_splines) add(totals[claim.id], try_on_mesh(claim, mesh));
    }
  });
  return totals;
}

TEST(EnumerateCommand, TotalsAreThoseOfEachMeshByItself) {
  const std::pair<Names, Enumeration> scopes[] = {
      {{"--domain", "4,4,5", "--max-subdivisions", "2"}, {{{3, 3, 3}, 2, {4, 4, 5}}, 2}},
      {{"--domain", "5,4,4", "--grading", "3", "--max-subdivisions", "2"}, {{{3, 3, 3}, 3, {5, 4, 4}}, 2}},
      {{"--degree", "3,5,3", "--domain", "4,6,5", "--max-subdivisions", "2", "--admissible"},
       {{{3, 5, 3}, 2, {4, 6, 5}}, 2, true}}};
  for (const auto& [scope, enumeration] : scopes) {
    Names arguments = with_properties(scope);
    for (const Claim& claim : all_claims()) {
      if (claim.of_splines) arguments.insert(arguments.end(), {"--claim", claim.id});
    }
    const auto records = records_by_id(run(arguments));
    for (const auto& [id, total] : totals_mesh_by_mesh(enumeration)) {
      const Json& record = records.at(id);
      EXPECT_EQ(record["violations"], total.violations) << record;
      EXPECT_EQ(record["not_applicable"], total.not_applicable) << record;
      if (record.contains("claim")) {
        EXPECT_EQ(record["met"], total.met) << record;
      }
    }
  }
}

// Without --claim and --property all claims about one mesh are tried; the others cannot be asked for.
TEST(EnumerateCommand, TriesAllClaimsAboutOneMesh) {
  Names ids;
  for (const Claim& claim : all_claims()) {
    if (claim.on_mesh != nullptr) {
      ids.emplace_back(claim.id);
      continue;
    }
    const Outcome outcome = run({"enumerate", "--max-subdivisions", "0", "--claim", claim.id});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err, std::string("asts: claim '") + claim.id + "' is not about one mesh\n");
  }
  Names tried;
  for (const Json& record : records_of(run({"enumerate", "--max-subdivisions", "0", "--format", "json"}).out)) {
    EXPECT_EQ(record["meshes"], 1);
    EXPECT_TRUE(record["met"].is_number());
    tried.push_back(record["claim"]);
  }
  EXPECT_EQ(tried, ids);
}

TEST(EnumerateCommand, ExitCodesSayWhatWasFound) {
  const Names scope{"enumerate", "--domain", "4,4,5", "--max-subdivisions", "2"};
  const auto exit_code = [&](Names more) {
    more.insert(more.begin(), scope.begin(), scope.end());
    return run(more).exit_code;
  };
  EXPECT_EQ(exit_code({"--property", "admissible"}), 1);
  EXPECT_EQ(exit_code({"--property", "admissible", "--admissible"}), 0);
  EXPECT_EQ(exit_code({"--property", "analysis-suitable"}), 0);
}

TEST(EnumerateCommand, ShowsATableAndTheSmallestCase) {
  const Outcome outcome = run({"enumerate", "--max-subdivisions", "2", "--property", "admissible", "--property",
                               "analysis-suitable", "--domain", "4,4,5"});
  const Names lines = lines_of(outcome.out);
  ASSERT_EQ(lines.size(), 11U) << outcome.out;
  EXPECT_TRUE(lines[0].starts_with("claim "));
  EXPECT_TRUE(lines[1].starts_with("admissible "));
  EXPECT_TRUE(lines[2].starts_with("analysis-suitable "));
  EXPECT_EQ(lines[4], "# admissible is violated; with the fewest subdivisions by");
  EXPECT_EQ(lines[9], "subdivide 0 0 0");
  EXPECT_EQ(lines[10], "subdivide 0 0 0");
  EXPECT_EQ(outcome.err, "");
}

TEST(EnumerateCommand, RejectsWhatItCannotDo) {
  const std::pair<Names, std::string> faults[] = {
      {{"enumerate"}, "asts: --max-subdivisions is required"},
      {{"enumerate", "--property", "admissible", "--max-subdivisions", "-1"},
       "asts: the number of subdivisions is negative"},
      {{"enumerate", "--property", "admissible", "--max-subdivisions", "99"},
       "asts: so many subdivisions cannot be enumerated"},
      {{"enumerate", "--max-subdivisions", "1", "--domain", "4,4"}, "asts: --domain takes three numbers"},
      {{"enumerate", "--max-subdivisions", "1", "--degree", "3,4,3"}, "asts: the degree '4' is even"},
      {{"enumerate", "--max-subdivisions", "1", "--grading", "1"}, "asts: the grading '1' is below 2"},
      {{"enumerate", "--max-subdivisions", "1", "--claim", "none"}, "asts: no claim is called 'none'"},
      {{"enumerate", "--max-subdivisions", "1", "--property", "none"}, "asts: no property is called 'none'"},
  };
  for (const auto& [arguments, reason] : faults) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << reason;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(outcome.err.starts_with(reason)) << outcome.err;
  }
}

// There is no end in sight when the interrupt comes.
TEST(EnumerateCommand, EndsWithNothingWhenInterrupted) {
  Process process({"enumerate", "--property", "dual-basis", "--max-subdivisions", "9"});
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  kill(process.id(), SIGINT);
  const Outcome outcome = process.wait();
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "");
}

}  // namespace
}  // namespace asts::testing
