#include "tests/reference/decide.hpp"
#include "tests/reference/validate_kinds.hpp"

namespace asts::reference {

using nlohmann::json;

namespace {

/// The failures and pairs of the mesh, recounted when it has at most 400 active nodes.
std::string check_counts(const Setting& setting, const Mesh& mesh, const json& witness) {
  const std::size_t failures = read_count(witness["failures"], "failures");
  const std::size_t pairs = read_count(witness["pairs"], "pairs");
  if (failures < 1 || pairs < failures) throw Rejected("failures and pairs do not fit together");
  const Space<Rational> space = make_space<Rational>(setting, mesh, 1);
  const std::vector<Point> nodes = active_nodes(space);
  if (nodes.size() > 400)
    return " The numbers of failures (" + std::to_string(failures) + ") and pairs (" + std::to_string(pairs) +
           ") were not recounted: the mesh has " + std::to_string(nodes.size()) + " active nodes, more than 400.";
  const auto splines = active_splines(space);
  if (!splines) throw Rejected("an active node of the mesh has no index vector: the property does not apply");
  const DualCount count = count_dual_failures(setting.degree, *splines, false);
  if (count.failures != failures || count.pairs != pairs)
    throw Rejected("recounted: " + std::to_string(count.failures) + " failures of " + std::to_string(count.pairs) +
                   " pairs, not " + std::to_string(failures) + " of " + std::to_string(pairs));
  return " Recounted: " + std::to_string(failures) + " of the " + std::to_string(pairs) +
         " ordered pairs of nodes whose supports' intersection has positive volume fail on this mesh.";
}

/// The three factors by literal integration, compared with the printed ones; both sides in the common field.
std::array<Number, dimension> checked_factors(const Setting& setting, const ActiveNode<Rational>& v,
                                              const ActiveNode<Rational>& w, const json& printed) {
  if (!printed.is_array() || printed.size() != dimension) throw Rejected("factors are not three values");
  const CosineField& common = common_field(setting.degree);
  std::array<Number, dimension> factors;
  for (std::size_t a = 0; a < dimension; ++a) {
    const std::string name = std::string("factor along ") + axis_name(a);
    factors[a] = lambda(v.vectors[a], w.vectors[a]);
    const CosineField& own = CosineField::get(setting.degree[a] + 1);
    if (read_value(printed[a], common, name) != own.embed(factors[a], common))
      throw Rejected(name + ": lambda of " + text(v.vectors[a]) + " on the B-spline of " + text(w.vectors[a]) + " is " +
                     text(own, factors[a]));
  }
  return factors;
}

std::string described(const ActiveNode<Rational>& v) {
  std::string result = text(v.node) + " with index vectors";
  for (std::size_t a = 0; a < dimension; ++a) result += std::string(" ") + axis_name(a) + " " + text(v.vectors[a]);
  return result;
}

}  // namespace

std::string validate_lambda_not_delta(const Setting& setting, const Mesh& mesh, const json& witness) {
  require_keys(witness, {"kind", "v", "w", "factors", "value", "expected", "failures", "pairs"}, "the witness");
  const Space<Rational> space = make_space<Rational>(setting, mesh, 1);
  const ActiveNode<Rational> v = checked_active_node(space, witness["v"], "v");
  const ActiveNode<Rational> w = checked_active_node(space, witness["w"], "w");
  const CosineField& common = common_field(setting.degree);
  const std::array<Number, dimension> factors = checked_factors(setting, v, w, witness["factors"]);
  const Number value = product_of_factors(setting.degree, factors);
  if (read_value(witness["value"], common, "value") != value)
    throw Rejected("value: the product of the factors is " + text(common, value));
  const int delta = v.node == w.node ? 1 : 0;
  if (read_number(witness["expected"]) != delta) throw Rejected("expected: it is " + std::to_string(delta));
  if (value == common.rational(delta)) throw Rejected("the value is the expected one: nothing is violated");
  const std::string counts = check_counts(setting, mesh, witness);
  std::string product;
  for (std::size_t a = 0; a < dimension; ++a)
    product += (a > 0 ? " times [" : "[") + text(CosineField::get(setting.degree[a] + 1), factors[a]) + "]";
  return "v = " + described(v) + " and w = " + described(w) + " are active nodes." +
         check_property_applies(setting, mesh) + " lambda_v(B_w), by exact integration (Proposition 6.1, Definition "
         "6.2), is " + product + " = [" + text(common, value) + "]; the Kronecker delta is " + std::to_string(delta) +
         "." + counts + " The functionals are no dual basis.";
}

}  // namespace asts::reference
