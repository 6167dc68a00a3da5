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
  /// No mesh at all: the witness of a statement that needs none is decided by its numbers alone.
  static ClaimSubject none();

  bool is_none() const { return !steps_ && !mesh_; }
  const Setting& setting() const { return setting_; }
  /// nullptr for an explicit mesh, or where there is none.
  const std::vector<LiteralStep>* steps() const { return steps_ ? &*steps_ : nullptr; }
  /// The last mesh; tiles the domain. Throws Rejected when the boxes do not, when a mark lies outside of the
  /// domain, or when there is no mesh.
  const Mesh& mesh();
  /// How many elements it has: for calls of Algorithm 2.9 alone counted without making it. Nothing when these go too
  /// deep for that.
  std::optional<std::size_t> element_count();

 private:
  ClaimSubject() = default;
  std::optional<std::size_t> count_by_subdivisions() const;
  std::size_t count_on_grid(int finest_level) const;

  Setting setting_{{3, 3, 3}, 2, {1, 1, 1}};
  std::optional<std::vector<LiteralStep>> steps_;
  std::optional<Mesh> mesh_;
  bool tiles_ = false;
};

/// The mesh after one more step. Throws Rejected when a mark lies outside of the domain.
Mesh after_step(const Setting& setting, const Mesh& mesh, const LiteralStep& step);

}  // namespace asts::reference
