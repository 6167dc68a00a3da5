#include "lib/gen/random_boxes.hpp"

#include <algorithm>

namespace asts {

namespace {

/// The planes of the initial mesh along an axis, the inner ones moved by less than 1/2 each when asked for.
std::vector<Rational> random_planes(Draw& draw, int length, bool move) {
  std::vector<Rational> planes;
  for (int i = 0; i <= length; ++i) {
    planes.emplace_back(i);
    if (move && i > 0 && i < length && draw.one_in(3)) planes.back() += Rational(draw.between(-3, 3)) / 7;
  }
  return planes;
}

bool interiors_meet(const RationalBox& a, const RationalBox& b) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (a.upper[axis] <= b.lower[axis] || b.upper[axis] <= a.lower[axis]) return false;
  }
  return true;
}

bool contains(const RationalBox& outer, const RationalBox& inner) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (inner.lower[axis] < outer.lower[axis] || inner.upper[axis] > outer.upper[axis]) return false;
  }
  return true;
}

bool meets_active_region(const Setting& setting, const RationalBox& box) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const int frame = (setting.degree[axis] + 1) / 2;
    if (box.upper[axis] < frame || box.lower[axis] > setting.domain[axis] - frame) return false;
  }
  return true;
}

/// The boxes between planes, x running fastest.
std::vector<RationalBox> tensor_product(const PerAxis<std::vector<Rational>>& planes) {
  std::vector<RationalBox> boxes(1);
  for (std::size_t axis = kDimension; axis-- > 0;) {
    std::vector<RationalBox> next;
    for (const RationalBox& box : boxes) {
      for (std::size_t i = 0; i + 1 < planes[axis].size(); ++i) {
        next.push_back(box);
        next.back().lower[axis] = planes[axis][i];
        next.back().upper[axis] = planes[axis][i + 1];
      }
    }
    boxes = std::move(next);
  }
  return boxes;
}

}  // namespace

BoxTiling::BoxTiling(const Setting& setting, Draw& draw, bool move_planes) {
  PerAxis<std::vector<Rational>> planes;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    planes[axis] = random_planes(draw, setting.domain[axis], move_planes);
  }
  boxes_ = tensor_product(planes);
}

void BoxTiling::cut(std::size_t axis, const Rational& q, const RationalBox& region) {
  const std::size_t count = boxes_.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!interiors_meet(boxes_[i], region) || boxes_[i].lower[axis] >= q || boxes_[i].upper[axis] <= q) continue;
    RationalBox upper_part = boxes_[i];
    boxes_[i].upper[axis] = upper_part.lower[axis] = q;
    boxes_.push_back(upper_part);
  }
}

bool BoxTiling::replace(const RationalBox& region, const std::vector<RationalBox>& replacement) {
  std::vector<RationalBox> kept;
  for (const RationalBox& box : boxes_) {
    if (!interiors_meet(box, region)) {
      kept.push_back(box);
    } else if (!contains(region, box)) {
      return false;
    }
  }
  kept.insert(kept.end(), replacement.begin(), replacement.end());
  boxes_ = std::move(kept);
  return true;
}

RationalBox random_region(Draw& draw, const BoxTiling& tiling, const Setting& setting, int reach) {
  RationalBox region = draw.choose(tiling.boxes());
  // boxes outside the active region are most of a small mesh, and the least interesting ones
  for (int tries = draw.between(0, 6); tries > 0 && !meets_active_region(setting, region); --tries) {
    region = draw.choose(tiling.boxes());
  }
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const Rational wanted = region.upper[axis] + draw.between(0, reach);
    Rational side = setting.domain[axis];
    for (const RationalBox& box : tiling.boxes()) {
      if (box.upper[axis] >= wanted) side = std::min(side, box.upper[axis]);
    }
    region.upper[axis] = side;
  }
  return region;
}

std::vector<RationalBox> pinwheel(Draw& draw, const RationalBox& region, std::size_t axis) {
  const std::size_t a = (axis + 1) % kDimension;
  const std::size_t b = (axis + 2) % kDimension;
  // inner planes a1 < a2 and b1 < b2
  const Rational a1 = random_between(draw, region.lower[a], region.upper[a]);
  const Rational a2 = random_between(draw, a1, region.upper[a]);
  const Rational b1 = random_between(draw, region.lower[b], region.upper[b]);
  const Rational b2 = random_between(draw, b1, region.upper[b]);
  std::vector<RationalBox> boxes(5, region);
  const auto set = [&](std::size_t i, const Rational& a_low, const Rational& a_high, const Rational& b_low,
                       const Rational& b_high) {
    boxes[i].lower[a] = a_low;
    boxes[i].upper[a] = a_high;
    boxes[i].lower[b] = b_low;
    boxes[i].upper[b] = b_high;
  };
  set(0, region.lower[a], a2, region.lower[b], b1);
  set(1, a2, region.upper[a], region.lower[b], b2);
  set(2, a1, region.upper[a], b2, region.upper[b]);
  set(3, region.lower[a], a1, b1, region.upper[b]);
  set(4, a1, a2, b1, b2);
  return boxes;
}

Rational random_between(Draw& draw, const Rational& lower, const Rational& upper) {
  const int parts = draw.choose(std::vector{2, 2, 3, 4, 5, 7});
  return lower + (upper - lower) * draw.between(1, parts - 1) / parts;
}

}  // namespace asts
