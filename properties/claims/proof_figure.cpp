#include "properties/claims/proof_figure.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "lib/refine/replay.hpp"
#include "lib/spline/perturbed_regions.hpp"
#include "properties/describe.hpp"

namespace asts {

namespace {

using Rectangle = ProofFigure::Rectangle;
using Point2 = std::array<int, 2>;
using Place = std::vector<Rational>;

constexpr Point2 kSquares{17, 21};
constexpr int kDrawnLevel = 3;  // of K

bool within(const Rectangle& inner, const Rectangle& outer) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (inner.lower[i] < outer.lower[i] || outer.upper[i] < inner.upper[i]) return false;
  }
  return true;
}

bool equal(const Rectangle& one, const Rectangle& other) { return within(one, other) && within(other, one); }

/// The width of the domain beside the drawn squares, the same on all four sides.
std::optional<int> margin_of(const Setting& setting) {
  const int margin = setting.domain[1] - kSquares[0];
  if (margin < 0 || margin % 2 != 0 || setting.domain[2] - kSquares[1] != margin) return std::nullopt;
  return margin / 2;
}

Rational coordinate(const RefinementTree& tree, Axis axis, std::int32_t rank) {
  return tree.grid(axis).coordinate(tree.grid(axis).line_of_rank(rank));
}

/// An element's rectangle in halves; nothing when it is not on them.
std::optional<Rectangle> rectangle_of(const RefinementTree& tree, std::int32_t id, int margin) {
  Rectangle result;
  for (std::size_t i = 0; i < 2; ++i) {
    const Axis axis = static_cast<Axis>(i) + 1;
    const RankInterval extent = tree.extent(id, axis);
    for (const bool upper : {false, true}) {
      const Rational halves = (coordinate(tree, axis, upper ? extent.upper : extent.lower) - margin) * 2;
      if (boost::multiprecision::denominator(halves) != 1) return std::nullopt;
      (upper ? result.upper : result.lower)[i] = static_cast<int>(boost::multiprecision::numerator(halves));
    }
  }
  return result;
}

int drawn_level(const ProofFigure& figure, const Rectangle& rectangle) {
  int level = 0;
  for (const Rectangle& region : figure.levels) level += within(rectangle, region);
  return level;
}

/// Does an element meet the slice through the middle of K? Elements beside it are no smaller than K's halves along x.
bool on_slice(const RefinementTree& tree, std::int32_t id, std::int32_t k) {
  const RankInterval middle = tree.extent(tree.node(k).first_child, 0);
  const RankInterval extent = tree.extent(id, 0);
  return extent.lower <= middle.upper && middle.upper <= extent.upper;
}

/// Do the leaves on the slice have the drawn levels?
bool levels_as_drawn(const RefinementTree& tree, std::int32_t k, const ProofFigure& figure, int margin) {
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (!tree.is_leaf(id) || !on_slice(tree, id, k)) continue;
    const auto rectangle = rectangle_of(tree, id, margin);
    if (!rectangle) return false;
    const int expected = tree.node(id).parent == k ? kDrawnLevel + 1 : drawn_level(figure, *rectangle);
    if (tree.node(id).level != expected) return false;
  }
  return true;
}

/// Unit cells of the half lattice on the slice, by their lower corners: the union of elements.
using Cells = std::set<Point2>;

void add_cells(const Rectangle& rectangle, Cells& cells) {
  for (int y = rectangle.lower[0]; y < rectangle.upper[0]; ++y) {
    for (int z = rectangle.lower[1]; z < rectangle.upper[1]; ++z) cells.insert({y, z});
  }
}

Cells cells_of(const Rectangle& rectangle) {
  Cells cells;
  add_cells(rectangle, cells);
  return cells;
}

bool meets_environment(const RefinementTree& tree, std::int32_t id, const PerAxis<RankInterval>& environment) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const RankInterval extent = tree.extent(id, axis);
    const RankInterval open = environment[at(axis)];
    if (extent.upper <= open.lower || open.upper <= extent.lower) return false;
  }
  return true;
}

