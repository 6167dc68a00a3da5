#include <algorithm>

#include "lib/gen/biased_cases.hpp"

namespace asts {

namespace {

/// On how many axes a bias makes the active region a point.
std::size_t thin_axes(Bias bias) {
  switch (bias) {
    case Bias::region_point:
      return 3;
    case Bias::region_segment:
      return 2;
    case Bias::region_plane:
    case Bias::boxes_planar:
      return 1;
    default:
      return 0;
  }
}

/// The region is [(p+1)/2, length - (p+1)/2]: one coordinate when the length is p+1. On the other axes it is longer.
void make_thin(Draw& draw, Setting& setting, std::size_t count) {
  std::vector<std::size_t> axes{0, 1, 2};
  draw.shuffle(axes);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const int least = setting.degree[axes[i]] + 1;
    int& length = setting.domain[axes[i]];
    length = i < count ? least : std::max(length, least + 1);
  }
}

/// Supports of nodes at the ends of the region reach (p+1)/2 cubes from them: they touch where the region is p+1 long.
void stretch_for_interface(Draw& draw, const CaseLimits& limits, Setting& setting) {
  const std::size_t along = draw.index(kDimension);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    setting.domain[axis] = setting.degree[axis] + 1;
  }
  setting.domain[along] = 2 * setting.degree[along] + draw.between(1, 3);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    const std::int64_t cubes = std::int64_t{setting.domain[0]} * setting.domain[1] * setting.domain[2];
    const std::int64_t with_one_more = cubes / setting.domain[axis] * (setting.domain[axis] + 1);
    if (axis != along && (with_one_more <= limits.max_cubes || draw.one_in(2))) ++setting.domain[axis];
  }
}

/// Long along one axis, and with a region that is no point along the others: then a mesh of few elements has them of
/// levels 0, 1 and 2 in the region.
void stretch_for_grading(Draw& draw, Setting& setting) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    setting.domain[axis] = setting.degree[axis] + 1 + (draw.one_in(4) ? 0 : draw.between(1, 2));
  }
  const std::size_t longest = draw.index(kDimension);
  const int least = setting.degree[longest] + 1;
  setting.domain[longest] = draw.between(2 * least + 2, 4 * least);
}

/// Thin along one axis; along the others the region has one or two integers in its interior.
void make_planar(Draw& draw, Setting& setting) {
  const std::size_t thin = draw.index(kDimension);
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    setting.domain[axis] = setting.degree[axis] + (axis == thin ? 1 : draw.between(3, 4));
  }
}

}  // namespace

Setting trouble_setting(Draw& draw, const CaseLimits& limits, Bias bias) {
  Setting setting = random_setting(draw, limits);
  if (bias == Bias::bare_interface) {
    stretch_for_interface(draw, limits, setting);
  } else if (bias == Bias::marks_graded) {
    stretch_for_grading(draw, setting);
  } else if (bias == Bias::boxes_planar_inside) {
    make_planar(draw, setting);
  } else if (thin_axes(bias) > 0) {
    make_thin(draw, setting, thin_axes(bias));
  }
  return setting;
}

}  // namespace asts
