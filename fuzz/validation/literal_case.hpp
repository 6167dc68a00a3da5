#pragma once

#include <algorithm>
#include <cstddef>

#include "lib/mesh/case.hpp"
#include "lib/mesh/mesh.hpp"
#include "tests/reference/claim_subject.hpp"

/// The bridge between lib's types and those of the literal reference.
namespace asts::literal {

inline reference::Setting setting(const Setting& setting) { return {setting.degree, setting.grading, setting.domain}; }

inline reference::Point point(const Point& point) {
  reference::Point result;
  for (std::size_t axis = 0; axis < kDimension; ++axis) result[axis] = point[axis].value();
  return result;
}

inline reference::Box box(const Mesh& mesh, const Box& element) {
  reference::Box result;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    result.lower[a] = mesh.coordinate(axis, element.lower[a]);
    result.upper[a] = mesh.coordinate(axis, element.upper[a]);
  }
  return result;
}

/// The boxes of a mesh of lib, in order.
inline reference::Mesh mesh(const Mesh& mesh) {
  reference::Mesh result;
  for (const Box& element : mesh.elements) result.push_back(box(mesh, element));
  return result;
}

/// As a set.
inline reference::Mesh sorted(reference::Mesh mesh) {
  std::sort(mesh.begin(), mesh.end());
  return mesh;
}

/// The boxes of a case's `element` lines, in order.
inline reference::Mesh boxes(const Case& test_case) {
  reference::Mesh result;
  for (const ElementLine& line : test_case.elements) result.push_back({point(line.lower), point(line.upper)});
  return result;
}

inline reference::LiteralStep step(const Step& step) {
  reference::LiteralStep result{step.kind == Step::Kind::refine, {}};
  for (const Point& mark : step.marks) result.marks.push_back(point(mark));
  return result;
}

/// The mesh or the sequence of a case's first steps, which the literal code makes by its own means: nothing of the mesh
/// kernel is used. REQUIRES: the case has so many steps.
inline reference::ClaimSubject subject(const Case& test_case, std::size_t steps) {
  const reference::Setting literal_setting{test_case.degree, test_case.grading, test_case.domain};
  if (test_case.explicit_mesh) return {literal_setting, boxes(test_case)};
  std::vector<reference::LiteralStep> sequence;
  for (std::size_t i = 0; i < steps; ++i) sequence.push_back(step(test_case.steps[i]));
  return {literal_setting, std::move(sequence)};
}

inline reference::ClaimSubject subject(const Case& test_case) { return subject(test_case, test_case.steps.size()); }

}  // namespace asts::literal
