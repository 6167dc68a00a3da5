#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <map>

#include "lib/gen/growing_case.hpp"
#include "properties/claims/theorem_5_3_proof.hpp"
#include "tests/properties/subdivided_mesh.hpp"

namespace asts {
namespace {

/// A mesh that is refined around a point and coarse elsewhere: the domain is long enough along one axis for levels to
/// fall off inside the active region, which random admissible meshes on short domains cannot do.
Case graded_case(Draw& draw) {
  Setting setting;
  setting.grading = draw.between(2, 6);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    setting.degree[axis] = draw.one_in(8) ? 5 : 3;
    setting.domain[axis] = setting.degree[axis] + 1 + (draw.one_in(4) ? 0 : draw.between(1, 2));
  }
  const std::size_t longest = draw.index(kDimension);
  const int cells = setting.degree[longest] + 1;
  setting.domain[longest] = draw.between(2 * cells + 2, 4 * cells);
  GrowingCase growing(setting, 900);
  const Point focus = random_point(draw, setting);
  for (int step = 0; step < 12; ++step) {
    const Point mark = step < 2 || !draw.one_in(4) ? focus : random_point(draw, setting);
    const std::int32_t leaf = growing.tree().leaf_at(mark);
    growing.add(Step::Kind::refine, {&leaf, 1});
  }
  return growing.content();
}

Case admissible_case(Draw& draw) {
  if (draw.one_in(10)) return graded_case(draw);
  CaseLimits limits;
  limits.max_degree = 5;
  limits.max_grading = 9;
  limits.max_steps = 9;
  return random_admissible_case(draw, limits).content;
}

struct Tally {
  std::map<std::string, std::int64_t> met;
  std::map<std::string, int> meshes;  ///< with met > 0
  std::int64_t steps = 0;

  void add(const char* claim, std::int64_t number) {
    met[claim] += number;
    meshes[claim] += number > 0;
  }
};

/// All statements about steps in one go through the steps of a mesh; the display as printed is not among them.
Judgement judge_all(const SubdivisionStep& step, std::map<std::string, std::int64_t>& met) {
  Judgement result;
  const auto take = [&](const char* claim, Judgement judgement) {
    met[claim] += judgement.met;
    if (judgement.violation) result = std::move(judgement);
  };
  take("new-nodes-keep-regions", judge_kept_regions(step));
  take("sigma-unperturbed", judge_sigma_unperturbed(step));
  take("new-node-split-repaired", judge_new_node_split_repaired(step));
  take("sigma-extent", judge_sigma_extent(step));
  return result;
}

void try_admissible(SubdividedMesh& subject, Tally& tally) {
  std::map<std::string, std::int64_t> met;
  const Trial steps = judge_steps(subject.mesh(), [&](const SubdivisionStep& step) {
    ++tally.steps;
    return judge_all(step, met);
  });
  EXPECT_NE(steps.verdict.outcome, Outcome::violated);
  for (const auto& [claim, number] : met) tally.add(claim.c_str(), number);
  for (const char* id : {"admissible-implies-as", "second-patch-sizes"}) {
    const Trial trial = try_on_mesh(*find_claim(id), subject.mesh());
    EXPECT_NE(trial.verdict.outcome, Outcome::violated) << id;
    tally.add(id, trial.met);
  }
}

/// ASTS_MESHES asks for another number of meshes.
int admissible_meshes() {
  const char* wanted = std::getenv("ASTS_MESHES");
  return wanted != nullptr ? std::atoi(wanted) : 250;
}

// The claims that stand, on random admissible meshes: m from 2 to 9, degrees 3 and 5, mixed.
TEST(Theorem53Random, ClaimsHoldOnAdmissibleMeshes) {
  Tally tally;
  for (int seed = 0; seed < admissible_meshes() && !testing::Test::HasFailure(); ++seed) {
    Draw draw(static_cast<std::uint64_t>(seed));
    SubdividedMesh subject(admissible_case(draw));
    SCOPED_TRACE(write_case(subject.content()));
    try_admissible(subject, tally);
  }
  std::cout << tally.steps << " subdivisions that reach active nodes\n";
  for (const auto& [claim, number] : tally.met) {
    std::cout << claim << ": met " << number << " on " << tally.meshes[claim] << " meshes\n";
    EXPECT_GT(number, 0) << claim;
  }
}

}  // namespace
}  // namespace asts
