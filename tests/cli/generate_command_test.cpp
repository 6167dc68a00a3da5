#include <gtest/gtest.h>

#include "lib/mesh/case_file.hpp"
#include "tests/cli/run_program.hpp"
#include "tests/reference/refine.hpp"

namespace asts::testing {
namespace {

using Names = std::vector<std::string>;

struct Workload {
  Names arguments;
  std::int64_t elements;
};

/// One line: test discovery reads it.
void PrintTo(const Workload& workload, std::ostream* out) {
  for (const std::string& argument : workload.arguments) *out << argument << ' ';
}

std::string generated(const Workload& workload) {
  Names arguments{"generate"};
  arguments.insert(arguments.end(), workload.arguments.begin(), workload.arguments.end());
  arguments.insert(arguments.end(), {"--elements", std::to_string(workload.elements)});
  const Outcome outcome = run(arguments);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

class GeneratedCase : public ::testing::TestWithParam<Workload> {};

const Workload kWorkloads[] = {
    {{"corner", "--degree", "3,3,3", "--grading", "2", "--domain", "16,16,16"}, 10'000},
    {{"sphere", "--degree", "3,3,3", "--grading", "2", "--domain", "16,16,16"}, 10'000},
    {{"--degree", "3,5,7", "--grading", "3", "--domain", "5,9,8", "corner"}, 3'000},
    {{"sphere", "--degree", "3,5,3", "--grading", "4", "--domain", "4,6,5"}, 2'000},
    {{"random", "--degree", "3,3,3", "--grading", "2", "--domain", "16,16,16"}, 10'000},
    {{"random", "--degree", "3,5,3", "--grading", "3", "--domain", "5,7,4"}, 2'000},
    {{"corner", "--domain", "4,4,4"}, 64},
};

INSTANTIATE_TEST_SUITE_P(Workloads, GeneratedCase, ::testing::ValuesIn(kWorkloads));

TEST_P(GeneratedCase, EndsWithTheFirstMeshThatIsLargeEnough) {
  const auto records = records_of(run({"refine", "-", "--format", "json"}, generated(GetParam())).out);
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i]["elements"] >= GetParam().elements, i + 1 == records.size()) << i;
  }
  EXPECT_EQ(records.empty(), GetParam().elements == 64) << "an initial mesh that is large enough needs no step";
}

TEST_P(GeneratedCase, IsTheSameInTwoRuns) { EXPECT_EQ(generated(GetParam()), generated(GetParam())); }

TEST(GenerateCommand, MarksTheOrigin) {
  const Case content = parse_case(generated({{"corner", "--domain", "4,4,4"}, 500}), "corner");
  ASSERT_FALSE(content.steps.empty());
  for (const Step& step : content.steps) EXPECT_EQ(step, (Step{Step::Kind::refine, {Point{}}}));
}

/// Whether a closed box meets the sphere around the domain's centre with radius a quarter of the shortest side: the
/// nearest point of the box is at most so far away, and the farthest vertex at least.
bool meets_sphere(const reference::Setting& setting, const reference::Box& box) {
  const Rational radius = Rational(*std::min_element(setting.domain.begin(), setting.domain.end())) / 4;
  Rational nearest = 0;
  Rational farthest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Rational centre = Rational(setting.domain[axis]) / 2;
    const Rational clamped = std::clamp(centre, box.lower[axis], box.upper[axis]);
    nearest += (clamped - centre) * (clamped - centre);
    const Rational lower = (box.lower[axis] - centre) * (box.lower[axis] - centre);
    const Rational upper = (box.upper[axis] - centre) * (box.upper[axis] - centre);
    farthest += std::max(lower, upper);
  }
  return nearest <= radius * radius && radius * radius <= farthest;
}

/// The elements that a step's marks name, and those that it ought to mark, by a scan of all.
void expect_sphere_marks(const reference::Setting& setting, const reference::Mesh& mesh, const Step& step,
                         std::vector<std::size_t>& named) {
  std::vector<std::size_t> expected;
  for (std::size_t k = 0; k < mesh.size(); ++k) {
    if (meets_sphere(setting, mesh[k])) expected.push_back(k);
  }
  for (const Point& mark : step.marks) {
    reference::Point point;
    for (std::size_t axis = 0; axis < point.size(); ++axis) point[axis] = mark[axis].value();
    named.push_back(reference::element_at(setting, mesh, point).value());
  }
  std::sort(named.begin(), named.end());
  EXPECT_EQ(named, expected);
}

class SphereCase : public ::testing::TestWithParam<Names> {};

INSTANTIATE_TEST_SUITE_P(Domains, SphereCase,
                         ::testing::Values(Names{"sphere", "--domain", "4,4,4"},
                                           Names{"sphere", "--domain", "5,4,6", "--grading", "3"},
                                           Names{"sphere", "--domain", "8,8,8"}));

TEST_P(SphereCase, MarksExactlyTheLeavesWhoseClosedBoxMeetsTheSphere) {
  const Case content = parse_case(generated({GetParam(), 1'200}), "sphere");
  const reference::Setting setting{content.degree, content.grading, content.domain};
  reference::Mesh mesh = reference::initial_mesh(setting);
  ASSERT_GE(content.steps.size(), 2U);
  for (const Step& step : content.steps) {
    std::vector<std::size_t> named;
    expect_sphere_marks(setting, mesh, step, named);
    mesh = reference::refine(setting, mesh, named);
  }
  EXPECT_GE(mesh.size(), 1'200U);
}

}  // namespace
}  // namespace asts::testing
