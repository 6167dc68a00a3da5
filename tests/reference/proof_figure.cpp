#include "tests/reference/proof_figure.hpp"

#include <algorithm>

#include "tests/reference/witness_json.hpp"

namespace asts::reference {

namespace {

using Place = std::array<Rational, 2>;

constexpr int squares[2] = {17, 21};

Rational half(int numerator) { return Rational(numerator, 2); }

/// Lines at first, first + 1, ..., last in halves, each in two pieces; across axis 0 (y) or 1 (z).
DrawnSet lines(std::size_t across, int first, int last, const std::array<Rational, 4>& ends) {
  DrawnSet result;
  for (int place = first; place <= last; place += 2)
    for (const std::size_t piece : {0U, 2U}) {
      DrawnRectangle line;
      line.lower[across] = line.upper[across] = half(place);
      line.lower[1 - across] = ends[piece];
      line.upper[1 - across] = ends[piece + 1];
      result.push_back(line);
    }
  return result;
}

/// The closed outer rectangle without the interior of the inner one.
DrawnSet ring(const DrawnRectangle& outer, const DrawnRectangle& inner) {
  return {{outer.lower, {inner.lower[0], outer.upper[1]}},
          {{inner.upper[0], outer.lower[1]}, outer.upper},
          {outer.lower, {outer.upper[0], inner.lower[1]}},
          {{outer.lower[0], inner.upper[1]}, outer.upper}};
}

DrawnSet with(DrawnSet set, const DrawnRectangle& more) {
  set.push_back(more);
  return set;
}

const DrawnRectangle drawn_k{{8, half(21)}, {half(17), 11}};
const DrawnRectangle drawn_sigma{{7, half(19)}, {half(19), 12}};

}  // namespace

bool DrawnRectangle::contains(const Place& place) const {
  return lower[0] <= place[0] && place[0] <= upper[0] && lower[1] <= place[1] && place[1] <= upper[1];
}

DrawnProofFigure printed_proof_figure() {
  return {{{{{3, 3}, {14, 18}}, {{5, 7}, {12, 14}}, {{6, 9}, {half(21), 12}}}},
          drawn_k,
          {{"patch", {{{6, half(19)}, {half(21), 12}}}},
           {"second-order patch", {{{5, 7}, {half(23), 14}}}},
           {"Sigma", {drawn_sigma}},
           {"Rx", with(ring({{1, 1}, {16, 20}}, {{4, 4}, {13, 17}}), drawn_sigma)},
           {"Ry", lines(0, 11, 23, {5, 8, 13, 16})},
           {"Rz", lines(1, 19, 23, {5, half(13), 10, half(23)})}}};
}

DrawnProofFigure repaired_proof_figure() {
  return {{{{{0, 0}, {17, 21}}, {{4, 4}, {13, 17}}, {{6, 8}, {half(21), 13}}}},
          drawn_k,
          {{"patch", {{{6, half(17)}, {half(21), 13}}}},
           {"second-order patch", {{{4, 6}, {half(25), 15}}}},
           {"Sigma", {drawn_sigma}},
           {"Rx", with(ring({{0, 0}, {17, 21}}, {{1, 1}, {16, 20}}), drawn_sigma)},
           {"Ry", lines(0, 9, 25, {2, 5, 16, 19})},
           {"Rz", lines(1, 17, 25, {5, half(13), 10, half(23)})}}};
}

namespace {

/// An element's y- and z-range in the drawing.
DrawnRectangle seen_along_x(const Box& box, int margin) {
  return {{box.lower[1] - margin, box.lower[2] - margin}, {box.upper[1] - margin, box.upper[2] - margin}};
}

bool lies_in(const DrawnRectangle& inner, const DrawnRectangle& outer) {
  return outer.contains(inner.lower) && outer.contains(inner.upper);
}

int drawn_level(const DrawnProofFigure& figure, const DrawnRectangle& rectangle) {
  int level = 0;
  for (const DrawnRectangle& region : figure.levels) level += lies_in(rectangle, region);
  return level;
}

bool on_slice(const Box& box, const Rational& xi) { return box.lower[0] <= xi && xi <= box.upper[0]; }

}  // namespace

ProofFigureMesh proof_figure_mesh(const DrawnProofFigure& figure, const Setting& setting, const Mesh& mesh,
                                  const Box& k) {
  const int margin = (setting.domain[1] - squares[0]) / 2;
  const Rational xi = (k.lower[0] + k.upper[0]) / 2;
  const ProofFigureMesh result{setting, mesh, k, xi, margin};
  if (setting.grading != 2 || margin < 0 || setting.domain[1] != squares[0] + 2 * margin ||
      setting.domain[2] != squares[1] + 2 * margin)
    throw Rejected("the setting is not the figure's: the claim says nothing about the mesh");
  const DrawnRectangle place = seen_along_x(k, margin);
  if (!lies_in(place, figure.k) || !lies_in(figure.k, place) || level(setting, k) != 3)
    throw Rejected("K: it is not the element of level 3 that is drawn");
  for (const Box& child : children(setting, k))
    if (std::find(mesh.begin(), mesh.end(), child) == mesh.end()) throw Rejected("K: it has not been subdivided");
  for (const Box& element : mesh) {
    if (!on_slice(element, xi)) continue;
    const int expected = contains(k, element) ? 4 : drawn_level(figure, seen_along_x(element, margin));
    if (level(setting, element) != expected)
      throw Rejected("the level of " + text(element) + " is not the drawn " + std::to_string(expected) +
                     ": the claim says nothing about the mesh");
  }
  return result;
}

ProofFigureMesh make_proof_figure_mesh(const DrawnProofFigure& figure, int p2, int p3) {
  const int margin = (std::max(p2, p3) + 1) / 2;
  const Setting setting{{3, p2, p3}, 2, {5, squares[0] + 2 * margin, squares[1] + 2 * margin}};
  Box k{{2, figure.k.lower[0] + margin, figure.k.lower[1] + margin},
        {half(5), figure.k.upper[0] + margin, figure.k.upper[1] + margin}};
  Mesh mesh = initial_mesh(setting);
  for (const DrawnRectangle& region : figure.levels) {
    Mesh finer;
    for (const Box& element : mesh) {
      const Mesh parts = lies_in(seen_along_x(element, margin), region) ? children(setting, element) : Mesh{element};
      finer.insert(finer.end(), parts.begin(), parts.end());
    }
    mesh = finer;
  }
  std::erase(mesh, k);
  for (const Box& child : children(setting, k)) mesh.push_back(child);
  return proof_figure_mesh(figure, setting, mesh, k);
}

}  // namespace asts::reference
