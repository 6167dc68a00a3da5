#include <algorithm>

#include "lib/refine/replay.hpp"
#include "properties/claims/proof_figure.hpp"
#include "properties/describe.hpp"
#include "properties/properties.hpp"

namespace asts {

namespace {

using Rectangle = ProofFigure::Rectangle;

/// The lines at every half between two bounds, in two pieces each.
std::vector<Rectangle> pieces(std::size_t axis, int first, int last, std::array<int, 2> low, std::array<int, 2> high) {
  std::vector<Rectangle> result;
  for (int place = first; place <= last; place += 2) {
    for (const std::array<int, 2>& range : {low, high}) {
      Rectangle piece;
      piece.lower[axis] = piece.upper[axis] = place;
      piece.lower[1 - axis] = range[0];
      piece.upper[1 - axis] = range[1];
      result.push_back(piece);
    }
  }
  return result;
}

CompactRational halves(int number) { return CompactRational(Rational(number) / 2); }

/// One mark for each element of a level in a rectangle, at every x.
Step subdivide_region(const Case& content, const Rectangle& region, int level, int margin) {
  Step step{Step::Kind::subdivide, {}};
  const int x_step = level >= 1 ? 1 : 2;
  const int y_step = level >= 2 ? 1 : 2;
  for (int x = 0; x < 2 * content.domain[0]; x += x_step) {
    for (int y = region.lower[0]; y < region.upper[0]; y += y_step) {
      for (int z = region.lower[1]; z < region.upper[1]; z += 2) {
        step.marks.push_back({halves(x), halves(y + 2 * margin), halves(z + 2 * margin)});
      }
    }
  }
  return step;
}

}  // namespace

ProofFigure drawn_proof_figure() {
  ProofFigure figure;
  figure.levels = {{{{6, 6}, {28, 36}}, {{10, 14}, {24, 28}}, {{12, 18}, {21, 24}}}};
  figure.element = {{16, 21}, {17, 22}};
  figure.patch = {{12, 19}, {21, 24}};
  figure.second_patch = {{10, 14}, {23, 28}};
  figure.sigma = {{14, 19}, {19, 24}};
  figure.ring_outside = {{2, 2}, {32, 40}};
  figure.ring_inside = {{8, 8}, {26, 34}};
  figure.lines_y = pieces(0, 11, 23, {10, 16}, {26, 32});
  figure.lines_z = pieces(1, 19, 23, {10, 13}, {20, 23});
  return figure;
}

// By hand, for p = (3,3,3), from K = [8,17/2] x [21/2,11] outwards. U(K) reaches 4 of K's sides beyond K: the patch is
// [6,21/2] x [17/2,13], and level >= 3 is needed there, that is in the elements of level 2 that meet it: z in [8,13].
// Their patches reach 4 half units along y and 4 units along z: level >= 2 in [4,25/2] x [4,17], rounded to unit
// squares [4,13] x [4,17]; level >= 1 in [0,17] x [0,21]. Supports reach two entries beyond a node.
ProofFigure correct_proof_figure() {
  ProofFigure figure = drawn_proof_figure();
  figure.levels = {{{{0, 0}, {34, 42}}, {{8, 8}, {26, 34}}, {{12, 16}, {21, 26}}}};
  figure.patch = {{12, 17}, {21, 26}};
  figure.second_patch = {{8, 12}, {25, 30}};
  figure.ring_outside = {{-4, -4}, {38, 46}};
  figure.ring_inside = {{2, 2}, {32, 40}};
  figure.lines_y = pieces(0, 9, 25, {4, 10}, {32, 38});
  figure.lines_z = pieces(1, 17, 25, {10, 13}, {20, 23});
  figure.around = 3;
  return figure;
}

Case case_of_figure(const ProofFigure& figure, const PerAxis<int>& degree) {
  Case content;
  content.degree = degree;
  const int margin = (std::max(degree[1], degree[2]) + 1) / 2 + figure.around;
  content.domain = {degree[0] + 2, 17 + 2 * margin, 21 + 2 * margin};
  for (int level = 0; level < 3; ++level) {
    content.steps.push_back(subdivide_region(content, figure.levels[at(level)], level, margin));
  }
  const Point k{CompactRational(Rational((degree[0] + 1) / 2)), halves(figure.element.lower[0] + 2 * margin),
                halves(figure.element.lower[1] + 2 * margin)};
  content.steps.push_back({Step::Kind::subdivide, {k}});
  return content;
}

namespace {

/// The levels are not those of an admissible mesh.
void add_levels(MeshUnderTest& mesh, ClaimWitness& witness) {
  const Verdict admissible = decide_admissible(mesh);
  const auto& coarser = std::get<CoarserInPatchWitness>(admissible.witness.value());
  witness.values.emplace_back("levels: subdivided", coarser.element);
  witness.values.emplace_back("levels: environment", coarser.environment);
  witness.values.emplace_back("levels: coarser", coarser.coarser);
}

}  // namespace

Trial judge_proof_figure(MeshUnderTest& mesh, const ProofFigure& figure) {
  const auto element = find_drawn_element(mesh, figure);
  if (!element) return {Verdict::not_applicable("not the figure's mesh")};
  ClaimWitness witness{"drawn-otherwise",
                       "the definitions do not give what is drawn: the mesh is not admissible, or only the figure or "
                       "only the mesh has the place (y,z) of the drawn squares in the set",
                       {{"K", describe_tree_element(mesh.tree(), *element)}}};
  Trial trial;
  if (mesh.admissible()) {
    ++trial.met;
  } else {
    add_levels(mesh, witness);
  }
  for (const auto& [name, place] : differences_from_figure(mesh, *element, figure)) {
    trial.met += place ? 0 : 1;
    if (place) witness.values.emplace_back(name, *place);
  }
  if (witness.values.size() > 1) trial.verdict = Verdict::violated(std::move(witness));
  return trial;
}

namespace {

FigureItems items_for_degree(const ProofFigure& figure, const PerAxis<int>& degree) {
  const Case content = case_of_figure(figure, degree);
  Replay replay(content);
  while (!replay.done()) replay.advance();
  MeshUnderTest mesh(replay.tree());
  return items_of_figure(mesh, find_drawn_element(mesh, figure).value(), figure);
}

}  // namespace

Trial judge_degrees(const ProofFigure& figure, int max_degree) {
  Trial trial;
  ClaimWitness table{"no-degree-fits",
                     "no odd degrees p2, p3 fit; for each item those among the tried ones for which it is as drawn",
                     {{"tried to", std::int64_t{max_degree}}}};
  bool fitting = false;
  std::vector<std::pair<std::string, std::string>> rows;
  for (int p2 = 3; p2 <= max_degree; p2 += 2) {
    for (int p3 = 3; p3 <= max_degree; p3 += 2) {
      const FigureItems items = items_for_degree(figure, {3, p2, p3});
      rows.resize(items.size());
      for (std::size_t i = 0; i < items.size(); ++i) {
        rows[i].first = items[i].first;
        if (items[i].second) rows[i].second += " (" + std::to_string(p2) + "," + std::to_string(p3) + ")";
      }
      trial.met += std::count_if(items.begin(), items.end(), [](const auto& item) { return item.second; });
      fitting |= std::all_of(items.begin(), items.end(), [](const auto& item) { return item.second; });
    }
  }
  if (fitting) return trial;
  for (auto& [name, degrees] : rows) table.values.emplace_back(name, degrees.empty() ? "none" : degrees.substr(1));
  trial.verdict = Verdict::violated(std::move(table));
  return trial;
}

Trial figure_proof_levels(MeshUnderTest& mesh) { return judge_proof_figure(mesh, drawn_proof_figure()); }

// Degrees up to 5, or 9. None of the larger ones fits either: U(K) grows with the degree, and for p3 = 3 it already
// meets elements of level 2, so that the subdivision of K is not admissible.
Trial figure_proof_levels_alone(Extent extent) {
  return judge_degrees(drawn_proof_figure(), extent == Extent::short_run ? 5 : 9);
}

Trial figure_proof_levels_repaired(MeshUnderTest& mesh) {
  if (mesh.mesh().setting.degree != PerAxis<int>{3, 3, 3}) return {Verdict::not_applicable("not for this degree")};
  return judge_proof_figure(mesh, correct_proof_figure());
}

Trial figure_proof_levels_repaired_alone(Extent /*extent*/) {
  const ProofFigure figure = correct_proof_figure();
  const Case content = case_of_figure(figure, {3, 3, 3});
  Replay replay(content);
  while (!replay.done()) replay.advance();
  MeshUnderTest mesh(replay.tree());
  return judge_proof_figure(mesh, figure);
}

}  // namespace asts
