#include "tests/reference/skeleton_claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>

#include "lib/gen/planar_tiling.hpp"
#include "lib/gen/random_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "lib/spline/hanging.hpp"
#include "properties/claims/hanging_cover.hpp"
#include "properties/claims/index_entries.hpp"
#include "properties/claims/planar_suitability.hpp"
#include "properties/claims/proof_figure.hpp"
#include "properties/claims/slice_figures.hpp"
#include "properties/claims/uniform_mesh.hpp"
#include "tests/literal_mesh.hpp"
#include "tests/properties/claim_checks.hpp"
#include "tests/reference/tree.hpp"

namespace asts {
namespace {

namespace fs = std::filesystem;

Rational over(int top, int bottom) { return Rational(top) / bottom; }

Point point(const Rational& x, const Rational& y, const Rational& z) {
  return {CompactRational(x), CompactRational(y), CompactRational(z)};
}

Case subdivisions(const PerAxis<int>& degree, const PerAxis<int>& domain, std::vector<Point> marks) {
  Case content;
  content.degree = degree;
  content.domain = domain;
  if (!marks.empty()) content.steps.push_back({Step::Kind::subdivide, std::move(marks)});
  return content;
}

/// A case's last mesh, with the tree that it needs.
struct LastMesh {
  std::unique_ptr<Replay> replay;
  std::unique_ptr<MeshUnderTest> mesh;

