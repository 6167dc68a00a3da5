#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "lib/gen/enumerate.hpp"
#include "lib/minimize/case_size.hpp"

namespace asts {

/// A finite scope: every mesh that at most `subdivisions` subdivisions make, on every domain of at most `volume` unit
/// cubes, with every odd degree from 3 to `degree` along each axis and every m from 2 to `grading`.
struct Scope {
  int subdivisions = 0;
  std::int64_t volume = 0;
  int degree = 3;
  int grading = 2;
};

/// "every mesh of at most 2 subdivisions on domains of at most 80 cubes, degrees 3 to 5, m = 2 to 3".
std::string scope_text(const Scope& scope);

/// Whether no mesh of a setting can violate, so that none need be tried.
using Excluded = std::function<bool(const Setting& setting)>;

/// How many meshes that are, of settings that are not excluded: the sum of n/(n+mj) binomial(n+mj, j) over settings
/// with n cubes and j = 0, ..., subdivisions. Nothing beyond `limit`. Cost: linear in the settings.
std::optional<std::int64_t> count_meshes(const Scope& scope, const Excluded& excluded, std::int64_t limit);

/// The largest scope of a fixed list around a mesh of this size that has at most `limit` meshes. Those at the head of
/// the list contain every smaller mesh of their settings; then it is `complete`. Behind them come scopes with fewer
/// subdivisions, of at most a tenth of that.
struct ChosenScope {
  Scope scope;
  bool complete = false;
};
std::optional<ChosenScope> choose_scope(const Case& smallest, const CaseSize& size, const Excluded& excluded,
                                        std::int64_t limit);

/// Decides the meshes of one enumeration, in its order.
using MeshTrial = std::function<bool(const EnumeratedMesh& mesh)>;

/// Searches a scope for a violating mesh that is smaller than a case; gives the smallest. `new_trial` makes what
/// decides the meshes of a setting. With `up_to_reflection` one mesh is tried for all its reflections.
struct Exhausted {
  std::int64_t meshes = 0;     ///< distinct meshes tried, reflections counted
  std::int64_t excluded = 0;   ///< settings of the scope of which none was tried
  std::int64_t violating = 0;  ///< of the meshes tried
  std::optional<Case> smaller;
};
Exhausted exhaust(const Scope& scope, const Case& smallest, const CaseSize& size, bool up_to_reflection,
                  const Excluded& excluded, const std::function<MeshTrial()>& new_trial);

}  // namespace asts
