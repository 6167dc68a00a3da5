#include <algorithm>

#include "lib/gen/biased_cases.hpp"
#include "properties/campaign/provoked_cases.hpp"

namespace asts {

namespace {

constexpr int kMostSide = 9;
constexpr std::int64_t kMostElements = 1000;

}  // namespace

Case interface_case(Draw& draw) {
  while (true) {
    const CaseLimits limits{draw.one_in(3) ? 7 : 3, 4, kMostSide, 350, 600, 12};
    const Setting setting = setting_for(draw, limits, Bias::bare_interface);
    const int longest = *std::max_element(setting.domain.begin(), setting.domain.end());
    if (longest <= kMostSide) return random_case_in(draw, setting, limits, Bias::bare_interface).content;
  }
}

// One cube of level 2 in the lower or upper third, and cubes of level 1 on one side of it, at random and with gaps.
Case small_interface_case(Draw& draw) {
  Setting setting{{3, 3, 3}, draw.one_in(4) ? 3 : 2, {}};
  if (draw.one_in(4)) setting.degree[draw.index(kDimension)] = 5;
  Column column{draw.index(kDimension), {}, {}};
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    setting.domain[axis] = setting.degree[axis] + (axis == column.axis ? setting.degree[axis] + 2 : 2);
    column.cube[axis] = setting.domain[axis] / 2;
  }
  const int length = setting.domain[column.axis];
  const int peak = draw.between(1, 2);
  for (int place = 0; place < length; ++place) {
    const bool beside = place > peak && place <= peak + 4;
    column.levels.push_back(place == peak ? 2 : beside && draw.one_in(2) ? 1 : 0);
  }
  if (draw.one_in(2)) std::reverse(column.levels.begin(), column.levels.end());
  GrowingCase growing(setting, kMostElements);
  subdivide_column(draw, growing, column);
  return growing.content();
}

Case graded_case(Draw& draw) {
  const CaseLimits limits{3, 3, 7, 250, 900, 12};
  return random_case_in(draw, setting_for(draw, limits, Bias::marks_graded), limits, Bias::marks_graded).content;
}

}  // namespace asts