  explicit LastMesh(const Case& content) {
    if (content.explicit_mesh) {
      mesh = std::make_unique<MeshUnderTest>(mesh_of(setting_of(content), content.elements));
      return;
    }
    replay = std::make_unique<Replay>(content);
    while (!replay->done()) replay->advance();
    mesh = std::make_unique<MeshUnderTest>(replay->tree());
  }
};

Trial trial_of(const char* id, const Case& content) {
  LastMesh last(content);
  return try_on_mesh(*find_claim(id), *last.mesh);
}

Outcome outcome_of(const char* id, const Case& content) { return trial_of(id, content).verdict.outcome; }

Case finding(const std::string& name) {
  return read_case_file((fs::path(ASTS_CASES) / ".." / ".." / "reports" / "findings" / (name + ".case")).string());
}

Case corpus(const std::string& name) { return read_case_file((fs::path(ASTS_CASES) / (name + ".case")).string()); }

std::string kind_of(const Trial& trial) { return std::get<ClaimWitness>(trial.verdict.witness.value()).kind; }

/// Unit cubes but for two of them along x that are merged into one box.
Case merged_pair(const PerAxis<int>& degree, const PerAxis<int>& domain, const PerAxis<int>& first) {
  Case content{degree, 2, domain, {}, true, {}};
  for (int x = 0; x < domain[0]; ++x) {
    for (int y = 0; y < domain[1]; ++y) {
      for (int z = 0; z < domain[2]; ++z) {
        const bool row = y == first[1] && z == first[2];
        if (row && x == first[0] + 1) continue;
        const int width = row && x == first[0] ? 2 : 1;
        content.elements.push_back({point(x, y, z), point(x + width, y + 1, z + 1)});
      }
    }
  }
  return content;
}

// ---- Definition 4.3 ----

TEST(SkeletonClaims, FrameEntriesNeedRoomOnTheAxis) {
  // ceil(5/2) = 3: the entry 2 is outside [0,1]; with X~ = 2 it is X~ itself
  EXPECT_EQ(outcome_of("frame-in-index-sets", subdivisions({5, 3, 3}, {1, 1, 1}, {})), Outcome::violated);
  EXPECT_EQ(outcome_of("frame-in-index-sets", subdivisions({5, 3, 3}, {2, 1, 1}, {})), Outcome::holds);
  EXPECT_EQ(outcome_of("frame-in-index-sets", subdivisions({3, 3, 3}, {1, 1, 1}, {})), Outcome::holds);
  EXPECT_EQ(outcome_of("frame-in-index-sets", subdivisions({3, 3, 9}, {1, 1, 3}, {})), Outcome::violated);
  EXPECT_EQ(outcome_of("frame-in-index-sets-repaired", subdivisions({5, 3, 3}, {1, 1, 1}, {})), Outcome::holds);
  EXPECT_EQ(outcome_of("frame-in-index-sets-repaired", subdivisions({5, 5, 5}, {1, 1, 1}, {})),
            Outcome::not_applicable);
}

TEST(SkeletonClaims, FrameEntriesCountCellsWithMoreEntries) {
  // one cube of 1 x 2 x 1 halved along x: X has 1/2 through one of two cells; the other axes have integers only
  EXPECT_EQ(trial_of("frame-in-index-sets", subdivisions({3, 3, 3}, {1, 2, 1}, {point(0, 0, 0)})).met, 1);
}

// ---- Definition 4.4 ----

TEST(SkeletonClaims, IndexVectorsNeedEntriesOnBothSides) {
  // AR = {2}^3; the box [0,2] x [1,2]^2 takes the entry 1 from X(y,z) on the lines through it, not at its corners
  const Case inside = merged_pair({3, 3, 3}, {4, 4, 4}, {0, 1, 1});
  LastMesh last(inside);
  EXPECT_EQ(judge_index_vectors(last.mesh->mesh()).verdict.outcome, Outcome::holds);
  // two merged pairs beside each other on the whole cross-section: the node (2,2,2) has one entry below it
  Case all = subdivisions({3, 3, 3}, {4, 4, 4}, {});
  all.explicit_mesh = true;
  for (int y = 0; y < 4; ++y) {
    for (int z = 0; z < 4; ++z) {
      for (int x = 0; x < 4; x += x == 0 ? 2 : 1) {
        all.elements.push_back({point(x, y, z), point(x == 0 ? 2 : x + 1, y + 1, z + 1)});
      }
    }
  }
  LastMesh missing(all);
  const Trial trial = judge_index_vectors(missing.mesh->mesh());
  EXPECT_EQ(trial.verdict.outcome, Outcome::violated);
  EXPECT_EQ(kind_of(trial), "no-unique-index-vector");
}

// ---- Definition 5.1 ----

TEST(SkeletonClaims, UniformMeshesAreTensorProducts) {
  const RefinementTree tree = uniform_tree({{3, 3, 3}, 2, {5, 5, 5}}, 4);
  EXPECT_EQ(tree.element_count(), 125 * 16);
  MeshUnderTest mesh(tree);
  const Trial trial = uniform_unperturbed(mesh);
  EXPECT_EQ(trial.verdict.outcome, Outcome::holds);
  EXPECT_EQ(trial.met, 5 + 3 + 3);  // AR = [2,3]^3; level 4: quarters along x, halves along y and z
}

TEST(SkeletonClaims, HangingNodesAndEdgesOfOneSubdivision) {
  // [0,1]^3 halved along x in 1 x 2 x 1: the plane x = 1/2 ends on the element above
  LastMesh last(subdivisions({3, 3, 3}, {1, 2, 1}, {point(0, 0, 0)}));
  EXPECT_EQ(hanging_nodes(last.mesh->mesh()).size(), 2u);  // (1/2,1,0), (1/2,1,1)
  const std::vector<Hanging> edges = hanging_edges(last.mesh->mesh());
  ASSERT_EQ(edges.size(), 1u);  // (1/2,1) x [0,1]; the halves of the cube's own edges do not hang
  EXPECT_EQ(edges.front().axis, 0);
  EXPECT_EQ(edges.front().box.lower[2], 0);
  EXPECT_EQ(edges.front().box.upper[2], 1);
}

TEST(SkeletonClaims, NodesInAFaceHangAlongTwoAxes) {
  // the cube below divided into quarters along x and y: (1/2,1/2,1) lies in the face of the cube above
  Case content = subdivisions({3, 3, 3}, {1, 1, 2}, {point(0, 0, 0)});
  content.steps.push_back({Step::Kind::subdivide, {point(0, 0, 0), point(over(1, 2), 0, 0)}});
  LastMesh last(content);
  const std::vector<Hanging> nodes = hanging_nodes(last.mesh->mesh());
  EXPECT_EQ(nodes.size(), 2u + 4u);  // twice in the face, and four on its edges
  EXPECT_EQ(hanging_edges(last.mesh->mesh()).size(), 4u);
}

TEST(SkeletonClaims, HangingNodesInTheFrameAreNotCovered) {
  EXPECT_EQ(outcome_of("perturbed-cover-hanging", finding("perturbed-cover-hanging")), Outcome::violated);
  EXPECT_EQ(outcome_of("perturbed-cover-hanging-repaired", finding("perturbed-cover-hanging")), Outcome::holds);
}

// One coarse element among fine ones: its vertices' projections all lie in faces, and nothing is perturbed.
TEST(SkeletonClaims, HangingNodesInsideTheActiveRegionNeedNotBeCovered) {
  const Case inside = finding("perturbed-cover-hanging-inside");
  LastMesh last(inside);
  EXPECT_TRUE(last.mesh->admissible());
  EXPECT_EQ(last.mesh->mesh().setting.domain, (PerAxis<int>{5, 6, 6}));
  for (const auto& region : perturbed_regions(*last.mesh)) EXPECT_TRUE(region.empty());
  EXPECT_EQ(outcome_of("perturbed-cover-hanging", inside), Outcome::violated);
  EXPECT_EQ(trial_of("perturbed-cover-hanging-repaired", inside).met, 0);
  // the same with fewer subdivisions on smaller active regions, where the hanging nodes are on their sides
  EXPECT_EQ(outcome_of("perturbed-cover-hanging", subdivisions({3, 3, 3}, {5, 4, 4}, {point(2, 1, 1)})),
            Outcome::violated);
  EXPECT_EQ(outcome_of("perturbed-cover-hanging", subdivisions({3, 3, 3}, {5, 5, 5}, {point(2, 1, 2), point(2, 3, 2)})),
            Outcome::violated);
}

TEST(SkeletonClaims, ThreeSubdivisionsDoNotMakeACoarseElementInside) {
  // [2,3] x [1,5] x [1,5] has all the elements that touch nodes of the slices in AR = [2,3] x [2,4]^2
  std::vector<Point> cells;
  for (int y = 1; y <= 4; ++y) {
    for (int z = 1; z <= 4; ++z) cells.push_back(point(2, y, z));
  }
  const PerAxis<HalfRank> centre{5, 6, 6};  // (5/2,3,3), where lines are 0,1,2,5/2,... along x
  int uncovered = 0;
  int tried = 0;
  for (std::size_t a = 0; a < cells.size(); ++a) {
    for (std::size_t b = a; b < cells.size(); ++b) {
      for (std::size_t c = b; c < cells.size(); ++c) {
        LastMesh last(subdivisions({3, 3, 3}, {5, 6, 6}, {cells[a], cells[b], cells[c]}));
        const std::vector<Hanging> nodes = hanging_nodes(last.mesh->mesh());
        const auto inside = [&](const Hanging& h) {
          return h.box.lower == PerAxis<std::int32_t>{3, 3, 3} && h.axis == 0;
        };
        if (std::none_of(nodes.begin(), nodes.end(), inside)) continue;
        ++tried;
        uncovered += perturbed_regions(*last.mesh)[0].empty();
      }
    }
  }
  EXPECT_EQ(centre[0], 5);
  EXPECT_GT(tried, 300);
  EXPECT_EQ(uncovered, 0);
}

/// Four elements subdivided around two coarse ones in AR = [c,c+1] x [c,c+2]^2, c = (p+1)/2: the counterexample inside
/// for any degree and grading.
Case coarse_pair_inside(int degree, int grading) {
  const int c = (degree + 1) / 2;
  Case content = subdivisions({degree, degree, degree}, {degree + 2, degree + 3, degree + 3},
                              {point(c, c, c), point(c, c + 1, c + 1), point(c, c - 1, c + 2), point(c, c + 2, c - 1)});
  content.grading = grading;
  return content;
}

bool nothing_is_perturbed(const Case& content) {
  LastMesh last(content);
  const PerturbedRegions regions = perturbed_regions(*last.mesh);
  return last.mesh->admissible() && regions[0].empty() && regions[1].empty() && regions[2].empty();
}

TEST(SkeletonClaims, UncoveredHangingNodesForOtherDegreesGradingsAndDomains) {
  for (const int degree : {3, 5, 7}) {
    for (const int grading : {2, 3, 4}) {
      const Case content = coarse_pair_inside(degree, grading);
      EXPECT_TRUE(nothing_is_perturbed(content)) << degree << " " << grading;
      EXPECT_EQ(outcome_of("perturbed-cover-hanging", content), Outcome::violated) << degree << " " << grading;
    }
  }
  // all elements but one in the middle
  std::vector<Point> marks;
  for (int x = 0; x < 7; ++x) {
    for (int y = 0; y < 7; ++y) {
      for (int z = 0; z < 7; ++z) {
        if (x != 3 || y != 3 || z != 3) marks.push_back(point(x, y, z));
      }
    }
  }
  EXPECT_TRUE(nothing_is_perturbed(subdivisions({3, 3, 3}, {7, 7, 7}, marks)));
}

// The repaired form needs admissibility: with m = 4 an element's corner has many entries between it and the next one.
TEST(SkeletonClaims, RepairedCoverNeedsAdmissibility) {
  Case content = subdivisions({3, 3, 5}, {5, 5, 6}, {point(2, 2, 3)});
  content.grading = 4;
  const std::vector<Point> marks{point(over(9, 4), 2, 3), point(over(5, 2), 2, 3), point(over(5, 2), over(11, 4), 3),
                                 point(2, 2, 3), point(over(5, 2), over(9, 4), 3)};
  for (const Point& mark : marks) content.steps.push_back({Step::Kind::subdivide, {mark}});
  LastMesh last(content);
  EXPECT_FALSE(last.mesh->admissible());
  EXPECT_EQ(judge_hanging_cover_repaired(last.mesh->mesh(), perturbed_regions(*last.mesh)).verdict.outcome,
            Outcome::violated);
  EXPECT_FALSE(
      reference::hanging_covered_if_vertex_outside(literal::setting(setting_of(content)), literal::last_mesh(content)));
}

// Admissible meshes on domains with a wide active region, refined inside it: that is where the repaired form speaks.
TEST(SkeletonClaims, RepairedCoverOnWideActiveRegions) {
  std::int64_t met = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Draw draw(seed);
    Case content = subdivisions({3, draw.one_in(3) ? 5 : 3, 3}, {}, {});
    content.grading = draw.between(2, 4);
    for (int& side : content.domain) side = draw.between(6, 9);
    for (int steps = draw.between(1, 3); steps > 0; --steps) {
      Point mark;
      for (std::size_t axis = 0; axis < kDimension; ++axis) {
        const int frame = (content.degree[axis] + 1) / 2;
        mark[axis] = CompactRational(over(draw.between(4 * frame, 4 * (content.domain[axis] - frame)), 4));
      }
      content.steps.push_back({Step::Kind::refine, {mark}});
    }
    const Trial trial = trial_of("perturbed-cover-hanging-repaired", content);
    ASSERT_EQ(trial.verdict.outcome, Outcome::holds) << write_case(content);
    met += trial.met;
  }
  EXPECT_GT(met, 5000);
}

// ---- the remark to Definition 5.2 ----

TEST(SkeletonClaims, PublishedPlanarMeshes) {
  for (const char* name : {"planar/published-good-tmesh", "planar/published-bad-tmesh"}) {
    const Trial trial = trial_of("planar-equals-classical-repaired", corpus(name));
    EXPECT_EQ(trial.verdict.outcome, Outcome::holds) << name;
    EXPECT_EQ(trial.met, 1) << name;  // one horizontal and one vertical T-junction
  }
}

TEST(SkeletonClaims, ExtensionsOfTheGoodMesh) {
  LastMesh last(corpus("planar/published-good-tmesh"));
  const PlanarMesh planar = planar_mesh(last.mesh->mesh()).value();
  const std::vector<TJunction> junctions = t_junctions(planar.edges);
  ASSERT_EQ(junctions.size(), 2u);  // (7/2,4) and (5,7/2): ranks count 7/2 as 4
  EXPECT_EQ(junctions[0], (TJunction{{4, 5}, 1, +1}));
  EXPECT_EQ(junctions[1], (TJunction{{6, 4}, 0, +1}));
  const Extension vertical = extension(planar.edges, junctions[0], 3);
  EXPECT_EQ(vertical.lower, 4);  // back to 7/2
  EXPECT_EQ(vertical.upper, 7);  // on to 6
  const Extension longer = extension(planar.edges, junctions[0], 5);
  EXPECT_EQ(longer.lower, 3);
  EXPECT_EQ(longer.upper, 8);
}

TEST(SkeletonClaims, FacingJunctionsRefuteTheRemark) {
  const Case counterexample = finding("planar-equals-classical");
  const Trial trial = trial_of("planar-equals-classical", counterexample);
  EXPECT_EQ(kind_of(trial), "only-extensions-meet");
  EXPECT_EQ(outcome_of("planar-equals-classical-repaired", counterexample), Outcome::not_applicable);
}

/// All meshes with halved squares on an active region: how many there are, and how many violate the claims.
struct PlanarCounts {
  int meshes = 0;
  int violations = 0;
  int repaired_violations = 0;
};

PlanarCounts count_planar(std::array<int, 2> squares) {
  PlanarCounts counts;
  std::vector<int> ways(static_cast<std::size_t>(squares[0] * squares[1]), 0);
  for (std::size_t place = 0; place < ways.size();) {
    LastMesh last(halved_squares(squares, ways).extruded({3, 3, 3}));
    ++counts.meshes;
    counts.violations += planar_equals_classical(*last.mesh).verdict.outcome == Outcome::violated;
    counts.repaired_violations += planar_equals_classical_repaired(*last.mesh).verdict.outcome == Outcome::violated;
    for (place = 0; place < ways.size() && ways[place] == kSquareCuts - 1; ++place) ways[place] = 0;
    if (place < ways.size()) ++ways[place];
  }
  return counts;
}

TEST(SkeletonClaims, SmallPlanarMeshesExhaustively) {
  const PlanarCounts one = count_planar({1, 1});
  EXPECT_EQ(one.meshes, 8);
  EXPECT_EQ(one.violations, 0);
  const PlanarCounts two = count_planar({1, 2});
  EXPECT_EQ(two.meshes, 64);
  EXPECT_EQ(two.violations, 4);
  EXPECT_EQ(two.repaired_violations, 0);
  const PlanarCounts three = count_planar({1, 3});
  EXPECT_EQ(three.meshes, 512);
  EXPECT_EQ(three.violations, 70);
  EXPECT_EQ(three.repaired_violations, 0);
}

/// The cuts that make a mesh of halved squares, frame included: the boxes that it has more than unit squares. A line
/// that ends on a side of the active region cuts the two squares of the frame behind it.
int cuts_of(const PlanarTiling& tiling, const std::array<int, 2>& squares) {
  std::set<std::array<int, 3>> ends;
  for (const PlanarTiling::Box& box : tiling.boxes()) {
    for (const int axis : {0, 1}) {
      const std::size_t a = at(axis);
      for (const int place : {box.lower[1 - a], box.upper[1 - a]}) {
        if (place % 2 != 0 && box.lower[a] == 0) ends.insert({axis, 0, place});
        if (place % 2 != 0 && box.upper[a] == 2 * squares[a]) ends.insert({axis, 1, place});
      }
    }
  }
  return static_cast<int>(tiling.boxes().size() + 2 * ends.size()) - squares[0] * squares[1];
}

/// Goes over all ways to divide the squares from one on with at most so many cuts; counts tried meshes and violations.
void count_few_cuts(std::array<int, 2> squares, std::vector<int>& ways, std::size_t square, int cuts, int max_cuts,
                    PlanarCounts& counts) {
  constexpr std::array<int, kSquareCuts> kCuts{0, 1, 2, 2, 1, 2, 2, 3};
  if (square == ways.size()) {
    const PlanarTiling tiling = halved_squares(squares, ways);
    if (cuts_of(tiling, squares) > max_cuts) return;
    LastMesh last(tiling.extruded({3, 3, 3}));
    ++counts.meshes;
    counts.violations += planar_equals_classical(*last.mesh).verdict.outcome == Outcome::violated;
    return;
  }
  for (int way = 0; way < kSquareCuts; ++way) {
    const int more = cuts + kCuts[static_cast<std::size_t>(way)];
    if (more > max_cuts) continue;
    ways[square] = way;
    count_few_cuts(squares, ways, square + 1, more, max_cuts, counts);
  }
  ways[square] = 0;
}

PlanarCounts few_cuts(std::array<int, 2> squares, int max_cuts) {
  PlanarCounts counts;
  std::vector<int> ways(static_cast<std::size_t>(squares[0] * squares[1]), 0);
  count_few_cuts(squares, ways, 0, 0, max_cuts, counts);
  return counts;
}

// The counterexample has four cuts; with halves the smallest has four on 2 x 6 squares. (For one degree along x and y, mirrored active regions are alike.)
TEST(SkeletonClaims, NoSmallerPlanarCounterexample) {
  std::size_t cuts = 0;
  for (const Step& step : finding("planar-equals-classical").steps) cuts += step.marks.size();
  EXPECT_EQ(cuts, 4u * 4) << "in each of four layers";
  int meshes = 0;
  for (const auto& squares : std::vector<std::array<int, 2>>{{1, 1},
                                                             {1, 2},
                                                             {1, 3},
                                                             {1, 4},
                                                             {1, 5},
                                                             {1, 6},
                                                             {1, 7},
                                                             {1, 8},
                                                             {2, 2},
                                                             {2, 3},
                                                             {2, 4},
                                                             {2, 5},
                                                             {3, 3},
                                                             {3, 4}}) {
    const PlanarCounts counts = few_cuts(squares, 4);
    EXPECT_EQ(counts.violations, 0) << squares[0] << " x " << squares[1];
    meshes += counts.meshes;
  }
  EXPECT_EQ(few_cuts({2, 6}, 3).violations, 0);
  EXPECT_EQ(few_cuts({3, 5}, 3).violations, 0);
  EXPECT_EQ(few_cuts({4, 4}, 2).violations, 0);
  EXPECT_EQ(few_cuts({2, 6}, 4).violations, 4);
  RecordProperty("meshes with at most four cuts", meshes);
}

// ---- figures ----

TEST(SkeletonClaims, FiguresAfterDefinition52) {
  const std::vector<SliceFigure> figures = slice_figures();
  EXPECT_EQ(judge_slice_figure(figures[0]).verdict.outcome, Outcome::holds);
  EXPECT_EQ(judge_slice_figure(figures[1]).verdict.outcome, Outcome::holds);
  EXPECT_EQ(judge_slice_figure(figures[0]).met, 38 + 5);  // 23 orange and 15 blue nodes, five sets
}

std::string text_of(const Trial& trial, const std::string& name) {
  for (const auto& [key, value] : std::get<ClaimWitness>(trial.verdict.witness.value()).values) {
    if (key == name) return std::get<std::string>(value);
  }
  return "";
}

TEST(SkeletonClaims, NoDegreeFitsTheProofsFigures) {
  const Trial trial = figure_proof_levels_alone(Extent::short_run);
  EXPECT_EQ(text_of(trial, "levels"), "none");
  EXPECT_EQ(text_of(trial, "patch"), "none");
  EXPECT_EQ(text_of(trial, "second-order patch"), "none");
  EXPECT_EQ(text_of(trial, "Sigma"), "(3,3)");
  EXPECT_EQ(text_of(trial, "Rx"), "(3,3)");
}

/// The names of the items that are as drawn, for any odd degrees.
std::string fitting_items(const PerAxis<int>& degree) {
  const ProofFigure figure = drawn_proof_figure();
  LastMesh last(case_of_figure(figure, degree));
  std::string names;
  for (const auto& [name, fits] : items_of_figure(*last.mesh, find_drawn_element(*last.mesh, figure).value(), figure)) {
    if (fits) names += name + ";";
  }
  return names;
}

TEST(SkeletonClaims, WhatEachDegreeFits) {
  EXPECT_EQ(fitting_items({3, 3, 3}), "Sigma;Rx;Ry;Rz;");
  EXPECT_EQ(fitting_items({3, 3, 1}), "patch;Rz;");
  EXPECT_EQ(fitting_items({3, 1, 1}), "levels;");
}

TEST(SkeletonClaims, ProofsSituationDoneRight) {
  EXPECT_EQ(figure_proof_levels_repaired_alone(Extent::short_run).met, 7);
  EXPECT_EQ(outcome_of("figure-proof-levels-repaired", corpus("paper/theorem-5.3-proof")), Outcome::holds);
  EXPECT_EQ(outcome_of("figure-proof-levels", corpus("paper/theorem-5.3-proof")), Outcome::not_applicable);
  EXPECT_EQ(outcome_of("figure-proof-levels", corpus("paper-figures/theorem-5.3-as-drawn")), Outcome::violated);
}

// ---- the literal twin ----

/// Every unit cube subdivided once: level 1 everywhere.
Case uniform_case(Draw& draw) {
  Case content = subdivisions({3, 3, 3}, {draw.between(4, 5), draw.between(4, 5), 4}, {});
  Step step{Step::Kind::subdivide, {}};
  for (int x = 0; x < content.domain[0]; ++x) {
    for (int y = 0; y < content.domain[1]; ++y) {
      for (int z = 0; z < content.domain[2]; ++z) step.marks.push_back(point(x, y, z));
    }
  }
  content.steps.push_back(step);
  return content;
}

/// Small meshes of all kinds, and planar ones.
Case random_small_case(std::uint64_t seed) {
  Draw draw(seed);
  if (seed % 200 == 4) return uniform_case(draw);
  CaseLimits limits;
  limits.max_cubes = 60;
  limits.max_side = 5;
  limits.max_elements = 110;
  limits.max_steps = 3;
  switch (seed % 4) {
    case 0:
      return random_admissible_case(draw, limits).content;
    case 1:
      return random_bare_case(draw, limits).content;
    default:
      return random_planar_tiling(draw, {draw.between(1, 3), draw.between(1, 3)}).extruded({3, 3, 3});
  }
}

struct Literal {
  reference::Setting setting;
  reference::Mesh mesh;

