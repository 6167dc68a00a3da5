#include "lib/spline/independence.hpp"

#include <algorithm>
#include <map>

#include "lib/exact/errors.hpp"
#include "lib/spline/bspline.hpp"

namespace asts {
namespace {

/// What each index vector of one axis is worth in terms of something that all vectors share (B-splines on neighbouring
/// lines, points): consecutive numbers from `first` on, zero elsewhere.
template <class Number>
struct Sparse {
  std::int32_t first;
  std::vector<Number> numbers;
};

/// The vectors of an axis as combinations of B-splines on neighbouring lines; those that vanish in the region left out
/// as zeros.
template <class Number>
std::vector<Sparse<Number>> refined_vectors(const TSplines& splines, Axis axis, const std::vector<Number>& lines,
                                            Region region) {
  const IndexVectors& vectors = splines.vectors[at(axis)];
  const auto length = static_cast<std::int32_t>(vectors.length());
  std::vector<Sparse<Number>> result;
  for (std::int32_t id = 0; id < vectors.size(); ++id) {
    Sparse<Number> row{vectors.front(id), refined_coefficients(vectors[id], lines)};
    for (std::size_t i = 0; region == Region::active_region && i < row.numbers.size(); ++i) {
      const std::int32_t lower = row.first + static_cast<std::int32_t>(i);
      const bool meets =
          2 * lower < splines.region.upper[at(axis)] && 2 * (lower + length - 1) > splines.region.lower[at(axis)];
      if (!meets) row.numbers[i] = Number(0);
    }
    result.push_back(std::move(row));
  }
  return result;
}

/// The lines modulo the prime; nothing when a denominator or the difference of two lines of an axis vanishes there.
std::optional<PerAxis<std::vector<Residue>>> residues_of_lines(const Mesh& mesh) {
  PerAxis<std::vector<Residue>> result;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    std::vector<std::uint64_t> seen;
    for (const Rational& line : mesh.coordinates[at(axis)]) {
      const std::optional<Residue> residue = residue_of(line);
      if (!residue) return std::nullopt;
      result[at(axis)].push_back(*residue);
      seen.push_back(residue->value());
    }
    std::sort(seen.begin(), seen.end());
    if (std::adjacent_find(seen.begin(), seen.end()) != seen.end()) return std::nullopt;
  }
  return result;
}

/// Fixed pseudo-random numbers (the finaliser of splitmix64): entry i of functional j of an axis.
Residue weight(Axis axis, std::size_t j, std::int32_t i) {
  std::uint64_t bits = 0x9e3779b97f4a7c15U * ((j * kDimension + at(axis) + 1) * 0x100000U + at(i));
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  return Residue(static_cast<std::int64_t>((bits ^ (bits >> 31U)) >> 1U));
}

/// Row j: the value of the axis's functional j for each index vector.
Matrix<Residue> functionals(const std::vector<Sparse<Residue>>& vectors, Axis axis, std::size_t count) {
  Matrix<Residue> result(count, vectors.size());
  std::int32_t end = 0;
  for (const auto& row : vectors) end = std::max(end, row.first + static_cast<std::int32_t>(row.numbers.size()));
  std::vector<Residue> weights(at(end));
  for (std::size_t j = 0; j < count; ++j) {
    for (std::int32_t i = 0; i < end; ++i) weights[at(i)] = weight(axis, j, i);
    for (std::size_t id = 0; id < vectors.size(); ++id) {
      const auto& row = vectors[id];
      for (std::size_t i = 0; i < row.numbers.size(); ++i) {
        result(j, id) += row.numbers[i] * weights[at(row.first) + i];
      }
    }
  }
  return result;
}

/// p+1 points inside each cell between neighbouring lines; cell i has the points (p+1) i, ..., (p+1) i + p.
std::vector<Rational> points_of(const Mesh& mesh, Axis axis) {
  const std::vector<Rational>& lines = mesh.coordinates[at(axis)];
  const int count = mesh.setting.degree[at(axis)] + 1;
  std::vector<Rational> result;
  for (std::size_t cell = 0; cell + 1 < lines.size(); ++cell) {
    for (int i = 1; i <= count; ++i) result.push_back(lines[cell] + (lines[cell + 1] - lines[cell]) * i / (count + 1));
  }
  return result;
}

/// The values of each index vector's B-spline at the points in its support.
std::vector<Sparse<Rational>> values_of_vectors(const Mesh& mesh, const TSplines& splines, Axis axis,
                                                const std::vector<Rational>& points) {
  const IndexVectors& vectors = splines.vectors[at(axis)];
  const std::size_t in_cell = vectors.length() - 1;
  std::vector<Sparse<Rational>> result;
  for (std::int32_t id = 0; id < vectors.size(); ++id) {
    std::vector<Rational> knots;
    for (const std::int32_t rank : vectors[id]) knots.push_back(mesh.coordinate(axis, rank));
    Sparse<Rational> row{vectors.front(id) * static_cast<std::int32_t>(in_cell), {}};
    std::size_t piece = 0;
    for (std::int32_t cell = vectors.front(id); cell < vectors.back(id); ++cell) {
      if (cell == vectors[id][piece + 1]) ++piece;
      for (std::size_t i = 0; i < in_cell; ++i) {
        const Rational& point = points[at(cell) * in_cell + i];
        row.numbers.push_back(bspline_piece_value<Rational>(knots, piece, point));
      }
    }
    result.push_back(std::move(row));
  }
  return result;
}

using SparseAxes = PerAxis<std::vector<Sparse<Rational>>>;

SparseAxes values_of_vectors(const Mesh& mesh, const TSplines& splines) {
  SparseAxes result;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    result[at(axis)] = values_of_vectors(mesh, splines, axis, points_of(mesh, axis));
  }
  return result;
}

