#include "lib/zones/factor_table.hpp"

#include "lib/mesh/level_formulas.hpp"

namespace asts {

namespace {

/// A pattern moved to a place, in the unit m^-depth.
std::vector<Rational> placed(std::span<const std::int64_t> pattern, const Rational& first, const Rational& unit) {
  std::vector<Rational> result;
  for (const std::int64_t distance : pattern) result.push_back(first + Rational(distance) * unit);
  return result;
}

}  // namespace

std::size_t FactorTable::slot_of(const VectorStore::Relation& relation) const {
  std::uint64_t hash = static_cast<std::uint64_t>(relation.pattern) << 32 | static_cast<std::uint32_t>(relation.other);
  hash = (hash ^ static_cast<std::uint64_t>(relation.offset) << 7) * 0x9E3779B97F4A7C15ull;
  hash = (hash ^ hash >> 29 ^ static_cast<std::uint32_t>(relation.depths)) * 0xD6E8FEB86659FD93ull;
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash >> 24 & mask;
  while (slots_[slot].relation.pattern >= 0 && slots_[slot].relation != relation) slot = (slot + 1) & mask;
  return slot;
}

FactorTable::Factor FactorTable::of(const VectorStore& vectors, std::int32_t x, std::int32_t x_tilde) {
  VectorStore::Relation relation;
  if (!vectors.relate(x, x_tilde, relation)) return {};
  const std::size_t slot = slot_of(relation);
  if (slots_[slot].relation.pattern >= 0) return slots_[slot].factor;
  const Factor factor = evaluate(vectors, relation);
  slots_[slot] = {relation, factor};
  if (2 * ++used_ > slots_.size()) {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& one : old) {
      if (one.relation.pattern >= 0) slots_[slot_of(one.relation)] = one;
    }
  }
  return factor;
}

FactorTable::Factor FactorTable::evaluate(const VectorStore& vectors, const VectorStore::Relation& relation) {
  // in the smaller unit of the two
  const Rational unit = grading_power(vectors.grading(), std::max(relation.depths, 0));
  const Rational other = grading_power(vectors.grading(), std::max(-relation.depths, 0));
  const FieldElement value =
      functional_.lambda(placed(vectors.pattern(relation.pattern), 0, unit),
                         placed(vectors.pattern(relation.other), Rational(relation.offset), other));
  return {true, value.is_zero(), value == Rational(1)};
}

}  // namespace asts