  bool admissible() const {
    return reference::admissible_mesh(setting, mesh, reference::refinement_tree(setting, mesh));
  }
  bool one_level() const {
    return std::all_of(mesh.begin(), mesh.end(), [&](const reference::Box& k) {
      return reference::level(setting, k) == reference::level(setting, mesh.front());
    });
  }
};

Outcome as_outcome(bool applies, const std::function<bool()>& holds) {
  if (!applies) return Outcome::not_applicable;
  return holds() ? Outcome::holds : Outcome::violated;
}

bool frame_entries(const Literal& literal, bool if_long_enough) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const bool long_enough = literal.setting.domain[axis] >= (literal.setting.degree[axis] + 1) / 2 - 1;
    if (if_long_enough && !long_enough) continue;
    if (!reference::frame_entries_included(literal.setting, literal.mesh, axis)) return false;
  }
  return true;
}

std::map<std::string, Outcome> literal_step_outcomes(const Literal& literal) {
  const bool admissible = literal.admissible();
  const bool uniform = literal.one_level();
  const auto& [setting, mesh] = literal;
  return {{"frame-in-index-sets", as_outcome(admissible, [&] { return frame_entries(literal, false); })},
          {"frame-in-index-sets-repaired", as_outcome(true, [&] { return frame_entries(literal, true); })},
          {"index-vectors-exist", as_outcome(true, [&] { return reference::index_vectors_unique(setting, mesh); })},
          {"uniform-unperturbed", as_outcome(uniform, [&] { return reference::unperturbed(setting, mesh); })},
          {"perturbed-cover-hanging", as_outcome(!uniform, [&] { return reference::hanging_covered(setting, mesh); })},
          {"perturbed-cover-hanging-repaired",
           as_outcome(admissible, [&] { return reference::hanging_covered_if_vertex_outside(setting, mesh); })}};
}

