#pragma once

#include <functional>
#include <vector>

#include "lib/mesh/case.hpp"
#include "properties/claims/claim.hpp"

/// What every claim's family brings to tests/properties/claims_test.cpp, which runs all of them and finds what is
/// missing.
namespace asts {

/// A planted fault under which the test of a claim must report a violation: a wrong patch radius, closed for open, an
/// axis mixed up, an index vector shifted, a level off by one, a forgotten direction, a forgotten hypothesis.
struct NegativeControl {
  const char* claim;
  const char* fault;             ///< in words
  std::function<Verdict()> run;  ///< the claim's own test with the fault in what it looks at
};

/// The literal code's word on a refuted claim: decides with tests/reference alone that the hypotheses hold and the
/// conclusion fails for the counterexample reports/findings/ID.case.
struct Confirmation {
  const char* claim;
  std::function<bool(const Case& counterexample)> refutes;
};

std::vector<NegativeControl> refinement_controls();
std::vector<NegativeControl> equation_controls();
std::vector<NegativeControl> complexity_controls();
std::vector<NegativeControl> skeleton_controls();
std::vector<NegativeControl> theorem_5_3_controls();
std::vector<NegativeControl> suitability_controls();
std::vector<NegativeControl> functional_controls();
std::vector<NegativeControl> independence_controls();

std::vector<Confirmation> refinement_confirmations();
std::vector<Confirmation> equation_confirmations();
std::vector<Confirmation> complexity_confirmations();
std::vector<Confirmation> skeleton_confirmations();
std::vector<Confirmation> theorem_5_3_confirmations();
std::vector<Confirmation> suitability_confirmations();
std::vector<Confirmation> functional_confirmations();
std::vector<Confirmation> independence_confirmations();

}  // namespace asts
