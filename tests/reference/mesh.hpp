#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "lib/exact/rational.hpp"

/// The literal, brute-force transcription of the paper's definitions: the independent twin of lib/. Slow, and meant to
/// be read beside the paper. It shares nothing with lib/ but the exact scalar types.
namespace asts::reference {

constexpr std::size_t dimension = 3;

/// A box given by two corners. Closed (an element, a support) or open (an environment), as each function says.
template <class T>
struct BasicBox {
  std::array<T, dimension> lower, upper;
};

using Point = std::array<Rational, dimension>;
struct Box {
  Point lower, upper;
  bool operator==(const Box&) const = default;
};
using Mesh = std::vector<Box>;

/// Degrees p (odd, >= 3), grading m >= 2 and the numbers X~, Y~, Z~ of unit cubes.
struct Setting {
  std::array<int, dimension> degree;
  int grading;
  std::array<int, dimension> domain;
};

/// Order by lower, then upper corner, for use in sets.
bool operator<(const Box& a, const Box& b);

/// Definition 2.1: the X~ Y~ Z~ closed unit cubes.
Mesh initial_mesh(const Setting& setting);

/// |K|.
Rational volume(const Box& box);

/// m^exponent, for exponents of either sign.
Rational power(int grading, int exponent);

/// Definition 2.2: -log_m |K| when it is an integer (of either sign), otherwise nothing.
std::optional<int> level(const Setting& setting, const Box& box);

/// mid(K).
Point midpoint(const Box& box);

/// Definition 2.3: abs(mid(K) - x), componentwise.
Point distance(const Box& box, const Point& x);

/// Definition 2.4: D(k), by its three cases.
Point environment_radius(const Setting& setting, int k);

/// Definition 2.4: U(K) = {x in Omega | Dist(K, x) < D(l(K))}, an OPEN box since Omega is open and the relation strict.
/// REQUIRES: K has a level (throws std::invalid_argument).
Box environment(const Setting& setting, const Box& box);

/// Does the closed box (of positive volume) meet the open box? On each axis [a,b] meets (c,d) iff a < d and c < b.
bool closed_meets_open(const Box& closed, const Box& open);

/// Definition 2.4: the patch, as positions in the mesh, increasing. K itself need not be in the mesh.
std::vector<std::size_t> patch(const Setting& setting, const Mesh& mesh, const Box& box);

/// Definition 2.5: subdivision of K into m equal boxes along one axis.
std::vector<Box> subdivide_along(const Setting& setting, const Box& box, std::size_t axis);

/// Definition 2.6: child(K), along x, y, z for level 0, 1, 2 modulo 3. REQUIRES: K has a level.
std::vector<Box> children(const Setting& setting, const Box& box);

/// Definitions 2.6 and 2.7: subdivides the elements at the given positions (duplicates count once), one after another.
/// An element's children take the place at the end; the others keep their order.
Mesh subdivide(const Setting& setting, const Mesh& mesh, const std::vector<std::size_t>& marked);

/// Closed containment: inner is a subset of outer.
bool contains(const Box& outer, const Box& inner);

/// The element that a mark names: half-open boxes (lower faces belong to the element), but the domain's upper faces
/// belong to the last element. Nothing for a point outside the domain.
std::optional<std::size_t> element_at(const Setting& setting, const Mesh& mesh, const Point& point);

/// Do the boxes tile the domain: none empty, all inside, no two with common interior, volumes adding up to the domain's?
bool tiles_domain(const Setting& setting, const Mesh& mesh);

}  // namespace asts::reference