std::map<std::string, Outcome> literal_planar_outcomes(const Literal& literal) {
  const auto rectangles = reference::planar_rectangles(literal.mesh, 2).value();
  const bool facing = reference::planar_junctions_face(rectangles);
  const auto agree = [&] {
    const bool suitable = reference::analysis_suitable(literal.setting, literal.mesh).value();
    return suitable != reference::planar_extensions_meet(rectangles, {3, 3});
  };
  return {{"planar-equals-classical", as_outcome(true, agree)},
          {"planar-equals-classical-repaired", as_outcome(!facing, agree)}};
}

Literal literal_of(const Case& content) { return {literal::setting(setting_of(content)), literal::last_mesh(content)}; }

TEST(SkeletonClaims, AgreeWithTheLiteralReading) {
  std::map<std::pair<std::string, Outcome>, int> tally;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    const Case content = random_small_case(seed);
    const Literal literal = literal_of(content);
    LastMesh last(content);
    const auto expected = content.explicit_mesh ? literal_planar_outcomes(literal) : literal_step_outcomes(literal);
    for (const auto& [id, outcome] : expected) {
      const Outcome fast = try_on_mesh(*find_claim(id), *last.mesh).verdict.outcome;
      ASSERT_EQ(outcome_name(fast), std::string(outcome_name(outcome))) << id << " on\n" << write_case(content);
      ++tally[{id, outcome}];
    }
  }
  for (const auto& [what, count] : tally) RecordProperty(what.first + " " + outcome_name(what.second), count);
  const auto violated = [&](const char* id) { return tally[{id, Outcome::violated}]; };
  EXPECT_GT(violated("perturbed-cover-hanging"), 100);
  EXPECT_GT(violated("planar-equals-classical"), 5);
  for (const char* id : {"frame-in-index-sets-repaired", "index-vectors-exist", "uniform-unperturbed",
                         "perturbed-cover-hanging-repaired", "planar-equals-classical-repaired"}) {
    EXPECT_EQ(violated(id), 0) << id;
    EXPECT_GT((tally[{id, Outcome::holds}]), 0) << id;
  }
}

