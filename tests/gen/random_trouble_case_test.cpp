#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "lib/gen/growing_case.hpp"
#include "lib/gen/random_case.hpp"
#include "lib/gen/smaller_patch.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/refinement.hpp"
#include "lib/refine/replay.hpp"
#include "lib/spline/active_region.hpp"
#include "properties/claims/claim.hpp"
#include "properties/properties.hpp"
#include "tests/literal_mesh.hpp"

namespace asts {
namespace {

const std::array<CaseLimits, 3> kLimits{CaseLimits{}, CaseLimits{3, 2, 4, 64, 70, 2},
                                        CaseLimits{7, 16, 9, 600, 900, 12}};

bool is_interface(Bias bias) { return bias == Bias::bare_interface; }

bool is_graded(Bias bias) { return bias == Bias::marks_graded; }

bool is_region(Bias bias) { return bias >= Bias::region_point && bias <= Bias::region_plane; }

bool is_planar(Bias bias) { return bias == Bias::boxes_planar_inside; }

std::int64_t cubes_of(const Case& content) {
  return std::int64_t{content.domain[0]} * content.domain[1] * content.domain[2];
}

/// Law (2) with the room that trouble takes.
void expect_limits(const RandomCase& random, const CaseLimits& limits) {
  const Case& content = random.content;
  const int new_elements = content.grading - 1;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const int p = content.degree[axis];
    EXPECT_LE(p, limits.max_degree);
    const int side = is_interface(random.bias) ? 2 * p + 3
                     : is_graded(random.bias)  ? 4 * (p + 1)
                     : is_planar(random.bias)  ? p + 4
                     : is_region(random.bias)  ? p + 2
                                               : p + 1;
    EXPECT_LE(content.domain[axis], std::max(limits.max_side, side));
  }
  EXPECT_LE(content.grading, limits.max_grading);
  EXPECT_LE(static_cast<int>(content.steps.size()), std::max(limits.max_steps + 1, is_graded(random.bias) ? 12 : 3));
  if (content.explicit_mesh) return;
  Replay replay(content);
  while (!replay.done()) replay.advance();
  const std::int64_t room = std::max<std::int64_t>(
      cubes_of(content) + (is_interface(random.bias) ? 12 : 2) * new_elements, is_graded(random.bias) ? 900 : 0);
  EXPECT_LE(replay.tree().element_count(), std::max(limits.max_elements, room));
}

void expect_kind(const RandomCase& random) {
  const auto has = [&](Step::Kind kind) {
    return std::any_of(random.content.steps.begin(), random.content.steps.end(),
                       [kind](const Step& step) { return step.kind == kind; });
  };
  EXPECT_EQ(random.content.explicit_mesh, is_planar(random.bias));
  if (is_region(random.bias) || is_planar(random.bias)) return;
  EXPECT_EQ(has(Step::Kind::subdivide), random.bias >= Bias::bare_smaller_patch);
  if (random.bias < Bias::bare_smaller_patch) return;
  EXPECT_FALSE(has(Step::Kind::refine));
}

// Laws 1 to 4.
TEST(RandomTroubleCase, IsValidKeepsItsLimitsAndItsKindAndEveryBiasOccurs) {
  std::set<Bias> biases;
  Draw draw(3);
  for (std::size_t round = 0; round < 450; ++round) {
    const CaseLimits& limits = kLimits[round % 3];
    const RandomCase random = random_trouble_case(draw, limits);
    SCOPED_TRACE(std::string(bias_name(random.bias)) + "\n" + write_case(random.content));
    EXPECT_EQ(parse_case(write_case(random.content), "random"), random.content);
    expect_limits(random, limits);
    expect_kind(random);
    biases.insert(random.bias);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_TRUE(std::ranges::equal(biases, trouble_biases()));
}

// Law 5, for every bias there is; and the same state gives the same case.
TEST(RandomCaseIn, HasTheSettingAndTheBiasThatWereChosen) {
  for (const Bias bias : all_biases()) {
    Draw draw(11);
    Draw again(11);
    for (int round = 0; round < 20; ++round) {
      const Setting setting = setting_for(draw, {}, bias);
      const RandomCase random = random_case_in(draw, setting, {}, bias);
      EXPECT_EQ(random.bias, bias);
      EXPECT_EQ(random.content.degree, setting.degree);
      EXPECT_EQ(random.content.grading, setting.grading);
      EXPECT_EQ(random.content.domain, setting.domain);
      EXPECT_EQ(random_case_in(again, setting_for(again, {}, bias), {}, bias).content, random.content);
    }
  }
}

TEST(Biases, HaveNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const Bias bias : all_biases()) names.insert(bias_name(bias));
  EXPECT_EQ(names.size(), all_biases().size());
  EXPECT_EQ(plain_biases().size() + trouble_biases().size(), all_biases().size());
  EXPECT_EQ(bias_name(Bias::marks_edge), std::string("marks-edge"));
  EXPECT_EQ(bias_name(Bias::boxes_planar_inside), std::string("boxes-planar-inside"));
}

/// How many axes the active region has an extent on.
int dimension_of_region(const Case& content) {
  int dimension = 0;
  for (std::size_t axis = 0; axis < kDimension; ++axis) dimension += content.domain[axis] > content.degree[axis] + 1;
  return dimension;
}

TEST(RandomTroubleCase, RegionsAreAPointASegmentOrARectangle) {
  const std::map<Bias, int> dimensions{{Bias::region_point, 0}, {Bias::region_segment, 1}, {Bias::region_plane, 2}};
  for (const auto& [bias, dimension] : dimensions) {
    Draw draw(5);
    for (int round = 0; round < 40; ++round) {
      const Setting setting = setting_for(draw, kLimits[static_cast<std::size_t>(round % 3)], bias);
      const RandomCase random = random_case_in(draw, setting, {}, bias);
      EXPECT_EQ(dimension_of_region(random.content), dimension) << bias_name(bias);
      EXPECT_FALSE(active_region(mesh_of(RefinementTree(setting))).empty);
    }
  }
}

/// Whether all leaves that a step subdivides itself lie on the same `fixed` sides of the domain.
bool marks_share_sides(const Case& content, int fixed) {
  PerAxis<bool> lower{true, true, true};
  PerAxis<bool> upper{true, true, true};
  Replay replay(content);
  for (const Step& step : content.steps) {
    const RefinementTree& tree = replay.tree();
    for (const Point& mark : step.marks) {
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const RankInterval side = tree.extent(tree.leaf_at(mark), axis);
        lower[at(axis)] &= side.lower == 0;
        upper[at(axis)] &= side.upper == tree.grid(axis).line_count() - 1;
      }
    }
    replay.advance();
  }
  int shared = 0;
  for (std::size_t axis = 0; axis < kDimension; ++axis) shared += lower[axis] || upper[axis];
  return shared >= fixed;
}

