#include "lib/gen/case_bytes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "lib/gen/draw.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/mesh.hpp"
#include "lib/refine/replay.hpp"

namespace asts {
namespace {

using ByteString = std::vector<std::uint8_t>;

ByteString random_bytes(Draw& draw) {
  ByteString bytes(draw.index(120));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(draw.between(0, 255));
  return bytes;
}

std::int64_t cubes_of(const Case& content) {
  return std::int64_t{content.domain[0]} * content.domain[1] * content.domain[2];
}

void expect_limits(const Case& content, const ByteCaseLimits& limits) {
  EXPECT_LE(cubes_of(content), limits.max_cubes);
  EXPECT_LE(static_cast<int>(content.steps.size()), limits.max_steps);
  EXPECT_LE(static_cast<int>(content.elements.size()), limits.max_cells);
  if (content.explicit_mesh) return;
  Replay replay(content);
  while (!replay.done()) replay.advance();
  EXPECT_LE(replay.tree().element_count(), limits.max_elements);
}

Case parsed(const std::string& text) { return parse_case(text, "text"); }

// Laws 1 and 2.
TEST(CaseBytes, AnyBytesAreAValidCaseWithinTheLimitsThatHasBytes) {
  Draw draw(1);
  for (int round = 0; round < 3000; ++round) {
    const ByteCaseLimits limits = round % 2 == 0 ? ByteCaseLimits{} : kTinyCases;
    const Case content = case_of_bytes(random_bytes(draw), limits);
    const std::string text = write_case(content);
    SCOPED_TRACE(text);
    EXPECT_EQ(parsed(text), content);
    if (content.explicit_mesh) {
      EXPECT_NO_THROW(mesh_of(setting_of(content), content.elements));
    }
    expect_limits(content, limits);
    const auto bytes = bytes_of_case(content, limits);
    ASSERT_TRUE(bytes.has_value());
    EXPECT_EQ(case_of_bytes(*bytes, limits), content);
    ASSERT_FALSE(HasFailure());
  }
}

// A fuzzer finds nothing where the bytes never lead.
TEST(CaseBytes, RandomBytesReachAllThatTheFormHas) {
  Draw draw(2);
  std::map<std::string, int> seen;
  for (int round = 0; round < 2000; ++round) {
    const Case content = case_of_bytes(random_bytes(draw));
    ++seen[content.explicit_mesh ? "boxes" : "steps"];
    ++seen["m=" + std::to_string(content.grading)];
    bool narrow = false;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      ++seen["p=" + std::to_string(content.degree[axis])];
      narrow = narrow || content.domain[axis] <= content.degree[axis];
    }
    ++seen[narrow ? "narrow" : "wide"];
    for (const Step& step : content.steps) ++seen[step.kind == Step::Kind::refine ? "refine" : "subdivide"];
  }
  for (const char* what : {"m=2", "m=3", "m=4", "p=3", "p=5", "boxes", "steps", "narrow", "refine", "subdivide"}) {
    EXPECT_GE(seen[what], 200) << what;
  }
  EXPECT_GT(seen["wide"], seen["narrow"]);
}

TEST(CaseBytes, NoBytesAreTheInitialMeshOfTheLeastDomainWithAnActiveNode) {
  EXPECT_EQ(case_of_bytes({}), parsed("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\n"));
}

// The form as the header says it, byte by byte.
TEST(CaseBytes, AStepIsAByteAndSixBytesAMark) {
  const ByteString bytes{1, 0, 3, 0, /*subdivide, two marks*/ 3, 1, 0, 2, 1, 4, 99, 0, 3, 6, 0, 0, 0};
  EXPECT_EQ(case_of_bytes(bytes), parsed("asts-case 1\ndegree 3 5 3\ngrading 3\ndomain 4 6 4\n"
                                         "subdivide 1 5/2 4  2/3 6 0\n"));
}

TEST(CaseBytes, BoxesBeginInTheFirstFreeCellAndAreCutOffWhereOthersStand) {
  // 1 x 1 x 2 cubes; a plane at x = 1/2; the first box wants 1 x 1 x 2 cells, the second 3 x 3 x 3
  const ByteString bytes{9, 224, 224, 228, 1, 0, 1, 0, 0, 0, 12 * 4, 18, 18 + 9 * 0};
  EXPECT_EQ(case_of_bytes(bytes), parsed("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 1 1 2\n"
                                         "element 0 0 0 1/2 1 2\nelement 1/2 0 0 1 1 1\nelement 1/2 0 1 1 1 2\n"));
}

// No guillotine cut makes a pinwheel.
TEST(CaseBytes, APinwheelHasBytes) {
  const Case content = parsed(
      "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 3 3 1\nelement 0 0 0 2 1 1\nelement 2 0 0 3 2 1\n"
      "element 1 2 0 3 3 1\nelement 0 1 0 1 3 1\nelement 1 1 0 2 2 1\n");
  const auto bytes = bytes_of_case(content);
  ASSERT_TRUE(bytes.has_value());
  Case read = case_of_bytes(*bytes);
  EXPECT_TRUE(std::is_permutation(read.elements.begin(), read.elements.end(), content.elements.begin(),
                                  content.elements.end()));
}

TEST(CaseBytes, ACaseOutsideTheFormHasNoBytes) {
  const std::string header = "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 4\n";
  EXPECT_TRUE(bytes_of_case(parsed(header + "refine 1/19 0 4\n")).has_value());
  for (const std::string& text : {std::string("asts-case 1\ndegree 7 3 3\ngrading 2\ndomain 4 4 4\n"),
                                  std::string("asts-case 1\ndegree 3 3 3\ngrading 5\ndomain 4 4 4\n"),
                                  std::string("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 4 4 10\n"),
                                  std::string("asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 9 9 9\n"),
                                  header + "refine 1/21 0 0\n", header + "refine 1/100000000000000000000 0 0\n"}) {
    EXPECT_FALSE(bytes_of_case(parsed(text)).has_value()) << text;
  }
}

}  // namespace
}  // namespace asts
