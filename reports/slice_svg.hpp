#pragma once

#include <string>
#include <vector>

#include "properties/mesh_under_test.hpp"
#include "properties/witness.hpp"
#include "reports/slices/slice_geometry.hpp"
#include "reports/slices/slice_marks.hpp"

namespace asts {

/// One slice of a mesh as an SVG picture: the elements that the plane cuts, shaded by level, the domain, the active
/// region, the active nodes, the perturbed regions in the plane, and the marks: nodes with their supports and index
/// vectors, points, boxes; with labels in exact coordinates, a legend, and `title` and `desc` that say the same in
/// words. Where the plane has faces of elements, those on either side are drawn. Coordinates are exact up to the
/// rounding to hundredths of pixels: the same arguments give the same bytes. Throws what cut() throws.
/// Cost: that of cut(), and linear in what the plane cuts.
std::string slice_svg(MeshUnderTest& mesh, const Slice& slice, const SliceMarks& marks);

struct SlicePicture {
  Slice slice;
  std::string name;  ///< for a file: "x-5_2" is the slice x = 5/2
  std::string svg;
};

std::string slice_name(const Slice& slice);

/// The slices that matter for a witness (see slices_that_matter), or without one the middle ones.
std::vector<SlicePicture> slice_pictures(MeshUnderTest& mesh, const Witness* witness);

}  // namespace asts
