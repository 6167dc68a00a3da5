#include "tests/reference/complexity_claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/complexity_constants.hpp"
#include "lib/refine/refinement.hpp"
#include "lib/refine/replay.hpp"
#include "properties/claims/complexity_bounds.hpp"
#include "properties/claims/distance_bound.hpp"
#include "properties/claims/experiment.hpp"
#include "properties/claims/lambda_sums.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/properties/claim_checks.hpp"
#include "tests/reference/corner_experiment.hpp"
#include "tests/reference/lambda_chain.hpp"

namespace asts {

namespace {

using Constants = PerAxis<CubeRootNumber>;

Constants scaled(const Constants& d, const Rational& factor) { return {d[0] * factor, d[1] * factor, d[2] * factor}; }

CompactRational over(int top, int bottom) { return CompactRational(Rational(top) / Rational(bottom)); }

/// The origin's element marked so many times.
Case corner_case(int grading, int steps, PerAxis<int> domain = {5, 5, 5}) {
  Case result{{3, 3, 3}, grading, domain, {}, false, {}};
  result.steps.assign(static_cast<std::size_t>(steps), Step{Step::Kind::refine, {Point{}}});
  return result;
}

Verdict verdict_of(std::optional<ClaimWitness> witness) {
  return witness ? Verdict::violated(std::move(*witness)) : Verdict::holds();
}

// ---- constants

TEST(ComplexityConstants, ByHand) {
  // m = 8: t = 2, 1/(1 - 1/t) = 2; d_1 = 2 (3 + 5/2 + 1/64) = 353/32, d_2 = 2 d_1, d_3 = 4 d_1
  const Constants d = distance_constants({3, 3, 3}, 8);
  EXPECT_EQ(d[0], Rational(353) / 32);
  EXPECT_EQ(d[1], Rational(353) / 16);
  EXPECT_EQ(d[2], Rational(353) / 8);
  // C = 4 (353/8 + 1)(353/4 + 2)(353/2 + 4) = 4 * 361/8 * 361/4 * 361/2
  EXPECT_EQ(complexity_constant(d), Rational(361 * 361) * 361 / 16);
  // corrected: 7/16 in place of 1/64
  EXPECT_EQ(corrected_distance_constants({3, 3, 3}, 8)[0], 2 * (Rational(11) / 2 + Rational(7) / 16));
}

TEST(ComplexityConstants, TheCorrectionIsNoneForHalves) {
  for (const int p : {3, 5, 7}) {
    EXPECT_EQ(distance_constants({p, 3, 5}, 2), corrected_distance_constants({p, 3, 5}, 2));
    for (int m = 3; m <= 20; ++m) {
      EXPECT_LT(distance_constants({p, 3, 5}, m)[1], corrected_distance_constants({p, 3, 5}, m)[1]) << m;
    }
  }
}

TEST(ComplexityConstants, OfTheExperiment) {
  const auto text = [](int m) { return enclose_decimal(experiment_constant(m) * (Rational(1) / 3000), 10).lower; };
  EXPECT_EQ(text(2), "4286.003126");
  EXPECT_EQ(text(3), "1595.968265");
  EXPECT_EQ(text(4), "1152.161751");
  EXPECT_EQ(text(5), "1014.035743");
}

// ---- Lemma 7.2

/// The least upper bound F of the true distance and the bound R, in sides of K_0; see distance_bound.hpp.
int sign_of_slack(int p, int m) {
  const Rational farthest = 1 - Rational(1) / (2 * m) + Rational(3 * (p + 1)) / (m - 1);
  const CubeRootNumber bound = distance_constants({p, p, p}, m)[0] * cube_root_power(m, -1);
  return sign(bound - farthest);
}

TEST(DistanceBound, ThePrintedConstantsDoUpToGrading1267) {
  for (int m = 2; m <= kLargestGradingOfPrintedConstants; ++m) EXPECT_EQ(sign_of_slack(3, m), 1) << m;
  EXPECT_EQ(sign_of_slack(3, kLargestGradingOfPrintedConstants + 1), -1);
  for (const int p : {5, 7, 9}) EXPECT_EQ(sign_of_slack(p, 1268), 1) << "larger degrees come later: " << p;
}

// With one subdivision before the marks nothing is farther than 1 + p/m sides; the bound allows that up to m = 1314.
TEST(DistanceBound, OneSubdivisionIsNotEnoughBelowGrading1315) {
  const auto slack = [](int p, int m) {
    return sign(distance_constants({p, p, p}, m)[0] * cube_root_power(m, -1) - Rational(1 + Rational(p) / m));
  };
  for (int m = 2; m <= 1314; ++m) EXPECT_EQ(slack(3, m), 1) << m;
  EXPECT_EQ(slack(3, 1315), -1);
  EXPECT_EQ(slack(5, 1315), 1);
}

/// Cubes [0,1] and [1,2]; the first is subdivided along x. Marks the slab that is 3 slabs away from the second.
Verdict mark_third_slab(int grading) {
  RefinementTree tree({{3, 3, 3}, grading, {2, 1, 1}});
  tree.subdivide(tree.leaf_at(Point{}));
  tree.update_ranks();
  MeshUnderTest mesh(tree);
  return try_on_mesh(*find_claim("distance-bound"), mesh).verdict;
}

// The slab's distance to the last child of [1,2] along x is 1 + 3/m: the first m for which that is too far is 1315.
TEST(DistanceBound, FailsAtOnceFromGrading1315On) {
  EXPECT_EQ(mark_third_slab(1314).outcome, Outcome::holds);
  EXPECT_EQ(mark_third_slab(1315).outcome, Outcome::violated);
}

// With marks of level 4 it fails for the first m for which it can.
TEST(DistanceBound, FailsForGrading1268) {
  constexpr int m = kLargestGradingOfPrintedConstants + 1;
  RefinementTree tree({{3, 3, 3}, m, {2, 1, 1}});
  // slab m - 13; then its last slice of level 4 but three
  const Point place{CompactRational(Rational(m - 12) / m - Rational(4) / (m * m)), {}, {}};
  for (int step = 0; step < 4; ++step) {
    const std::int32_t mark = tree.leaf_at(place);
    refine(tree, std::span(&mark, 1));
  }
  EXPECT_EQ(tree.node(tree.leaf_at(place)).level, 4);
  const std::int32_t far_cube = tree.unit_cube({1, 0, 0});
  ASSERT_TRUE(tree.is_leaf(far_cube));
  const std::int32_t mark = tree.leaf_at(place);
  refine(tree, std::span(&mark, 1));
  ASSERT_FALSE(tree.is_leaf(far_cube)) << "K_0 = [1,2] is subdivided for the mark";
  // mark: [m-12-4/m, m-12-3/m]/m; the last child of K_0 ends at 2
  const Rational marked = (m - 12 - Rational(7) / (2 * m)) / m;
  const Rational distance = 2 - Rational(1) / (2 * m) - marked;
  EXPECT_GT(Rational(distance), Rational(1));
  EXPECT_LT(distance_constants({3, 3, 3}, m)[0] * cube_root_power(m, -1), distance);
  EXPECT_GT(corrected_distance_constants({3, 3, 3}, m)[0] * cube_root_power(m, -1), distance);
}

/// A mesh with every single mark, decided twice, with bounds so small that some do not hold.
void compare_distance_bounds(const Case& content, const Rational& factor) {
  Replay replay(content);
  while (!replay.done()) replay.advance();
  MeshUnderTest under_test(replay.tree());
  std::int64_t met = 0;
  const Constants d = scaled(distance_constants(content.degree, content.grading), factor);
  const bool fast = !judge_distance_bound(replay.tree(), LeafPatches(under_test), d, met);
  const reference::Setting setting = literal::setting(setting_of(content));
  const reference::Mesh mesh = literal::last_mesh(content);
  bool slow = true;
  for (std::size_t mark = 0; mark < mesh.size() && slow; ++mark) {
    slow = reference::distance_bound_holds(setting, mesh, {mark}, factor);
  }
  EXPECT_EQ(fast, slow);
  EXPECT_TRUE(slow || factor < 1);
}

Case small_sequence(Draw& draw) {
  CaseLimits limits;
  limits.max_grading = 16;
  limits.max_side = 4;
  limits.max_cubes = 24;
  limits.max_elements = 60;
  return random_admissible_case(draw, limits).content;
}

/// Bounds scaled down by powers of 2: on some of them the statements fail.
Rational draw_factor(Draw& draw, int most) {
  Rational factor = 1;
  for (int halvings = draw.between(0, most); halvings > 0; --halvings) factor /= 2;
  return factor;
}

TEST(DistanceBound, AgreesWithTheLiteralCode) {
  Draw draw(17);
  for (int number = 0; number < 150 && !testing::Test::HasFailure(); ++number) {
    const Case content = small_sequence(draw);
    const Rational factor = draw_factor(draw, 6);
    SCOPED_TRACE(to_string(factor) + "\n" + write_case(content));
    compare_distance_bounds(content, factor);
  }
}

// The lemma for all sets of marks is the lemma for single marks.
TEST(DistanceBound, HoldsForSetsOfMarksByTheLiteralCode) {
  Draw draw(18);
  for (int number = 0; number < 150 && !testing::Test::HasFailure(); ++number) {
    const Case content = small_sequence(draw);
    const reference::Mesh mesh = literal::last_mesh(content);
    std::vector<std::size_t> marks;
    for (int i = draw.between(1, 4); i > 0; --i) marks.push_back(draw.index(mesh.size()));
    SCOPED_TRACE(write_case(content));
    EXPECT_TRUE(reference::distance_bound_holds(literal::setting(setting_of(content)), mesh, marks, 1));
  }
}

// Deep marks, large m: meshes as the generators make them, without the literal code.
TEST(DistanceBound, HoldsOnRandomMeshesUpToGrading16) {
  Draw draw(19);
  std::int64_t met = 0;
  for (int number = 0; number < 300 && !testing::Test::HasFailure(); ++number) {
    CaseLimits limits;
    limits.max_grading = 16;
    limits.max_steps = 9;
    const Case content = random_admissible_case(draw, limits).content;
    SCOPED_TRACE(write_case(content));
    Replay replay(content);
    while (!replay.done()) replay.advance();
    MeshUnderTest mesh(replay.tree());
    for (const char* id : {"distance-bound", "distance-bound-repaired"}) {
      const Trial trial = try_on_mesh(*find_claim(id), mesh);
      EXPECT_EQ(trial.verdict.outcome, Outcome::holds) << id;
      met += trial.met;
    }
  }
  EXPECT_GT(met, 10'000);
}

// ---- Theorem 7.1 and its sums

reference::Sequence literal_sequence(const Case& content) {
  reference::Sequence sequence{literal::setting(setting_of(content)), {}, {}};
  sequence.meshes.push_back(reference::initial_mesh(sequence.setting));
  for (const Step& step : content.steps) {
    const reference::Mesh& mesh = sequence.meshes.back();
    std::set<std::size_t> marked;
    for (const Point& mark : step.marks) {
      marked.insert(reference::element_at(sequence.setting, mesh, literal::point(mark)).value());
    }
    reference::Mesh marks;
    for (const std::size_t mark : marked) marks.push_back(mesh[mark]);
    sequence.marks.push_back(marks);
    sequence.meshes.push_back(reference::refine(sequence.setting, mesh, {marked.begin(), marked.end()}));
  }
  return sequence;
}

TEST(ComplexityBound, AndLambdaSumsAgreeWithTheLiteralCode) {
  Draw draw(23);
  int failed = 0;
  for (int number = 0; number < 400 && !testing::Test::HasFailure(); ++number) {
    const Case content = small_sequence(draw);
    const Rational reach = draw_factor(draw, 6);
    Rational scale = draw_factor(draw, 22);
    SCOPED_TRACE(to_string(reach) + " " + to_string(scale) + "\n" + write_case(content));
    const MarkedSequence marked = *follow(content, NewElements::list);
    const Constants d = distance_constants(content.degree, content.grading);
    const CubeRootNumber constant = complexity_constant(d);
    const reference::Sequence sequence = literal_sequence(content);
    const bool bounded = !judge_complexity(marked, constant * scale);
    EXPECT_EQ(bounded, reference::complexity_bound_holds(sequence, scale));
    std::int64_t met = 0;
    const bool sums = !judge_lambda_sums(marked, scaled(d, 2 * reach), constant * scale, met);
    EXPECT_EQ(sums, reference::lambda_sums_hold(sequence, reach, scale));
    EXPECT_FALSE(judge_complexity(marked, constant));
    EXPECT_FALSE(judge_lambda_sums(marked, scaled(d, 2), constant, met));
    EXPECT_EQ(try_on_sequence(*find_claim("lambda-sums-repaired"), content).verdict.outcome, Outcome::holds);
    failed += !bounded + !sums;
  }
  EXPECT_GT(failed, 40) << "the scales are small enough to tell the two apart";
}

TEST(ComplexityBound, IsAboutRefinementStepsOnly) {
  Case content = corner_case(2, 2);
  content.steps.push_back(Step{Step::Kind::subdivide, {Point{}}});
  for (const char* id : {"complexity-bound", "lambda-sums", "experiment-constant"}) {
    EXPECT_EQ(try_on_sequence(*find_claim(id), content).verdict.outcome, Outcome::not_applicable) << id;
  }
}

// One cube, m = 2, two marks: after the first 2 halves are new, after the second the marked half's halves and, since
// nothing is coarser than level 1, the other half: 3 new elements.
TEST(ComplexityBound, FollowsMarksByHand) {
  const MarkedSequence marked = *follow(corner_case(2, 2, {1, 1, 1}), NewElements::list);
  ASSERT_EQ(marked.steps.size(), 2U);
  EXPECT_EQ(marked.steps[1].new_elements, 3);
  EXPECT_EQ(marked.steps[1].marked, 1);
  EXPECT_EQ(marked.marks[0].level, 0);
  EXPECT_EQ(marked.marks[1].level, 1);
  EXPECT_EQ(marked.new_elements.size(), 3U);
}

// ---- the sums for large m

/// The findings' sequence: three cubes in a row along x. Marks the elements of level 0, 1, 2, 3 at slab `first` of
/// width 1/m, then in each slab from there on the last slice of level 4, up to the slab with 12 others before [2,3].
Case chain_of_marks(int m, int first) {
  Case result{{3, 3, 3}, m, {3, 1, 1}, {}, false, {}};
  const auto mark = [&](const Rational& x) {
    result.steps.push_back({Step::Kind::refine, {{CompactRational(x), CompactRational(), CompactRational()}}});
  };
  mark(0);
  for (int level = 1; level <= 3; ++level) mark(Rational(first) / m);
  for (int slab = first; slab <= 2 * m - 13; ++slab) mark((Rational(slab + 1) - Rational(1) / m) / m);
  return result;
}

const ClaimWitness& witness_of(const Trial& trial) { return std::get<ClaimWitness>(*trial.verdict.witness); }

// By hand for m = 1331, where m^(1/3) = 11: see the finding.
TEST(LambdaSums, AreBelow1ForGrading1331) {
  const Case chain = chain_of_marks(1331, 1329);
  EXPECT_EQ(chain.steps.size(), 1325U);
  const Trial trial = try_on_sequence(*find_claim("lambda-sums"), chain);
  ASSERT_EQ(trial.verdict.outcome, Outcome::violated);
  const auto& values = witness_of(trial).values;
  EXPECT_EQ(std::get<std::int64_t>(values[1].second), 1320);
  const auto& k = std::get<ElementInfo>(values[0].second);
  EXPECT_EQ(k.level, 1);
  EXPECT_EQ(k.box.lower[0], 3 - Rational(1) / 1331);
  EXPECT_EQ(k.box.upper, (ExactPoint{3, 1, 1}));
  EXPECT_TRUE(std::get<std::string>(values[2].second).starts_with("120/121")) << "1320/1331";
}

/// The marks that lambda(K, .) of the last child of [2,3] reaches, each 1/m, as chain_of_marks makes them with the
/// least number of steps: slab `first` is the last one with its midpoint out of reach.
int marks_within_reach(int m) {
  const CubeRootNumber reach = distance_constants({3, 3, 3}, m)[0] * cube_root_power(m, -1) * Rational(2);
  const Rational middle = 3 - Rational(1) / (2 * m);
  int within = 0;
  for (int slab = 2 * m - 13; slab >= 0; --slab) {
    const Rational mark = (Rational(slab + 1) - Rational(1) / (2 * m)) / m;
    if (reach < Rational(middle - mark)) break;
    ++within;
  }
  return within;
}

TEST(LambdaSums, TheChainReachesMarksThatAddUpTo1BelowGrading1303) {
  for (int m = 1268; m <= 1302; ++m) EXPECT_GE(marks_within_reach(m), m) << m;
  for (int m = 1303; m <= 1331; ++m) EXPECT_LT(marks_within_reach(m), m) << m;
  EXPECT_EQ(marks_within_reach(1303), 1302);
}

// The least m for which this kind of sequence does it is 1303: the last child of [2,3] is looked at among others.
TEST(LambdaSums, NeedGrading1303ForThisSequence) {
  const auto outcome = [](const char* id, int m, int first) {
    return try_on_sequence(*find_claim(id), chain_of_marks(m, first)).verdict.outcome;
  };
  EXPECT_EQ(outcome("lambda-sums", 1303, 1291), Outcome::violated);
  EXPECT_EQ(outcome("lambda-sums", 1302, 1290), Outcome::undecided) << "never `holds` when little is looked at";
  EXPECT_EQ(outcome("lambda-sums-repaired", 1303, 1291), Outcome::undecided);
}

// Theorem 7.1 itself is far from it, and the meshes are as large as the finding says.
TEST(LambdaSums, LeaveTheTheoremAlone) {
  const Case chain = chain_of_marks(1303, 1291);
  const NarrowSequence narrow = follow_narrowly(chain);
  EXPECT_EQ(narrow.marks.size(), 1307U);
  EXPECT_EQ(narrow.subdivided.elements().size(), 47034U);
  EXPECT_EQ(narrow.subdivided.new_element_count(), 47034 * 1302 + 3);
  const CubeRootNumber constant = complexity_constant(distance_constants(chain.degree, chain.grading));
  EXPECT_GT(constant, Rational(1'000'000'000));
}

// The two forms of a sequence, where both can be had: the same new elements.
TEST(LambdaSums, NarrowFormAgrees) {
  Draw draw(29);
  int failed = 0;
  for (int number = 0; number < 200 && !testing::Test::HasFailure(); ++number) {
    const Case content = small_sequence(draw);
    const Rational factor = draw_factor(draw, 8);
    SCOPED_TRACE(to_string(factor) + "\n" + write_case(content));
    const MarkedSequence marked = *follow(content, NewElements::list);
    const NarrowSequence narrow = follow_narrowly(content);
    EXPECT_EQ(narrow.marks.size(), marked.marks.size());
    EXPECT_EQ(narrow.subdivided.new_element_count(), static_cast<std::int64_t>(marked.new_elements.size()));
    const Constants d = distance_constants(content.degree, content.grading);
    std::int64_t met = 0;
    const bool found = judge_outer_children(narrow, scaled(d, factor), met).has_value();
    const bool violated = judge_lambda_sums(marked, scaled(d, factor), complexity_constant(d), met).has_value();
    EXPECT_TRUE(violated || !found);
    failed += found;
  }
  EXPECT_GT(failed, 20);
}

// ---- the experiment

TEST(Experiment, FirstStepsByTheLiteralCode) {
  for (int m = 2; m <= 5; ++m) {
    const SelfSimilarity certificate = experiment_certificate(m);
    const auto steps = std::min<std::int64_t>(16, static_cast<std::int64_t>(certificate.new_elements.size()) - 1);
    const auto counts = reference::corner_counts({{3, 3, 3}, m, {5, 5, 5}}, static_cast<int>(steps));
    for (std::size_t n = 0; n < counts.size(); ++n) EXPECT_EQ(counts[n], certificate.new_elements[n]) << m << ' ' << n;
  }
}

TEST(Experiment, TheLiteralCodeSeesTheMeshesRepeat) {
  EXPECT_TRUE(reference::corner_repeats({{3, 3, 3}, 3, {5, 5, 5}}, 13, 4));
  EXPECT_FALSE(reference::corner_repeats({{3, 3, 3}, 3, {5, 5, 5}}, 12, 4));
  EXPECT_TRUE(reference::corner_repeats({{3, 3, 3}, 4, {5, 5, 5}}, 8, 4));
  EXPECT_TRUE(reference::corner_repeats({{3, 3, 3}, 5, {5, 5, 5}}, 8, 3));
}

TEST(Experiment, ExceedsThePrintedBoundForGrading3AtStep117) {
  const auto first = [](int m) {
    return first_step_not_below(experiment_certificate(m), experiment_constant(m) * (Rational(1) / 3000));
  };
  EXPECT_FALSE(first(2));
  EXPECT_EQ(first(3), Integer(117));
  EXPECT_FALSE(first(4));
  EXPECT_FALSE(first(5));
  const Claim& claim = *find_claim("experiment-constant");
  EXPECT_EQ(try_on_sequence(claim, corner_case(3, 116)).verdict.outcome, Outcome::holds);
  EXPECT_EQ(try_on_sequence(claim, corner_case(3, 117)).verdict.outcome, Outcome::violated);
  EXPECT_EQ(try_alone(claim, Extent::short_run).verdict.outcome, Outcome::violated);
}

TEST(Experiment, StaysBelowItsLimits) {
  const Claim& claim = *find_claim("experiment-constant-repaired");
  EXPECT_EQ(try_alone(claim, Extent::short_run).verdict.outcome, Outcome::holds);
  for (int m = 2; m <= 5; ++m) {
    EXPECT_EQ(try_on_sequence(claim, corner_case(m, 60)).verdict.outcome, Outcome::holds) << m;
    const SelfSimilarity certificate = experiment_certificate(m);
    EXPECT_TRUE(first_step_not_below(certificate, {m, Rational(experiment_limit(m) - 1)})) << "the limit is the limit";
  }
  EXPECT_GT(Rational(experiment_limit(3)), Rational(1600)) << "above C/3000 for m = 3";
  EXPECT_GT(CubeRootNumber(3, Rational(experiment_limit(3))), experiment_constant(3) * (Rational(1) / 2850));
}

// Growth 2, 2, 5 after 1, 1, 1, 1 new elements: the ratio reaches 2 at n = 9: 1 + 9 + 2 + 2 + ... by residues.
TEST(Experiment, FirstStepByHand) {
  const SelfSimilarity certificate{1, 1, {0, 1, 1, 1, 1}, {2, 2, 5}};
  // counts for n = 4, 5, ...: 1, 3, 5, 10, 12, 14, 19, 21, 23, 28
  EXPECT_EQ(first_step_not_below(certificate, {2, 1}), Integer(1));
  EXPECT_EQ(first_step_not_below(certificate, {2, Rational(5) / 4}), Integer(7)) << "10/7; before 3/5, 5/6";
  EXPECT_EQ(first_step_not_below(certificate, {2, Rational(2)}), Integer(13)) << "28/13; before 19/10, 21/11, 23/12";
  EXPECT_FALSE(first_step_not_below(certificate, {2, Rational(3)})) << "the limit";
}

TEST(Experiment, AnyCornerButOneCorner) {
  const auto with_marks = [](std::vector<Point> marks) {
    Case content = corner_case(3, 0);
    for (const Point& mark : marks) content.steps.push_back(Step{Step::Kind::refine, {mark}});
    return content;
  };
  const Point origin{}, far{over(5, 1), over(5, 1), over(5, 1)}, mixed{over(5, 1), over(0, 1), over(5, 1)};
  EXPECT_FALSE(no_experiment(with_marks({origin, origin})));
  EXPECT_FALSE(no_experiment(with_marks({far, far, far})));
  EXPECT_FALSE(no_experiment(with_marks({mixed, mixed})));
  EXPECT_TRUE(no_experiment(with_marks({origin, far})));
  EXPECT_TRUE(no_experiment(with_marks({})));
  EXPECT_TRUE(no_experiment(with_marks({{over(5, 2), over(0, 1), over(0, 1)}})));
  EXPECT_TRUE(no_experiment(corner_case(6, 1)));
  EXPECT_TRUE(no_experiment(corner_case(3, 1, {5, 5, 4})));
  Case two_marks = with_marks({origin});
  two_marks.steps[0].marks.push_back(far);
  EXPECT_TRUE(no_experiment(two_marks));
}

// ---- planted faults

/// Bounds as if the sum over the chain had one term: the factor 1/(1 - m^(-1/3)) is forgotten.
Verdict distance_without_geometric_sum(bool corrected) {
  constexpr int m = 2;
  RefinementTree tree({{3, 3, 3}, m, {16, 1, 1}});
  for (int step = 0; step < 5; ++step) {
    const std::int32_t mark = tree.leaf_at(Point{});
    refine(tree, std::span(&mark, 1));
  }
  MeshUnderTest mesh(tree);
  Constants d = corrected ? corrected_distance_constants({3, 3, 3}, m) : distance_constants({3, 3, 3}, m);
  const CubeRootNumber one(m, 1);
  for (CubeRootNumber& constant : d) constant *= one - cube_root_power(m, -1);
  std::int64_t met = 0;
  return verdict_of(judge_distance_bound(tree, LeafPatches(mesh), d, met));
}

/// C for d = 0: the sizes of the elements alone.
Verdict complexity_without_distances() {
  const CubeRootNumber zero(3, 0);
  return verdict_of(
      judge_complexity(*follow(corner_case(3, 9), NewElements::count), complexity_constant({zero, zero, zero})));
}

/// lambda with the distances of one level's elements only: d = (1, 1, 1).
Verdict lambda_without_reach() {
  const MarkedSequence marked = *follow(corner_case(3, 6), NewElements::list);
  const CubeRootNumber one(3, 1);
  std::int64_t met = 0;
  return verdict_of(judge_lambda_sums(marked, {one, one, one}, experiment_constant(3), met));
}

/// The chain of marks for m = 1303 with the printed constants in place of the true ones.
Verdict repaired_lambda_with_printed_constants() {
  const Case chain = chain_of_marks(1303, 1291);
  std::int64_t met = 0;
  return verdict_of(
      judge_outer_children(follow_narrowly(chain), scaled(distance_constants(chain.degree, chain.grading), 2), met));
}

/// Every step counted with one level's growth too many: as if phi lifted levels by 2.
Verdict experiment_with_shifted_growth() {
  SelfSimilarity certificate = experiment_certificate(5);
  for (std::int64_t& growth : certificate.growth) growth += growth / 2;
  return verdict_of(
      judge_experiment(5, certificate, experiment_constant(5) * (Rational(1) / kExperimentDivisor), "C/3000"));
}

/// Counts all elements, not the new ones.
Verdict experiment_counting_old_elements() {
  SelfSimilarity certificate = experiment_certificate(5);
  for (std::int64_t& count : certificate.new_elements) count += 124;
  certificate.new_elements.back() += 5000;
  return verdict_of(judge_experiment(5, certificate, {5, Rational(experiment_limit(5))}, "limit stated"));
}

/// The lemma's failure by the literal code: each step's subdivisions are admissible, and no mark is close enough.
bool literal_distance_bound_fails(const Case& content) {
  const reference::Setting setting = literal::setting(setting_of(content));
  const bool one_cube = content.steps.size() == 1 && content.steps[0].marks.size() == 1;
  if (!one_cube || !reference::admissible_subdivision(setting, reference::initial_mesh(setting), 0)) return false;
  const reference::Mesh mesh = literal::last_mesh(content);
  // the mark that violates it: the slab that ends 3 slabs before the other cube
  const reference::Point mark{1 - Rational(4) / setting.grading, 0, 0};
  const auto position = reference::element_at(setting, mesh, mark).value();
  return !reference::distance_bound_holds(setting, mesh, {position}, 1);
}

/// The failure of the first sum by the literal code, on the set of subdivided elements: each step refines one mark, the
/// mesh is admissible, K is new, and its sum is below 1.
bool literal_lambda_sums_fail(const Case& content) {
  reference::SubdividedSet mesh(literal::setting(setting_of(content)));
  std::vector<reference::GridBox> marks;
  for (const Step& step : content.steps) {
    if (step.kind != Step::Kind::refine || step.marks.size() != 1) return false;
    marks.push_back(mesh.element_at(literal::point(step.marks[0])));
    mesh.refine(marks.back());
  }
  // the last child of [2,3]: a cube's side is 2 m^2 steps of the literal code's grid
  const std::int64_t side = std::int64_t{2} * content.grading * content.grading;
  const reference::GridBox k = mesh.child({{2 * side, 0, 0}, {3 * side, side, side}, 0}, content.grading - 1);
  return mesh.admissible() && mesh.is_new(k) && mesh.lambda_sum_below_one(k, marks);
}

/// The experiment's failure by the literal code: the meshes after the steps 13 and 16 and the closures between show
/// that every later step adds as many elements as the one three steps before it.
bool literal_experiment_fails(const Case& content) {
  const reference::Setting setting = literal::setting(setting_of(content));
  const Step mark_origin{Step::Kind::refine, {Point{}}};
  const bool experiment =
      setting.domain == std::array{5, 5, 5} && setting.degree == std::array{3, 3, 3} &&
      std::all_of(content.steps.begin(), content.steps.end(), [&](const Step& step) { return step == mark_origin; });
  if (!experiment || setting.grading != 3 || !reference::corner_repeats(setting, 13, 4)) return false;
  std::vector<std::int64_t> counts = reference::corner_counts(setting, 19);
  while (counts.size() <= content.steps.size()) {
    const std::size_t n = counts.size();
    counts.push_back(counts[n - 1] + counts[n - 3] - counts[n - 4]);
  }
  const Rational ratio = Rational(counts[content.steps.size()]) / Rational(content.steps.size());
  const reference::RootSum bound = reference::complexity_constant(setting) * (Rational(1) / 3000);
  return reference::sign(reference::RootSum{3, ratio} - bound) >= 0;
}

}  // namespace

std::vector<NegativeControl> complexity_controls() {
  return {
      {"distance-bound", "the factor 1/(1 - m^(-1/3)) forgotten", [] { return distance_without_geometric_sum(false); }},
      {"distance-bound-repaired", "the factor 1/(1 - m^(-1/3)) forgotten",
       [] { return distance_without_geometric_sum(true); }},
      {"complexity-bound", "C without the distances d", complexity_without_distances},
      {"lambda-sums", "lambda with 2d = (1,1,1)", lambda_without_reach},
      {"lambda-sums-repaired", "the printed constants for m = 1303", repaired_lambda_with_printed_constants},
      {"experiment-constant", "late steps' growth counted one and a half times", experiment_with_shifted_growth},
      {"experiment-constant-repaired", "old elements counted as new", experiment_counting_old_elements}};
}

std::vector<Confirmation> complexity_confirmations() {
  return {{"distance-bound", literal_distance_bound_fails},
          {"lambda-sums", literal_lambda_sums_fail},
          {"experiment-constant", literal_experiment_fails}};
}

}  // namespace asts
