#include "tests/reference/claim_witness.hpp"
#include "tests/reference/independence_claims.hpp"
#include "tests/reference/spline_hypotheses.hpp"
#include "tests/reference/validate_kinds.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

/// The functions of a witness with their coefficients: the values coefficient_1, node_1, coefficient_2, ...
struct Combination {
  std::vector<Rational> coefficients;
  std::vector<ActiveNode<Rational>> splines;
};

Combination read_combination(const Space<Rational>& space, const json& values) {
  if (!values.is_object() || values.empty() || values.size() % 2 != 0)
    throw Rejected("values are not coefficients and nodes, one of each");
  Combination result;
  for (std::size_t i = 1; i <= values.size() / 2; ++i) {
    const std::string coefficient = "coefficient_" + std::to_string(i), node = "node_" + std::to_string(i);
    if (!values.contains(coefficient) || !values.contains(node))
      throw Rejected("values lacks the key \"" + coefficient + "\" or \"" + node + "\"");
    result.coefficients.push_back(read_number(values[coefficient]));
    if (result.coefficients.back() == 0) throw Rejected(coefficient + " is 0");
    result.splines.push_back(checked_active_node(space, values[node], node));
    for (std::size_t j = 0; j + 1 < result.splines.size(); ++j)
      if (result.splines[j].node == result.splines.back().node) throw Rejected(node + ": the node is named twice");
  }
  return result;
}

std::string check_dependent(ClaimSubject& subject, const json& witness) {
  const std::string compatible = mesh_is_compatible(subject.setting(), subject.mesh());
  const Space<Rational> space = make_space<Rational>(subject.setting(), subject.mesh(), 1);
  const Combination combination = read_combination(space, witness.at("values"));
  const Rational square = squared_norm(combination.splines, combination.coefficients);
  if (square != 0)
    throw Rejected("nothing is violated: the integral of the square of the sum is " + text(square) + ", not 0");
  std::string sum;
  for (std::size_t i = 0; i < combination.splines.size(); ++i)
    sum +=
        (i == 0 ? "" : " + ") + ("(" + text(combination.coefficients[i])) + ") B_" + text(combination.splines[i].node);
  return "Hypothesis:" + compatible + " Conclusion: the integral of the square of " + sum +
         " is 0: the functions are linearly dependent.";
}

constexpr ClaimKind kinds[] = {
    {"dc-implies-independent", "dependent", "the sum of coefficient times B_node is 0 on every element",
     check_dependent},
};

}  // namespace

std::span<const ClaimKind> independence_kinds() { return kinds; }

}  // namespace asts::reference
