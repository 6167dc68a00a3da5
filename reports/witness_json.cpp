#include "reports/witness_json.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

Json number(const Rational& value) { return to_string(value); }

Json numbers(const std::vector<Rational>& values) {
  Json result = Json::array();
  for (const Rational& value : values) result.push_back(number(value));
  return result;
}

Json point(const ExactPoint& value) { return numbers({value.begin(), value.end()}); }

Json box(const ExactBox& value) { return {{"lower", point(value.lower)}, {"upper", point(value.upper)}}; }

Json element(const ElementInfo& info) {
  Json result = box(info.box);
  result["level"] = info.level ? Json(*info.level) : Json(nullptr);
  return result;
}

Json active_node(const ActiveNodeInfo& info) {
  Json vectors;
  for (Axis axis = 0; axis < kDimension; ++axis) {
    vectors[axis_name(axis)] = numbers(info.index_vectors[static_cast<std::size_t>(axis)]);
  }
  return {{"node", point(info.node)}, {"index_vectors", vectors}, {"support", box(info.support)}};
}

Json field_value(const FieldElement& value) {
  if (value.is_rational()) return number(value.to_rational());
  Json polynomial = Json::array();
  for (const Integer& coefficient : value.field()->minimal_polynomial()) polynomial.push_back(coefficient.str());
  const DecimalEnclosure enclosure = enclose_decimal(value);
  return {{"coefficients", numbers(value.coefficients())},
          {"generator", "2*cos(pi/" + std::to_string(value.field()->n()) + ")"},
          {"minimal_polynomial", polynomial},
          {"enclosure", {enclosure.lower, enclosure.upper}}};
}

Json perturbation(const PerturbationInfo& info) {
  return {{"axis", axis_name(info.axis)},
          {"slice", number(info.slice)},
          {"in", active_node(info.in)},
          {"out", active_node(info.out)}};
}

struct ValueToJson {
  Json operator()(const std::string& text) const { return text; }
  Json operator()(std::int64_t count) const { return count; }
  Json operator()(const Rational& value) const { return number(value); }
  Json operator()(const std::vector<Rational>& values) const { return numbers(values); }
  Json operator()(const ExactPoint& value) const { return point(value); }
  Json operator()(const ExactBox& value) const { return box(value); }
  Json operator()(const ElementInfo& info) const { return element(info); }
  Json operator()(const ActiveNodeInfo& info) const { return active_node(info); }
  Json operator()(const FieldElement& value) const { return field_value(value); }
};

struct ToJson {
  Json operator()(const ClaimWitness& w) const {
    Json values = Json::object();
    for (const auto& [name, value] : w.values) values[name] = std::visit(ValueToJson{}, value);
    return {{"kind", kind_of(w)}, {"says", w.says}, {"values", values}};
  }
  Json operator()(const CoarserInPatchWitness& w) const {
    return {{"kind", kind_of(w)},
            {"element", element(w.element)},
            {"environment", box(w.environment)},
            {"coarser", element(w.coarser)}};
  }
  Json operator()(const OutsideClassWitness& w) const {
    return {{"kind", kind_of(w)}, {"element", element(w.element)}};
  }
  Json operator()(const PatchNotNestedWitness& w) const {
    return {{"kind", kind_of(w)},
            {"inner", element(w.inner)},
            {"outer", element(w.outer)},
            {"element", element(w.element)}};
  }
  Json operator()(const RegionsMeetWitness& w) const {
    return {{"kind", kind_of(w)},
            {"point", point(w.point)},
            {"first", perturbation(w.first)},
            {"second", perturbation(w.second)}};
  }
  Json operator()(const NoPartialOverlapWitness& w) const {
    Json axes = Json::array();
    for (const NoOverlapInfo& info : w.axes) {
      axes.push_back(
          {{"axis", axis_name(info.axis)}, {"coordinate", number(info.coordinate)}, {"in", info.in_v ? "v" : "w"}});
    }
    return {{"kind", kind_of(w)}, {"v", active_node(w.v)}, {"w", active_node(w.w)}, {"axes", axes}};
  }
  Json operator()(const LambdaNotDeltaWitness& w) const {
    Json factors = Json::array();
    for (const FieldElement& factor : w.factors) factors.push_back(field_value(factor));
    return {{"kind", kind_of(w)},
            {"v", active_node(w.v)},
            {"w", active_node(w.w)},
            {"factors", factors},
            {"value", field_value(w.value)},
            {"expected", std::to_string(w.expected)},
            {"failures", w.failures},
            {"pairs", w.pairs}};
  }
};

}  // namespace

Json witness_json(const Witness& witness) { return std::visit(ToJson{}, witness); }

Json verdict_json(const Verdict& verdict) {
  Json result{{"verdict", outcome_name(verdict.outcome)}};
  if (!verdict.reason.empty()) result["reason"] = verdict.reason;
  if (verdict.witness) result["witness"] = witness_json(*verdict.witness);
  return result;
}

}  // namespace asts
