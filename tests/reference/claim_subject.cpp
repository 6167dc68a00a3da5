#include "tests/reference/claim_subject.hpp"

#include <algorithm>

#include "tests/reference/lambda_chain.hpp"
#include "tests/reference/refine.hpp"
#include "tests/reference/witness_json.hpp"

namespace asts::reference {

ClaimSubject::ClaimSubject(const Setting& setting, std::vector<LiteralStep> steps)
    : setting_(setting), steps_(std::move(steps)) {}

ClaimSubject::ClaimSubject(const Setting& setting, Mesh explicit_mesh)
    : setting_(setting), mesh_(std::move(explicit_mesh)) {}

ClaimSubject ClaimSubject::none() { return {}; }

const Mesh& ClaimSubject::mesh() {
  if (is_none()) throw Rejected("there is no mesh");
  if (!mesh_) {
    mesh_ = initial_mesh(setting_);
    for (const LiteralStep& step : *steps_) mesh_ = after_step(setting_, *mesh_, step);
  }
  if (!tiles_ && !tiles_domain(setting_, *mesh_)) throw Rejected("the mesh does not tile the domain");
  tiles_ = true;
  return *mesh_;
}

std::optional<std::size_t> ClaimSubject::element_count() {
  const bool refines_only =
      steps_ && std::all_of(steps_->begin(), steps_->end(), [](const LiteralStep& step) { return step.refine; });
  return refines_only ? count_by_subdivisions() : std::optional(mesh().size());
}

/// Few levels are tried first: the grid of many would not fit into whole numbers when m is large.
std::optional<std::size_t> ClaimSubject::count_by_subdivisions() const {
  constexpr std::size_t few_levels = 12;
  for (const std::size_t levels : {std::min(steps_->size() + 1, few_levels), steps_->size() + 1}) {
    try {
      return count_on_grid(static_cast<int>(levels));
    } catch (const TooFine&) {
      continue;
    } catch (const std::overflow_error&) {
      continue;
    }
  }
  return std::nullopt;
}

/// A subdivision puts m elements in the place of one.
std::size_t ClaimSubject::count_on_grid(int finest_level) const {
  SubdividedSet subdivided(setting_, finest_level);
  for (const LiteralStep& step : *steps_) {
    std::vector<GridBox> marks;
    for (const Point& mark : step.marks) marks.push_back(subdivided.element_at(mark));
    subdivided.refine(marks);
  }
  std::size_t cubes = 1;
  for (const int side : setting_.domain) cubes *= static_cast<std::size_t>(side);
  return cubes + subdivided.size() * static_cast<std::size_t>(setting_.grading - 1);
}

Mesh after_step(const Setting& setting, const Mesh& mesh, const LiteralStep& step) {
  std::vector<std::size_t> marked;
  for (const Point& mark : step.marks) {
    const auto element = element_at(setting, mesh, mark);
    if (!element) throw Rejected("a mark lies outside of the domain");
    marked.push_back(*element);
  }
  return step.refine ? refine(setting, mesh, marked) : subdivide(setting, mesh, marked);
}

}  // namespace asts::reference
