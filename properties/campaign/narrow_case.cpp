#include "lib/gen/random_case.hpp"
#include "properties/campaign/provoked_cases.hpp"

namespace asts {

Case narrow_case(Draw& draw) {
  const CaseLimits limits{3, 4, 7, 125, 250, 3};
  Setting setting = setting_for(draw, limits, Bias::marks_anywhere);
  const std::size_t axis = draw.index(kDimension);
  setting.degree[axis] = 3 + 2 * draw.between(1, 4);
  setting.domain[axis] = draw.between(1, (setting.degree[axis] - 3) / 2);
  return random_case_in(draw, setting, limits, Bias::marks_anywhere).content;
}

}  // namespace asts
