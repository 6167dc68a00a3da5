#include "properties/ledger/ledger.hpp"

#include <gtest/gtest.h>

#include <set>

#include "lib/gen/growing_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "properties/properties.hpp"
#include "reports/ledger_report.hpp"

namespace asts {
namespace {

// Claims of this test's own making.

std::set<std::pair<std::uint64_t, std::uint64_t>> meshes_tried;
std::int64_t most_elements = 0;

Verdict refuted_by(const std::string& says) { return Verdict::violated(ClaimWitness{"toy", says, {}}); }

Trial every_mesh(MeshUnderTest& mesh) {
  const Fingerprint value = fingerprint_of(mesh.mesh());
  EXPECT_TRUE(meshes_tried.insert({value.high, value.low}).second);
  most_elements = std::max(most_elements, static_cast<std::int64_t>(mesh.mesh().elements.size()));
  return {Verdict::holds(), 2};
}

Trial is_admissible(MeshUnderTest& mesh) { return {decide_admissible(mesh), 1}; }

Trial has_its_tree(MeshUnderTest& mesh) {
  return {mesh.outside_class() ? refuted_by("outside the class") : Verdict::holds(), mesh.admissible() ? 0 : 1};
}

Trial never_met(MeshUnderTest&) { return {Verdict::not_applicable("never"), 0}; }

Trial too_expensive(MeshUnderTest&) { throw BudgetExhausted("no budget"); }

Trial broken(MeshUnderTest&) { throw InternalError("broken"); }

Trial only_refines(const Case& sequence) {
  for (const Step& step : sequence.steps) {
    if (step.kind != Step::Kind::refine) return {refuted_by("no sequence of refine steps"), 1};
  }
  return {Verdict::holds(), static_cast<std::int64_t>(sequence.steps.size())};
}

Trial short_or_long(Extent extent) { return {Verdict::holds(), extent == Extent::long_run ? 100 : 1}; }

Claim on_meshes(const char* id, Trial (*decide)(MeshUnderTest&), const char* meshes) {
  Claim claim{id, "nowhere", "a claim of this test", ClaimKind::remark, meshes, "meshes"};
  claim.on_mesh = decide;
  return claim;
}

struct Toys {
  Claim all = on_meshes("all", every_mesh, "are");
  Claim admissible = on_meshes("admissible", is_admissible, "a");
  Claim subdivided = on_meshes("subdivided", has_its_tree, "ar");
  Claim any_admissible = on_meshes("any-admissible", is_admissible, "re");
  Claim unmet = on_meshes("unmet", never_met, "are");
  Claim expensive = on_meshes("expensive", too_expensive, "are");
  Claim sequence{"sequence", "nowhere", "a claim of this test", ClaimKind::remark, "a", "steps"};
  Claim alone{"alone", "nowhere", "a claim of this test", ClaimKind::remark, "", "extents"};

