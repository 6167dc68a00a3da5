#include "properties/campaign/provocations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/refine/replay.hpp"
#include "properties/campaign/provoked_cases.hpp"
#include "properties/ledger/trials.hpp"
#include "properties/statement.hpp"

namespace asts {
namespace {

constexpr std::uint64_t kDraws = 200;  // of law 2

class Provoked : public testing::TestWithParam<Provocation> {};

Case drawn(const Provocation& provocation, std::uint64_t seed) {
  Draw draw(seed);
  return provocation.draw(draw);
}

// Law 1. A tiling that is none is refused when the mesh is built.
TEST_P(Provoked, CasesAreValidAndDependOnTheStateAlone) {
  std::set<std::string> texts;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Case content = drawn(GetParam(), seed);
    const std::string text = write_case(content);
    EXPECT_EQ(parse_case(text, "provoked"), content);
    EXPECT_EQ(drawn(GetParam(), seed), content) << text;
    if (content.explicit_mesh) {
      EXPECT_NO_THROW(mesh_of(setting_of(content), content.elements)) << text;
    }
    texts.insert(text);
  }
  EXPECT_GE(texts.size(), 15U);
}

// Law 2.
TEST_P(Provoked, TheClaimIsViolatedWhereItIsRefutedAndElsewhereSaysSomething) {
  const Statement statement = find_statement(GetParam().claim).value();
  for (std::uint64_t seed = 1; seed <= kDraws; ++seed) {
    const Case content = drawn(GetParam(), seed);
    const Trial trial = try_on_case(statement, content);
    const bool violated = trial.verdict.outcome == Outcome::violated;
    ASSERT_TRUE(statement.claim->refuted || !violated) << write_case(content);
    if (statement.claim->refuted ? violated : trial.met > 0) return;
  }
  FAIL() << "none of " << kDraws << " cases";
}

std::string test_name(const testing::TestParamInfo<Provocation>& info) {
  std::string name = info.param.claim;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, Provoked, testing::ValuesIn(all_provocations().begin(), all_provocations().end()),
                         test_name);

TEST(Provocations, AreForClaimsAndNamedAfterThem) {
  std::set<std::string> names;
  for (const Bias bias : all_biases()) names.insert(bias_name(bias));
  for (const Provocation& one : all_provocations()) {
    ASSERT_NE(find_claim(one.claim), nullptr) << one.claim;
    EXPECT_EQ(one.name, "provoke-" + std::string(one.claim));
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_GE(one.rarity, 1);
  }
}

// The figure's mesh is not admissible, and larger than random meshes for the claim.
TEST(Provocations, AreTriedWhateverTheClassAndSizeThatTheClaimIsStatedFor) {
  const Claim* claim = find_claim("figure-proof-levels");
  for (const Claim* only : {claim, static_cast<const Claim*>(nullptr)}) {
    Draw draw(1);
    const Case content = figure_case(draw);
    Replay replay(content);
    while (!replay.done()) replay.advance();
    MeshUnderTest mesh(replay.tree());
    TrialSubject subject(0, content, "provoke-figure-proof-levels");
    subject.only = only;
    subject.step = content.steps.size();
    subject.looks_at(mesh, {});
    Trials trials({claim}, {});
    trials.on_mesh(subject, mesh);
    EXPECT_EQ(trials.records().front().violated, only != nullptr ? 1 : 0);
  }
}

}  // namespace
}  // namespace asts
