#include "fuzz/targets/case_mutator.hpp"

#include <gtest/gtest.h>

#include <set>

#include "lib/gen/case_bytes.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/refine/replay.hpp"

namespace asts::fuzz {
namespace {

void expect_valid(const Case& content) {
  EXPECT_EQ(parse_case(write_case(content), "mutated"), content);
  if (!content.explicit_mesh) return;
  EXPECT_NO_THROW(mesh_of(setting_of(content), content.elements));
}

// A walk of mutations as a fuzzer makes it: whatever comes out is a valid case, and most of it has bytes.
TEST(CaseMutator, EveryCaseOnALongWalkIsValid) {
  Draw draw(1);
  Case content = case_of_bytes({});
  int steps = 0, boxes = 0, with_bytes = 0, made = 0;
  for (int round = 0; round < 3000; ++round) {
    if (round % 300 == 0) content = case_of_bytes({});
    const auto changed = mutated(content, draw);
    if (!changed) continue;
    SCOPED_TRACE(write_case(*changed));
    expect_valid(*changed);
    ASSERT_FALSE(HasFailure());
    ++made;
    ++(changed->explicit_mesh ? boxes : steps);
    const auto bytes = bytes_of_case(*changed);
    if (!bytes) continue;
    ++with_bytes;
    content = case_of_bytes(*bytes);
  }
  EXPECT_GE(made, 1500);
  EXPECT_GE(steps, 300);
  EXPECT_GE(boxes, 300);
  EXPECT_GE(2 * with_bytes, made);
}

TEST(CaseMutator, AddsTakesAwayMovesAndGoesDeeper) {
  const Case content = parse_case(
      "asts-case 1\ndegree 3 3 3\ngrading 3\ndomain 4 4 4\nsubdivide 1 1 1\nrefine 5/2 1 1 0 0 0\n", "steps");
  Draw draw(2);
  std::set<std::size_t> step_counts, first_mark_counts;
  bool deeper = false;
  for (int round = 0; round < 400; ++round) {
    const auto changed = with_other_steps(content, draw);
    if (!changed) continue;
    step_counts.insert(changed->steps.size());
    if (changed->steps.size() == 2) first_mark_counts.insert(changed->steps[1].marks.size());
    // the children of the cube at (1,1,1) begin at x = 1, 4/3, 5/3
    const Point child{CompactRational(Rational(4) / 3), CompactRational(1), CompactRational(1)};
    deeper = deeper || (changed->steps.size() == 3 && changed->steps[1].marks == std::vector{child});
  }
  EXPECT_EQ(step_counts, (std::set<std::size_t>{1, 2, 3}));
  EXPECT_EQ(first_mark_counts, (std::set<std::size_t>{1, 2, 3}));
  EXPECT_TRUE(deeper);
}

TEST(CaseMutator, SplitsAndMergesBoxes) {
  const Case content = written_out(parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 2 1 1\n", "cubes"));
  ASSERT_EQ(content.elements.size(), 2U);
  Draw draw(3);
  std::set<std::size_t> counts;
  for (int round = 0; round < 500; ++round) {
    if (const auto changed = with_other_boxes(content, draw)) counts.insert(changed->elements.size());
  }
  EXPECT_EQ(counts, (std::set<std::size_t>{1, 2, 3}));
}

}  // namespace
}  // namespace asts::fuzz