PerAxis<RankInterval> environment_of(const RefinementTree& tree, std::int32_t id) {
  PerAxis<RankInterval> environment;
  for (Axis axis = 0; axis < kDimension; ++axis) environment[at(axis)] = tree.environment(id, axis);
  return environment;
}

/// The part on the slice of the union of the leaves that meet one of some environments.
Cells union_on_slice(const RefinementTree& tree, std::int32_t k, const std::vector<PerAxis<RankInterval>>& environments,
                     int margin) {
  Cells cells;
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (!tree.is_leaf(id) || !on_slice(tree, id, k)) continue;
    for (const PerAxis<RankInterval>& environment : environments) {
      if (!meets_environment(tree, id, environment)) continue;
      add_cells(rectangle_of(tree, id, margin).value(), cells);
      break;
    }
  }
  return cells;
}

std::vector<PerAxis<RankInterval>> environments_in_patch(const RefinementTree& tree, std::int32_t k) {
  std::vector<PerAxis<RankInterval>> result;
  const PerAxis<RankInterval> environment = environment_of(tree, k);
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (tree.is_leaf(id) && meets_environment(tree, id, environment)) result.push_back(environment_of(tree, id));
  }
  return result;
}

/// Points of the slices at multiples of a quarter that lie in the drawn squares and in the active region: enough to
/// tell closed sets apart whose sides are at halves. In quarters.
class Quarters {
 public:
  Quarters(const Mesh& mesh, int margin) : active_(active_region(mesh)) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (int place = 0; place <= 4 * kSquares[i]; ++place) {
        ranks_[i].push_back(half_rank(mesh, static_cast<Axis>(i) + 1, Rational(place) / 4 + margin));
      }
    }
  }

  template <class Predicate>
  std::set<Point2> where(const Predicate& predicate) const {
    std::set<Point2> points;
    for (int y = 0; y <= 4 * kSquares[0]; ++y) {
      for (int z = 0; z <= 4 * kSquares[1]; ++z) {
        if (active_.contains(1, rank(0, y)) && active_.contains(2, rank(1, z)) && predicate(y, z))
          points.insert({y, z});
      }
    }
    return points;
  }

  /// The union of boxes of half ranks, seen along x.
  std::set<Point2> seen(const std::vector<Box>& boxes) const {
    std::set<std::array<std::int32_t, 4>> shadows;
    for (const Box& box : boxes) shadows.insert({box.lower[1], box.upper[1], box.lower[2], box.upper[2]});
    return where([&](int y, int z) {
      for (const auto& [y_lower, y_upper, z_lower, z_upper] : shadows) {
        const bool in_y = y_lower <= rank(0, y) && rank(0, y) <= y_upper;
        if (in_y && z_lower <= rank(1, z) && rank(1, z) <= z_upper) return true;
      }
      return false;
    });
  }

  std::set<Point2> drawn(const std::vector<Rectangle>& rectangles) const {
    return where([&](int y, int z) {
      for (const Rectangle& r : rectangles) {
        if (2 * r.lower[0] <= y && y <= 2 * r.upper[0] && 2 * r.lower[1] <= z && z <= 2 * r.upper[1]) return true;
      }
      return false;
    });
  }

 private:
  HalfRank rank(std::size_t i, int place) const { return ranks_[i][static_cast<std::size_t>(place)]; }

  ActiveRegion active_;
  std::array<std::vector<HalfRank>, 2> ranks_;
};

/// The red areas: the ring, as the four rectangles that it consists of, and Sigma.
std::vector<Rectangle> drawn_region_x(const ProofFigure& figure) {
  const Rectangle& out = figure.ring_outside;
  const Rectangle& in = figure.ring_inside;
  return {figure.sigma,
          {out.lower, {in.lower[0], out.upper[1]}},
          {{in.upper[0], out.lower[1]}, out.upper},
          {out.lower, {out.upper[0], in.lower[1]}},
          {{out.lower[0], in.upper[1]}, out.upper}};
}

