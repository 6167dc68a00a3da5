#pragma once

#include <memory>
#include <string>
#include <utility>

#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "properties/claims/subdivision_step.hpp"

namespace asts {

/// The last mesh of a case of steps, for tests that look at it and at what subdividing one of its elements does.
class SubdividedMesh {
 public:
  explicit SubdividedMesh(Case content) : content_(std::move(content)), replay_(content_) {
    while (!replay_.done()) replay_.advance();
    mesh_ = std::make_unique<MeshUnderTest>(replay_.tree());
  }
  /// A case's text without its first line.
  explicit SubdividedMesh(const std::string& text) : SubdividedMesh(parse_case("asts-case 1\n" + text, "f")) {}

  SubdividedMesh(const SubdividedMesh&) = delete;
  SubdividedMesh& operator=(const SubdividedMesh&) = delete;

  const Case& content() const { return content_; }
  const RefinementTree& tree() const { return replay_.tree(); }
  MeshUnderTest& mesh() const { return *mesh_; }

  SubdivisionStep step_of(std::int32_t leaf) { return subdivision_step(*mesh_, leaf); }
  SubdivisionStep step_at(const Point& point) { return step_of(tree().leaf_at(point)); }

 private:
  Case content_;
  Replay replay_;
  std::unique_ptr<MeshUnderTest> mesh_;
};

}  // namespace asts
