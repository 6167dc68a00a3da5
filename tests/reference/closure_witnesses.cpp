#include <algorithm>
#include <numeric>

#include "tests/reference/overlay.hpp"
#include "tests/reference/refinement_checks.hpp"
#include "tests/reference/refinement_claims.hpp"
#include "tests/reference/witness_elements.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

using Positions = std::vector<std::size_t>;

bool has(const Positions& set, std::size_t element) { return std::find(set.begin(), set.end(), element) != set.end(); }

/// Algorithm 2.8 as printed, its loops over the elements in this order.
Positions printed_loop(const Patches& patches, const Positions& marks, const Positions& order) {
  std::vector<bool> marked(patches.of.size(), false);
  for (const std::size_t mark : marks) marked[mark] = true;
  for (bool grew = true; grew;) {
    grew = false;
    for (const std::size_t k : order) {
      if (!marked[k]) continue;
      for (const std::size_t other : patches.coarser[k]) {
        grew = grew || !marked[other];
        marked[other] = true;
      }
    }
  }
  Positions result;
  for (std::size_t k = 0; k < marked.size(); ++k)
    if (marked[k]) result.push_back(k);
  return result;
}

Positions mesh_order(const Patches& patches) {
  Positions order(patches.of.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

Positions closure_of(const Patches& patches, const Positions& marks) {
  return printed_loop(patches, marks, mesh_order(patches));
}

/// The same by following each mark in turn.
Positions closure_mark_by_mark(const Patches& patches, Positions marks) {
  Positions pending = std::move(marks), result;
  for (std::size_t done = 0; done < pending.size(); ++done) {
    if (has(result, pending[done])) continue;
    result.push_back(pending[done]);
    for (const std::size_t other : patches.coarser[pending[done]]) pending.push_back(other);
  }
  return result;
}

/// What all witnesses of a wrong closure have.
struct WrongClosure {
  const Setting& setting;
  Mesh mesh;
  Patches all;
  Positions marks;
  std::size_t element;
  bool too_many;  ///< else missing

  WrongClosure(const Setting& s, Mesh of, const json& values) : setting(s), mesh(std::move(of)) {
    require_class(setting, mesh);
    all = patches(setting, mesh);
    for (const json& mark : numbered(values, "mark")) marks.push_back(position_in_mesh(setting, mesh, mark, "mark"));
    too_many = values.contains("element too many");
    const char* name = too_many ? "element too many" : "element missing";
    element = position_in_mesh(setting, mesh, values[name], name);
  }

  /// The element must be in exactly one of the two sets: the first, when it is said to be too many in it.
  std::string compared(bool in_first, const std::string& first, bool in_second, const std::string& second) const {
    const std::string box = described(setting, mesh[element]);
    if (in_first == in_second)
      throw Rejected(box + " is in " + (in_first ? "both " : "neither ") + first + (in_first ? " and " : " nor ") +
                     second);
    if (in_first != too_many) throw Rejected(box + " is in " + (in_first ? first : second) + " alone");
    return "For the " + std::to_string(marks.size()) + " marks, " + box + " is in " + (in_first ? first : second) +
           " and not in " + (in_first ? second : first) + ".";
  }
};

const json& closure_values(const json& witness, bool mirrored = false) {
  const json& values = witness.at("values");
  const char* name = values.is_object() && values.contains("element too many") ? "element too many" : "element missing";
  return mirrored ? values_with_lists(witness, {name, "mirrored along"}, {"mark"})
                  : values_with_lists(witness, {name}, {"mark"});
}

}  // namespace

std::string check_closure_not_least(ClaimSubject& subject, const json& witness) {
  const WrongClosure wrong(subject.setting(), subject.mesh(), closure_values(witness));
  return wrong.compared(has(closure_of(wrong.all, wrong.marks), wrong.element), "the closure of Algorithm 2.8",
                        in_every_closed_superset(wrong.all, wrong.marks, wrong.element),
                        "the least closed superset of the marks");
}

std::string check_closure_depends_on_loop(ClaimSubject& subject, const json& witness) {
  const WrongClosure wrong(subject.setting(), subject.mesh(), closure_values(witness));
  Positions backwards = mesh_order(wrong.all);
  std::reverse(backwards.begin(), backwards.end());
  return wrong.compared(has(closure_of(wrong.all, wrong.marks), wrong.element), "the result of the loop in one order",
                        has(printed_loop(wrong.all, wrong.marks, backwards), wrong.element),
                        "its result in the opposite order");
}

std::string check_closure_depends_on_marks(ClaimSubject& subject, const json& witness) {
  const WrongClosure wrong(subject.setting(), subject.mesh(), closure_values(witness));
  const Positions backwards(wrong.marks.rbegin(), wrong.marks.rend());
  return wrong.compared(has(closure_mark_by_mark(wrong.all, wrong.marks), wrong.element), "the closure of the marks",
                        has(closure_mark_by_mark(wrong.all, backwards), wrong.element),
                        "the closure of the marks in the opposite order");
}

std::string check_closure_not_idempotent(ClaimSubject& subject, const json& witness) {
  const WrongClosure wrong(subject.setting(), subject.mesh(), closure_values(witness));
  const Positions once = closure_of(wrong.all, wrong.marks);
  return wrong.compared(has(closure_of(wrong.all, once), wrong.element), "the closure of the closure",
                        has(once, wrong.element), "the closure");
}

std::string check_closure_not_monotone(ClaimSubject& subject, const json& witness) {
  const WrongClosure wrong(subject.setting(), subject.mesh(), closure_values(witness));
  const auto half = wrong.marks.begin() + static_cast<std::ptrdiff_t>(wrong.marks.size() / 2);
  if (wrong.too_many) throw Rejected("the closure of half of the marks can only have an element that is missing");
  return wrong.compared(has(closure_of(wrong.all, wrong.marks), wrong.element), "the closure of the marks",
                        has(closure_of(wrong.all, {wrong.marks.begin(), half}), wrong.element),
                        "the closure of their first half");
}

namespace {

/// "x, z" as axes.
std::array<bool, dimension> read_axes(const json& value) {
  for (unsigned bits = 1; bits < 8; ++bits) {
    std::array<bool, dimension> axes{};
    std::string names;
    for (std::size_t a = 0; a < dimension; ++a) {
      axes[a] = (bits >> a & 1U) != 0;
      if (axes[a]) names += (names.empty() ? "" : ", ") + std::string(axis_name(a));
    }
    if (value == names) return axes;
  }
  throw Rejected("mirrored along: no set of axes");
}

}  // namespace

std::string check_closure_not_mirrored(ClaimSubject& subject, const json& witness) {
  const Setting& setting = subject.setting();
  const json& values = closure_values(witness, true);
  const std::array<bool, dimension> axes = read_axes(values["mirrored along"]);
  const WrongClosure wrong(setting, mirrored(setting, subject.mesh(), axes), values);
  const Patches original = patches(setting, subject.mesh());
  const auto image = [&](std::size_t position) {
    const Box box = mirrored(setting, {wrong.mesh[position]}, axes).front();
    return static_cast<std::size_t>(std::find(subject.mesh().begin(), subject.mesh().end(), box) -
                                    subject.mesh().begin());
  };
  Positions marks;
  for (const std::size_t mark : wrong.marks) marks.push_back(image(mark));
  return wrong.compared(has(closure_of(wrong.all, wrong.marks), wrong.element), "the closure of the mirrored marks",
                        has(closure_of(original, marks), image(wrong.element)), "the mirrored closure");
}

namespace {

/// The subdivisions of these elements one after the other, sorted.
Mesh one_by_one(const Setting& setting, Mesh mesh, const Mesh& elements) {
  for (const Box& element : elements) {
    const auto position = std::find(mesh.begin(), mesh.end(), element) - mesh.begin();
    mesh = subdivide(setting, mesh, {static_cast<std::size_t>(position)});
  }
  std::sort(mesh.begin(), mesh.end());
  return mesh;
}

/// The numbers 1, ..., n in some order, from 0.
Positions read_order(const json& value, std::size_t size) {
  Positions order;
  for (const Rational& number : read_numbers(value))
    for (std::size_t i = 0; i < size; ++i)
      if (number == Rational(i + 1) && !has(order, i)) order.push_back(i);
  if (order.size() != size || value.size() != size)
    throw Rejected("other order: not the numbers from 1 to " + std::to_string(size));
  return order;
}

}  // namespace

std::string check_order_matters(ClaimSubject& subject, const json& witness) {
  const Setting& setting = subject.setting();
  const json& values = values_with_lists(witness, {"other order"}, {"element"});
  require_class(setting, subject.mesh());
  Mesh elements, reordered;
  for (const json& value : numbered(values, "element")) {
    elements.push_back(element_of_mesh(setting, subject.mesh(), value, "element").box);
    if (std::count(elements.begin(), elements.end(), elements.back()) > 1) throw Rejected("an element is there twice");
  }
  for (const std::size_t i : read_order(values["other order"], elements.size())) reordered.push_back(elements[i]);
  const Mesh one = one_by_one(setting, subject.mesh(), elements),
             other = one_by_one(setting, subject.mesh(), reordered);
  if (one == other)
    throw Rejected("both orders of the " + std::to_string(elements.size()) + " subdivisions make the same mesh of " +
                   std::to_string(one.size()) + " elements");
  return "The two orders make different meshes, of " + std::to_string(one.size()) + " and " +
         std::to_string(other.size()) + " elements.";
}

}  // namespace asts::reference
