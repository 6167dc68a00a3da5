#pragma once

#include "lib/minimize/case_size.hpp"
#include "lib/minimize/oracle.hpp"
#include "lib/minimize/path_case.hpp"

namespace asts {

/// What of a case of steps a predicate looks at.
enum class PathForm {
  mesh,      ///< the last mesh alone
  sequence,  ///< the steps
};

/// REQUIRES: a mesh.
CaseSize size_of_mesh(const PathCase& mesh);

/// A case of steps on its way down: the current one violates, and only smaller ones that violate replace it.
class PathSearch {
 public:
  /// REQUIRES: the oracle says that the case violates.
  PathSearch(Oracle& oracle, PathForm form, const PathCase& start);

  PathForm form() const { return form_; }
  Oracle& oracle() const { return oracle_; }
  const PathCase& current() const { return current_.paths; }
  const CaseSize& size() const { return current_.size; }
  const Case& written() const { return current_.written; }

  /// Brings a changed case into its form; if that is smaller than the current one and violates, it becomes the current
  /// one. Cost: one evaluation, none when it is not smaller or was asked before.
  bool propose(const PathCase& candidate);
  /// The same for a case of any size.
  bool move_to(const PathCase& candidate);
  /// Takes another search's case if it is smaller.
  bool adopt(const PathSearch& other);

 private:
  struct State {
    PathCase paths;
    Case written;
    CaseSize size;
  };

  std::optional<State> state_of(const PathCase& candidate) const;
  bool precedes_current(const State& state) const;

  Oracle& oracle_;
  PathForm form_;
  State current_;
};

}  // namespace asts