/// Calls visit(place, value) for every product of one number an axis that is not 0.
template <class Visit>
void for_each_product(const TSplines& splines, const SparseAxes& axes, std::int32_t node, const Visit& visit) {
  PerAxis<const Sparse<Rational>*> row;
  for (std::size_t a = 0; a < kDimension; ++a) row[a] = &axes[a][at(splines.vector_ids[at(node)][a])];
  static_assert(kDimension == 3, "one loop an axis");
  for (std::size_t i = 0; i < row[0]->numbers.size(); ++i) {
    if (row[0]->numbers[i].is_zero()) continue;
    for (std::size_t j = 0; j < row[1]->numbers.size(); ++j) {
      const Rational plane = row[0]->numbers[i] * row[1]->numbers[j];
      for (std::size_t k = 0; !plane.is_zero() && k < row[2]->numbers.size(); ++k) {
        const PerAxis<std::size_t> place{at(row[0]->first) + i, at(row[1]->first) + j, at(row[2]->first) + k};
        if (!row[2]->numbers[k].is_zero()) visit(place, plane * row[2]->numbers[k]);
      }
    }
  }
}

/// One row for each place that occurs, in their order.
Matrix<Rational> matrix_of(const TSplines& splines, const SparseAxes& axes) {
  std::map<PerAxis<std::size_t>, std::size_t> rows;
  for (std::int32_t v = 0; v < splines.size(); ++v) {
    for_each_product(splines, axes, v, [&](const PerAxis<std::size_t>& place, const Rational&) { rows[place] = 0; });
  }
  std::size_t count = 0;
  for (auto& [place, row] : rows) row = count++;
  Matrix<Rational> result(count, at(splines.size()));
  for (std::int32_t v = 0; v < splines.size(); ++v) {
    for_each_product(splines, axes, v, [&](const PerAxis<std::size_t>& place, const Rational& value) {
      result(rows[place], at(v)) = value;
    });
  }
  return result;
}

}  // namespace

bool certainly_independent(const Mesh& mesh, const TSplines& splines, Region region) {
  const auto lines = residues_of_lines(mesh);
  if (!lines) return false;
  const std::size_t count = at(splines.size());
  std::vector<Matrix<Residue>> factors;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    factors.push_back(functionals(refined_vectors(splines, axis, (*lines)[at(axis)], region), axis, count));
  }
  Matrix<Residue> matrix(count, count);
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t v = 0; v < count; ++v) {
      matrix(j, v) = Residue(1);
      for (std::size_t a = 0; a < kDimension; ++a) matrix(j, v) *= factors[a](j, at(splines.vector_ids[v][a]));
    }
  }
  return rank(matrix) == count;
}

Matrix<Rational> coefficient_matrix(const Mesh& mesh, const TSplines& splines, Region region) {
  SparseAxes axes;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    axes[at(axis)] = refined_vectors(splines, axis, mesh.coordinates[at(axis)], region);
  }
  return matrix_of(splines, axes);
}

Matrix<Rational> value_matrix(const Mesh& mesh, const TSplines& splines) {
  return matrix_of(splines, values_of_vectors(mesh, splines));
}

std::optional<std::vector<Integer>> find_dependence(const Mesh& mesh, const TSplines& splines, Region region) {
  if (certainly_independent(mesh, splines, region)) return std::nullopt;
  std::vector<std::vector<Integer>> kernel = kernel_basis(coefficient_matrix(mesh, splines, region));
  if (kernel.empty()) return std::nullopt;
  return std::move(kernel.front());
}

bool vanishes_everywhere(const Mesh& mesh, const TSplines& splines, const std::vector<Integer>& coefficients) {
  require(coefficients.size() == at(splines.size()), "one coefficient an active node");
  const SparseAxes axes = values_of_vectors(mesh, splines);
  std::map<PerAxis<std::size_t>, Rational> sum;
  for (std::int32_t v = 0; v < splines.size(); ++v) {
    if (coefficients[at(v)].is_zero()) continue;
    for_each_product(splines, axes, v, [&](const PerAxis<std::size_t>& place, const Rational& value) {
      sum[place] += value * coefficients[at(v)];
    });
  }
  return std::all_of(sum.begin(), sum.end(), [](const auto& entry) { return entry.second.is_zero(); });
}

}  // namespace asts
