#include <algorithm>

#include "lib/mesh/mesh.hpp"
#include "lib/mesh/pair_table.hpp"

namespace asts {

namespace {

std::int32_t whole_part(const Rational& value) {
  return static_cast<std::int32_t>(
      Integer(boost::multiprecision::numerator(value) / boost::multiprecision::denominator(value)));
}

/// An interval as a cell of an axis (see AxisGrid): the unit cell that contains it, and the child to choose at each
/// depth on the way down. An interval that is no such cell has no unit cell.
struct CellPath {
  std::int32_t unit = -1;
  std::vector<std::int32_t> children;
};

/// `place` and `size` are the interval's lower end and length relative to the cell at hand, in its length.
CellPath path_of(const Rational& lower, const Rational& upper, int grading) {
  CellPath path;
  const std::int32_t unit = whole_part(lower);
  Rational place = lower - unit;
  Rational size = upper - lower;
  while (size < 1) {
    place *= grading;
    size *= grading;
    path.children.push_back(whole_part(place));
    place -= path.children.back();
  }
  if (size == 1 && place == 0) path.unit = unit;
  return path;
}

/// The level of an element whose sides were split so often, if there is one: x is split first, then y, then z, in turn.
std::optional<std::int32_t> level_of_depths(const PerAxis<std::size_t>& depths) {
  std::size_t level = 0;
  for (const std::size_t depth : depths) level += depth;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    if (depths[axis] != (level + kDimension - 1 - axis) / kDimension) return std::nullopt;
  }
  return static_cast<std::int32_t>(level);
}

class Recogniser {
 public:
  explicit Recogniser(const Mesh& mesh) : mesh_(mesh), tree_(mesh.setting) {}

  /// The tree's node that is this box, made when missing; kNone for a box outside the class.
  std::int32_t find_or_make(const Box& box) {
    PerAxis<const CellPath*> paths;
    PerAxis<std::size_t> depths;
    PerAxis<std::int32_t> cube;
    for (std::size_t axis = 0; axis < kDimension; ++axis) {
      paths[axis] = &path(axis, box);
      if (paths[axis]->unit < 0) return RefinementTree::kNone;
      cube[axis] = paths[axis]->unit;
      depths[axis] = paths[axis]->children.size();
    }
    const auto level = level_of_depths(depths);
    if (!level) return RefinementTree::kNone;
    std::int32_t id = tree_.unit_cube(cube);
    for (std::int32_t k = 0; k < *level; ++k) {
      if (tree_.is_leaf(id)) tree_.subdivide(id);
      id = tree_.node(id).first_child + paths[at(k % kDimension)]->children[at(k / kDimension)];
    }
    return id;
  }

  RefinementTree take() {
    tree_.update_ranks();
    return std::move(tree_);
  }

 private:
  const CellPath& path(std::size_t axis, const Box& box) {
    const std::int32_t lower = box.lower[axis];
    const std::int32_t upper = box.upper[axis];
    const std::int32_t id = path_id_[axis].get(lower, upper, [&] {
      paths_[axis].push_back(
          path_of(mesh_.coordinates[axis][at(lower)], mesh_.coordinates[axis][at(upper)], mesh_.setting.grading));
      return static_cast<std::int32_t>(paths_[axis].size()) - 1;
    });
    return paths_[axis][at(id)];
  }

  const Mesh& mesh_;
  RefinementTree tree_;
  PerAxis<PairTable<std::int32_t>> path_id_;
  PerAxis<std::vector<CellPath>> paths_;  ///< one an interval that occurs
};

}  // namespace

bool RecognisedTree::complete() const {
  return std::find(node_of_element.begin(), node_of_element.end(), RefinementTree::kNone) == node_of_element.end();
}

RecognisedTree recognise(const Mesh& mesh) {
  Recogniser recogniser(mesh);
  std::vector<std::int32_t> nodes;
  nodes.reserve(mesh.elements.size());
  for (const Box& box : mesh.elements) nodes.push_back(recogniser.find_or_make(box));
  return {recogniser.take(), std::move(nodes)};
}

}  // namespace asts
