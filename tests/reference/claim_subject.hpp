#pragma once

#include <optional>
#include <vector>

#include "tests/reference/mesh.hpp"

namespace asts::reference {

/// One step of a sequence: a call of Algorithm 2.9 for the elements that the points name, or their bare subdivision
/// (Definition 2.7).
struct LiteralStep {
  bool refine = true;
  std::vector<Point> marks;
};

/// What a claim's witness is about: a setting with steps from the initial mesh, or with the boxes of an explicit mesh.
/// The last mesh is made when it is first asked for, since some sequences end in one that is too large to be made.
class ClaimSubject {
 public:
  ClaimSubject(const Setting& setting, std::vector<LiteralStep> steps);
  ClaimSubject(const Setting& setting, Mesh explicit_mesh);

  const Setting& setting() const { return setting_; }
  /// nullptr for an explicit mesh.
  const std::vector<LiteralStep>* steps() const { return steps_ ? &*steps_ : nullptr; }
  /// The last mesh; tiles the domain. Throws Rejected when the boxes do not, or when a mark lies outside of the domain.
  const Mesh& mesh();

 private:
  Setting setting_;
  std::optional<std::vector<LiteralStep>> steps_;
  std::optional<Mesh> mesh_;
  bool tiles_ = false;
};

/// The mesh after one more step. Throws Rejected when a mark lies outside of the domain.
Mesh after_step(const Setting& setting, const Mesh& mesh, const LiteralStep& step);

}  // namespace asts::reference
