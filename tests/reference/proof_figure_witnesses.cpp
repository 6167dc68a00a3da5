#include "tests/reference/proof_figure.hpp"
#include "tests/reference/skeleton_kinds.hpp"
#include "tests/reference/spline_hypotheses.hpp"
#include "tests/reference/tree.hpp"
#include "tests/reference/validate_kinds.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

constexpr const char* set_names[] = {"patch", "second-order patch", "Sigma", "Rx", "Ry", "Rz"};

/// The drawn levels are not those of an admissible mesh: the three values say why. Empty if they are not there.
std::string check_levels(ClaimSubject& subject, const json& values) {
  if (!values.contains("levels: subdivided")) return "";
  for (const char* name : {"levels: environment", "levels: coarser"})
    if (!values.contains(name)) throw Rejected(std::string("values lacks the key \"") + name + "\"");
  const json inner{{"kind", "coarser-in-patch"},
                   {"element", values["levels: subdivided"]},
                   {"environment", values["levels: environment"]},
                   {"coarser", values["levels: coarser"]}};
  return " " + validate_coarser_in_patch(subject.setting(), subject.mesh(), inner);
}

std::string check_set(const DrawnProofFigure& drawn, const ProofFigureMesh& f, const json& values, const char* name) {
  if (!values.contains(name)) return "";
  const std::vector<Rational> numbers = read_numbers(values[name]);
  if (numbers.size() != 2) throw Rejected(std::string(name) + ": it is no place (y,z)");
  const std::array<Rational, 2> place{numbers[0], numbers[1]};
  if (!comparable(f, name, place))
    throw Rejected(std::string(name) + ": the place is not in the drawn squares, or not in the active region");
  const bool found = in_set(found_set(f, name), place), is_drawn = in_set(drawn.sets.at(name), place);
  if (found == is_drawn)
    throw Rejected(std::string(name) + ": nothing is violated at " + text(numbers) + ", which both figure and mesh " +
                   (found ? "have" : "lack"));
  return std::string(" ") + name + ": " + text(numbers) +
         (found ? " is in it and is not drawn." : " is drawn and not in it.");
}

std::string check_figure(ClaimSubject& subject, const json& witness, const DrawnProofFigure& drawn) {
  const json& values = witness.at("values");
  if (!values.is_object() || !values.contains("K")) throw Rejected("values is no object with an element K");
  const ElementText k = read_element(values["K"], "K");
  if (k.level != 3) throw Rejected("K: its level is 3");
  const ProofFigureMesh f = proof_figure_mesh(drawn, subject.setting(), subject.mesh(), k.box);
  std::size_t known = 1;
  std::string conclusion = check_levels(subject, values);
  if (!conclusion.empty()) known += 3;
  for (const char* name : set_names) {
    const std::string sentence = check_set(drawn, f, values, name);
    if (!sentence.empty()) ++known;
    conclusion += sentence;
  }
  if (known != values.size()) throw Rejected("values has a key that is none of its kind");
  if (known == 1) throw Rejected("nothing is said to be other than drawn");
  return "Hypothesis: on the slice x = " + text(f.xi) + " through the middle of K = " + text(f.k) +
         " the elements have the drawn levels, for p = (" + std::to_string(f.setting.degree[0]) + "," +
         std::to_string(f.setting.degree[1]) + "," + std::to_string(f.setting.degree[2]) +
         "), m = 2; the drawn squares begin at " + std::to_string(f.margin) + ". Conclusion:" + conclusion;
}

/// For which degrees an item is as drawn, as the witness writes them.
std::string fitting(const DrawnProofFigure& drawn, const std::vector<ProofFigureMesh>& meshes,
                    const std::string& item) {
  std::string result;
  for (const ProofFigureMesh& f : meshes) {
    const bool fits = item == "levels" ? admissible_mesh(f.setting, f.mesh, refinement_tree(f.setting, f.mesh))
                                       : same_sets(f, item, drawn.sets.at(item));
    if (fits) result += " (" + std::to_string(f.setting.degree[1]) + "," + std::to_string(f.setting.degree[2]) + ")";
  }
  return result.empty() ? "none" : result.substr(1);
}

/// An element of the patch of K, for p = (3,3,3), that is coarser than K: U(K) grows with the degrees, so that the
/// subdivision of K is admissible for no odd degrees.
std::string coarser_for_all_degrees(const ProofFigureMesh& f) {
  for (const std::size_t position : patch(f.setting, f.mesh, f.k))
    if (level(f.setting, f.mesh[position]).value() < 3)
      return text(f.mesh[position]) + " of level " + std::to_string(level(f.setting, f.mesh[position]).value());
  throw Rejected("nothing is violated: no element of the patch of K is coarser than K for p = (3,3,3)");
}

}  // namespace

std::string check_proof_figure(ClaimSubject& subject, const json& witness) {
  return check_figure(subject, witness, printed_proof_figure());
}

std::string check_proof_figure_repaired(ClaimSubject& subject, const json& witness) {
  if (subject.setting().degree != std::array<int, dimension>{3, 3, 3})
    throw Rejected("the degree is not (3,3,3): the claim says nothing about the mesh");
  return check_figure(subject, witness, repaired_proof_figure());
}

std::string check_no_degree(ClaimSubject& /*subject*/, const json& witness) {
  const json& values =
      values_of(witness, {"tried to", "levels", "patch", "second-order patch", "Sigma", "Rx", "Ry", "Rz"});
  const std::size_t last = read_count(values["tried to"], "tried to");
  if (last < 3 || last > 9) throw Rejected("tried to: only degrees from 3 to 9 are tried again");
  const DrawnProofFigure drawn = printed_proof_figure();
  std::vector<ProofFigureMesh> meshes;
  for (int p2 = 3; p2 <= static_cast<int>(last); p2 += 2)
    for (int p3 = 3; p3 <= static_cast<int>(last); p3 += 2) meshes.push_back(make_proof_figure_mesh(drawn, p2, p3));
  const std::string coarser = coarser_for_all_degrees(meshes.front());
  std::string rows;
  for (const char* item : {"levels", "patch", "second-order patch", "Sigma", "Rx", "Ry", "Rz"}) {
    const std::string degrees = fitting(drawn, meshes, item);
    if (values[item] != degrees) throw Rejected(std::string(item) + ": as drawn for " + degrees);
    rows += std::string(" ") + item + ": " + degrees + ";";
  }
  return "The patch of K has for p = (3,3,3) " + coarser +
         ", and U(K) grows with the degrees: the levels are those of an "
         "admissible mesh for no odd degrees p2, p3 >= 3. As drawn, for the degrees up to " +
         std::to_string(last) + ":" + rows;
}

}  // namespace asts::reference
