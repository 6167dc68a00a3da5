#include "lib/minimize/minimize.hpp"

#include <gtest/gtest.h>

#include "lib/exact/errors.hpp"
#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/minimize/path_case.hpp"
#include "lib/refine/replay.hpp"
#include "properties/statement.hpp"

namespace asts {
namespace {

Minimized minimized(const Case& start, const Predicate& predicate, PathForm form = PathForm::mesh) {
  return minimize(start, form, predicate, {});
}

std::string steps_of(const Case& test_case) {
  const std::string text = write_case(test_case);
  return text.substr(text.find("grading"));
}

Case random_start(std::uint64_t seed) {
  CaseLimits limits;
  limits.max_degree = 7;
  limits.max_side = 9;
  Draw draw(seed);
  return random_bare_case(draw, limits).content;
}

/// The level of the last mesh's finest element.
std::int32_t level_of_last_mesh(const Case& test_case) {
  Replay replay(test_case);
  while (!replay.done()) replay.advance();
  return replay.tree().max_level();
}

Predicate when(const std::function<bool(const Case&)>& condition) {
  return [condition](const Case& test_case) { return condition(test_case) ? ViolationKind("kind") : std::nullopt; };
}

// Predicates whose least cases are known without a search.
TEST(Minimize, FindsWhatAPredicateAsksForAndNothingElse) {
  const Predicate deep = when([](const Case& c) { return level_of_last_mesh(c) >= 3; });
  const Predicate wide = when([](const Case& c) { return c.domain[1] >= 4 && level_of_last_mesh(c) >= 1; });
  const Predicate high = when([](const Case& c) { return c.degree[2] >= 5; });
  const Predicate graded = when([](const Case& c) { return c.grading >= 3 && level_of_last_mesh(c) >= 2; });
  int tried = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Case start = random_start(seed);
    SCOPED_TRACE(write_case(start));
    const auto expect = [&](const Predicate& predicate, const std::string& least) {
      if (!predicate(start)) return;
      ++tried;
      EXPECT_EQ(steps_of(minimized(start, predicate).smallest), least);
    };
    expect(deep, "grading 2\ndomain 1 1 1\nsubdivide 0 0 0\nsubdivide 0 0 0\nsubdivide 0 0 0\n");
    expect(wide, "grading 2\ndomain 1 4 1\nsubdivide 0 0 0\n");
    expect(high, "grading 2\ndomain 1 1 1\n");
    expect(graded, "grading 3\ndomain 1 1 1\nsubdivide 0 0 0\nsubdivide 0 0 0\n");
  }
  EXPECT_GT(tried, 80);
}

// Laws (1) to (3), for statements that random cases violate.
TEST(Minimize, GivesASmallerViolationThatStaysAsItIs) {
  int tried = 0;
  for (const char* id :
       {"admissible", "analysis-suitable", "dual-compatible", "dual-basis", "perturbed-cover-hanging"}) {
    const Statement statement = find_statement(id).value();
    const Predicate predicate = [&](const Case& c) { return violation_of(statement, c); };
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      const Case start = random_start(seed);
      const ViolationKind kind = predicate(start);
      if (!kind) continue;
      ++tried;
      SCOPED_TRACE(std::string(id) + "\n" + write_case(start));
      const Minimized first = minimized(start, predicate);
      EXPECT_EQ(predicate(first.smallest), kind);
      EXPECT_EQ(first.guarantee, Guarantee::one_minimal);
      EXPECT_LE(first.size.subdivisions, follow_paths(start).subdivisions);
      EXPECT_EQ(write_case(minimized(start, predicate).smallest), write_case(first.smallest)) << "deterministic";
      EXPECT_EQ(write_case(minimized(first.smallest, predicate).smallest), write_case(first.smallest)) << "idempotent";
      for (const PassRecord& pass : first.last_run) EXPECT_FALSE(pass.accepted) << pass.pass;
    }
  }
  EXPECT_GT(tried, 50);
}

// Law (4), for steps and for boxes: what is asked about can be read back and replayed, or built.
TEST(Minimize, AsksAboutValidCasesAlone) {
  const Statement statement = find_statement("dual-compatible").value();
  std::int64_t asked = 0;
  const Predicate predicate = [&](const Case& c) {
    ++asked;
    EXPECT_EQ(parse_case(write_case(c), "asked"), c);
    return violation_of(statement, c);
  };
  int violating = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Draw draw(seed);
    const Case start = seed % 2 == 0 ? random_start(seed) : random_box_case(draw, CaseLimits{}).content;
    if (!violation_of(statement, start)) continue;
    SCOPED_TRACE(write_case(start));
    EXPECT_NO_THROW(minimized(start, predicate));
    ++violating;
  }
  EXPECT_GT(violating, 10);
  EXPECT_GT(asked, 1000);
}

