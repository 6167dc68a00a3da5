#pragma once

#include <string>
#include <vector>

#include "lib/minimize/case_size.hpp"
#include "lib/minimize/oracle.hpp"
#include "lib/minimize/path_search.hpp"

namespace asts {

/// What is known of a minimized case.
enum class Guarantee {
  one_minimal,  ///< a last full run of all passes changed nothing
  budget,       ///< the budget ended before
  interrupted,
};

/// "1-minimal", "budget" or "interrupted".
const char* guarantee_name(Guarantee guarantee);

/// What a pass did in the last run of all passes.
struct PassRecord {
  std::string pass;
  std::int64_t evaluations = 0;
  bool accepted = false;
};

struct Minimized {
  Case smallest;
  CaseSize size;
  std::string kind;
  Guarantee guarantee = Guarantee::one_minimal;
  std::int64_t evaluations = 0;
  std::vector<PassRecord> last_run;    ///< when 1-minimal: each pass, and that it accepted nothing
  std::map<std::string, Case> others;  ///< by kind: other ways to violate that were met on the way
};

/// From a case that violates to a small one that violates in the same way, smaller by CaseSize and compare_numbers.
/// `form` says whether the predicate looks at the last mesh or at the steps of a case of steps.
///
/// First the sequence is cut behind its first violating mesh (of more than 32 steps: behind one before which a mesh does
/// not violate, found by halving). Then passes propose smaller cases until none of them
/// finds one: subdivisions, steps, marks or boxes are left out in chunks, layers of the domain are taken away, degrees
/// and m are lowered, axes permuted and reflected, marks moved towards the origin; at the end also cases in a larger
/// setting that need fewer subdivisions.
///
/// Laws (tests/minimize/minimize_test.cpp): (1) the result violates with the same kind, and it is not larger; (2) it
/// depends on the start, the predicate and the budget alone; (3) minimizing the result gives it back; (4) every case
/// that the predicate is asked about is a valid one.
/// Throws InputError when the start does not violate.
Minimized minimize(const Case& start, PathForm form, const Predicate& predicate, const Oracle::Options& options);

}  // namespace asts
