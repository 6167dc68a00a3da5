#include <algorithm>

#include "tests/reference/complexity_checks.hpp"
#include "tests/reference/root_text.hpp"
#include "tests/reference/witness_elements.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

/// The whole sequence, by Algorithm 2.9 alone. Its last mesh must be admissible, as Theorem 3.3 has it.
LiteralSequence whole_sequence(const ClaimSubject& subject) {
  if (subject.steps() == nullptr) throw Rejected("the claim is about sequences of steps");
  LiteralSequence sequence = follow_literally(subject, subject.steps()->size());
  if (!sequence.mesh.admissible()) throw Rejected("the last mesh is not admissible");
  return sequence;
}

std::string check_below_1(ClaimSubject& subject, const json& witness, const std::vector<DistanceConstant>& constants) {
  const json& values = values_of(witness, {"K", "marks K~ with lambda(K,K~) > 0", "sum"});
  const Setting& setting = subject.setting();
  const ElementText claimed = read_element(values["K"], "K");
  for (std::size_t a = 0; a < dimension; ++a)
    if (claimed.box.lower[a] < 0 || claimed.box.upper[a] > setting.domain[a])
      throw Rejected("K lies outside of the domain");
  const LiteralSequence sequence = whole_sequence(subject);
  const GridBox k = sequence.mesh.element_at(claimed.box.lower);
  if (!(sequence.mesh.box(k) == claimed.box)) throw Rejected("K is no element of the last mesh");
  check_level(setting, claimed, "K");
  if (!sequence.mesh.is_new(k)) throw Rejected("K is an element of the initial mesh");
  return with_any(constants, [&](DistanceConstant d) {
    const LambdaSum found = sequence.mesh.lambda_sum(k, sequence.marks, d);
    require_equal(read_count(values["marks K~ with lambda(K,K~) > 0"], "marks"), found.within,
                  "the number of marks with lambda(K,K~) > 0");
    require_equal(read_root_sum(values["sum"], setting.grading, "the sum"), found.sum, "the sum");
    if (sign(found.sum - RootSum{setting.grading, 1}) >= 0) throw Rejected("the sum is at least 1: " + text(found.sum));
    return "The sequence refines " + std::to_string(sequence.marks.size()) +
           " marks, and each mesh is admissible. K = " + described(setting, claimed.box) +
           " is in G_J \\ G_0. lambda(K,K~) > 0 for " + std::to_string(found.within) +
           " of the marks, and the sum is " + text(found.sum) + " < 1.";
  });
}

/// So many new elements are added up for one mark.
constexpr std::size_t most_terms = 500'000;

std::string check_above_c(ClaimSubject& subject, const json& witness, const std::vector<DistanceConstant>& constants) {
  const json& values = values_of(witness, {"K~", "sum", "C"});
  const Setting& setting = subject.setting();
  const ElementText claimed = read_element(values["K~"], "K~");
  check_level(setting, claimed, "K~");
  const LiteralSequence sequence = whole_sequence(subject);
  const auto mark = std::find_if(sequence.marks.begin(), sequence.marks.end(),
                                 [&](const GridBox& one) { return sequence.mesh.box(one) == claimed.box; });
  if (mark == sequence.marks.end()) throw Rejected("K~ is no mark of the sequence");
  if (sequence.mesh.new_element_count() > most_terms) throw Rejected("there are too many new elements to add up");
  return with_any(constants, [&](DistanceConstant d) {
    const RootSum sum = sequence.mesh.lambda_sum_over_new(*mark, d).sum, bound = complexity_constant(setting, d);
    require_equal(read_root_sum(values["sum"], setting.grading, "the sum"), sum, "the sum");
    require_equal(read_root_sum(values["C"], setting.grading, "C"), bound, "C");
    if (sign(bound - sum) >= 0) throw Rejected("the sum is at most C: " + text(sum) + " <= " + text(bound));
    return "The sequence refines marks, and each mesh is admissible. K~ = " + described(setting, claimed.box) +
           " is one of them, and the sum over the new elements is " + text(sum) + " > C = " + text(bound) + ".";
  });
}

}  // namespace

std::string check_sum_below_1(ClaimSubject& subject, const json& witness) {
  return check_below_1(subject, witness, {distance_constant});
}

std::string check_sum_below_1_repaired(ClaimSubject& subject, const json& witness) {
  return check_below_1(subject, witness, repaired_constants(subject.setting()));
}

std::string check_sum_above_c(ClaimSubject& subject, const json& witness) {
  return check_above_c(subject, witness, {distance_constant});
}

std::string check_sum_above_c_repaired(ClaimSubject& subject, const json& witness) {
  return check_above_c(subject, witness, repaired_constants(subject.setting()));
}

}  // namespace asts::reference
