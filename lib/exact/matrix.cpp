#include "lib/exact/matrix.hpp"

#include <gmp.h>
// GMP first: FLINT declares its mpz functions only behind it.
#include <flint/fmpz_mat.h>
#include <flint/nmod_mat.h>

#include <algorithm>

namespace asts {
namespace {

/// Owns an nmod_mat_t.
class ModularMatrix {
 public:
  ModularMatrix(std::size_t rows, std::size_t columns) {
    nmod_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns), Residue::kPrime);
  }
  ~ModularMatrix() { nmod_mat_clear(value_); }
  ModularMatrix(const ModularMatrix&) = delete;
  ModularMatrix& operator=(const ModularMatrix&) = delete;
  nmod_mat_struct* get() { return value_; }

 private:
  nmod_mat_t value_;
};

/// Owns an fmpz_mat_t.
class IntegerMatrix {
 public:
  IntegerMatrix(std::size_t rows, std::size_t columns) {
    fmpz_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  ~IntegerMatrix() { fmpz_mat_clear(value_); }
  IntegerMatrix(const IntegerMatrix&) = delete;
  IntegerMatrix& operator=(const IntegerMatrix&) = delete;
  fmpz_mat_struct* get() { return value_; }

 private:
  fmpz_mat_t value_;
};

/// The least positive integer that makes a row integral.
Integer common_denominator(const Matrix<Rational>& matrix, std::size_t row) {
  Integer common = 1;
  for (std::size_t column = 0; column < matrix.columns; ++column) {
    mpz_lcm(common.backend().data(), common.backend().data(), mpq_denref(matrix(row, column).backend().data()));
  }
  return common;
}

/// The rows, each multiplied by its common denominator: the same kernel.
void set_integral(fmpz_mat_struct* result, const Matrix<Rational>& matrix) {
  for (std::size_t row = 0; row < matrix.rows; ++row) {
    const Integer common = common_denominator(matrix, row);
    for (std::size_t column = 0; column < matrix.columns; ++column) {
      const Rational scaled = matrix(row, column) * common;
      fmpz_set_mpz(fmpz_mat_entry(result, static_cast<slong>(row), static_cast<slong>(column)),
                   mpq_numref(scaled.backend().data()));
    }
  }
}

/// Without the common divisor, the first entry that is not 0 positive. REQUIRES: not the zero vector.
void make_primitive(std::vector<Integer>& vector) {
  Integer divisor = 0;
  for (const Integer& entry : vector) divisor = gcd(divisor, entry);
  const auto first = std::find_if(vector.begin(), vector.end(), [](const Integer& entry) { return !entry.is_zero(); });
  if (first->sign() < 0) divisor = -divisor;
  for (Integer& entry : vector) entry /= divisor;
}

}  // namespace

std::size_t rank(const Matrix<Residue>& matrix) {
  ModularMatrix reduced(matrix.rows, matrix.columns);
  for (std::size_t row = 0; row < matrix.rows; ++row) {
    for (std::size_t column = 0; column < matrix.columns; ++column) {
      nmod_mat_entry(reduced.get(), row, column) = matrix(row, column).value();
    }
  }
  return static_cast<std::size_t>(nmod_mat_rank(reduced.get()));
}

std::vector<std::vector<Integer>> kernel_basis(const Matrix<Rational>& matrix) {
  IntegerMatrix integral(matrix.rows, matrix.columns);
  set_integral(integral.get(), matrix);
  IntegerMatrix kernel(matrix.columns, matrix.columns);
  const auto dimension = static_cast<std::size_t>(fmpz_mat_nullspace(kernel.get(), integral.get()));
  std::vector<std::vector<Integer>> basis(dimension, std::vector<Integer>(matrix.columns));
  for (std::size_t i = 0; i < dimension; ++i) {
    for (std::size_t row = 0; row < matrix.columns; ++row) {
      fmpz_get_mpz(basis[i][row].backend().data(),
                   fmpz_mat_entry(kernel.get(), static_cast<slong>(row), static_cast<slong>(i)));
    }
    make_primitive(basis[i]);
  }
  return basis;
}

}  // namespace asts
