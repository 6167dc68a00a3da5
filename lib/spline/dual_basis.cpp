#include "lib/spline/dual_basis.hpp"

#include <numeric>

#include "lib/exact/errors.hpp"
#include "lib/spline/axis_factors.hpp"

namespace asts {

namespace {

FieldElement product(const PerAxis<FieldElement>& factors) {
  int n = 1;
  for (const FieldElement& factor : factors) n = std::lcm(n, factor.field()->n());
  const auto field = std::make_shared<const CosineField>(n);
  FieldElement value(field, Rational(1));
  for (const FieldElement& factor : factors) value *= embed(factor, field);
  return value;
}

class DualFailures {
 public:
  DualFailures(const Mesh& mesh, const TSplines& splines, const Bricks& bricks) : splines_(splines), bricks_(bricks) {
    factors_.reserve(kDimension);
    for (Axis axis = 0; axis < kDimension; ++axis) factors_.emplace_back(mesh, splines, bricks, axis);
  }

  /// All ordered pairs with v in one of two bricks and w in the other.
  void ask(std::int32_t i, std::int32_t j) {
    const Brick& one = bricks_.bricks[at(i)];
    const Brick& other = bricks_.bricks[at(j)];
    std::int64_t forward = 1;
    std::int64_t backward = 1;
    for (AxisFactors& factors : factors_) {
      const NonzeroCounts counts = factors.nonzero(one, other);
      forward *= counts.forward;
      backward *= counts.backward;
      if (forward == 0 && backward == 0) return;
    }
    add_failures(i, j, forward);
    add_failures(j, i, backward);
  }

  /// All ordered pairs of different nodes of a brick.
  void ask_within(std::int32_t i) {
    const Brick& brick = bricks_.bricks[at(i)];
    std::int64_t nonzero = 1;
    for (AxisFactors& factors : factors_) nonzero *= factors.nonzero(brick, brick).forward;
    add_failures(i, i, nonzero - diagonal_nonzero(brick));
  }

  /// v = w for all nodes of a brick: the product is to be 1.
  void ask_diagonal(std::int32_t i) {
    const Brick& brick = bricks_.bricks[at(i)];
    bool all_one = true;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      for (const std::int32_t id : bricks_.profile(brick, axis).vector_ids) {
        all_one = all_one && factors_[at(axis)].is_one(id);
      }
    }
    if (!all_one) ask_diagonal_nodes(brick);
  }

  DualBasisFailures result() {
    result_.one = diagonal_failure_;
    if (result_.failures > 0) count_pairs();
    if (first_) {
      const NodePair pair = failing_nodes(bricks_.bricks[at(first_->first)], bricks_.bricks[at(first_->second)]);
      if (!result_.one || pair < *result_.one) result_.one = pair;
    }
    return result_;
  }

 private:
  void add_failures(std::int32_t i, std::int32_t j, std::int64_t count) {
    if (count == 0) return;
    result_.failures += count;
    if (!first_ || std::pair{i, j} < *first_) first_ = {i, j};
  }

  void count_pairs() {
    const auto meeting = [&](const Brick& one, const Brick& other) {
      std::int64_t count = 1;
      for (const AxisFactors& factors : factors_) count *= factors.meeting(one, other);
      return count;
    };
    for (const Brick& brick : bricks_.bricks) result_.pairs += meeting(brick, brick);
    for (const auto& [i, j] : bricks_.pairs) {
      result_.pairs += 2 * meeting(bricks_.bricks[at(i)], bricks_.bricks[at(j)]);
    }
  }

  std::int64_t diagonal_nonzero(const Brick& brick) {
    std::int64_t nonzero = 1;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      std::int64_t along = 0;
      for (const std::int32_t id : bricks_.profile(brick, axis).vector_ids) {
        along += factors_[at(axis)].is_zero(id, id) ? 0 : 1;
      }
      nonzero *= along;
    }
    return nonzero;
  }

  void ask_diagonal_nodes(const Brick& brick) {
    for (std::int32_t place = brick.begin; place < brick.begin + brick.count[0] * brick.count[1] * brick.count[2];
         ++place) {
      const std::int32_t node = bricks_.members[at(place)];
      const auto factor = [&](Axis axis) {
        const std::int32_t id = splines_.vector_ids[at(node)][at(axis)];
        return factors_[at(axis)].lambda(id, id);
      };
      if (product({factor(0), factor(1), factor(2)}) == Rational(1)) continue;
      ++result_.failures;
      const NodePair pair{node, node};
      if (!diagonal_failure_ || pair < *diagonal_failure_) diagonal_failure_ = pair;
    }
  }

  /// The first failing pair of two bricks, or of one, that is not on the diagonal: in each axis the first pair of
  /// indices with a factor other than 0, and one that differs from the diagonal where it must.
  NodePair failing_nodes(const Brick& one, const Brick& other) {
    for (Axis off = 0; off < kDimension; ++off) {  // the axis along which v and w differ, if they are in one brick
      PerAxis<std::int32_t> v;
      PerAxis<std::int32_t> w;
      bool found = true;
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const bool differ = &one == &other && axis == off;
        found = found && first_nonzero(one, other, axis, differ, v[at(axis)], w[at(axis)]);
      }
      if (found) return {bricks_.node(one, v), bricks_.node(other, w)};
    }
    throw InternalError("the bricks have no failing pair");
  }

  bool first_nonzero(const Brick& one, const Brick& other, Axis axis, bool differ, std::int32_t& i, std::int32_t& j) {
    const AxisProfile& rows = bricks_.profile(one, axis);
    const AxisProfile& columns = bricks_.profile(other, axis);
    for (i = 0; i < one.count[at(axis)]; ++i) {
      for (j = 0; j < other.count[at(axis)]; ++j) {
        const std::int32_t x = rows.vector_ids[at(i)];
        const std::int32_t x_tilde = columns.vector_ids[at(j)];
        if (differ && i == j) continue;
        if (factors_[at(axis)].meet(x, x_tilde) && !factors_[at(axis)].is_zero(x, x_tilde)) return true;
      }
    }
    return false;
  }

  const TSplines& splines_;
  const Bricks& bricks_;
  std::vector<AxisFactors> factors_;
  DualBasisFailures result_;
  std::optional<std::pair<std::int32_t, std::int32_t>> first_;
  std::optional<NodePair> diagonal_failure_;
};

}  // namespace

DualValue dual_value(const Mesh& mesh, const TSplines& splines, std::int32_t v, std::int32_t w) {
  const auto factor = [&](Axis axis) {
    DualFunctional functional(mesh.setting.degree[at(axis)]);
    return functional.lambda(vector_coordinates(mesh, splines, axis, splines.vector_ids[at(v)][at(axis)]),
                             vector_coordinates(mesh, splines, axis, splines.vector_ids[at(w)][at(axis)]));
  };
  static_assert(kDimension == 3, "one factor an axis");
  PerAxis<FieldElement> factors{factor(0), factor(1), factor(2)};
  FieldElement value = product(factors);
  return {std::move(factors), std::move(value)};
}

DualBasisFailures find_dual_failures(const Mesh& mesh, const TSplines& splines, const Bricks& bricks) {
  DualFailures failures(mesh, splines, bricks);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(bricks.bricks.size()); ++i) {
    failures.ask_within(i);
    failures.ask_diagonal(i);
  }
  for (const auto& [i, j] : bricks.pairs) failures.ask(i, j);
  return failures.result();
}

}  // namespace asts
