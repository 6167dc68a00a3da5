#include <algorithm>

#include "tests/reference/complexity_checks.hpp"
#include "tests/reference/refine.hpp"
#include "tests/reference/root_text.hpp"
#include "tests/reference/witness_elements.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

constexpr const char* too_far =
    "a child K of K_0, which the mark K' makes the algorithm subdivide, is farther from K' than the bound";
constexpr const char* too_many = "the new elements exceed C times the marks";
constexpr const char* below_1 = "the sum of lambda(K,K~) over all marks K~ is below 1";
constexpr const char* above_c = "the sum of lambda(K,K~) over all new K exceeds C";
constexpr const char* ratio = "the ratio of new elements to marks is not below the bound";

constexpr ClaimKind kinds[] = {
    {"distance-bound", "too-far", too_far, check_too_far},
    {"distance-bound-repaired", "too-far", too_far, check_too_far_repaired},
    {"complexity-bound", "too-many-elements", too_many, check_too_many_elements},
    {"lambda-sums", "sum-below-1", below_1, check_sum_below_1},
    {"lambda-sums", "sum-above-C", above_c, check_sum_above_c},
    {"lambda-sums-repaired", "sum-below-1", below_1, check_sum_below_1_repaired},
    {"lambda-sums-repaired", "sum-above-C", above_c, check_sum_above_c_repaired},
    {"experiment-constant", "ratio-not-below", ratio, check_ratio},
    {"experiment-constant-repaired", "ratio-not-below", ratio, check_ratio_repaired},
    {"experiment-constant-repaired", "other-limit", "what late steps add is not the limit stated, or not below C/2849",
     check_other_limit},
};

}  // namespace

std::span<const ClaimKind> complexity_kinds() { return kinds; }

std::vector<DistanceConstant> repaired_constants(const Setting& setting) {
  if (setting.grading > 1267) return {repaired_distance_constant};
  return {repaired_distance_constant, distance_constant};
}

namespace {

/// The mark, and an element that Algorithm 2.8 subdivides for it, one of whose children is too far away.
struct FarChild {
  const Setting& setting;
  Box mark, parent;
  std::size_t axis;
  Box child;  ///< the farthest along the axis
  Rational distance;

  FarChild(ClaimSubject& subject, const json& values) : setting(subject.setting()), axis(read_axis(values["axis"])) {
    const Mesh& mesh = subject.mesh();
    require_admissible(setting, mesh);
    const std::size_t k = position_in_mesh(setting, mesh, values["K'"], "K'");
    const std::size_t k_0 = position_in_mesh(setting, mesh, values["K_0"], "K_0");
    const std::vector<std::size_t> closure = reference::closure(setting, mesh, {k});
    if (!std::binary_search(closure.begin(), closure.end(), k_0))
      throw Rejected("K_0: Algorithm 2.8 does not subdivide " + text(mesh[k_0]) + " for the mark K'");
    mark = mesh[k];
    parent = mesh[k_0];
    distance = -1;
    for (const Box& one : children(setting, parent)) {
      const Rational between = reference::distance(one, midpoint(mark))[axis];
      if (between <= distance) continue;
      distance = between;
      child = one;
    }
  }
};

std::string check_far(ClaimSubject& subject, const json& witness, const std::vector<DistanceConstant>& constants) {
  const char* const name = "largest distance along the axis of a child of K_0 from K'";
  const json& values = values_of(witness, {"K'", "K_0", "axis", name, "bound along the axis"});
  const FarChild far(subject, values);
  const int m = far.setting.grading, child_level = level(far.setting, far.child).value();
  require_equal(read_number(values[name]), far.distance, name);
  return with_any(constants, [&](DistanceConstant d) {
    const RootSum bound = root_power(m, -child_level) * d(far.setting, static_cast<int>(far.axis));
    require_equal(read_root_sum(values["bound along the axis"], m, "the bound"), bound, "the bound");
    if (sign(bound - RootSum{m, far.distance}) >= 0)
      throw Rejected("the bound holds: " + text(far.distance) + " <= " + text(bound));
    return "The mesh is admissible, M = {K'}, K' = " + described(far.setting, far.mark) +
           ". Algorithm 2.8 subdivides K_0 = " + described(far.setting, far.parent) +
           " too. Its child K = " + text(far.child) + " is in refine(G,M) \\ G, and along " + axis_name(far.axis) +
           " its distance from K', " + text(far.distance) + ", is more than m^(-l(K)/3) d = " + text(bound) + ".";
  });
}

}  // namespace

std::string check_too_far(ClaimSubject& subject, const json& witness) {
  return check_far(subject, witness, {distance_constant});
}

std::string check_too_far_repaired(ClaimSubject& subject, const json& witness) {
  return check_far(subject, witness, repaired_constants(subject.setting()));
}

namespace {

LiteralSequence follow_to(const ClaimSubject& subject, std::size_t steps, int finest_level) {
  LiteralSequence result{SubdividedSet(subject.setting(), finest_level), {}, {}, {}};
  for (std::size_t n = 0; n < steps; ++n) {
    const LiteralStep& step = (*subject.steps())[n];
    if (!step.refine) throw Rejected("a step is a bare subdivision: the claim says nothing about the sequence");
    std::set<GridBox> marks;
    for (const Point& mark : step.marks) {
      for (std::size_t a = 0; a < dimension; ++a)
        if (mark[a] < 0 || mark[a] > subject.setting().domain[a]) throw Rejected("a mark lies outside of the domain");
      marks.insert(result.mesh.element_at(mark));
    }
    result.mesh.refine({marks.begin(), marks.end()});
    result.marks.insert(result.marks.end(), marks.begin(), marks.end());
    result.marked.push_back(marks.size());
    result.fresh.push_back(result.mesh.new_element_count());
  }
  return result;
}

}  // namespace

/// On ever finer grids, until one is fine enough.
LiteralSequence follow_literally(const ClaimSubject& subject, std::size_t steps) {
  if (subject.steps() == nullptr) throw Rejected("the claim is about sequences of steps");
  if (steps > subject.steps()->size()) throw Rejected("there are not so many steps");
  for (int finest_level = 6;; finest_level += 6) {
    try {
      return follow_to(subject, steps, finest_level);
    } catch (const TooFine&) {
    } catch (const std::overflow_error& reason) {
      throw Rejected(reason.what());
    }
  }
}

std::string check_too_many_elements(ClaimSubject& subject, const json& witness) {
  const json& values = values_of(witness, {"J", "new elements", "marks", "C times marks"});
  const std::size_t steps = read_count(values["J"], "J");
  if (steps == 0) throw Rejected("J is 0");
  const LiteralSequence sequence = follow_literally(subject, steps);
  const int m = subject.setting().grading;
  require_equal(read_count(values["marks"], "marks"), sequence.marks.size(), "the number of marks");
  require_equal(read_count(values["new elements"], "new elements"), sequence.fresh.back(),
                "the number of new elements");
  const RootSum bound = complexity_constant(subject.setting()) * Rational(sequence.marks.size());
  require_equal(read_root_sum(values["C times marks"], m, "C times marks"), bound, "C times marks");
  if (sign(bound - RootSum{m, Rational(sequence.fresh.back())}) >= 0)
    throw Rejected("the bound holds: " + std::to_string(sequence.fresh.back()) + " <= " + text(bound));
  return "After " + std::to_string(steps) + " steps with " + std::to_string(sequence.marks.size()) +
         " marks there are " + std::to_string(sequence.fresh.back()) + " new elements, more than C times the marks, " +
         text(bound) + ".";
}

}  // namespace asts::reference