// The hanging nodes and edges themselves, and the repaired form's judgement on meshes that are not admissible.
TEST(SkeletonClaims, HangingPartsAgreeWithTheLiteralReading) {
  int violated = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Case content = random_small_case(seed % 2 + 4 * seed);
    const Literal literal = literal_of(content);
    LastMesh last(content);
    const auto boxes = [&](const std::vector<Hanging>& hanging) {
      std::set<reference::Box> result;
      for (const Hanging& part : hanging) result.insert(literal::box(last.mesh->mesh(), part.box));
      return result;
    };
    std::set<reference::Box> nodes;
    for (const reference::Point& node : reference::hanging_nodes(literal.mesh)) nodes.insert({node, node});
    ASSERT_EQ(boxes(hanging_nodes(last.mesh->mesh())), nodes) << write_case(content);
    const reference::Mesh edges = reference::hanging_edges(literal.mesh);
    ASSERT_EQ(boxes(hanging_edges(last.mesh->mesh())), (std::set<reference::Box>(edges.begin(), edges.end())))
        << write_case(content);
    const bool fast = judge_hanging_cover_repaired(last.mesh->mesh(), perturbed_regions(*last.mesh)).verdict.outcome ==
                      Outcome::holds;
    ASSERT_EQ(fast, reference::hanging_covered_if_vertex_outside(literal.setting, literal.mesh)) << write_case(content);
    violated += !fast;
  }
  RecordProperty("repaired form violated without admissibility", violated);
}

