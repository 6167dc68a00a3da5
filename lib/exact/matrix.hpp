#pragma once

#include <cstddef>
#include <vector>

#include "lib/exact/rational.hpp"
#include "lib/exact/residue.hpp"

namespace asts {

/// A dense matrix; row after row.
template <class Number>
struct Matrix {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<Number> entries;

  Matrix(std::size_t row_count, std::size_t column_count)
      : rows(row_count), columns(column_count), entries(row_count * column_count) {}

  Number& operator()(std::size_t row, std::size_t column) { return entries[row * columns + column]; }
  const Number& operator()(std::size_t row, std::size_t column) const { return entries[row * columns + column]; }
};

/// The rank. Cost: cubic, as FLINT's elimination modulo a word-sized prime.
std::size_t rank(const Matrix<Residue>& matrix);

/// A basis of the x with `matrix` x = 0: vectors of integers without a common divisor, the first entry that is not 0
/// positive. The rank is the number of columns less the number of vectors (a test compares both ranks).
/// Cost: FLINT's fraction-free elimination.
std::vector<std::vector<Integer>> kernel_basis(const Matrix<Rational>& matrix);

}  // namespace asts
