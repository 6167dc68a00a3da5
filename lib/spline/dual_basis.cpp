#include "lib/spline/dual_basis.hpp"

#include <algorithm>
#include <numeric>

namespace asts {

namespace {

std::size_t at(std::int32_t id) { return static_cast<std::size_t>(id); }

std::vector<Rational> coordinates(const Mesh& mesh, const TSplines& splines, Axis axis, std::int32_t vector) {
  std::vector<Rational> result;
  for (const std::int32_t rank : splines.vectors[at(axis)][vector]) result.push_back(mesh.coordinate(axis, rank));
  return result;
}

FieldElement product(const PerAxis<FieldElement>& factors) {
  int n = 1;
  for (const FieldElement& factor : factors) n = std::lcm(n, factor.field()->n());
  const auto field = std::make_shared<const CosineField>(n);
  FieldElement value(field, Rational(1));
  for (const FieldElement& factor : factors) value *= embed(factor, field);
  return value;
}

}  // namespace

VectorPairings::VectorPairings(const Mesh& mesh, const TSplines& splines, Axis axis)
    : mesh_(mesh), splines_(splines), axis_(axis), functional_(mesh.setting.degree[at(axis)]) {
  values_.emplace_back(functional_.field(), Rational(0));
  values_.emplace_back(functional_.field(), Rational(1));
}

FieldElement VectorPairings::lambda(std::int32_t x, std::int32_t x_tilde) {
  return values_[at(slot(x, x_tilde))];
}

std::int32_t VectorPairings::slot(std::int32_t x, std::int32_t x_tilde) {
  const std::uint64_t key = static_cast<std::uint64_t>(x) << 32 | static_cast<std::uint32_t>(x_tilde);
  const auto [place, is_new] = slots_.try_emplace(key, 0);
  if (is_new) place->second = evaluate(x, x_tilde);
  return place->second;
}

std::int32_t VectorPairings::evaluate(std::int32_t x, std::int32_t x_tilde) {
  FieldElement value = functional_.lambda(coordinates(mesh_, splines_, axis_, x),
                                          coordinates(mesh_, splines_, axis_, x_tilde));
  if (value.is_zero()) return kZero;
  if (value == Rational(1)) return kOne;
  values_.push_back(std::move(value));
  return static_cast<std::int32_t>(values_.size()) - 1;
}

DualValue dual_value(const Mesh& mesh, const TSplines& splines, std::int32_t v, std::int32_t w) {
  const auto factor = [&](Axis axis) {
    DualFunctional functional(mesh.setting.degree[at(axis)]);
    return functional.lambda(coordinates(mesh, splines, axis, splines.vector_ids[at(v)][at(axis)]),
                             coordinates(mesh, splines, axis, splines.vector_ids[at(w)][at(axis)]));
  };
  static_assert(kDimension == 3, "one factor an axis");
  PerAxis<FieldElement> factors{factor(0), factor(1), factor(2)};
  FieldElement value = product(factors);
  return {std::move(factors), std::move(value)};
}

namespace {

class DualFailures {
 public:
  DualFailures(const Mesh& mesh, const TSplines& splines, const LineRuns& runs)
      : splines_(splines), runs_(runs), order_(splines.line_order[at(runs.axis)]) {
    pairings_.reserve(kDimension);
    for (Axis axis = 0; axis < kDimension; ++axis) pairings_.emplace_back(mesh, splines, axis);
  }

  /// All ordered pairs with v in `one` and w in `other`.
  void ask(const LineRun& one, const LineRun& other) {
    if (!meet_across(one, other)) return;
    result_.pairs += count_meeting(one, other);
    for (Axis axis = 0; axis < kDimension; ++axis) {
      if (axis == runs_.axis) continue;
      if (pairings_[at(axis)].is_zero(vector_of(one.begin, axis), vector_of(other.begin, axis))) return;
    }
    for (std::int32_t i = one.begin; i < one.end; ++i) {
      for (std::int32_t j = other.begin; j < other.end; ++j) ask_nodes(order_[at(i)], order_[at(j)]);
    }
  }

  DualBasisFailures result() const { return result_; }

 private:
  std::int32_t vector_of(std::int32_t place, Axis axis) const {
    return splines_.vector_ids[at(order_[at(place)])][at(axis)];
  }

  bool meet_across(const LineRun& one, const LineRun& other) const {
    for (Axis axis = 0; axis < kDimension; ++axis) {
      if (axis == runs_.axis) continue;
      if (one.support.lower[at(axis)] >= other.support.upper[at(axis)]) return false;
      if (other.support.lower[at(axis)] >= one.support.upper[at(axis)]) return false;
    }
    return true;
  }

  /// Pairs of nodes whose supports meet along the runs. Lower and upper ends ascend along a run, so those that meet a
  /// given support stand together, and both ends of their range only move on.
  std::int64_t count_meeting(const LineRun& one, const LineRun& other) const {
    std::int64_t count = 0;
    std::int32_t first = other.begin;
    std::int32_t last = other.begin;
    for (std::int32_t i = one.begin; i < one.end; ++i) {
      const RankInterval side = splines_.support(order_[at(i)], runs_.axis);
      while (first < other.end && splines_.support(order_[at(first)], runs_.axis).upper <= side.lower) ++first;
      last = std::max(last, first);
      while (last < other.end && splines_.support(order_[at(last)], runs_.axis).lower < side.upper) ++last;
      count += last - first;
    }
    return count;
  }

  void ask_nodes(std::int32_t v, std::int32_t w) {
    if (!interiors_meet(splines_.support(v, runs_.axis), splines_.support(w, runs_.axis))) return;
    if (v == w ? is_one(v) : is_zero(v, w, runs_.axis)) return;
    ++result_.failures;
    const NodePair pair{v, w};
    if (!result_.least || pair < *result_.least) result_.least = pair;
  }

  bool is_zero(std::int32_t v, std::int32_t w, Axis axis) {
    return pairings_[at(axis)].is_zero(splines_.vector_ids[at(v)][at(axis)], splines_.vector_ids[at(w)][at(axis)]);
  }

  bool is_one(std::int32_t v) {
    bool all_one = true;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      const std::int32_t id = splines_.vector_ids[at(v)][at(axis)];
      all_one = all_one && pairings_[at(axis)].is_one(id, id);
    }
    if (all_one) return true;
    const auto factor = [&](Axis axis) {
      const std::int32_t id = splines_.vector_ids[at(v)][at(axis)];
      return pairings_[at(axis)].lambda(id, id);
    };
    return product({factor(0), factor(1), factor(2)}) == Rational(1);
  }

  const TSplines& splines_;
  const LineRuns& runs_;
  const std::vector<std::int32_t>& order_;
  std::vector<VectorPairings> pairings_;
  DualBasisFailures result_;
};

}  // namespace

DualBasisFailures find_dual_failures(const Mesh& mesh, const TSplines& splines, const LineRuns& runs) {
  DualFailures failures(mesh, splines, runs);
  for (const LineRun& run : runs.runs) failures.ask(run, run);
  for (const auto& [i, j] : runs.pairs) {
    failures.ask(runs.runs[at(i)], runs.runs[at(j)]);
    failures.ask(runs.runs[at(j)], runs.runs[at(i)]);
  }
  return failures.result();
}

}  // namespace asts