// ---- planted faults ----

/// An element in the middle of the active region, subdivided once: everything that hangs is covered.
Case one_in_the_middle() { return subdivisions({3, 3, 3}, {9, 9, 9}, {point(4, 4, 4)}); }

Verdict cover_without_x(bool repaired) {
  LastMesh last(one_in_the_middle());
  PerturbedRegions regions = perturbed_regions(*last.mesh);
  regions[0].clear();
  const Mesh& mesh = last.mesh->mesh();
  return (repaired ? judge_hanging_cover_repaired(mesh, regions) : judge_hanging_cover(mesh, regions)).verdict;
}

TEST(SkeletonClaims, CoverHoldsWithoutTheFault) {
  EXPECT_EQ(outcome_of("perturbed-cover-hanging", one_in_the_middle()), Outcome::holds);
  EXPECT_EQ(outcome_of("perturbed-cover-hanging-repaired", one_in_the_middle()), Outcome::holds);
  EXPECT_GT(trial_of("perturbed-cover-hanging-repaired", one_in_the_middle()).met, 0);
}

Verdict frame_with_merged_boxes() {
  LastMesh last(merged_pair({5, 3, 3}, {6, 4, 4}, {1, 0, 0}));
  return judge_frame_entries(last.mesh->mesh(), {true, true, true}).verdict;
}

