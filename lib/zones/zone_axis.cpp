#include "lib/zones/zone_axis.hpp"

#include "lib/exact/errors.hpp"

namespace asts {

/// The numbers of the lines in a closed range of ranks, as bits.
std::uint64_t ZoneAxis::between(const RankInterval& ranks) const {
  const std::int32_t lower = std::max(ranks.lower, box_.lower);
  const std::int32_t upper = std::min(ranks.upper, box_.upper);
  if (lower > upper) return 0;
  const std::uint32_t first = in_use_[at(lower - box_.lower)];
  const std::uint32_t end = in_use_[at(upper + 1 - box_.lower)];
  const std::uint64_t below_end = end == kMostLines ? ~std::uint64_t{0} : (std::uint64_t{1} << end) - 1;
  return first == kMostLines ? 0 : below_end & ~std::uint64_t{0} << first;
}

std::int32_t ZoneAxis::number_lines(const VectorStore& store, const AxisGrid& grid, const RankInterval& active,
                                    std::size_t most_lines) {
  in_use_.assign(at(box_.upper - box_.lower + 2), 0);
  const auto use = [&](std::int32_t rank) {
    if (rank >= box_.lower && rank <= box_.upper) in_use_[at(rank - box_.lower)] = 1;
  };
  for (const std::int32_t rank : {box_.lower, box_.upper, active.lower, active.upper}) use(rank);
  for (const std::int32_t id : ids_) {
    for (const std::int32_t line : store[id]) use(grid.rank_of_line(line));
  }
  ranks_.clear();
  for (std::size_t i = 0; i < in_use_.size(); ++i) {
    if (in_use_[i] != 0) ranks_.push_back(box_.lower + static_cast<std::int32_t>(i));
  }
  if (ranks_.size() > most_lines) return ranks_[ranks_.size() / 2];
  std::uint8_t below = 0;
  for (std::uint8_t& line : in_use_) {
    const std::uint8_t used = line;
    line = below;
    below = static_cast<std::uint8_t>(below + used);
  }
  active_ = between(active);
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    Vector& vector = vectors_[i];
    vector.reached = between(vector.range);
    for (const std::int32_t line : store[ids_[i]]) {
      const std::int32_t rank = grid.rank_of_line(line);
      if (rank >= box_.lower && rank <= box_.upper) vector.entries |= between({rank, rank});
    }
  }
  return -1;
}

bool ZoneAxis::find_failures() {
  failing_.assign(ids_.size(), false);
  const bool none = std::all_of(vectors_.begin(), vectors_.end(),
                                [](const Vector& vector) { return vector.entries == vector.reached; });
  if (none) return false;
  having_.reset(ranks_.size(), ids_.size());
  lacking_.reset(ranks_.size(), ids_.size());
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    const Vector& vector = vectors_[i];
    for_each_bit(vector.entries, [&](std::size_t line) { having_.set(line, i); });
    for_each_bit(vector.reached & ~vector.entries, [&](std::size_t line) { lacking_.set(line, i); });
  }
  failures_.reset(ids_.size(), ids_.size());
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    const Vector& vector = vectors_[i];
    for_each_bit(vector.entries, [&](std::size_t line) { failures_.unite(i, lacking_, line); });
    for_each_bit(vector.reached & ~vector.entries, [&](std::size_t line) { failures_.unite(i, having_, line); });
    failing_[i] = failures_.any(i);
  }
  return true;
}

void ZoneAxis::evaluate(const VectorStore& store, std::size_t x, std::size_t x_tilde) {
  asked_.set(x, x_tilde);
  const RankInterval& a = vectors_[x].range;
  const RankInterval& b = vectors_[x_tilde].range;
  if (a.lower >= b.upper || b.lower >= a.upper) return;  // DualFunctional, law 3
  const FactorTable::Factor factor = factors_.of(store, ids_[x], ids_[x_tilde]);
  if (!factor.known || !factor.zero) nonzero_.set(x, x_tilde);
}

}  // namespace asts
