#include <algorithm>

#include "tests/reference/decide.hpp"

namespace asts::reference {

namespace {

/// lambda for all pairs of the distinct index vectors of one axis, filled when asked for.
template <class T>
struct LambdaTable {
  std::vector<std::vector<T>> vectors;    ///< distinct, sorted
  std::vector<std::size_t> id;            ///< of each node's vector
  std::vector<std::optional<Number>> values;

  LambdaTable(const std::vector<ActiveNode<T>>& splines, std::size_t axis) {
    for (const ActiveNode<T>& v : splines) vectors.push_back(v.vectors[axis]);
    std::sort(vectors.begin(), vectors.end());
    vectors.erase(std::unique(vectors.begin(), vectors.end()), vectors.end());
    for (const ActiveNode<T>& v : splines) {
      const auto at = std::lower_bound(vectors.begin(), vectors.end(), v.vectors[axis]);
      id.push_back(static_cast<std::size_t>(at - vectors.begin()));
    }
    values.resize(vectors.size() * vectors.size());
  }

  const Number& at(std::size_t v, std::size_t w) {
    std::optional<Number>& value = values[id[v] * vectors.size() + id[w]];
    if (!value) value = lambda_remembered(vectors[id[v]], vectors[id[w]]);
    return *value;
  }
};

bool is_one(const Number& a) {
  return a[0] == 1 && is_rational(a);
}

/// Definition 6.2 against the Kronecker delta. A zero factor makes the product zero, three ones make it one; in all
/// other cases the product is formed.
template <class T>
bool is_delta(const std::array<int, dimension>& degree, std::vector<LambdaTable<T>>& tables, std::size_t v,
              std::size_t w) {
  int ones = 0;
  for (LambdaTable<T>& table : tables) {
    const Number& factor = table.at(v, w);
    if (is_zero(factor)) return v != w;
    if (is_one(factor)) ++ones;
  }
  if (ones == 3) return v == w;
  const Number value = product_of_factors(degree, {tables[0].at(v, w), tables[1].at(v, w), tables[2].at(v, w)});
  return v == w && is_one(value);  // a product of numbers that are not zero is not zero
}

}  // namespace

template <class T>
DualCount count_dual_failures(const std::array<int, dimension>& degree, const std::vector<ActiveNode<T>>& splines,
                              bool until_first_failure) {
  std::vector<LambdaTable<T>> tables;
  for (std::size_t a = 0; a < dimension; ++a) tables.emplace_back(splines, a);
  DualCount count;
  for (std::size_t v = 0; v < splines.size(); ++v)
    for (std::size_t w = 0; w < splines.size(); ++w) {
      if (!intersect_with_volume(splines[v].support, splines[w].support)) continue;
      ++count.pairs;
      if (!is_delta(degree, tables, v, w)) ++count.failures;
      if (until_first_failure && count.failures > 0) return count;
    }
  return count;
}

template DualCount count_dual_failures(const std::array<int, dimension>&, const std::vector<ActiveNode<Rational>>&,
                                       bool);
template DualCount count_dual_failures(const std::array<int, dimension>&, const std::vector<ActiveNode<Grid>>&, bool);

}  // namespace asts::reference
