#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/exact/matrix.hpp"
#include "lib/spline/tsplines.hpp"

namespace asts {

/// Linear independence of the blending functions {B_v | v in N_A} (Corollary 6.8), decided without dual functionals.
///
/// Where. B_v is a function on R^3 that vanishes outside its support, a box in the closed domain; independence is meant
/// of these functions. `Region::active_region` asks for their restrictions to the active region instead, which is more:
/// restrictions may depend on each other although the functions do not.
///
/// How. On each axis let N_0, N_1, ... be the B-splines on p+2 neighbouring lines of the mesh. Knot insertion gives
/// N_x(v) = sum of a_i(v) N_i, so B_v has the coefficient a_i(v) b_j(v) c_k(v) at N_i(x) N_j(y) N_k(z). These products
/// are linearly independent, so the B_v are independent exactly if their coefficient vectors are. On an open box with
/// positive volume the products whose supports meet it are still independent (B-splines are locally independent), and
/// the others vanish there.
///
/// Certificates. Independent: full rank modulo a prime of the matrix (phi_j(B_v)) for as many functionals phi_j as
/// there are nodes. The functionals multiply fixed pseudo-random linear functionals of the axes, so that phi_j(B_v) is
/// a product of three numbers. Any functionals will do for the certificate; that these do when the functions are
/// independent is near-certain, because the determinant is a polynomial of degree 3 in each functional's numbers that
/// is not 0. Where the rank drops, the kernel of the coefficient matrix is computed over Q.
///
/// Laws (each has a test that names it):
///  1. two set-ups: the coefficients and the values at (p+1)^3 points of each cell between lines have the same kernel.
///  2. a dependence vanishes everywhere, and not with one coefficient changed.
///  3. certainly_independent implies that there is no dependence; in tests the converse holds too.
enum class Region { everywhere, active_region };

/// REQUIRES: active nodes, none without an index vector; for Region::active_region one of positive volume.
/// Cost: n^2 multiplications and the rank of an n x n matrix modulo a prime for n nodes.
bool certainly_independent(const Mesh& mesh, const TSplines& splines, Region region = Region::everywhere);

/// One row for each product of B-splines on neighbouring lines that a blending function needs, one column a node.
Matrix<Rational> coefficient_matrix(const Mesh& mesh, const TSplines& splines, Region region = Region::everywhere);

/// One row for each of (p+1)^3 points in each cell between lines, one column a node: a piecewise polynomial that
/// vanishes at those points vanishes on the cell.
Matrix<Rational> value_matrix(const Mesh& mesh, const TSplines& splines);

/// Integers c_v, not all 0 and without a common divisor, with sum of c_v B_v = 0 on the region; nothing when there are
/// none. Exact.
std::optional<std::vector<Integer>> find_dependence(const Mesh& mesh, const TSplines& splines,
                                                    Region region = Region::everywhere);

/// Whether sum of c_v B_v = 0 on every cell between lines, hence on every element: by values, not by knot insertion.
/// Cost: as many products as blending functions have points in their supports.
bool vanishes_everywhere(const Mesh& mesh, const TSplines& splines, const std::vector<Integer>& coefficients);

}  // namespace asts
