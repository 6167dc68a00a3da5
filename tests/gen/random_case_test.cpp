#include "lib/gen/random_case.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "properties/properties.hpp"
#include "tests/literal_mesh.hpp"

namespace asts {
namespace {

using Generator = RandomCase (*)(Draw&, const CaseLimits&);

struct Range {
  std::int64_t first, last;
};

// The lists that cases are drawn from leave none out, first to last.
TEST(Biases, AreAllListed) {
  const auto last = static_cast<std::size_t>(Bias::boxes_planar_inside);
  ASSERT_EQ(all_biases().size(), last + 1);
  for (std::size_t i = 0; i <= last; ++i) EXPECT_EQ(static_cast<std::size_t>(all_biases()[i]), i);
  EXPECT_EQ(plain_biases().size() + trouble_biases().size(), last + 1);
  EXPECT_EQ(plain_biases().back(), Bias::boxes_written_out);
  EXPECT_EQ(trouble_biases().back(), Bias::boxes_planar_inside);
}

// The engine's first numbers for the default seed are fixed by the C++ standard ([rand.predef] gives the 10000th), and
// `between` takes them modulo the range's length: a seed means the same everywhere.
TEST(Draw, TakesTheStandardEnginesNumbers) {
  std::mt19937_64 engine(5489);
  engine.discard(9999);
  EXPECT_EQ(engine(), 9981545732273789042ULL);
  std::mt19937_64 same(17);
  Draw draw(17);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(draw.between(3, 9), 3 + static_cast<int>(same() % 7));
}

TEST(Draw, ReachesBothEndsAndNothingElse) {
  Draw draw(1);
  for (const Range range : {Range{0, 0}, Range{-3, 2}, Range{5, 6}}) {
    std::set<std::int64_t> seen;
    for (int i = 0; i < 300; ++i) seen.insert(draw.between(range.first, range.last));
    EXPECT_EQ(*seen.begin(), range.first);
    EXPECT_EQ(*seen.rbegin(), range.last);
    EXPECT_EQ(static_cast<std::int64_t>(seen.size()), range.last - range.first + 1);
  }
}

TEST(Draw, ShufflesIntoEveryOrder) {
  Draw draw(2);
  std::map<std::vector<int>, int> orders;
  for (int i = 0; i < 600; ++i) {
    std::vector<int> values{1, 2, 3};
    draw.shuffle(values);
    ++orders[values];
  }
  ASSERT_EQ(orders.size(), 6U);
  for (const auto& [order, count] : orders) EXPECT_GT(count, 60);  // 100 expected, standard deviation 9
}

void expect_limits(const Case& content, const CaseLimits& limits) {
  std::int64_t cubes = 1;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    EXPECT_LE(content.degree[axis], limits.max_degree);
    EXPECT_LE(content.domain[axis], std::max(limits.max_side, content.degree[axis] + 1));
    cubes *= content.domain[axis];
  }
  EXPECT_LE(content.grading, limits.max_grading);
  EXPECT_LE(static_cast<int>(content.steps.size()), limits.max_steps + 1);
  EXPECT_LE(static_cast<std::int64_t>(content.elements.size()), std::max(limits.max_elements, 8 * cubes));
  if (content.explicit_mesh) return;
  Replay replay(content);
  while (!replay.done()) replay.advance();
  EXPECT_LE(replay.tree().element_count(), std::max(limits.max_elements, cubes + 2 * (content.grading - 1)));
}

void expect_kind(const RandomCase& random, int generator) {
  const auto count = [&](Step::Kind kind) {
    return std::count_if(random.content.steps.begin(), random.content.steps.end(),
                         [kind](const Step& step) { return step.kind == kind; });
  };
  EXPECT_EQ(count(Step::Kind::subdivide) > 0, generator == 1);
  EXPECT_EQ(random.content.explicit_mesh, generator == 2);
}

void expect_valid(const Case& content) {
  const std::string text = write_case(content);
  const Case read = parse_case(text, "random");
  EXPECT_EQ(write_case(read), text);
  EXPECT_EQ(read, content);
  if (!content.explicit_mesh) return;
  EXPECT_NO_THROW(mesh_of(setting_of(read), read.elements));
  EXPECT_TRUE(reference::tiles_domain(literal::setting(setting_of(read)), literal::last_mesh(read)));
}

// Laws 1 to 4.
TEST(RandomCase, IsValidKeepsItsLimitsAndItsKindAndEveryBiasOccurs) {
  const std::array<Generator, 3> generators{random_admissible_case, random_bare_case, random_box_case};
  const std::array<CaseLimits, 3> all_limits{CaseLimits{}, CaseLimits{3, 2, 4, 64, 70, 2},
                                             CaseLimits{7, 7, 9, 600, 900, 12}};
  std::set<Bias> biases;
  Draw draw(3);
  for (int round = 0; round < 450; ++round) {
    const int generator = round % 3;
    const CaseLimits& limits = all_limits[static_cast<std::size_t>(round / 3 % 3)];
    const RandomCase random = generators[static_cast<std::size_t>(generator)](draw, limits);
    SCOPED_TRACE(std::string(bias_name(random.bias)) + "\n" + write_case(random.content));
    expect_valid(random.content);
    expect_limits(random.content, limits);
    expect_kind(random, generator);
    biases.insert(random.bias);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_EQ(biases.size(), plain_biases().size());
}

TEST(RandomCase, ASeedIsOneCase) {
  std::set<std::string> texts;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Draw one(seed);
    Draw other(seed);
    const std::string text = write_case(random_bare_case(one, {}).content);
    EXPECT_EQ(text, write_case(random_bare_case(other, {}).content));
    texts.insert(text);
  }
  EXPECT_GE(texts.size(), 38U);
}

/// What a bias is named for, counted on the cases drawn with it.
struct BiasTally {
  int cases = 0, not_admissible = 0, outside_class = 0;
};

void decide_case(const Case& content, BiasTally& tally) {
  ++tally.cases;
  std::optional<MeshUnderTest> mesh;
  std::optional<Replay> replay;
  if (content.explicit_mesh) {
    mesh.emplace(mesh_of(setting_of(content), content.elements));
  } else {
    replay.emplace(content);
    while (!replay->done()) replay->advance();
    mesh.emplace(replay->tree());
  }
  tally.not_admissible += decide_admissible(*mesh).outcome == Outcome::violated;
  tally.outside_class += mesh->outside_class().has_value();
}

// Biases that provoke nothing would make a campaign look thorough: each provokes what it is named for.
TEST(RandomCase, BiasesProvokeWhatTheyAreNamedFor) {
  std::map<Bias, BiasTally> tallies;
  Draw draw(4);
  for (int round = 0; round < 400; ++round) {
    for (const Generator generator : {random_admissible_case, random_bare_case, random_box_case}) {
      const RandomCase random = generator(draw, {});
      decide_case(random.content, tallies[random.bias]);
    }
  }
  for (const Bias bias : {Bias::marks_anywhere, Bias::marks_clustered, Bias::marks_corner, Bias::marks_deep}) {
    EXPECT_EQ(tallies[bias].not_admissible, 0) << bias_name(bias);
  }
  for (const Bias bias :
       {Bias::bare_scattered, Bias::bare_stacked, Bias::bare_one_left_out, Bias::bare_touching, Bias::bare_in_frame}) {
    EXPECT_GE(4 * tallies[bias].not_admissible, tallies[bias].cases) << bias_name(bias);
  }
  for (const Bias bias : {Bias::boxes_cut, Bias::boxes_merged, Bias::boxes_frame, Bias::boxes_pinwheel}) {
    EXPECT_GE(2 * tallies[bias].outside_class, tallies[bias].cases) << bias_name(bias);
  }
  EXPECT_EQ(tallies[Bias::boxes_written_out].outside_class, 0);
}

}  // namespace
}  // namespace asts
