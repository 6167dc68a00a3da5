#include "properties/sequence_under_test.hpp"

#include <gtest/gtest.h>

#include <map>

#include "lib/gen/workloads.hpp"
#include "lib/mesh/case_file.hpp"
#include "reports/check_report.hpp"
#include "tests/step_cases.hpp"

namespace asts {
namespace {

/// Everything that `asts check` says about a verdict.
std::string text(const Property& property, const Verdict& verdict) {
  CheckRecord record;
  record.entries.push_back({&property, verdict});
  return check_json(record);
}

struct Tally {
  int meshes = 0;
  std::map<std::string, int> outcomes;  ///< "PROPERTY OUTCOME"
};

/// Follows a case and compares with each mesh on its own. `every` n-th mesh is asked, so that some steps are not.
void compare(const Case& content, int jobs, const ZoneLimits& limits, std::size_t every, Tally& tally) {
  Replay replay(content);
  SequenceUnderTest sequence(replay, jobs, limits);
  for (std::size_t step = 0;; ++step) {
    if (step % every == 0 || replay.done()) {
      MeshUnderTest alone(replay.tree());
      ++tally.meshes;
      ASSERT_EQ(sequence.active_nodes(), alone.splines().size()) << write_case(content) << "step " << step;
      for (const Property& property : all_properties()) {
        const Verdict expected = decide(property, alone);
        ASSERT_EQ(text(property, sequence.decide(property)), text(property, expected))
            << write_case(content) << "step " << step << ", zones of " << limits.elements << " elements, "
            << limits.lines << " lines, " << jobs << " jobs";
        ++tally.outcomes[std::string(property.id) + " " + outcome_name(expected.outcome)];
      }
    }
    if (replay.done()) return;
    replay.advance();
    sequence.after_step();
  }
}

TEST(SequenceUnderTest, DecidesEachMeshAsItIsDecidedAlone) {
  constexpr ZoneLimits kLimits[] = {{1, 64}, {5, 64}, {40, 64}, {4096, 64}, {10, 12}, {300, 9}};
  Tally tally;
  for (std::int64_t number = 0; number < 2500 && !HasFatalFailure(); ++number) {
    const auto content = testing::random_steps(number);
    if (!content) continue;
    const auto turn = static_cast<std::size_t>(number);
    compare(*content, 1 + static_cast<int>(turn % 3 == 0), kLimits[turn % std::size(kLimits)], 1 + turn % 4 / 3, tally);
  }
  EXPECT_GT(tally.meshes, 4000);
  for (const Property& property : all_properties()) {
    EXPECT_GT(tally.outcomes[std::string(property.id) + " holds"], 500) << property.id;
    if (property.decide != decide_nested_patches) {
      EXPECT_GT(tally.outcomes[std::string(property.id) + " violated"], 20) << property.id;
    }
  }
}

TEST(SequenceUnderTest, DecidesTheFindingsAsTheyAreDecidedAlone) {
  Tally tally;
  for (const Case& content : testing::found_steps()) compare(content, 1, {5, 64}, 1, tally);
  EXPECT_GT(tally.outcomes["dual-compatible violated"], 5);
  EXPECT_GT(tally.outcomes["analysis-suitable violated"], 0);
}

/// Marks spread over a mesh of some thousand elements: most zones are not looked at again.
TEST(SequenceUnderTest, FollowsALargerMesh) {
  for (const Workload workload : {Workload::sphere, Workload::corner, Workload::random}) {
    Case content = generate_workload(workload, {{3, 3, 3}, 2, {8, 9, 10}}, 3000);
    for (int i = 0; i < 12; ++i) {
      const auto along = [&](int side, int factor) {
        return CompactRational(Rational(1 + i * factor % (7 * side), 8));
      };
      Step step;
      step.kind = Step::Kind::refine;
      step.marks.push_back({along(8, 11), along(9, 17), along(10, 23)});
      content.steps.push_back(step);
    }
    Tally tally;
    compare(content, 1, {100, 64}, 1, tally);
    EXPECT_GT(tally.outcomes["dual-basis holds"], 12);
  }
}

}  // namespace
}  // namespace asts
