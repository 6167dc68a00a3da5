#include "reports/paper/proof_plane.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "lib/exact/errors.hpp"
#include "properties/claims/patch_relation.hpp"
#include "properties/describe.hpp"

namespace asts {

namespace {

constexpr std::int32_t kLevel = 3;  // of K

/// K: the only element of its level that is subdivided.
std::int32_t subdivided_element(const RefinementTree& tree) {
  std::int32_t found = RefinementTree::kNone;
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (tree.level(id) != kLevel || tree.is_leaf(id)) continue;
    ensure(found == RefinementTree::kNone, "one element of K's level is subdivided");
    found = id;
  }
  ensure(found != RefinementTree::kNone, "an element of K's level is subdivided");
  return found;
}

Rational area(const PlaneRectangle& r) { return (r.upper[0] - r.lower[0]) * (r.upper[1] - r.lower[1]); }

/// Moved by the margin and cut off at the squares; nothing where nothing is left.
std::optional<PlaneRectangle> in_squares(PlaneRectangle rectangle, int margin) {
  for (std::size_t k = 0; k < 2; ++k) {
    const Rational side = ProofPlane::kSquares[k];
    rectangle.lower[k] = std::max(Rational(rectangle.lower[k] - margin), Rational(0));
    rectangle.upper[k] = std::min(Rational(rectangle.upper[k] - margin), side);
    if (rectangle.lower[k] > rectangle.upper[k]) return std::nullopt;
  }
  return rectangle;
}

std::vector<PlaneRectangle> in_squares(const std::vector<PlaneRectangle>& rectangles, int margin) {
  std::vector<PlaneRectangle> result;
  for (const PlaneRectangle& rectangle : rectangles) {
    if (const auto part = in_squares(rectangle, margin)) result.push_back(*part);
  }
  return result;
}

/// The traces of some elements on the plane at a place of x, each once.
std::vector<PlaneRectangle> traces(const RefinementTree& tree, const Elements& elements, const Rational& place) {
  std::vector<PlaneRectangle> result;
  for (const std::int32_t id : elements) {
    const ExactBox box = describe_tree_element(tree, id).box;
    if (place < box.lower[0] || box.upper[0] <= place) continue;
    result.push_back({{box.lower[1], box.lower[2]}, {box.upper[1], box.upper[2]}});
  }
  return result;
}

Elements patch_of(const RefinementTree& tree, const Elements& leaves, std::int32_t element) {
  Elements result;
  std::copy_if(leaves.begin(), leaves.end(), std::back_inserter(result),
               [&](std::int32_t leaf) { return in_patch(tree, element, leaf); });
  return result;
}

Elements patch_of(const RefinementTree& tree, const Elements& leaves, const Elements& elements) {
  Elements result;
  std::copy_if(leaves.begin(), leaves.end(), std::back_inserter(result), [&](std::int32_t leaf) {
    return std::any_of(elements.begin(), elements.end(), [&](std::int32_t k) { return in_patch(tree, k, leaf); });
  });
  return result;
}

}  // namespace

ProofPlane::ProofPlane(Px left, Px top, int pixels_a_unit)
    : frame{pixels_a_unit,
            {{left, top}, {left + px(kSquares[0] * pixels_a_unit), top + px(kSquares[1] * pixels_a_unit)}}} {}

ProofSlice::ProofSlice(MeshUnderTest& mesh, int margin) {
  const RefinementTree& tree = mesh.tree();
  const std::int32_t element = subdivided_element(tree);
  const Rational xi = describe_tree_element(tree, tree.first_child(element)).box.upper[0];
  const SliceGeometry geometry = cut(mesh, {0, xi});
  for (ElementTrace trace : geometry.elements) {
    const auto part = in_squares(trace.trace, margin);
    if (!part || area(*part).is_zero()) continue;
    trace.trace = *part;
    elements_.push_back(trace);
  }
  const Elements leaves = leaves_in_order(tree);
  const Elements patch = patch_of(tree, leaves, element);
  patch_ = in_squares(traces(tree, patch, xi), margin);
  second_patch_ = in_squares(traces(tree, patch_of(tree, leaves, patch), xi), margin);
  for (Axis axis = 0; axis < kDimension; ++axis) {
    regions_[at(axis)] = in_squares(geometry.regions.value()[at(axis)], margin);
  }
  place_ = to_string(xi);
  look_elsewhere(mesh, xi, margin);
}

/// A slice perturbation R_x(q) is not empty only where the mesh has a line at x = q.
void ProofSlice::look_elsewhere(MeshUnderTest& mesh, const Rational& xi, int margin) {
  for (const Rational& q : mesh.mesh().coordinates[0]) {
    if (q == xi) continue;
    const auto parts = in_squares(cut(mesh, {0, q}).regions.value()[0], margin);
    if (parts.empty()) continue;
    region_x_elsewhere_.insert(region_x_elsewhere_.end(), parts.begin(), parts.end());
    places_elsewhere_ += (places_elsewhere_.empty() ? "" : ", ") + to_string(q);
  }
}

PlaneRectangle in_units(const ProofFigure::Rectangle& halves) {
  return {{Rational(halves.lower[0], 2), Rational(halves.lower[1], 2)},
          {Rational(halves.upper[0], 2), Rational(halves.upper[1], 2)}};
}

PlaneRectangle filled_rectangle(const std::vector<PlaneRectangle>& parts) {
  ensure(!parts.empty(), "a set on the slice has a part");
  PlaneRectangle around = parts.front();
  Rational filled = 0;
  for (const PlaneRectangle& part : parts) {
    filled += area(part);
    for (std::size_t k = 0; k < 2; ++k) {
      around.lower[k] = std::min(around.lower[k], part.lower[k]);
      around.upper[k] = std::max(around.upper[k], part.upper[k]);
    }
  }
  ensure(filled == area(around), "a set on the slice is a rectangle");
  return around;
}

std::string rectangle_text(const PlaneRectangle& r) {
  return fmt::format("[{},{}] x [{},{}]", to_string(r.lower[0]), to_string(r.upper[0]), to_string(r.lower[1]),
                     to_string(r.upper[1]));
}

void draw_cells(XmlNode parent, const ProofPlane& plane, const std::vector<ElementTrace>& elements, bool levels) {
  XmlNode cells = add_group(parent, "cells");
  XmlNode numbers = add_group(parent, "levels");
  for (const ElementTrace& element : elements) {
    const PxBox box = plane.box(element.trace);
    add_outline(cells, box, {{"class", "cell"}});
    if (!levels) continue;
    add_text(numbers, (box.lower[0] + box.upper[0]) / 2, (box.lower[1] + box.upper[1]) / 2 + px(3),
             std::to_string(element.level.value()), {{"class", "level"}});
  }
}

}  // namespace asts