TEST(Minimize, KeepsTheKindAndReportsOthers) {
  const Predicate predicate = [](const Case& c) -> ViolationKind {
    if (level_of_last_mesh(c) >= 3) return "deep";
    return level_of_last_mesh(c) >= 1 ? ViolationKind("shallow") : std::nullopt;
  };
  const Case start = parse_case(
      "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 2 2 2\nsubdivide 1 1 1\nsubdivide 1 1 1\nsubdivide 1 1 1\n",
      "test");
  const Minimized result = minimized(start, predicate);
  EXPECT_EQ(result.kind, "deep");
  EXPECT_EQ(result.size.subdivisions, 3);
  ASSERT_TRUE(result.others.contains("shallow"));
  EXPECT_EQ(predicate(result.others.at("shallow")), "shallow");
}

TEST(Minimize, CutsBehindTheFirstViolatingMesh) {
  std::vector<std::size_t> asked;
  const Predicate predicate = [&](const Case& c) -> ViolationKind {
    asked.push_back(c.steps.size());
    return c.steps.size() >= 3 ? ViolationKind("three") : std::nullopt;
  };
  std::string text = "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 1 1 1\n";
  for (int i = 0; i < 6; ++i) text += "refine 0 0 0\n";
  const Minimized result = minimized(parse_case(text, "test"), predicate, PathForm::sequence);
  EXPECT_EQ(result.smallest.steps.size(), 3U);
  EXPECT_EQ((std::vector<std::size_t>(asked.begin(), asked.begin() + 5)), (std::vector<std::size_t>{6, 0, 1, 2, 3}));
}

TEST(Minimize, EndsWithTheBestSoFar) {
  const Statement statement = find_statement("dual-compatible").value();
  const Case start = parse_case(
      "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 6 6 6\nsubdivide 1 1 1  3 3 3  2 2 2  4 4 4\n"
      "subdivide 3/2 1 1  7/2 3 3  5/2 2 2\n",
      "test");
  const Predicate predicate = [&](const Case& c) { return violation_of(statement, c); };
  const Minimized whole = minimized(start, predicate);
  for (const std::int64_t budget : {1, 2, 10}) {
    const Minimized part = minimize(start, PathForm::mesh, predicate, {.budget = budget, .stop = {}, .evaluated = {}});
    EXPECT_EQ(part.guarantee, Guarantee::budget);
    EXPECT_LE(part.evaluations, budget);
    EXPECT_EQ(predicate(part.smallest), whole.kind);
    EXPECT_TRUE(part.size > whole.size);
  }
  int left = 20;
  const auto stop = [&] { return --left < 0; };
  const Minimized stopped = minimize(start, PathForm::mesh, predicate, {.budget = 0, .stop = stop, .evaluated = {}});
  EXPECT_EQ(stopped.guarantee, Guarantee::interrupted);
  EXPECT_EQ(predicate(stopped.smallest), whole.kind);
}

TEST(Minimize, RefusesWhatDoesNotViolate) {
  EXPECT_THROW(minimized(Case{}, when([](const Case&) { return false; })), InputError);
}

// Boxes: 24 boxes with fractions become the mesh of one subdivision, or stay boxes where no subdivision makes the cut.
TEST(Minimize, ExplicitMeshes) {
  const auto has_box_below = [](Axis axis, const Rational& size) {
    return when([=](const Case& c) {
      if (!c.explicit_mesh) return level_of_last_mesh(c) > axis;
      for (const ElementLine& box : c.elements) {
        if (box.upper[at(axis)].value() - box.lower[at(axis)].value() < size) return true;
      }
      return false;
    });
  };
  std::string text = "asts-case 1\ndegree 5 3 3\ngrading 3\ndomain 3 2 2\n";
  for (int y = 0; y < 2; ++y) {
    for (int z = 0; z < 2; ++z) {
      const std::string low = std::to_string(y) + " " + std::to_string(z);
      const std::string high = std::to_string(y + 1) + " " + std::to_string(z + 1);
      const char* const cuts[] = {"0", "2/7", "1", "3/2", "8/5", "2", "3"};
      for (int i = 0; i < 6; ++i) {
        text += std::string("element ") + cuts[i] + " " + low + "  " + cuts[i + 1] + " " + high + "\n";
      }
    }
  }
  const Minimized cut = minimized(parse_case(text, "test"), has_box_below(0, 1));
  EXPECT_EQ(write_case(cut.smallest), "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 1 1 1\nsubdivide 0 0 0\n");
  const Predicate two_boxes = when([](const Case& c) { return c.explicit_mesh && c.elements.size() >= 2; });
  const Minimized boxes = minimized(parse_case(text, "test"), two_boxes);
  EXPECT_EQ(write_case(boxes.smallest),
            "asts-case 1\ndegree 3 3 3\ngrading 2\ndomain 1 1 1\nelement 0 0 0  1/2 1 1\nelement 1/2 0 0  1 1 1\n");
}

}  // namespace
}  // namespace asts
