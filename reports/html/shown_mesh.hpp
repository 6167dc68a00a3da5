#pragma once

#include <optional>
#include <string>

#include "lib/mesh/case.hpp"
#include "properties/witness.hpp"
#include "reports/html/html.hpp"

namespace asts {

/// A mesh of a report: the last one of a case, with what is wrong with it.
struct ShownMesh {
  const Case* content;               ///< not nullptr
  const Witness* witness = nullptr;  ///< what is marked; may be missing
  std::string name;                  ///< for readers: "the mesh of ..."
};

/// Draws meshes into a page: for each a `figure class="mesh-view" id="view-N"` that the page's script makes
/// interactive, with the slice that matters most as its picture, and the other slices that matter, each in a figure of
/// its own. Every picture has its title and description in words. What the witness names beyond the case's surroundings
/// is not drawn. Cost of each: that of the replay, of the index vectors and of the perturbed regions.
class MeshGallery {
 public:
  /// Where a mesh is not drawn the page says why: too large, or beyond a budget. Throws InputError when the case cannot
  /// be replayed.
  void add(HtmlNode parent, const ShownMesh& shown);

 private:
  int views_ = 0;
  int pictures_ = 0;
};

}  // namespace asts