Verdict vectors_with_merged_boxes() {
  Case content{{3, 3, 3}, 2, {4, 4, 4}, {}, true, {}};
  content.elements = {{point(0, 0, 0), point(2, 4, 4)}};
  for (int x = 2; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int z = 0; z < 4; ++z) content.elements.push_back({point(x, y, z), point(x + 1, y + 1, z + 1)});
    }
  }
  LastMesh last(content);
  return judge_index_vectors(last.mesh->mesh()).verdict;
}

Verdict one_element_less() {
  LastMesh last(one_in_the_middle());
  return judge_unperturbed(*last.mesh).verdict;
}

Verdict face_extension_too_short() {
  LastMesh last(corpus("planar/published-bad-tmesh"));
  const PlanarMesh planar = planar_mesh(last.mesh->mesh()).value();
  return judge_planar(*last.mesh, planar, {1, 1}).verdict;
}

Verdict line_one_cell_shorter() {
  SliceFigure figure = slice_figures().front();
  figure.lines = slice_figures().back().lines;
  figure.nodes_in = slice_figures().back().nodes_in;
  return judge_slice_figure(figure).verdict;
}

Verdict patch_one_element_smaller(const PerAxis<int>& degree, bool correct) {
  ProofFigure figure = correct ? correct_proof_figure() : drawn_proof_figure();
  --figure.patch.upper[0];
  LastMesh last(case_of_figure(figure, degree));
  return judge_proof_figure(*last.mesh, figure).verdict;
}

}  // namespace

