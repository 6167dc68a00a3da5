#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <map>

#include "fuzz/validation/compare_with_literal.hpp"
#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "properties/case_meshes.hpp"
#include "properties/properties.hpp"
#include "tests/literal_mesh.hpp"

namespace asts {
namespace {

/// Meshes in all shards together.
constexpr int kMeshes = 20'000;
constexpr int kShards = 8;

/// ASTS_MESHES asks for another number of meshes.
int meshes_per_shard() {
  const char* wanted = std::getenv("ASTS_MESHES");
  return ((wanted != nullptr ? std::atoi(wanted) : kMeshes) + kShards - 1) / kShards;
}

enum class Origin { refine, bare, boxes };

struct Tally {
  int meshes = 0;
  std::map<Origin, int> origins;
  std::map<Bias, int> biases;
  std::map<std::string, int> violated;  ///< by property
  int witnesses = 0;
  int not_applicable = 0;             ///< no splines to speak of
  int lambda_fails_where_not_dc = 0;  ///< among the meshes that are not dual-compatible
  int dual_compatible_only = 0;       ///< dual-compatible and not analysis-suitable
  int analysis_suitable_only = 0;     ///< analysis-suitable and not dual-compatible
};

/// Decides one mesh twice and compares; the fast verdicts.
std::map<std::string, std::string> compare(const Case& content, Tally& tally) {
  std::map<std::string, std::string> verdicts;
  with_last_mesh(content, [&](MeshUnderTest& mesh) {
    const auto difference =
        compare_with_literal(mesh, literal::setting(setting_of(content)), literal::last_mesh(content));
    EXPECT_FALSE(difference) << difference->about << ": " << difference->says;
    for (const Property& property : all_properties()) {
      const Verdict verdict = decide(property, mesh);
      verdicts[property.id] = outcome_name(verdict.outcome);
      tally.witnesses += verdict.witness.has_value();
    }
  });
  return verdicts;
}

void count(const std::map<std::string, std::string>& verdicts, Tally& tally) {
  for (const auto& [property, verdict] : verdicts) tally.violated[property] += verdict == "violated";
  tally.not_applicable += verdicts.at("dual-compatible") == "not-applicable";
  const bool dual_compatible = verdicts.at("dual-compatible") != "violated";
  tally.lambda_fails_where_not_dc += !dual_compatible && verdicts.at("dual-basis") == "violated";
  const bool analysis_suitable = verdicts.at("analysis-suitable") != "violated";
  tally.dual_compatible_only += dual_compatible && !analysis_suitable;
  tally.analysis_suitable_only += analysis_suitable && !dual_compatible;
}

/// Small enough for the literal code: some milliseconds a mesh. One case in eight has higher degrees, one in eight has
/// room for nodes that are far apart on one line.
RandomCase small_case(Draw& draw, Origin origin) {
  CaseLimits limits;
  limits.max_steps = 9;
  limits.max_elements = 300;
  if (draw.one_in(8)) {
    limits.max_degree = 5;
    limits.max_cubes = 180;
  } else if (draw.one_in(7)) {
    limits.max_side = 12;
    limits.max_cubes = 180;
  }
  switch (origin) {
    case Origin::refine:
      return random_admissible_case(draw, limits);
    case Origin::bare:
      return random_bare_case(draw, limits);
    default:
      return random_box_case(draw, limits);
  }
}

/// Admissible meshes are all alike to Sections 5 and 6; most are drawn from the other origins.
Origin draw_origin(Draw& draw) {
  const int number = draw.between(0, 6);
  return number == 0 ? Origin::refine : number <= 3 ? Origin::bare : Origin::boxes;
}

Tally run_shard(int shard) {
  Draw draw(static_cast<std::uint64_t>(shard));
  Tally tally;
  for (const int meshes = meshes_per_shard(); tally.meshes < meshes && !testing::Test::HasFailure(); ++tally.meshes) {
    const Origin origin = draw_origin(draw);
    const RandomCase random = small_case(draw, origin);
    SCOPED_TRACE(std::string(bias_name(random.bias)) + "\n" + write_case(random.content));
    ++tally.origins[origin];
    ++tally.biases[random.bias];
    count(compare(random.content, tally), tally);
  }
  return tally;
}

void report(const Tally& tally) {
  const auto say = [](const std::string& what, int number) {
    testing::Test::RecordProperty(what, number);
    std::cout << what << ": " << number << '\n';
  };
  say("meshes", tally.meshes);
  for (const auto& [property, number] : tally.violated) say("not-" + property, number);
  say("witnesses", tally.witnesses);
  say("without-splines", tally.not_applicable);
  say("lambda-fails-where-not-dual-compatible", tally.lambda_fails_where_not_dc);
  say("dual-compatible-but-not-analysis-suitable", tally.dual_compatible_only);
  say("analysis-suitable-but-not-dual-compatible", tally.analysis_suitable_only);
  for (const auto& [bias, number] : tally.biases) say(bias_name(bias), number);
}

class Differential : public testing::TestWithParam<int> {};

// The shards' shares add up to: half of the meshes not admissible, 500 of 20,000 not analysis-suitable, 500 not
// dual-compatible. A run that misses its share would say little, however green.
void expect_shares(Tally& tally) {
  EXPECT_GE(2 * tally.violated["admissible"], tally.meshes);
  EXPECT_GE(40 * tally.violated["analysis-suitable"], tally.meshes);
  EXPECT_GE(40 * tally.violated["dual-compatible"], tally.meshes);
  for (const Origin origin : {Origin::refine, Origin::bare, Origin::boxes}) {
    EXPECT_GE(10 * tally.origins[origin], tally.meshes);
  }
  EXPECT_EQ(tally.biases.size(), plain_biases().size());
}

TEST_P(Differential, FastAndLiteralVerdictsAgree) {
  Tally tally = run_shard(GetParam());
  report(tally);
  EXPECT_EQ(tally.meshes, meshes_per_shard());
  if (meshes_per_shard() * kShards >= kMeshes) expect_shares(tally);  // fewer meshes may miss them by chance
}

INSTANTIATE_TEST_SUITE_P(Shards, Differential, testing::Range(0, kShards));

}  // namespace
}  // namespace asts
