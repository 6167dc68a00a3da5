#include "lib/spline/bricks.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

/// The next node on the line parallel to an axis, -1 behind the last one.
std::vector<std::int32_t> next_on_line(const TSplines& splines, Axis axis) {
  std::vector<std::int32_t> next(at(splines.size()), -1);
  const std::vector<std::int32_t>& order = splines.line_order[at(axis)];
  for (std::size_t i = 1; i < order.size(); ++i) {
    PerAxis<std::int32_t> one = splines.nodes[at(order[i - 1])];
    PerAxis<std::int32_t> other = splines.nodes[at(order[i])];
    one[at(axis)] = other[at(axis)] = 0;
    if (one == other) next[at(order[i - 1])] = order[i];
  }
  return next;
}

struct HashIds {
  std::size_t operator()(const std::vector<std::int32_t>& ids) const {
    std::uint64_t hash = 0;
    for (const std::int32_t id : ids)
      hash = (hash + static_cast<std::uint32_t>(id)) * 0x9E3779B97F4A7C15ull ^ hash >> 29;
    return hash;
  }
};

/// Joins bricks that follow one another along an axis, starting from single nodes.
class Joiner {
 public:
  explicit Joiner(const TSplines& splines) : splines_(splines) {
    for (std::int32_t node = 0; node < splines.size(); ++node) {
      Brick brick{node, {}, {}, {}};
      brick.count.fill(1);
      for (Axis axis = 0; axis < kDimension; ++axis) {
        const RankInterval side = splines.support(node, axis);
        brick.support.lower[at(axis)] = side.lower;
        brick.support.upper[at(axis)] = side.upper;
      }
      result_.bricks.push_back(brick);
      result_.members.push_back(node);
    }
  }

  /// Members keep the order of Bricks when the axes are joined in ascending order.
  void join_along(Axis axis) {
    const std::vector<std::int32_t> next = next_on_line(splines_, axis);
    std::vector<std::int32_t> brick_of_first(at(splines_.size()), -1);
    for (std::size_t i = 0; i < result_.bricks.size(); ++i) {
      brick_of_first[at(result_.members[at(result_.bricks[i].begin)])] = static_cast<std::int32_t>(i);
    }
    Bricks joined;
    std::vector<bool> taken(result_.bricks.size(), false);
    for (const std::int32_t first : splines_.line_order[at(axis)]) {
      std::int32_t id = brick_of_first[at(first)];
      if (id < 0 || taken[at(id)]) continue;
      Brick chain = result_.bricks[at(id)];
      chain.begin = static_cast<std::int32_t>(joined.members.size());
      append_members(result_.bricks[at(id)], joined.members);
      while (true) {
        const std::int32_t node = next[at(result_.members[at(result_.bricks[at(id)].begin)])];
        const std::int32_t follower = node < 0 ? -1 : brick_of_first[at(node)];
        if (follower < 0 || !continues(result_.bricks[at(id)], result_.bricks[at(follower)], axis)) break;
        id = follower;
        taken[at(id)] = true;
        chain.count[at(axis)] += result_.bricks[at(id)].count[at(axis)];
        chain.support.upper[at(axis)] = result_.bricks[at(id)].support.upper[at(axis)];
        append_members(result_.bricks[at(id)], joined.members);
      }
      joined.bricks.push_back(chain);
    }
    result_ = std::move(joined);
  }

  /// Gives each brick its profiles and hands the bricks over.
  Bricks take() {
    for (Axis axis = 0; axis < kDimension; ++axis) intern_profiles(axis);
    return std::move(result_);
  }

 private:
  void append_members(const Brick& brick, std::vector<std::int32_t>& members) const {
    const auto begin = result_.members.begin() + brick.begin;
    members.insert(members.end(), begin, begin + brick.count[0] * brick.count[1] * brick.count[2]);
  }

  bool continues(const Brick& brick, const Brick& next, Axis axis) const {
    if (next.support.lower[at(axis)] >= brick.support.upper[at(axis)]) return false;
    for (Axis other = 0; other < kDimension; ++other) {
      if (other == axis) continue;
      if (brick.count[at(other)] != next.count[at(other)]) return false;
      for (std::int32_t i = 0; i < brick.count[at(other)]; ++i) {
        if (vector_id(brick, other, i) != vector_id(next, other, i)) return false;
      }
    }
    return true;
  }

  /// The index vector along an axis of the nodes with this index.
  std::int32_t vector_id(const Brick& brick, Axis axis, std::int32_t index) const {
    PerAxis<std::int32_t> place{};
    place[at(axis)] = index;
    return splines_.vector_ids[at(result_.node(brick, place))][at(axis)];
  }

  void intern_profiles(Axis axis) {
    std::unordered_map<std::vector<std::int32_t>, std::int32_t, HashIds> known;
    std::vector<AxisProfile>& profiles = result_.profiles[at(axis)];
    std::vector<std::int32_t> ids;
    for (Brick& brick : result_.bricks) {
      ids.clear();
      for (std::int32_t i = 0; i < brick.count[at(axis)]; ++i) ids.push_back(vector_id(brick, axis, i));
      const auto [place, is_new] = known.try_emplace(ids, static_cast<std::int32_t>(profiles.size()));
      if (is_new) profiles.push_back({ids, entries_of(ids, axis)});
      brick.profile[at(axis)] = place->second;
    }
  }

  std::vector<std::int32_t> entries_of(const std::vector<std::int32_t>& ids, Axis axis) const {
    std::vector<std::int32_t> entries;
    for (const std::int32_t id : ids) {
      for (const std::int32_t entry : splines_.vectors[at(axis)][id]) {
        if (entries.empty() || entry > entries.back()) entries.push_back(entry);
      }
    }
    return entries;
  }

  const TSplines& splines_;
  Bricks result_;
};

/// A counting sort: those who read the pairs find the first brick and its neighbours in the cache.
void sort_by_first(Bricks& bricks) {
  std::vector<std::size_t> begin(bricks.bricks.size() + 1, 0);
  for (const auto& pair : bricks.pairs) ++begin[at(pair.first) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::pair<std::int32_t, std::int32_t>> sorted(bricks.pairs.size());
  for (const auto& pair : bricks.pairs) sorted[begin[at(pair.first)]++] = pair;
  bricks.pairs = std::move(sorted);
}

}  // namespace

std::int32_t Bricks::node(const Brick& brick, const PerAxis<std::int32_t>& index) const {
  std::int32_t place = 0;
  for (Axis axis = kDimension - 1; axis >= 0; --axis) place = place * brick.count[at(axis)] + index[at(axis)];
  return members[at(brick.begin + place)];
}

bool interiors_meet(const Box& one, const Box& other) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (one.lower[axis] >= other.upper[axis] || other.lower[axis] >= one.upper[axis]) return false;
  }
  return true;
}

Bricks bricks_of(const TSplines& splines, std::size_t max_pairs) {
  Joiner joiner(splines);
  for (Axis axis = 0; axis < kDimension; ++axis) joiner.join_along(axis);
  Bricks result = joiner.take();
  std::vector<Box> boxes;
  boxes.reserve(result.bricks.size());
  for (const Brick& brick : result.bricks) boxes.push_back(brick.support);
  for_each_meeting_pair(boxes, [&](std::int32_t i, std::int32_t j) {
    if (result.pairs.size() >= max_pairs)
      throw BudgetExhausted("more pairs of meeting supports than the budget allows");
    result.pairs.emplace_back(std::min(i, j), std::max(i, j));
  });
  sort_by_first(result);
  return result;
}

}  // namespace asts
