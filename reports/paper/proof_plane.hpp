#pragma once

#include <string>
#include <vector>

#include "properties/claims/proof_figure.hpp"
#include "reports/paper/picture.hpp"
#include "reports/slices/slice_drawing.hpp"

namespace asts {

/// The yz-view on the slice S_x(xi) in the proof of Theorem 5.3: the 17 x 21 unit squares that the paper draws, and
/// nothing beside them.
struct ProofPlane {
  Frame frame;

  static constexpr std::array<int, 2> kSquares{17, 21};
  ProofPlane(Px left, Px top, int pixels_a_unit);

  PxBox box(const PlaneRectangle& rectangle) const { return frame.box(rectangle); }
};

/// What a mesh has on the slice through the middle of K, in units of the drawn squares: a mesh whose domain has
/// `margin` more squares on each side. Parts beside the squares are cut off.
class ProofSlice {
 public:
  ProofSlice(MeshUnderTest& mesh, int margin);

  const std::vector<ElementTrace>& elements() const { return elements_; }
  /// The traces of the elements in the patch, and in the patches of these (the second-order patch).
  const std::vector<PlaneRectangle>& patch() const { return patch_; }
  const std::vector<PlaneRectangle>& second_patch() const { return second_patch_; }
  /// The perturbed regions' parts of the slice.
  const std::vector<PlaneRectangle>& region(Axis axis) const { return regions_[at(axis)]; }
  /// Rx besides the slice, seen along x, and the other places of x where it is, as text.
  const std::vector<PlaneRectangle>& region_x_elsewhere() const { return region_x_elsewhere_; }
  const std::string& places_elsewhere() const { return places_elsewhere_; }
  const std::string& place() const { return place_; }

 private:
  void look_elsewhere(MeshUnderTest& mesh, const Rational& xi, int margin);

  std::vector<ElementTrace> elements_;
  std::vector<PlaneRectangle> patch_;
  std::vector<PlaneRectangle> second_patch_;
  PerAxis<std::vector<PlaneRectangle>> regions_;
  std::vector<PlaneRectangle> region_x_elsewhere_;
  std::string places_elsewhere_;
  std::string place_;
};

/// A rectangle of the paper's figure: in halves there.
PlaneRectangle in_units(const ProofFigure::Rectangle& halves);

/// The least rectangle around some; ensures that they fill it.
PlaneRectangle filled_rectangle(const std::vector<PlaneRectangle>& parts);

/// "[6,21/2] x [19/2,12]"
std::string rectangle_text(const PlaneRectangle& rectangle);

/// The grid of elements with their levels as numbers.
void draw_cells(XmlNode parent, const ProofPlane& plane, const std::vector<ElementTrace>& elements, bool levels);

}  // namespace asts
