#include <gtest/gtest.h>
// rapidcheck's header needs gtest's before it.
#include <rapidcheck/gtest.h>

#include <iostream>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/admissibility.hpp"
#include "lib/refine/refinement.hpp"
#include "lib/refine/replay.hpp"
#include "properties/properties.hpp"

namespace asts {

/// What rapidcheck prints for a case: its text. Outside the unnamed namespace, where it looks for it.
static void showValue(const Case& test_case, std::ostream& out) { out << write_case(test_case); }

namespace {

// On admissible meshes all five properties are expected to hold: Definition 3.2 by Theorem 3.3, Lemma 3.4, Theorem 5.3,
// Theorem 6.6, Theorem 6.7. A failure here is a finding about the paper or a fault of the program; the case tells.

constexpr int kMeshes = 10'000;
constexpr int kShards = 8;

CaseLimits wide_limits(Draw& draw) {
  CaseLimits limits;
  limits.max_degree = 7;
  limits.max_side = 12;
  limits.max_cubes = draw.choose(std::vector<std::int64_t>{200, 400, 600, 1728});
  limits.max_elements = 6 * limits.max_cubes;
  limits.max_steps = 12;
  return limits;
}

/// The properties that do not hold, in words; empty when all do. Without active nodes the last three say nothing.
std::string violations(MeshUnderTest& mesh) {
  std::string result;
  for (const Property& property : all_properties()) {
    const Verdict verdict = decide(property, mesh);
    if (verdict.outcome == Outcome::holds) continue;
    if (verdict.outcome == Outcome::not_applicable && mesh.splines().size() == 0) continue;
    result += std::string(property.id) + ": " + outcome_name(verdict.outcome) + " " + verdict.reason + "\n";
  }
  return result;
}

/// The longest prefix of the case's steps that has been replayed, as text.
std::string text_up_to(Case content, const Replay& replay) {
  content.steps.resize(static_cast<std::size_t>(replay.counts().step));
  return write_case(content);
}

struct Tally {
  int meshes = 0;
  int with_splines = 0;
  int deepest = 0;
  std::int64_t elements = 0;
};

/// Every mesh of the sequence has all five properties; the history is admissible (Theorem 3.3) and so, by the
/// criterion, are the meshes.
void expect_all_properties(const Case& content, Tally& tally) {
  Replay replay(content);
  replay.watch_history();
  while (!replay.done()) {
    replay.advance();
    EXPECT_TRUE(replay.history_admissible()) << text_up_to(content, replay);
    MeshUnderTest mesh(replay.tree());
    EXPECT_EQ(violations(mesh), "") << text_up_to(content, replay);
    ++tally.meshes;
    tally.with_splines += mesh.splines().size() > 0;
    tally.elements += replay.tree().element_count();
    tally.deepest = std::max(tally.deepest, replay.tree().max_level());
  }
}

class AdmissibleMeshes : public testing::TestWithParam<int> {};

TEST_P(AdmissibleMeshes, HaveAllFiveProperties) {
  Draw draw(1000 + static_cast<std::uint64_t>(GetParam()));
  Tally tally;
  while (tally.meshes < kMeshes / kShards && !HasFailure()) {
    const CaseLimits limits = wide_limits(draw);
    expect_all_properties(random_admissible_case(draw, limits).content, tally);
  }
  RecordProperty("meshes", tally.meshes);
  std::cout << "meshes: " << tally.meshes << ", with active nodes: " << tally.with_splines
            << ", mean elements: " << tally.elements / tally.meshes << ", highest level: " << tally.deepest << '\n';
  EXPECT_GE(tally.deepest, 6);
  EXPECT_GE(10 * tally.with_splines, 8 * tally.meshes);
}

INSTANTIATE_TEST_SUITE_P(Shards, AdmissibleMeshes, testing::Range(0, kShards));

/// Drawn from one number of rapidcheck's and as one value, so that a failure prints the text of the case. All 64 bits
/// of the number come at rapidcheck's full size only, for which its own size need not pass 64.
Case random_case(RandomCase (*generate)(Draw&, const CaseLimits&)) {
  const auto seed = rc::gen::resize(64, rc::gen::arbitrary<std::uint64_t>());
  return *rc::gen::noShrink(rc::gen::map(seed, [generate](std::uint64_t number) {
    Draw draw(number);
    CaseLimits limits;
    limits.max_degree = 5;
    return generate(draw, limits).content;
  }));
}

RC_GTEST_PROP(RandomAdmissible, HasAllFivePropertiesOnEveryMesh, ()) {
  const Case content = random_case(random_admissible_case);
  Replay replay(content);
  while (true) {
    MeshUnderTest mesh(replay.tree());
    const std::string violated = violations(mesh);
    if (!violated.empty()) RC_FAIL(violated + text_up_to(content, replay));
    if (replay.done()) break;
    replay.advance();
  }
}

// An admissible history makes a mesh that the criterion accepts: also for bare steps that happen to be admissible.
RC_GTEST_PROP(RandomAdmissible, AnAdmissibleHistoryImpliesTheCriterion, ()) {
  const Case content = random_case(random_bare_case);
  RC_LOG() << write_case(content);
  Replay replay(content);
  replay.watch_history();
  while (!replay.done()) {
    replay.advance();
    if (replay.history_admissible()) RC_ASSERT(!find_inadmissible(replay.tree()));
  }
  RC_CLASSIFY(replay.history_admissible(), "admissible history");
}

// Theorem 3.3: refine(G, M) is admissible for every admissible G and every M; here for several random M on each mesh.
RC_GTEST_PROP(RandomAdmissible, RefinementStaysAdmissible, ()) {
  const Case content = random_case(random_admissible_case);
  RC_LOG() << write_case(content);
  Replay replay(content);
  while (!replay.done()) replay.advance();
  const auto seeds = *rc::gen::container<std::vector<std::uint32_t>>(3, rc::gen::arbitrary<std::uint32_t>());
  RefinementTree tree = replay.tree();
  std::vector<std::int32_t> marks;
  for (const std::uint32_t seed : seeds) {
    auto id = static_cast<std::int32_t>(seed % static_cast<std::uint32_t>(tree.node_count()));
    while (!tree.is_leaf(id)) id = tree.node(id).first_child;
    marks.push_back(id);
  }
  RefinementTree marked = tree;
  RC_ASSERT(is_admissible_subdivision(tree, mark_closure(marked, marks)));
  refine(tree, marks);
  RC_ASSERT(!find_inadmissible(tree));
}

}  // namespace
}  // namespace asts
