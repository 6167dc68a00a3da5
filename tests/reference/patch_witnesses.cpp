#include <algorithm>

#include "tests/reference/refine.hpp"
#include "tests/reference/refinement_checks.hpp"
#include "tests/reference/refinement_claims.hpp"
#include "tests/reference/validate_kinds.hpp"
#include "tests/reference/witness_elements.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

/// An element of the tree, or of the two generations below an element of the mesh.
Box read_descendant(const Setting& setting, const Mesh& mesh, const json& value, const std::string& what) {
  const ElementText element = read_element(value, what);
  check_level(setting, element, what);
  const auto near = [&](const Box& leaf) {
    return contains(element.box, leaf) ||
           (contains(leaf, element.box) && *element.level <= level(setting, leaf).value() + 2);
  };
  if (!in_class(setting, element.box) || !std::any_of(mesh.begin(), mesh.end(), near))
    throw Rejected(what + ": " + text(element.box) + " is neither in the refinement tree nor two generations below it");
  return element.box;
}

}  // namespace

std::string check_patch_not_nested(ClaimSubject& subject, const json& witness) {
  const Setting& setting = subject.setting();
  require_keys(witness, {"kind", "inner", "outer", "element"}, "the witness");
  require_class(setting, subject.mesh());
  const Box k = read_descendant(setting, subject.mesh(), witness["inner"], "inner");
  const Box l = read_descendant(setting, subject.mesh(), witness["outer"], "outer");
  const Box c = element_of_mesh(setting, subject.mesh(), witness["element"], "element").box;
  if (!contains(l, k)) throw Rejected("inner does not lie in outer");
  const Box inner = environment(setting, k), outer = environment(setting, l);
  if (!closed_meets_open(c, inner)) throw Rejected("the element is not in the patch of inner: U(K) is " + text(inner));
  if (closed_meets_open(c, outer)) throw Rejected("the element is in the patch of outer: U(K^) is " + text(outer));
  return "K = " + described(setting, k) + " lies in K^ = " + described(setting, l) + ". " + text(c) +
         " meets U(K) = " + text(inner) + " and not U(K^) = " + text(outer) + " (both open), against Lemma 3.4.";
}

namespace {

/// What the two claims with witnesses of the kind coarser-in-patch have in common: K with U(K), and C that meets it.
struct CoarserInPatch {
  Box k, environment, coarser;
  int k_level, coarser_level;

  CoarserInPatch(const Setting& setting, const Mesh& mesh, const json& witness) {
    require_keys(witness, {"kind", "element", "environment", "coarser"}, "the witness");
    k = element_of_mesh(setting, mesh, witness["element"], "element").box;
    coarser = element_of_mesh(setting, mesh, witness["coarser"], "coarser").box;
    environment = reference::environment(setting, k);
    if (!(read_box(witness["environment"], "environment") == environment))
      throw Rejected("environment: U(K) within the domain is " + text(environment));
    if (!closed_meets_open(coarser, environment)) throw Rejected("coarser: it does not meet the open environment");
    k_level = level(setting, k).value();
    coarser_level = level(setting, coarser).value();
  }

  std::string sentence(const Setting& setting) const {
    return "K = " + described(setting, k) + " has C = " + described(setting, coarser) +
           " in its patch: C meets U(K) = " + text(environment) + " (open).";
  }
};

}  // namespace

std::string check_levels_change(ClaimSubject& subject, const json& witness) {
  const Setting& setting = subject.setting();
  require_admissible(setting, subject.mesh());
  const CoarserInPatch found(setting, subject.mesh(), witness);
  if (found.coarser_level >= found.k_level - 1)
    throw Rejected("level(C) = " + std::to_string(found.coarser_level) +
                   " >= level(K) - 1 = " + std::to_string(found.k_level - 1));
  return "The mesh is admissible. " + found.sentence(setting) + " level(C) = " + std::to_string(found.coarser_level) +
         " < level(K) - 1 = " + std::to_string(found.k_level - 1) + ", against Lemma 3.5.";
}

std::string check_level_order(ClaimSubject& subject, const json& witness) {
  const Setting& setting = subject.setting();
  require_admissible(setting, subject.mesh());
  require_keys(witness, {"kind", "element", "environment", "coarser"}, "the witness");
  const Box element = read_element(witness["element"], "element").box;
  Mesh current = initial_mesh(setting);
  for (const Box& k : inner_by_level(setting, subject.mesh())) {
    if (k == element) {
      const CoarserInPatch found(setting, current, witness);
      if (found.coarser_level >= found.k_level)
        throw Rejected("coarser: its level is not lower than " + std::to_string(found.k_level));
      return "The mesh is admissible. When everything of lower levels is subdivided, " + found.sentence(setting) +
             " level(C) = " + std::to_string(found.coarser_level) + " < level(K) = " + std::to_string(found.k_level) +
             ": the subdivision of K is not admissible.";
    }
    const auto position = std::find(current.begin(), current.end(), k) - current.begin();
    current = subdivide(setting, current, {static_cast<std::size_t>(position)});
  }
  throw Rejected("element: " + text(element) + " is not subdivided on the way to the mesh");
}

