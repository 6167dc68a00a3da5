#include "properties/claims/closure_claims.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "lib/mesh/reflection.hpp"
#include "lib/refine/refinement.hpp"
#include "properties/claims/on_class.hpp"
#include "properties/describe.hpp"

namespace asts {

namespace {

Elements sorted(Elements elements) {
  std::sort(elements.begin(), elements.end());
  return elements;
}

/// The closure at fault, and an element that tells it from what it should be.
ClaimWitness wrong_closure(const RefinementTree& tree, std::string says, const Elements& marks, const Elements& closure,
                           const Elements& expected) {
  ClaimWitness witness{"wrong-closure", std::move(says), {}};
  append_elements(witness, "mark", tree, marks);
  Elements differing;
  std::set_symmetric_difference(closure.begin(), closure.end(), expected.begin(), expected.end(),
                                std::back_inserter(differing));
  const bool extra = std::binary_search(closure.begin(), closure.end(), differing.front());
  witness.values.emplace_back(extra ? "element too many" : "element missing",
                              describe_tree_element(tree, differing.front()));
  return witness;
}

/// One mesh, a function that is to be its closure, and what the closures of the mark sets are.
struct Subject {
  const RefinementTree& tree;
  const CoarserInPatches& patches;
  const ClosureOf& closure_of;

  Elements closure(const Elements& marks) const { return sorted(closure_of(tree, marks)); }
};

/// Superset, closed and least.
std::optional<Verdict> not_least(const Subject& subject, const Elements& marks, const Elements& closure) {
  const Elements least = least_closed_superset(subject.patches, marks);
  if (closure == least) return std::nullopt;
  return Verdict::violated(
      wrong_closure(subject.tree, "the closure is not the least closed superset of the marks", marks, closure, least));
}

/// The printed loop in the tree's order and backwards.
std::optional<Verdict> depends_on_order(const Subject& subject, const Elements& marks, const Elements& closure) {
  Elements order = subject.patches.leaves();
  for (int direction = 0; direction < 2; ++direction) {
    const Elements printed = closure_as_printed(subject.patches, marks, order);
    if (printed != closure) {
      return Verdict::violated(wrong_closure(
          subject.tree, "the loop of Algorithm 2.8 gives another set in another order", marks, closure, printed));
    }
    std::reverse(order.begin(), order.end());
  }
  Elements backwards = marks;
  std::reverse(backwards.begin(), backwards.end());
  const Elements other = subject.closure(backwards);
  if (other == closure) return std::nullopt;
  return Verdict::violated(
      wrong_closure(subject.tree, "the closure depends on the order of the marks", marks, closure, other));
}

/// The closure of the closure is the closure; half of the marks have a smaller one.
std::optional<Verdict> no_hull(const Subject& subject, const Elements& marks, const Elements& closure) {
  const Elements again = subject.closure(closure);
  if (again != closure) {
    return Verdict::violated(
        wrong_closure(subject.tree, "the closure of the closure is another set", marks, again, closure));
  }
  const auto half = marks.begin() + static_cast<std::ptrdiff_t>(marks.size() / 2);
  const Elements fewer = subject.closure({marks.begin(), half});
  if (std::includes(closure.begin(), closure.end(), fewer.begin(), fewer.end())) return std::nullopt;
  Elements both;
  std::set_union(closure.begin(), closure.end(), fewer.begin(), fewer.end(), std::back_inserter(both));
  return Verdict::violated(
      wrong_closure(subject.tree, "the first half of the marks has a closure that is no subset", marks, closure, both));
}

/// "x, z".
std::string names_of(const PerAxis<bool>& axes) {
  std::string names;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    if (axes[at(axis)]) names += (names.empty() ? "" : ", ") + std::string(axis_name(axis));
  }
  return names;
}

/// The closure of the mirrored marks in the mirrored mesh is the mirrored closure.
std::optional<Verdict> not_mirrored(const Subject& subject, const std::vector<Elements>& sets,
                                    const std::vector<Elements>& closures) {
  for (const PerAxis<bool>& axes : reflections()) {
    const Reflection mirror = reflect(subject.tree, axes);
    const auto image = [&](Elements elements) {
      for (std::int32_t& element : elements) element = mirror.image[at(element)];
      return elements;
    };
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const Elements closure = sorted(subject.closure_of(mirror.tree, image(sets[i])));
      const Elements expected = sorted(image(closures[i]));
      if (closure != expected) {
        ClaimWitness witness =
            wrong_closure(mirror.tree, "the mirrored marks have another closure than the mirrored one", image(sets[i]),
                          closure, expected);
        witness.values.emplace_back("mirrored along", names_of(axes));
        return Verdict::violated(std::move(witness));
      }
    }
  }
  return std::nullopt;
}

