#include <stdexcept>

#include "tests/reference/cosine_field.hpp"

namespace asts::reference {

namespace {

/// Brings row `pivot` of the system into use for unknown `pivot` and removes that unknown from all other rows.
void eliminate(std::vector<std::vector<Rational>>& rows, std::size_t pivot) {
  std::size_t with = pivot;
  while (with < rows.size() && rows[with][pivot] == 0) ++with;
  if (with == rows.size()) throw std::logic_error("inverse of zero");
  std::swap(rows[pivot], rows[with]);
  const Rational lead = rows[pivot][pivot];
  for (Rational& entry : rows[pivot]) entry /= lead;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    if (r == pivot) continue;
    const Rational factor = rows[r][pivot];
    for (std::size_t c = 0; c < rows[r].size(); ++c) rows[r][c] -= factor * rows[pivot][c];
  }
}

}  // namespace

/// Solves a * x = 1, a linear system for the coefficients of x, by Gauss-Jordan elimination.
Number CosineField::inverse(const Number& a) const {
  const std::size_t d = degree();
  std::vector<std::vector<Rational>> rows(d, std::vector<Rational>(d + 1));
  for (std::size_t k = 0; k < d; ++k) {
    Number unit(d);
    unit[k] = 1;
    const Number column = multiply(a, unit);
    for (std::size_t i = 0; i < d; ++i) rows[i][k] = column[i];
  }
  rows[0][d] = 1;
  for (std::size_t k = 0; k < d; ++k) eliminate(rows, k);
  Number result(d);
  for (std::size_t k = 0; k < d; ++k) result[k] = rows[k][d];
  return result;
}

}  // namespace asts::reference