std::string check_refine_subdivides_others(ClaimSubject& subject, const json& witness) {
  const Setting& setting = subject.setting();
  const json& values = values_of(witness, {"element", "elements before", "elements after", "grading"});
  require_admissible(setting, subject.mesh());
  require_equal(read_count(values["grading"], "grading"), static_cast<std::size_t>(setting.grading), "the grading");
  const ElementText element = read_element(values["element"], "element");
  check_level(setting, element, "element");
  Mesh current = initial_mesh(setting);
  for (const Box& k : inner_by_level(setting, subject.mesh())) {
    const auto position = static_cast<std::size_t>(std::find(current.begin(), current.end(), k) - current.begin());
    const std::size_t before = current.size();
    const bool subdivided = position == before;
    const Mesh refined = subdivided ? current : refine(setting, current, {position});
    const bool alone = !subdivided && refined == subdivide(setting, current, {position});
    if (k == element.box) {
      require_equal(read_count(values["elements before"], "elements before"), before, "elements before");
      require_equal(read_count(values["elements after"], "elements after"), refined.size(), "elements after");
      if (alone)
        throw Rejected("the call of refine subdivides the element alone: " + std::to_string(refined.size()) +
                       " elements after it, " + std::to_string(before) +
                       " before, m = " + std::to_string(setting.grading));
      return "The mesh is admissible. The call of refine for " + text(k) + " makes " + std::to_string(refined.size()) +
             " elements out of " + std::to_string(before) + ", not m - 1 = " + std::to_string(setting.grading - 1) +
             " more.";
    }
    if (!alone) throw Rejected("an element before it is not subdivided alone: " + text(k));
    current = refined;
  }
  throw Rejected("element: " + text(element.box) + " is not subdivided on the way to the mesh");
}

namespace {

/// The marks of a witness, as positions in the mesh.
std::vector<std::size_t> read_marks(ClaimSubject& subject, const json& values) {
  std::vector<std::size_t> marks;
  for (const json& mark : numbered(values, "mark"))
    marks.push_back(position_in_mesh(subject.setting(), subject.mesh(), mark, "mark"));
  return marks;
}

}  // namespace

std::string check_refined_not_admissible(ClaimSubject& subject, const json& witness) {
  const Setting& setting = subject.setting();
  const json& values = values_with_lists(witness, {"element", "environment", "coarser"}, {"mark"});
  require_admissible(setting, subject.mesh());
  const Mesh refined = refine(setting, subject.mesh(), read_marks(subject, values));
  return "The mesh is admissible. In the mesh that refine makes: " +
         validate_coarser_in_patch(setting, refined,
                                   {{"kind", "coarser-in-patch"},
                                    {"element", values["element"]},
                                    {"environment", values["environment"]},
                                    {"coarser", values["coarser"]}});
}

/// Subdividing an element never takes the admissibility of another's subdivision away (see admissible_mesh), so that
/// one run decides for all orders.
std::string check_subdivision_not_admissible(ClaimSubject& subject, const json& witness) {
  const Setting& setting = subject.setting();
  const json& values = values_with_lists(witness, {}, {"mark"});
  require_admissible(setting, subject.mesh());
  Mesh current = subject.mesh(), pending;
  for (const std::size_t k : closure(setting, current, read_marks(subject, values))) pending.push_back(current[k]);
  const std::size_t all = pending.size();
  for (bool progress = true; progress;) {
    progress = false;
    for (std::size_t i = 0; i < pending.size(); ++i) {
      const auto position = std::find(current.begin(), current.end(), pending[i]) - current.begin();
      if (!admissible_subdivision(setting, current, static_cast<std::size_t>(position))) continue;
      current = subdivide(setting, current, {static_cast<std::size_t>(position)});
      pending.erase(pending.begin() + static_cast<std::ptrdiff_t>(i--));
      progress = true;
    }
  }
  if (pending.empty())
    throw Rejected("there is an order: each of the " + std::to_string(all) +
                   " subdivisions of the closure is admissible");
  return "The mesh is admissible. Of the " + std::to_string(all) + " elements of the closure, " +
         std::to_string(pending.size()) + " always have a coarser one in their patches, " +
         described(setting, pending.front()) + " among them.";
}

}  // namespace asts::reference
