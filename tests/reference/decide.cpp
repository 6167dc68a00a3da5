#include "tests/reference/decide.hpp"

#include <stdexcept>
#include <string>

#include "tests/reference/tree.hpp"

namespace asts::reference {

namespace {

Verdict verdict(bool holds) { return holds ? Verdict::holds : Verdict::violated; }

template <class T>
Verdicts decide_splines(const Setting& setting, const Mesh& mesh, Grid scale, Verdicts verdicts) {
  const Space<T> space = make_space<T>(setting, mesh, scale);
  const auto splines = active_splines(space);
  if (!splines || splines->empty()) return verdicts;
  verdicts.analysis_suitable = verdict(!perturbed_regions_meet(space, *splines));
  verdicts.dual_compatible = verdict(!not_dual_compatible(*splines));
  verdicts.dual_basis = verdict(count_dual_failures(setting.degree, *splines, true).failures == 0);
  return verdicts;
}

Verdicts decide_tree(const Setting& setting, const Mesh& mesh) {
  const RefinementTree tree = refinement_tree(setting, mesh);
  Verdicts verdicts{verdict(admissible_mesh(setting, mesh, tree)), Verdict::not_applicable, Verdict::not_applicable,
                    Verdict::not_applicable, Verdict::not_applicable};
  if (!tree.elements.empty()) verdicts.nested_patches = verdict(!patches_not_nested(setting, mesh, tree));
  return verdicts;
}

}  // namespace

const char* verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::violated:
      return "violated";
    default:
      return "not-applicable";
  }
}

Verdict verdict_on(const Verdicts& verdicts, std::string_view property) {
  if (property == "admissible") return verdicts.admissible;
  if (property == "nested-patches") return verdicts.nested_patches;
  if (property == "analysis-suitable") return verdicts.analysis_suitable;
  if (property == "dual-compatible") return verdicts.dual_compatible;
  if (property == "dual-basis") return verdicts.dual_basis;
  throw std::invalid_argument("no property of the five: " + std::string(property));
}

Verdicts decide(const Setting& setting, const Mesh& mesh) {
  const Verdicts verdicts = decide_tree(setting, mesh);
  if (const auto scale = grid_scale(setting, mesh)) return decide_splines<Grid>(setting, mesh, *scale, verdicts);
  return decide_splines<Rational>(setting, mesh, 1, verdicts);
}

Verdicts decide_with_rationals(const Setting& setting, const Mesh& mesh) {
  return decide_splines<Rational>(setting, mesh, 1, decide_tree(setting, mesh));
}

}  // namespace asts::reference