TEST(RandomTroubleCase, MarksLieAlongAnEdgeOrAFace) {
  Draw draw(6);
  for (const auto& [bias, fixed] : {std::pair{Bias::marks_edge, 2}, std::pair{Bias::marks_face, 1}}) {
    for (int round = 0; round < 40; ++round) {
      const RandomCase random = random_case_in(draw, setting_for(draw, {}, bias), {}, bias);
      EXPECT_TRUE(marks_share_sides(random.content, fixed)) << write_case(random.content);
    }
  }
}

TEST(RandomTroubleCase, UniformMarksMakeUniformMeshes) {
  Draw draw(7);
  std::set<int> levels;
  for (int round = 0; round < 40; ++round) {
    const RandomCase random =
        random_case_in(draw, setting_for(draw, kLimits[0], Bias::marks_uniform), kLimits[2], Bias::marks_uniform);
    Replay replay(random.content);
    while (!replay.done()) replay.advance();
    for (const std::int32_t leaf : leaves_of(replay.tree())) {
      ASSERT_EQ(replay.tree().node(leaf).level, replay.tree().max_level());
    }
    levels.insert(replay.tree().max_level());
  }
  EXPECT_GE(levels.size(), 3U);
}

/// What a bias is named for, counted on the cases drawn with it.
struct BiasTally {
  int cases = 0, not_admissible = 0, not_analysis_suitable = 0, dual_compatible_only = 0;
};

BiasTally tally_of(Bias bias, int rounds, const CaseLimits& limits) {
  BiasTally tally;
  Draw draw(8);
  for (; tally.cases < rounds; ++tally.cases) {
    const RandomCase random = random_case_in(draw, setting_for(draw, limits, bias), limits, bias);
    Replay replay(random.content);
    while (!replay.done()) replay.advance();
    MeshUnderTest mesh(replay.tree());
    tally.not_admissible += !mesh.admissible();
    const bool suitable = decide_analysis_suitable(mesh).outcome != Outcome::violated;
    tally.not_analysis_suitable += !suitable;
    tally.dual_compatible_only += !suitable && decide_dual_compatible(mesh).outcome != Outcome::violated;
  }
  return tally;
}