/// Supports of the active nodes in K's new face: Sigma is their part of the slice.
std::vector<Box> new_supports(MeshUnderTest& mesh, std::int32_t k) {
  const RefinementTree& tree = mesh.tree();
  const Rational xi = coordinate(tree, 0, tree.extent(tree.node(k).first_child, 0).upper);
  std::vector<Box> supports;
  const TSplines& splines = mesh.splines();
  for (std::int32_t node = 0; node < splines.size(); ++node) {
    if (mesh.mesh().coordinate(0, splines.nodes[at(node)][0]) != xi) continue;
    Box support;
    for (Axis axis = 0; axis < kDimension; ++axis) {
      support.lower[at(axis)] = 2 * splines.support(node, axis).lower;
      support.upper[at(axis)] = 2 * splines.support(node, axis).upper;
    }
    supports.push_back(support);
  }
  return supports;
}

}  // namespace

namespace {

/// The proof speaks of slices that cut the active region: x = xi, strictly inside of K.
bool slice_cuts_active_region(const RefinementTree& tree, std::int32_t element) {
  const ElementInfo k = describe_tree_element(tree, element);
  const int frame = (tree.setting().degree[0] + 1) / 2;
  return k.box.lower[0] >= frame && k.box.upper[0] <= tree.setting().domain[0] - frame;
}

}  // namespace

std::optional<std::int32_t> find_drawn_element(MeshUnderTest& mesh, const ProofFigure& figure) {
  const RefinementTree& tree = mesh.tree();
  const std::optional<int> margin = margin_of(tree.setting());
  if (!margin || tree.setting().grading != 2 || mesh.outside_class()) return std::nullopt;
  for (std::int32_t id = 0; id < tree.node_count(); ++id) {
    if (tree.node(id).level != kDrawnLevel || tree.is_leaf(id)) continue;
    const auto rectangle = rectangle_of(tree, id, *margin);
    if (!rectangle || !equal(*rectangle, figure.element) || !slice_cuts_active_region(tree, id)) continue;
    if (levels_as_drawn(tree, id, figure, *margin)) return id;
  }
  return std::nullopt;
}

namespace {

/// The first of the points that only one of the sets has, in units of the drawn squares.
std::optional<Place> difference(const std::set<Point2>& one, const std::set<Point2>& other, const Rational& offset,
                                int parts) {
  std::vector<Point2> points;
  std::set_symmetric_difference(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(points));
  if (points.empty()) return std::nullopt;
  return Place{(points[0][0] + offset) / parts, (points[0][1] + offset) / parts};
}

}  // namespace

FigureDifferences differences_from_figure(MeshUnderTest& mesh, std::int32_t element, const ProofFigure& figure) {
  const RefinementTree& tree = mesh.tree();
  const int margin = margin_of(tree.setting()).value();
  const auto cells = [&](const std::vector<PerAxis<RankInterval>>& environments, const Rectangle& drawn) {
    return difference(union_on_slice(tree, element, environments, margin), cells_of(drawn), Rational(1, 2), 2);
  };
  FigureDifferences result;
  result.emplace_back("patch", cells({environment_of(tree, element)}, figure.patch));
  result.emplace_back("second-order patch", cells(environments_in_patch(tree, element), figure.second_patch));
  const Quarters quarters(mesh.mesh(), margin);
  const auto sets = [&](const std::vector<Box>& boxes, const std::vector<Rectangle>& drawn) {
    return difference(quarters.seen(boxes), quarters.drawn(drawn), 0, 4);
  };
  result.emplace_back("Sigma", sets(new_supports(mesh, element), {figure.sigma}));
  const PerAxis<std::vector<Rectangle>> drawn{drawn_region_x(figure), figure.lines_y, figure.lines_z};
  for (Axis axis = 0; axis < kDimension; ++axis) {
    result.emplace_back(std::string("R") + axis_name(axis),
                        sets(perturbed_region(mesh.splines(), mesh.bricks(), axis), drawn[at(axis)]));
  }
  return result;
}

FigureItems items_of_figure(MeshUnderTest& mesh, std::int32_t element, const ProofFigure& figure) {
  FigureItems items;
  items.emplace_back("levels", mesh.admissible());
  for (const auto& [name, place] : differences_from_figure(mesh, element, figure)) items.emplace_back(name, !place);
  return items;
}

}  // namespace asts
