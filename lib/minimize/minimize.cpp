#include "lib/minimize/minimize.hpp"

#include "lib/exact/errors.hpp"
#include "lib/minimize/path_passes.hpp"

namespace asts {

namespace {

Case cut_behind(const Case& test_case, std::size_t steps) {
  Case result = test_case;
  result.steps.resize(steps);
  return result;
}

/// More steps are not looked at one by one.
constexpr std::size_t kScanned = 32;

/// The first violating mesh of a short sequence. In a long one by halving: then one that violates, with a mesh before
/// it that does not.
Case first_violating(const Case& start, Oracle& oracle) {
  if (start.steps.size() <= kScanned) {
    for (std::size_t steps = 0; steps < start.steps.size(); ++steps) {
      Case prefix = cut_behind(start, steps);
      if (oracle.asks(prefix)) return prefix;
    }
    return start;
  }
  std::size_t holds = 0;
  std::size_t violates = start.steps.size();
  while (violates - holds > 1) {
    const std::size_t middle = holds + (violates - holds) / 2;
    (oracle.asks(cut_behind(start, middle)) ? violates : holds) = middle;
  }
  return cut_behind(start, violates);
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
    if (search_) take(*search_);
    result_.kind = oracle_.kind();
    result_.evaluations = oracle_.evaluations();
    result_.others = oracle_.others();
    return std::move(result_);
  }

 private:
  void minimize() {
    const Case cut = result_.smallest.explicit_mesh ? result_.smallest : first_violating(result_.smallest, oracle_);
    result_.smallest = cut;
    if (form_ == PathForm::mesh) {
      search_.emplace(oracle_, form_, mesh_paths(cut).value());
    } else {
      search_.emplace(oracle_, form_, follow_paths(cut).paths);
    }
    do {
      result_.last_run.clear();
      for (const PathPass& pass : descent_passes()) run_pass(pass);
      if (accepted()) continue;
      for (const PathPass& pass : escape_passes()) {
        if (run_pass(pass)) break;
      }
    } while (accepted());
  }

  bool run_pass(const PathPass& pass) {
    const std::int64_t before = oracle_.evaluations();
    const bool any = pass.run(*search_);
    result_.last_run.push_back({pass.name, oracle_.evaluations() - before, any});
    return any;
  }

  bool accepted() const {
    for (const PassRecord& record : result_.last_run) {
      if (record.accepted) return true;
    }
    return false;
  }

  void take(const PathSearch& search) {
    result_.smallest = search.written();
    result_.size = search.size();
  }

  PathForm form_;
  Oracle& oracle_;
  std::optional<PathSearch> search_;
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
  const ViolationKind kind = predicate(start);
  require(kind.has_value(), "the case does not violate what it is to be minimized for");
  Oracle oracle(predicate, *kind, options);
  return Minimizer(start, form, oracle).run();
}

}  // namespace asts
