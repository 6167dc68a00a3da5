#include "lib/exact/matrix.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace asts {
namespace {

template <class Number>
Matrix<Number> matrix_of(const std::vector<std::vector<Number>>& rows) {
  Matrix<Number> result(rows.size(), rows.front().size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < rows[r].size(); ++c) result(r, c) = rows[r][c];
  }
  return result;
}

Matrix<Residue> reduced(const Matrix<Rational>& matrix) {
  Matrix<Residue> result(matrix.rows, matrix.columns);
  for (std::size_t i = 0; i < matrix.entries.size(); ++i) result.entries[i] = *residue_of(matrix.entries[i]);
  return result;
}

/// Of rank at most `rank`: a product of two matrices.
Matrix<Rational> low_rank(std::size_t rows, std::size_t columns, std::size_t rank) {
  const auto entry = [] { return Rational(*rc::gen::inRange(-5, 6), *rc::gen::inRange(1, 4)); };
  Matrix<Rational> left(rows, rank), right(rank, columns), result(rows, columns);
  for (Rational& e : left.entries) e = entry();
  for (Rational& e : right.entries) e = entry();
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t k = 0; k < rank; ++k) result(r, c) += left(r, k) * right(k, c);
    }
  }
  return result;
}

Rational row_times(const Matrix<Rational>& matrix, std::size_t row, const std::vector<Integer>& x) {
  Rational sum = 0;
  for (std::size_t c = 0; c < matrix.columns; ++c) sum += matrix(row, c) * x[c];
  return sum;
}

using Rows = std::vector<std::vector<Rational>>;

TEST(Matrix, RankModuloThePrimeByHand) {
  const auto residues = [](const Rows& rows) { return reduced(matrix_of(rows)); };
  EXPECT_EQ(rank(residues({{1, 2}, {2, 4}})), 1U);
  EXPECT_EQ(rank(residues({{1, 2}, {2, 5}})), 2U);
  EXPECT_EQ(rank(residues({{0, 0, 0}, {0, 0, 0}})), 0U);
  EXPECT_EQ(rank(residues({{0, 1}, {1, 0}, {1, 1}})), 2U);
}

// The rank drops modulo the prime and not over the rational numbers: why the filter is one-sided.
TEST(Matrix, AMinorMayVanishModuloThePrimeAlone) {
  const Matrix<Rational> matrix = matrix_of<Rational>({{Rational(Residue::kPrime), 0}, {0, 1}});
  EXPECT_EQ(rank(reduced(matrix)), 1U);
  EXPECT_TRUE(kernel_basis(matrix).empty());
}

TEST(Matrix, KernelByHand) {
  // x + y/2 - z/3 = 0 and y = z: (1/3 - 1/2) z = x, so x = -z/6
  const auto kernel = kernel_basis(matrix_of<Rational>({{1, Rational(1, 2), Rational(-1, 3)}, {0, 1, -1}}));
  ASSERT_EQ(kernel.size(), 1U);
  EXPECT_EQ(kernel.front(), (std::vector<Integer>{1, -6, -6}));
  EXPECT_EQ(kernel_basis(matrix_of<Rational>({{0, 0}})).size(), 2U);
}

RC_GTEST_PROP(Matrix, KernelVectorsAreKilledAndAsManyAsTheRankLeaves, ()) {
  const auto rows = *rc::gen::inRange<std::size_t>(1, 9), columns = *rc::gen::inRange<std::size_t>(1, 9);
  const Matrix<Rational> matrix = low_rank(rows, columns, *rc::gen::inRange<std::size_t>(1, 9));
  const auto kernel = kernel_basis(matrix);
  RC_ASSERT(kernel.size() + rank(reduced(matrix)) == columns);
  for (const auto& x : kernel) {
    for (std::size_t row = 0; row < rows; ++row) RC_ASSERT(row_times(matrix, row, x) == 0);
    Integer divisor = 0;
    for (const Integer& entry : x) divisor = gcd(divisor, entry);
    RC_ASSERT(divisor == 1);
  }
}

}  // namespace
}  // namespace asts