  Toys() {
    sequence.on_sequence = only_refines;
    alone.alone = short_or_long;
  }
};

void no_watch(const char*, std::int64_t, std::int64_t) {}

std::vector<LedgerRecord> run(const LedgerPlan& plan) {
  meshes_tried.clear();
  most_elements = 0;
  Ledger ledger(plan, violation_text);
  ledger.run(no_watch);
  return ledger.records();
}

LedgerPlan plan_of(std::vector<const Claim*> claims, std::int64_t cases) {
  LedgerPlan plan;
  plan.claims = std::move(claims);
  plan.cases = cases;
  return plan;
}

std::string text_of(const std::vector<LedgerRecord>& records) {
  std::string text;
  for (const LedgerRecord& record : records) text += ledger_json(record);
  return text;
}

TEST(Ledger, TriesEveryMeshOnceAndCounts) {
  Toys toys;
  toys.all.max_elements = 1000;  // supports that touch in an edge need long domains
  const LedgerRecord record = run(plan_of({&toys.all}, 400)).front();
  EXPECT_EQ(record.meshes, static_cast<std::int64_t>(meshes_tried.size()));
  EXPECT_GE(record.meshes, 300);
  EXPECT_EQ(record.holds, record.meshes);
  EXPECT_EQ(record.met, 2 * record.meshes);
  EXPECT_EQ(record.trials_met, record.meshes);
  EXPECT_EQ(record.result(), LedgerResult::no_violation);
  EXPECT_EQ(record.bounds.elements, most_elements);
  EXPECT_LE(most_elements, toys.all.max_elements);
  EXPECT_EQ(record.biases.size(), all_biases().size());
  std::int64_t biased = 0;
  for (const auto& [bias, count] : record.biases) biased += count;
  EXPECT_EQ(biased, record.meshes);
  EXPECT_GE(record.features.at("refined-outside-region"), record.meshes / 4);
  EXPECT_LT(record.features.at("not-admissible"), record.meshes);
  // Supports touch in a point once in some 50,000 meshes: the long run has such ones.
  for (const char* touching : {"supports-touch-in-face", "supports-touch-in-edge"}) {
    EXPECT_TRUE(record.features.contains(touching)) << touching;
  }
}

// Which meshes a claim gets: those of its class, and no others.
TEST(Ledger, KeepsToTheClassesOfAClaim) {
  const Toys toys;
  const auto records = run(plan_of({&toys.all, &toys.admissible, &toys.subdivided, &toys.any_admissible}, 150));
  EXPECT_EQ(records[1].violated, 0);
  EXPECT_GE(records[1].meshes, 100);
  EXPECT_EQ(records[2].violated, 0);
  EXPECT_GT(records[2].meshes, records[1].meshes);
  EXPECT_GT(records[0].meshes, records[2].meshes);
  EXPECT_EQ(records[3].meshes, records[0].meshes);
  EXPECT_EQ(records[3].violated + records[1].meshes, records[3].meshes);
}

TEST(Ledger, KeepsTheSmallestViolation) {
  const Toys toys;
  const LedgerRecord record = run(plan_of({&toys.any_admissible}, 300)).front();
  EXPECT_EQ(record.result(), LedgerResult::violated);
  ASSERT_TRUE(record.smallest && record.smallest->content);
  EXPECT_FALSE(record.smallest->says.empty());
  // no single subdivision of the initial mesh is inadmissible: two are the fewest, and 4 x 4 x 4 is small
  const Case& content = *record.smallest->content;
  EXPECT_FALSE(content.explicit_mesh);
  std::size_t marks = 0;
  for (const Step& step : content.steps) marks += step.marks.size();
  EXPECT_EQ(marks, 2U);
  Replay replay(content);
  while (!replay.done()) replay.advance();
  MeshUnderTest mesh(replay.tree());
  EXPECT_FALSE(mesh.admissible());
}

TEST(Ledger, DoesNotCallASilentRunAPass) {
  const Toys toys;
  const auto records = run(plan_of({&toys.unmet, &toys.expensive}, 20));
  EXPECT_EQ(records[0].result(), LedgerResult::undecided);
  EXPECT_EQ(records[0].not_applicable, records[0].meshes);
  EXPECT_TRUE(records[0].biases.empty());
  EXPECT_EQ(records[1].result(), LedgerResult::undecided);
  EXPECT_EQ(records[1].undecided, records[1].meshes);
}

TEST(Ledger, TriesSequencesAndWhatNeedsNoMesh) {
  const Toys toys;
  LedgerPlan plan = plan_of({&toys.sequence, &toys.alone}, 100);
  const auto records = run(plan);
  EXPECT_GE(records[0].sequences, 15);
  EXPECT_EQ(records[0].violated, 0);
  EXPECT_GT(records[0].met, records[0].sequences);
  EXPECT_EQ(records[1].alone, 1);
  EXPECT_EQ(records[1].met, 1);
  plan.extent = Extent::long_run;
  EXPECT_EQ(run(plan)[1].met, 100);
}

TEST(Ledger, TakesOneMeshInAStrideAndUpToANumberOfElements) {
  Toys toys;
  toys.all.stride = 5;
  toys.all.max_elements = 130;
  const auto records = run(plan_of({&toys.all, &toys.unmet}, 300));
  EXPECT_LE(most_elements, 130);
  EXPECT_GE(records[0].meshes, records[1].meshes / 20);
  EXPECT_LE(records[0].meshes, records[1].meshes / 5);
}

// Law 1.
TEST(Ledger, GivesOneResultForASeed) {
  const Toys toys;
  LedgerPlan plan = plan_of({&toys.all, &toys.any_admissible, &toys.sequence}, 60);
  const std::string text = text_of(run(plan));
  EXPECT_EQ(text_of(run(plan)), text);
  plan.seed = 2;
  EXPECT_NE(text_of(run(plan)), text);
}

// Law 2.
TEST(Ledger, GivesTheSameResultInShares) {
  const Toys toys;
  LedgerPlan plan = plan_of({&toys.all, &toys.any_admissible, &toys.sequence, &toys.alone}, 80);
  const auto whole = run(plan);
  for (const int shares : {2, 3}) {
    std::vector<LedgerRecord> merged(whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) merged[i].claim = whole[i].claim;
    plan.shares = shares;
    for (plan.share = 0; plan.share < shares; ++plan.share) {
      const auto share = run(plan);
      EXPECT_LT(share[0].meshes, whole[0].meshes);
      for (std::size_t i = 0; i < share.size(); ++i) merge(merged[i], share[i]);
    }
    EXPECT_EQ(text_of(merged), text_of(whole));
  }
}

TEST(Ledger, KeepsItsRecordsWhenItIsEnded) {
  const Toys toys;
  Ledger ledger(plan_of({&toys.all}, 1000), violation_text);
  meshes_tried.clear();
  const auto end_soon = [](const char*, std::int64_t done, std::int64_t) {
    if (done == 20) throw std::runtime_error("enough");
  };
  EXPECT_THROW(ledger.run(end_soon), std::runtime_error);
  EXPECT_GE(ledger.records().front().meshes, 20);
}

TEST(Ledger, SaysWhichClaimAndWhichCaseBroke) {
  const Claim claim = on_meshes("broken-claim", broken, "are");
  try {
    run(plan_of({&claim}, 5));
    FAIL();
  } catch (const InternalError& error) {
    EXPECT_NE(std::string(error.what()).find("broken-claim: broken\nasts-case 1"), std::string::npos) << error.what();
  }
}

LedgerRecord some_record(int number) {
  LedgerRecord record;
  record.claim = "claim";
  record.meshes = number;
  record.holds = number - 1;
  record.violated = 1;
  record.met = 5 * number;
  record.trials_met = number;
  record.biases = {{"marks-deep", number}, {"bias-" + std::to_string(number), 1}};
  record.features = {{"not-admissible", 1}};
  record.bounds = {{4, 4, 4 + number}, {3, 9 - 2 * (number % 2), 3}, 2 + number, 3, 100 - number, 7};
  Case content{{3, 3, 3}, 2, {4, 4, 4}, {}, false, {}};
  for (int i = 0; i < 5 - number; ++i) content.steps.push_back({Step::Kind::subdivide, {Point{}}});
  record.smallest = LedgerViolation{content, "says \"" + std::to_string(number) + "\"\nin two lines"};
  return record;
}

// Laws of merge().
TEST(LedgerRecord, MergesInAnyOrder) {
  const auto merged = [](std::initializer_list<int> numbers) {
    LedgerRecord record;
    record.claim = "claim";
    for (const int number : numbers) merge(record, some_record(number));
    return ledger_json(record);
  };
  EXPECT_EQ(merged({1, 2, 3}), merged({3, 1, 2}));
  EXPECT_EQ(merged({2}), ledger_json(some_record(2)));
  LedgerRecord left = some_record(1);
  LedgerRecord right = some_record(2);
  merge(right, some_record(3));
  merge(left, right);
  EXPECT_EQ(ledger_json(left), merged({1, 2, 3}));
  EXPECT_EQ(left.smallest->content->steps.size(), 2U);
  EXPECT_EQ(left.meshes, 6);
  EXPECT_EQ(left.bounds.degree, (PerAxis<int>{3, 9, 3}));
}

TEST(LedgerRecord, IsReadBackFromItsLine) {
  LedgerRecord alone = some_record(4);
  alone.smallest->content.reset();
  LedgerRecord clean = some_record(4);
  clean.smallest.reset();
  for (const LedgerRecord& record : {some_record(1), alone, clean}) {
    const LedgerRecord read = ledger_from_json(ledger_json(record));
    EXPECT_EQ(ledger_json(read), ledger_json(record));
    EXPECT_EQ(read.bounds, record.bounds);
  }
  EXPECT_THROW(ledger_from_json("{}"), InputError);
  EXPECT_THROW(ledger_from_json("no json"), InputError);
}

}  // namespace
}  // namespace asts
