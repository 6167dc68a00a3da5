#include "properties/mesh_under_test.hpp"

#include <algorithm>

#include "lib/refine/admissibility.hpp"

namespace asts {

namespace {

bool is_unit_cube(const Mesh& mesh, const Box& box) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const Rational& lower = mesh.coordinate(axis, box.lower[at(axis)]);
    const Rational& upper = mesh.coordinate(axis, box.upper[at(axis)]);
    if (boost::multiprecision::denominator(lower) != 1 || upper - lower != 1) return false;
  }
  return true;
}

}  // namespace

MeshUnderTest::MeshUnderTest(const RefinementTree& tree) : mesh_(mesh_of(tree)), tree_(&tree) {}

MeshUnderTest::MeshUnderTest(Mesh mesh)
    : mesh_(std::move(mesh)), recognised_(std::make_unique<RecognisedTree>(recognise(mesh_))) {
  tree_ = &recognised_->tree;
}

std::optional<std::int32_t> MeshUnderTest::outside_class() const {
  if (!recognised_) return std::nullopt;
  const auto& nodes = recognised_->node_of_element;
  const auto outside = std::find(nodes.begin(), nodes.end(), RefinementTree::kNone);
  if (outside == nodes.end()) return std::nullopt;
  return static_cast<std::int32_t>(outside - nodes.begin());
}

bool MeshUnderTest::admissible() {
  if (!admissible_) admissible_ = !outside_class() && !find_inadmissible(*tree_);
  return *admissible_;
}

std::vector<std::int32_t> MeshUnderTest::tree_elements() const {
  std::vector<bool> belongs(at(tree_->node_count()), !recognised_);
  if (recognised_) {
    for (std::int32_t id : recognised_->node_of_element) {
      for (; id != RefinementTree::kNone && !belongs[at(id)]; id = tree_->node(id).parent) belongs[at(id)] = true;
    }
  }
  std::vector<std::int32_t> result;
  for (std::int32_t id = 0; id < tree_->node_count(); ++id) {
    if (belongs[at(id)] && tree_->node(id).level >= 0) result.push_back(id);
  }
  return result;
}

const TSplines& MeshUnderTest::splines() {
  if (!splines_) splines_ = tsplines_of(mesh_);
  return *splines_;
}

const Bricks& MeshUnderTest::bricks() {
  if (!bricks_) bricks_ = bricks_of(splines(), pair_budget);
  return *bricks_;
}

const PerturbedRegions& MeshUnderTest::perturbed_regions() {
  if (!perturbed_regions_) perturbed_regions_ = asts::perturbed_regions(bricks(), splines().region);
  return *perturbed_regions_;
}

const std::optional<RegionsMeet>& MeshUnderTest::meeting_regions() {
  if (!meeting_regions_) meeting_regions_.emplace(find_meeting(perturbed_regions()));
  return *meeting_regions_;
}

const std::optional<NodePair>& MeshUnderTest::incompatible() {
  if (!incompatible_) incompatible_.emplace(find_incompatible(splines(), bricks()));
  return *incompatible_;
}

const DualBasisFailures& MeshUnderTest::dual_failures() {
  if (!dual_failures_) dual_failures_ = find_dual_failures(mesh_, splines(), bricks());
  return *dual_failures_;
}

std::int64_t MeshUnderTest::new_elements() const {
  if (!recognised_) return tree_->new_element_count();
  return std::count_if(mesh_.elements.begin(), mesh_.elements.end(),
                       [&](const Box& box) { return !is_unit_cube(mesh_, box); });
}

std::optional<std::int32_t> MeshUnderTest::max_level() const {
  const auto highest = std::max_element(mesh_.levels.begin(), mesh_.levels.end());
  if (highest == mesh_.levels.end() || *highest == Mesh::kNoLevel) return std::nullopt;
  return *highest;
}

}  // namespace asts
