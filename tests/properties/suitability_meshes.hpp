#pragma once

#include <filesystem>
#include <memory>

#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "properties/mesh_under_test.hpp"

/// Meshes for the tests of the claims of Section 6.
namespace asts {

/// A case's last mesh with all that it stands on.
class LastMesh {
 public:
  explicit LastMesh(Case content) : content_(std::move(content)) {
    if (content_.explicit_mesh) {
      mesh_ = std::make_unique<MeshUnderTest>(mesh_of(setting_of(content_), content_.elements));
      return;
    }
    replay_ = std::make_unique<Replay>(content_);
    while (!replay_->done()) replay_->advance();
    mesh_ = std::make_unique<MeshUnderTest>(replay_->tree());
  }

  MeshUnderTest& operator*() { return *mesh_; }

 private:
  Case content_;
  std::unique_ptr<Replay> replay_;
  std::unique_ptr<MeshUnderTest> mesh_;
};

inline Case text_case(const std::string& steps) {
  return parse_case("asts-case 1\ndegree 3 3 3\ngrading 2\n" + steps, "case");
}

inline Case finding(const std::string& id) {
  const auto cases = std::filesystem::path(ASTS_CASES);
  return read_case_file((cases / ".." / ".." / "reports" / "findings" / (id + ".case")).string());
}

/// Not analysis-suitable, not dual-compatible, inside the active region; the supports at fault share volume.
inline Case crossing() { return text_case("domain 6 6 4\nsubdivide 5/2 5/2 3/2\nsubdivide 9/4 5/2 3/2\n"); }

}  // namespace asts
