#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asts {

/// B-splines N_X of a local index vector X = (x_1 < ... < x_(p+2)) over any field of numbers: Rational, or Residue
/// where the knots differ modulo the prime. Normalised as in a partition of unity (Definition 4.5).
///
/// Laws (each has a test that names it):
///  1. the value at a point is that of the definition, piece by piece.
///  2. knot insertion: N_X = sum of c_i N_i, where N_i are the B-splines on the finer knots.
///  3. reduction: with residues, everything is the residue of the rational result.

/// The polynomial that N_X is on its piece [x_(piece+1), x_(piece+2)], at t: the value of N_X where t lies in that
/// piece, and of its continuation elsewhere. By Cox and de Boor's recursion. REQUIRES: p+2 knots, different from each
/// other; 0 <= piece <= p. Cost: O(p^2).
template <class Number>
Number bspline_piece_value(std::span<const Number> knots, std::size_t piece, const Number& t) {
  const std::size_t intervals = knots.size() - 1;
  std::vector<Number> values(intervals, Number(0));
  values[piece] = Number(1);
  for (std::size_t degree = 1; degree < intervals; ++degree) {
    for (std::size_t i = 0; i + degree < intervals; ++i) {
      const Number rising = (t - knots[i]) / (knots[i + degree] - knots[i]);
      const Number falling = (knots[i + degree + 1] - t) / (knots[i + degree + 1] - knots[i + 1]);
      values[i] = rising * values[i] + falling * values[i + 1];
    }
  }
  return values[0];
}

/// Boehm's knot insertion of all lines between the ends of a vector: coefficient i is that of the B-spline on the p+2
/// neighbouring lines from rank vector.front() + i on. Lines are given by rank, so that only ranks are compared.
/// REQUIRES: `vector` ascends strictly; `lines` differ. Cost: O(p) a line and coefficient.
///
/// One insertion: with t strictly inside k_0 < ... < k_(p+1) and the finer knots k',
/// N[k] = a N[k'_0..k'_(p+1)] + b N[k'_1..k'_(p+2)], where a = 1 if t > k_p, else (t - k_0)/(k_p - k_0), and b = 1 if
/// t < k_1, else (k_(p+1) - t)/(k_(p+1) - k_1).
template <class Number>
std::vector<Number> refined_coefficients(std::span<const std::int32_t> vector, const std::vector<Number>& lines) {
  const auto line = [&](std::int32_t rank) -> const Number& { return lines[static_cast<std::size_t>(rank)]; };
  const std::size_t p = vector.size() - 2;
  std::vector<std::int32_t> knots(vector.begin(), vector.end());
  std::vector<Number> coefficients{Number(1)};
  for (std::int32_t t = vector.front() + 1; t < vector.back(); ++t) {
    if (std::binary_search(knots.begin(), knots.end(), t)) continue;
    std::vector<Number> next(coefficients.size() + 1, Number(0));
    for (std::size_t j = 0; j < coefficients.size(); ++j) {
      const std::int32_t* k = knots.data() + j;
      if (t > k[0]) {
        const Number share = t > k[p] ? Number(1) : Number((line(t) - line(k[0])) / (line(k[p]) - line(k[0])));
        next[j] += coefficients[j] * share;
      }
      if (t < k[p + 1]) {
        const Number share = t < k[1] ? Number(1) : Number((line(k[p + 1]) - line(t)) / (line(k[p + 1]) - line(k[1])));
        next[j + 1] += coefficients[j] * share;
      }
    }
    coefficients = std::move(next);
    knots.insert(std::upper_bound(knots.begin(), knots.end(), t), t);
  }
  return coefficients;
}

}  // namespace asts