/// The mesh that subdivisions in this order make. Its elements stand in the order of the tree's hierarchy, so that
/// equal sets of elements are equal lists.
Mesh subdivided(RefinementTree tree, const Elements& order, const SubdivideOne& subdivide) {
  for (const std::int32_t element : order) {
    if (tree.is_leaf(element)) subdivide(tree, element);
  }
  tree.update_ranks();
  return mesh_of(tree);
}

bool same_elements(const Mesh& one, const Mesh& other) {
  return one.coordinates == other.coordinates && one.elements == other.elements && one.levels == other.levels;
}

/// Other orders of so many elements than the tree's: backwards, from its middle on, and every other element first.
std::vector<std::vector<std::size_t>> orders_of(std::size_t size) {
  std::vector<std::size_t> all(size);
  std::iota(all.begin(), all.end(), 0U);
  std::vector<std::vector<std::size_t>> orders(3, all);
  std::reverse(orders[0].begin(), orders[0].end());
  std::rotate(orders[1].begin(), orders[1].begin() + static_cast<std::ptrdiff_t>(size / 2), orders[1].end());
  orders[2].clear();
  for (const std::size_t start : {0U, 1U}) {
    for (std::size_t i = start; i < size; i += 2) orders[2].push_back(i);
  }
  return orders;
}

Elements in_order(const Elements& set, const std::vector<std::size_t>& order) {
  Elements result;
  for (const std::size_t i : order) result.push_back(set[i]);
  return result;
}

/// The elements in the first order, and the other order by their numbers.
Verdict wrong_order(const RefinementTree& tree, const Elements& set, const std::vector<std::size_t>& order) {
  ClaimWitness witness{"order-matters", "two orders of these subdivisions make different meshes", {}};
  append_elements(witness, "element", tree, set);
  std::vector<Rational> numbers;
  for (const std::size_t i : order) numbers.emplace_back(i + 1);
  witness.values.emplace_back("other order", numbers);
  return Verdict::violated(std::move(witness));
}

}  // namespace

Elements closure_of_marks(const RefinementTree& tree, const Elements& marks) {
  RefinementTree copy = tree;
  return mark_closure(copy, marks);
}

Trial judge_closure_least(const RefinementTree& tree, const ClosureOf& closure_of) {
  const CoarserInPatches patches(tree);
  const Subject subject{tree, patches, closure_of};
  Trial trial;
  for (const std::int32_t leaf : patches.leaves()) {
    trial.met += !patches.of(leaf).empty();
    if (auto verdict = not_least(subject, {leaf}, subject.closure({leaf}))) return {*verdict, trial.met};
  }
  const std::vector<Elements> sets = mark_sets(tree);
  std::vector<Elements> closures;
  for (const Elements& marks : sets) {
    closures.push_back(subject.closure(marks));
    for (const auto law : {not_least, depends_on_order, no_hull}) {
      if (auto verdict = law(subject, marks, closures.back())) return {*verdict, trial.met};
    }
  }
  if (auto verdict = not_mirrored(subject, sets, closures)) trial.verdict = *verdict;
  return trial;
}

Trial judge_subdivision_commutes(const RefinementTree& tree, const SubdivideOne& subdivide) {
  Trial trial;
  for (const Elements& set : mark_sets(tree)) {
    if (set.size() < 2) continue;
    ++trial.met;
    const Mesh expected = subdivided(tree, set, subdivide);
    for (const std::vector<std::size_t>& order : orders_of(set.size())) {
      if (same_elements(subdivided(tree, in_order(set, order), subdivide), expected)) continue;
      return {wrong_order(tree, set, order), trial.met};
    }
  }
  return trial;
}

Trial try_closure_least(MeshUnderTest& mesh) {
  if (auto reason = outside_class(mesh)) return {*reason};
  return judge_closure_least(mesh.tree(), closure_of_marks);
}

Trial try_subdivision_commutes(MeshUnderTest& mesh) {
  if (auto reason = outside_class(mesh)) return {*reason};
  return judge_subdivision_commutes(mesh.tree(),
                                    [](RefinementTree& tree, std::int32_t element) { tree.subdivide(element); });
}

}  // namespace asts
