#include "tests/reference/claim_subject.hpp"

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
