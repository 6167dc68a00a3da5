#pragma once

#include <string>
#include <vector>

#include "lib/mesh/setting.hpp"
#include "properties/witness.hpp"
#include "reports/slices/slice_geometry.hpp"

namespace asts {

/// What a picture of a slice shows besides the mesh, by the names that the text uses.
struct SliceMarks {
  struct Node {
    std::string name;
    ActiveNodeInfo info;
  };
  struct Point {
    std::string name;
    ExactPoint point;
  };
  struct Box {
    std::string name;
    ExactBox box;
  };
  /// A coordinate that is an entry of another node's index vector, lies in the range of this one's, and is no entry.
  struct Missing {
    std::string node;
    Axis axis;
    Rational coordinate;
  };

  std::string says;  ///< what is wrong, in one sentence; empty when there is no witness
  std::vector<Node> nodes;
  std::vector<Point> points;
  std::vector<Box> boxes;
  std::vector<Missing> missing;
};

/// The nodes, points and boxes of a witness.
SliceMarks marks_of(const Witness& witness);

/// The planes in which a witness is seen, each once, at most six: through the point where perturbed regions meet;
/// through both nodes that fail to overlap or to be dual; through the middles of boxes; for a claim, the slices that
/// its values name, then planes through its points, nodes and boxes. Without a witness, or when it names no place, the
/// planes through the domain's middle.
std::vector<Slice> slices_that_matter(const Witness* witness, const Setting& setting);

}  // namespace asts
