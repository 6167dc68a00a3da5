#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "cli/statements.hpp"
#include "lib/gen/enumerate.hpp"

namespace asts::cli {

/// What came out when a statement was tried on a mesh.
struct TrialResult {
  Outcome outcome = Outcome::holds;
  std::int64_t met = 0;
};

/// Tries statements on the meshes of an enumeration. A mesh is one subdivision of the mesh that it extends, whose
/// results are kept: where that subdivision leaves active nodes and index vectors as they are (may_change_splines), a
/// statement that depends on nothing else has the same result again.
class TrialChain {
 public:
  explicit TrialChain(std::vector<const MeshStatement*> statements) : statements_(std::move(statements)) {}

  const std::vector<const MeshStatement*>& statements() const { return statements_; }

  /// One result a statement. REQUIRES: the visits of one enumeration, all of them, in their order.
  const std::vector<TrialResult>& results(const EnumeratedMesh& enumerated);

 private:
  /// A mesh and the first k of its subdivisions, for each k.
  struct Link {
    const RefinementTree* tree;
    std::unique_ptr<MeshUnderTest> mesh;  ///< built when first asked for
    std::vector<TrialResult> results;

    MeshUnderTest& mesh_under_test() {
      if (!mesh) mesh = std::make_unique<MeshUnderTest>(*tree);
      return *mesh;
    }
  };

  bool leaves_splines(std::int32_t subdivided);

  std::vector<const MeshStatement*> statements_;
  std::vector<Link> links_;
};

}  // namespace asts::cli