std::vector<NegativeControl> skeleton_controls() {
  return {
      {"frame-in-index-sets", "two boxes of the frame merged", frame_with_merged_boxes},
      {"frame-in-index-sets-repaired", "two boxes of the frame merged", frame_with_merged_boxes},
      {"index-vectors-exist", "the frame on one side is one box", vectors_with_merged_boxes},
      {"uniform-unperturbed", "forgotten hypothesis: one element is of level 1", one_element_less},
      {"perturbed-cover-hanging", "forgotten direction: Rx", [] { return cover_without_x(false); }},
      {"perturbed-cover-hanging-repaired", "forgotten direction: Rx", [] { return cover_without_x(true); }},
      {"planar-equals-classical", "extensions of a degree that is lower by two", face_extension_too_short},
      {"planar-equals-classical-repaired", "extensions of a degree that is lower by two", face_extension_too_short},
      {"figure-slices", "the first line ends one cell earlier", line_one_cell_shorter},
      {"figure-proof-levels", "the patch is drawn one element smaller",
       [] {
         return patch_one_element_smaller({3, 3, 3}, false);
       }},
      {"figure-proof-levels-repaired", "the patch is one element smaller",
       [] {
         return patch_one_element_smaller({3, 3, 3}, true);
       }},
  };
}

namespace {

bool refutes_frame(const Case& content) {
  const Literal literal = literal_of(content);
  return literal.admissible() && !frame_entries(literal, false);
}

bool refutes_cover(const Case& content) {
  const Literal literal = literal_of(content);
  return literal.admissible() && !literal.one_level() && !reference::hanging_covered(literal.setting, literal.mesh);
}

/// Is the planar mesh a refinement of the unit squares, with no T-junction outside the interior of the active region?
bool remark_applies(const Literal& literal, const std::vector<reference::Rectangle>& rectangles) {
  for (const reference::Rectangle& k : rectangles) {
    for (std::size_t a = 0; a < 2; ++a) {
      bool in_unit = false;
      for (int i = 0; i < literal.setting.domain[a]; ++i) in_unit |= i <= k.lower[a] && k.upper[a] <= i + 1;
      if (!in_unit) return false;
    }
  }
  for (const reference::PlanarJunction& junction : reference::planar_junctions(rectangles)) {
    for (std::size_t a = 0; a < 2; ++a) {
      const int half = (literal.setting.degree[a] + 1) / 2;
      if (junction.point[a] <= half || junction.point[a] >= literal.setting.domain[a] - half) return false;
    }
  }
  return true;
}

bool refutes_planar(const Case& content) {
  const Literal literal = literal_of(content);
  const auto rectangles = reference::planar_rectangles(literal.mesh, 2);
  if (!rectangles || !remark_applies(literal, *rectangles)) return false;
  return reference::analysis_suitable(literal.setting, literal.mesh) ==
         reference::planar_extensions_meet(*rectangles, {literal.setting.degree[0], literal.setting.degree[1]});
}

/// The level that the first figure draws on the slice at a point: the nodes that its loops place.
int drawn_level_at(const Rational& y, const Rational& z) {
  const auto in = [&](int y1, int z1, const Rational& y2, int z2) { return y1 <= y && y <= y2 && z1 <= z && z <= z2; };
  if (over(16, 2) <= y && y <= over(17, 2) && over(21, 2) <= z && z <= 11) return 4;
  return in(3, 3, 14, 18) + in(5, 7, 12, 14) + in(6, 9, over(21, 2), 12);
}

/// The levels at the middles of all elements that the slice runs through are as drawn, for the degree (3,3,3), and the
/// mesh is not admissible.
bool refutes_figure(const Case& content) {
  const Literal literal = literal_of(content);
  const Rational xi = over(9, 4);
  const int margin = (literal.setting.domain[1] - 17) / 2;
  int on_slice = 0;
  for (const reference::Box& k : literal.mesh) {
    if (k.upper[0] < xi || xi < k.lower[0]) continue;
    const reference::Point middle = reference::midpoint(k);
    if (reference::level(literal.setting, k) != drawn_level_at(middle[1] - margin, middle[2] - margin)) return false;
    ++on_slice;
  }
  return on_slice > 17 * 21 && !literal.admissible();
}

}  // namespace

std::vector<Confirmation> skeleton_confirmations() {
  return {{"frame-in-index-sets", refutes_frame},
          {"perturbed-cover-hanging", refutes_cover},
          {"planar-equals-classical", refutes_planar},
          {"figure-proof-levels", refutes_figure}};
}

}  // namespace asts
