#include "properties/case_meshes.hpp"

#include "lib/refine/replay.hpp"

namespace asts {

void for_each_mesh(const Case& test_case, const std::function<void(std::size_t step, MeshUnderTest& mesh)>& visit) {
  if (test_case.explicit_mesh) return with_last_mesh(test_case, [&](MeshUnderTest& mesh) { visit(0, mesh); });
  Replay replay(test_case);
  for (std::size_t step = 0;; ++step) {
    MeshUnderTest mesh(replay.tree());
    visit(step, mesh);
    if (replay.done()) return;
    replay.advance();
  }
}

void with_last_mesh(const Case& test_case, const std::function<void(MeshUnderTest& mesh)>& visit) {
  if (test_case.explicit_mesh) {
    MeshUnderTest mesh(mesh_of(setting_of(test_case), test_case.elements));
    return visit(mesh);
  }
  Replay replay(test_case);
  while (!replay.done()) replay.advance();
  MeshUnderTest mesh(replay.tree());
  visit(mesh);
}

}  // namespace asts
