#include "fuzz/targets/case_in_literal_code.hpp"

namespace asts::fuzz {

namespace {

reference::Point literal_point(const Point& point) {
  reference::Point result;
  for (std::size_t axis = 0; axis < kDimension; ++axis) result[axis] = point[axis].value();
  return result;
}

}  // namespace

reference::ClaimSubject literal_subject(const Case& content) {
  const reference::Setting setting{content.degree, content.grading, content.domain};
  if (content.explicit_mesh) {
    reference::Mesh mesh;
    for (const ElementLine& box : content.elements) {
      mesh.push_back({literal_point(box.lower), literal_point(box.upper)});
    }
    return {setting, std::move(mesh)};
  }
  std::vector<reference::LiteralStep> steps;
  for (const Step& step : content.steps) {
    steps.push_back({step.kind == Step::Kind::refine, {}});
    for (const Point& mark : step.marks) steps.back().marks.push_back(literal_point(mark));
  }
  return {setting, std::move(steps)};
}

}  // namespace asts::fuzz
