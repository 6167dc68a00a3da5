#pragma once

#include "tests/reference/mesh.hpp"

/// Meshes of the hand-computed cases.
namespace asts::reference {

inline Rational over(int top, int bottom) {
  return Rational(top) / Rational(bottom);
}

/// Degree 3, domain 8 x 8 x 4, active region [2,6] x [2,6] x [2,2]. A planar mesh extruded along z: the unit squares,
/// where x = 7/2 cuts those of [3,4] x [0,4], and y = 9/2 cuts those of [4,8] x [4,5]. The T-junctions (7/2, 4) and
/// (4, 9/2) face each other, and their extensions by two bays cross at (7/2, 9/2).
///
///   v = (7/2, 4):  x(v) = (2, 3, 7/2, 4, 5), y(v) = (2, 3, 4, 5, 6)
///   w = (4, 9/2):  x(w) = (2, 3, 4, 5, 6),   y(w) = (3, 4, 9/2, 5, 6)
struct CrossingExtensions {
  Setting setting{{3, 3, 3}, 2, {8, 8, 4}};
  Mesh mesh;

  CrossingExtensions() {
    for (const Box& cube : initial_mesh(setting)) {
      const Rational x = cube.lower[0], y = cube.lower[1];
      if (x == 3 && y < 4)
        cut(cube, 0);
      else if (x >= 4 && y == 4)
        cut(cube, 1);
      else
        mesh.push_back(cube);
    }
  }

 private:
  void cut(const Box& cube, std::size_t axis) {
    for (const Box& half : subdivide_along(setting, cube, axis)) mesh.push_back(half);
  }
};

/// A refinement of the unit cubes by a bare subdivision in the middle and one of its halves: not admissible.
struct BareSubdivisions {
  Setting setting{{3, 3, 3}, 2, {4, 4, 5}};
  Mesh mesh = initial_mesh(setting);

  BareSubdivisions() {
    subdivide_at({over(1, 4), over(1, 4), over(1, 4)});
    subdivide_at({over(1, 4), over(1, 4), over(1, 4)});
  }

 private:
  void subdivide_at(const Point& point) { mesh = subdivide(setting, mesh, {*element_at(setting, mesh, point)}); }
};

}  // namespace asts::reference
