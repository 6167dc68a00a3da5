#include "lib/spline/support_contacts.hpp"

#include <algorithm>

#include "lib/mesh/pair_table.hpp"

namespace asts {

namespace {

/// Ordered pairs of indices of two profiles whose supports have one point in common along the axis, and more.
struct AxisContacts {
  std::int64_t point = 0;
  std::int64_t interval = 0;
};

class AxisContactCount {
 public:
  AxisContactCount(const TSplines& splines, const Bricks& bricks, Axis axis)
      : vectors_(splines.vectors[at(axis)]), profiles_(bricks.profiles[at(axis)]), axis_(axis) {}

  const AxisContacts& of(const Brick& one, const Brick& other) {
    const std::int32_t a = one.profile[at(axis_)];
    const std::int32_t b = other.profile[at(axis_)];
    return known_.get(std::min(a, b), std::max(a, b), [&] { return count(profiles_[at(a)], profiles_[at(b)]); });
  }

 private:
  AxisContacts count(const AxisProfile& one, const AxisProfile& other) const {
    AxisContacts contacts;
    for (const std::int32_t i : one.vector_ids) {
      for (const std::int32_t j : other.vector_ids) {
        const std::int32_t lower = std::max(vectors_.front(i), vectors_.front(j));
        const std::int32_t upper = std::min(vectors_.back(i), vectors_.back(j));
        if (lower == upper) ++contacts.point;
        if (lower < upper) ++contacts.interval;
      }
    }
    return contacts;
  }

  const IndexVectors& vectors_;
  const std::vector<AxisProfile>& profiles_;
  Axis axis_;
  PairTable<AxisContacts> known_;
};

class ContactCount {
 public:
  ContactCount(const TSplines& splines, const Bricks& bricks) {
    for (Axis axis = 0; axis < kDimension; ++axis) axes_.emplace_back(splines, bricks, axis);
  }

  /// Of ordered pairs, one node of either brick.
  SupportContacts of(const Brick& one, const Brick& other) {
    SupportContacts contacts;
    contacts.by_dimension[0] = 1;
    for (AxisContactCount& axis : axes_) {
      const AxisContacts& along = axis.of(one, other);
      for (std::size_t dimension = kDimension; dimension > 0; --dimension) {
        contacts.by_dimension[dimension] =
            contacts.by_dimension[dimension] * along.point + contacts.by_dimension[dimension - 1] * along.interval;
      }
      contacts.by_dimension[0] *= along.point;
    }
    return contacts;
  }

 private:
  std::vector<AxisContactCount> axes_;
};

}  // namespace

SupportContacts count_contacts(const TSplines& splines, const Bricks& bricks) {
  ContactCount count(splines, bricks);
  SupportContacts total;
  for (const Brick& brick : bricks.bricks) {
    // each pair of different nodes was counted twice, and each node with itself once
    const SupportContacts twice = count.of(brick, brick);
    for (std::size_t d = 0; d <= kDimension; ++d) total.by_dimension[d] += twice.by_dimension[d];
  }
  total.by_dimension[kDimension] -= splines.size();
  for (std::int64_t& pairs : total.by_dimension) pairs /= 2;
  for (const auto& [i, j] : bricks.pairs) {
    const SupportContacts pairs = count.of(bricks.bricks[at(i)], bricks.bricks[at(j)]);
    for (std::size_t d = 0; d <= kDimension; ++d) total.by_dimension[d] += pairs.by_dimension[d];
  }
  return total;
}

}  // namespace asts
