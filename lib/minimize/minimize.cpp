#include "lib/minimize/minimize.hpp"

#include <algorithm>

#include "lib/mesh/case_prefix.hpp"
#include "lib/minimize/box_changes.hpp"
#include "lib/minimize/box_search.hpp"
#include "lib/minimize/path_passes.hpp"

namespace asts {

namespace {

/// No mesh of subdivisions with higher levels is made of boxes.
constexpr std::int32_t kMostClassLevels = 12;
/// More steps are not looked at one by one.
constexpr std::size_t kScanned = 32;

/// The first violating mesh of a short sequence. In a long one by halving: then one that violates, with a mesh before
/// it that does not.
Case first_violating(const Case& start, Oracle& oracle) {
  if (start.steps.size() <= kScanned) {
    for (std::size_t steps = 0; steps < start.steps.size(); ++steps) {
      Case prefix = case_prefix(start, steps);
      if (oracle.asks(prefix)) return prefix;
    }
    return start;
  }
  std::size_t holds = 0;
  std::size_t violates = start.steps.size();
  while (violates - holds > 1) {
    const std::size_t middle = holds + (violates - holds) / 2;
    (oracle.asks(case_prefix(start, middle)) ? violates : holds) = middle;
  }
  return case_prefix(start, violates);
}

class Minimizer {
 public:
  Minimizer(const Case& start, PathForm form, Oracle& oracle) : form_(form), oracle_(oracle) {
    result_.smallest = start;
  }

  Minimized run() {
    try {
      minimize();
    } catch (const Oracle::Stopped& stopped) {
      result_.guarantee = stopped.budget ? Guarantee::budget : Guarantee::interrupted;
      result_.last_run.clear();
    }
    take_best();
    result_.kind = oracle_.kind();
    result_.evaluations = oracle_.evaluations();
    result_.others = oracle_.others();
    return std::move(result_);
  }

 private:
  void minimize() {
    if (result_.smallest.explicit_mesh) {
      minimize_boxes();
    } else {
      result_.smallest = first_violating(result_.smallest, oracle_);
      paths_.emplace(
          oracle_, form_,
          form_ == PathForm::mesh ? mesh_paths(result_.smallest).value() : follow_paths(result_.smallest).paths);
    }
    if (paths_) minimize_paths();
  }

  /// Until nothing gets smaller, or the mesh is one that subdivisions make.
  void minimize_boxes() {
    boxes_.emplace(oracle_, result_.smallest);
    if (become_paths(mesh_paths(boxes_->current()))) return;
    do {
      result_.last_run.clear();
      for (const BoxPass& pass : simplifying_passes()) run_pass(pass, *boxes_);
      if (accepted()) continue;
      if (become_refined()) return;
      for (const BoxPass& pass : merging_passes()) run_pass(pass, *boxes_);
    } while (accepted());
  }

  /// Subdivisions begin along x, so that the axes matter.
  bool become_refined() {
    PerAxis<Axis> order{0, 1, 2};
    do {
      if (become_paths(refined_to_class(boxes_permuted(boxes_->current(), order), kMostClassLevels))) return true;
    } while (std::next_permutation(order.begin(), order.end()));
    return false;
  }

  bool become_paths(const std::optional<PathCase>& paths) {
    if (!paths || !oracle_.asks(case_of(*paths))) return false;
    paths_.emplace(oracle_, form_, *paths);
    return true;
  }

  void minimize_paths() {
    do {
      result_.last_run.clear();
      for (const PathPass& pass : descent_passes()) run_pass(pass, *paths_);
      if (accepted()) continue;
      for (const PathPass& pass : escape_passes()) {
        if (run_pass(pass, *paths_)) break;
      }
    } while (accepted());
  }

  template <class Pass, class Search>
  bool run_pass(const Pass& pass, Search& search) {
    const std::int64_t before = oracle_.evaluations();
    const bool any = pass.run(search);
    result_.last_run.push_back({pass.name, oracle_.evaluations() - before, any});
    return any;
  }

  bool accepted() const {
    for (const PassRecord& record : result_.last_run) {
      if (record.accepted) return true;
    }
    return false;
  }

  /// Before a search began the start is the best.
  void take_best() {
    if (!paths_ && !boxes_ && !result_.smallest.explicit_mesh) {
      paths_.emplace(oracle_, PathForm::sequence, follow_paths(result_.smallest).paths);
    }
    if (paths_) {
      result_.smallest = paths_->written();
      result_.size = paths_->size();
    } else if (boxes_) {
      result_.smallest = boxes_->current();
      result_.size = boxes_->size();
    } else {
      result_.size = size_of_boxes(result_.smallest);
    }
  }

  PathForm form_;
  Oracle& oracle_;
  std::optional<BoxSearch> boxes_;
  std::optional<PathSearch> paths_;
  Minimized result_;
};

}  // namespace

const char* guarantee_name(Guarantee guarantee) {
  switch (guarantee) {
    case Guarantee::one_minimal:
      return "1-minimal";
    case Guarantee::budget:
      return "budget";
    case Guarantee::interrupted:
      return "interrupted";
  }
  return "";
}

Minimized minimize(const Case& start, PathForm form, const Predicate& predicate, const Oracle::Options& options) {
  Oracle oracle(predicate, start, options);
  return Minimizer(start, form, oracle).run();
}

}  // namespace asts