// Biases that provoke nothing would make a campaign look thorough: each provokes what it is named for.
TEST(RandomTroubleCase, BiasesProvokeWhatTheyAreNamedFor) {
  for (const Bias bias : {Bias::marks_edge, Bias::marks_face, Bias::marks_uniform, Bias::marks_graded}) {
    EXPECT_EQ(tally_of(bias, 100, {}).not_admissible, 0) << bias_name(bias);
  }
  for (const Bias bias : {Bias::region_point, Bias::region_segment, Bias::region_plane}) {
    const BiasTally tally = tally_of(bias, 200, {});
    EXPECT_GE(4 * tally.not_admissible, tally.cases) << bias_name(bias);
    EXPECT_LE(tally.not_admissible, tally.cases - 20) << bias_name(bias);  // some are admissible
  }
  EXPECT_GE(8 * tally_of(Bias::bare_smaller_patch, 200, {}).not_admissible, 200);
  EXPECT_GE(tally_of(Bias::bare_holes, 400, {}).not_admissible, 4);
}

// The planar meshes that Definition 5.2's remark is about, with T-junctions of both directions in many of them.
TEST(RandomTroubleCase, PlanarCutsEndInsideTheActiveRegionOrNotAtAll) {
  const Claim& remark = *find_claim("planar-equals-classical");
  int with_pairs = 0;
  Draw draw(10);
  for (int round = 0; round < 100; ++round) {
    const Setting setting = setting_for(draw, {}, Bias::boxes_planar_inside);
    const Case content = random_case_in(draw, setting, {}, Bias::boxes_planar_inside).content;
    MeshUnderTest mesh(mesh_of(setting, content.elements));
    const Trial trial = try_on_mesh(remark, mesh);
    ASSERT_NE(trial.verdict.outcome, Outcome::not_applicable) << trial.verdict.reason << '\n' << write_case(content);
    with_pairs += trial.met > 0;
  }
  EXPECT_GE(with_pairs, 20);
}

// Index vectors that differ, with supports that have one plane in common: Definition 5.1 intersects closed supports,
// Definition 6.4 asks about those that share volume only.
TEST(RandomTroubleCase, InterfacesMakeDualCompatibleMeshesThatAreNotAnalysisSuitable) {
  const BiasTally tally = tally_of(Bias::bare_interface, 3000, {3, 2, 7, 200, 250, 5});
  EXPECT_GE(tally.not_analysis_suitable, 300);
  EXPECT_GE(tally.dual_compatible_only, 3);
}

/// The environment of D(k) less one element length, on all axes, by the literal definitions: open, clipped.
bool meets_smaller_environment(const Setting& setting, const reference::Box& element, const reference::Box& other) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const Rational middle = (element.lower[axis] + element.upper[axis]) / 2;
    const Rational reach = (element.upper[axis] - element.lower[axis]) * (2 * setting.degree[axis] + 1) / 2;
    if (other.upper[axis] <= middle - reach || other.lower[axis] >= middle + reach) return false;
  }
  return true;
}

/// The least superset, as its definition has it: by a loop until nothing joins.
std::set<std::int32_t> literal_smaller_closure(const RefinementTree& tree, std::int32_t mark) {
  std::set<std::int32_t> closure{mark};
  for (std::size_t before = 0; before != closure.size();) {
    before = closure.size();
    for (const std::int32_t leaf : leaves_of(tree)) {
      const bool joins = std::any_of(closure.begin(), closure.end(), [&](std::int32_t element) {
        return tree.node(leaf).level < tree.node(element).level &&
               meets_smaller_environment(tree.setting(), literal::box(tree, element), literal::box(tree, leaf));
      });
      if (joins) closure.insert(leaf);
    }
  }
  return closure;
}

// Law of lib/gen/smaller_patch.hpp.
TEST(SmallerClosure, IsTheLeastSupersetForTheSmallerEnvironment) {
  Draw draw(9);
  int smaller = 0;
  for (int round = 0; round < 60; ++round) {
    const RandomCase random = random_admissible_case(draw, {3, 3, 7, 120, 200, 4});
    Replay replay(random.content);
    while (!replay.done()) replay.advance();
    const std::int32_t mark = draw.choose(leaves_of(replay.tree()));
    const std::vector<std::int32_t> closure = smaller_closure(replay.tree(), std::vector{mark});
    EXPECT_EQ(std::set(closure.begin(), closure.end()), literal_smaller_closure(replay.tree(), mark));
    EXPECT_EQ(closure.front(), mark);
    RefinementTree copy = replay.tree();
    const std::vector<std::int32_t> whole = mark_closure(copy, std::vector{mark});
    for (const std::int32_t leaf : closure) EXPECT_TRUE(copy.is_marked(leaf));
    smaller += closure.size() < whole.size();
  }
  EXPECT_GE(smaller, 5);
}

}  // namespace
}  // namespace asts
