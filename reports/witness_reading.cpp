#include "reports/witness_reading.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include "lib/exact/errors.hpp"
#include "reports/witness_json.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

/// Beyond, the field's polynomial would take long; degrees of cases that are found and kept are far below.
constexpr int kLargestField = 5000;

[[noreturn]] void fail(const std::string& reason) { throw InputError(reason); }

Rational number(const Json& json) {
  if (!json.is_string()) fail(json.dump() + " is no number as text");
  const auto read = parse_rational(json.get_ref<const std::string&>());
  if (const auto* reason = std::get_if<std::string>(&read)) fail(*reason);
  return std::get<Rational>(read);
}

std::vector<Rational> numbers(const Json& json) {
  if (!json.is_array()) fail(json.dump() + " is no list of numbers");
  std::vector<Rational> result;
  for (const Json& one : json) result.push_back(number(one));
  return result;
}

ExactPoint point(const Json& json) {
  const std::vector<Rational> values = numbers(json);
  if (values.size() != kDimension) fail(json.dump() + " is no point");
  ExactPoint result;
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

ExactBox box(const Json& json) { return {point(json.at("lower")), point(json.at("upper"))}; }

ElementInfo element(const Json& json) {
  ElementInfo info{box(json), {}};
  if (!json.at("level").is_null()) info.level = json.at("level").get<std::int32_t>();
  return info;
}

Axis axis_of(const Json& json) {
  for (Axis axis = 0; axis < kDimension; ++axis) {
    if (json == axis_name(axis)) return axis;
  }
  fail(json.dump() + " is no axis");
}

ActiveNodeInfo active_node(const Json& json) {
  ActiveNodeInfo info;
  info.node = point(json.at("node"));
  for (Axis axis = 0; axis < kDimension; ++axis) {
    info.index_vectors[static_cast<std::size_t>(axis)] = numbers(json.at("index_vectors").at(axis_name(axis)));
  }
  info.support = box(json.at("support"));
  return info;
}

/// The N of "2*cos(pi/N)".
int field_number(const std::string& generator) {
  constexpr std::string_view kBegin = "2*cos(pi/";
  int n = 0;
  const char* end = generator.data() + generator.size();
  if (generator.starts_with(kBegin)) std::from_chars(generator.data() + kBegin.size(), end, n);
  if (n < 1 || n > kLargestField) fail("'" + generator + "' is no generator of a field");
  return n;
}

FieldElement field_value(const Json& json) {
  if (json.is_string()) return {std::make_shared<const CosineField>(1), number(json)};
  auto field = std::make_shared<const CosineField>(field_number(json.at("generator").get<std::string>()));
  std::vector<Rational> coefficients = numbers(json.at("coefficients"));
  require(coefficients.size() <= static_cast<std::size_t>(field->degree()), "a value has too many coefficients");
  return {std::move(field), std::move(coefficients)};
}

PerturbationInfo perturbation(const Json& json) {
  return {axis_of(json.at("axis")), number(json.at("slice")), active_node(json.at("in")), active_node(json.at("out"))};
}

/// A text that is a number is one, so that a picture can show the slice that it names.
ClaimValue text_value(const Json& json) {
  const auto read = parse_rational(json.get_ref<const std::string&>());
  if (const auto* value = std::get_if<Rational>(&read); value != nullptr && to_string(*value) == json) return *value;
  return json.get<std::string>();
}

ClaimValue claim_value(const Json& json) {
  if (json.is_string()) return text_value(json);
  if (json.is_number_integer()) return json.get<std::int64_t>();
  if (json.is_array() && json.size() == kDimension) return point(json);
  if (json.is_array()) return numbers(json);
  if (!json.is_object()) fail(json.dump() + " is no value");
  if (json.contains("node")) return active_node(json);
  if (json.contains("coefficients")) return field_value(json);
  if (json.contains("level")) return element(json);
  return box(json);
}

NoPartialOverlapWitness no_partial_overlap(const Json& json) {
  NoPartialOverlapWitness witness{active_node(json.at("v")), active_node(json.at("w")), {}};
  for (const Json& one : json.at("axes")) {
    witness.axes.push_back({axis_of(one.at("axis")), number(one.at("coordinate")), one.at("in") == "v"});
  }
  return witness;
}

LambdaNotDeltaWitness lambda_not_delta(const Json& json) {
  const Json& factors = json.at("factors");
  require(factors.is_array() && factors.size() == kDimension, "there are not three factors");
  const Rational expected = number(json.at("expected"));
  return {active_node(json.at("v")),
          active_node(json.at("w")),
          {field_value(factors[0]), field_value(factors[1]), field_value(factors[2])},
          field_value(json.at("value")),
          expected == 1 ? 1 : 0,
          count_in(json, "failures"),
          count_in(json, "pairs")};
}

ClaimWitness claim_witness(const Json& json) {
  ClaimWitness witness{text_in(json, "kind"), text_in(json, "says"), {}};
  for (const auto& [name, value] : json.at("values").items()) witness.values.emplace_back(name, claim_value(value));
  return witness;
}

Witness read_witness(const Json& json) {
  const std::string kind = text_in(json, "kind");
  if (json.contains("values")) return claim_witness(json);
  if (kind == "coarser-in-patch") {
    return CoarserInPatchWitness{element(json.at("element")), box(json.at("environment")), element(json.at("coarser"))};
  }
  if (kind == "outside-class") return OutsideClassWitness{element(json.at("element"))};
  if (kind == "patch-not-nested") {
    return PatchNotNestedWitness{element(json.at("inner")), element(json.at("outer")), element(json.at("element"))};
  }
  if (kind == "perturbed-regions-meet") {
    return RegionsMeetWitness{point(json.at("point")), perturbation(json.at("first")), perturbation(json.at("second"))};
  }
  if (kind == "no-partial-overlap") return no_partial_overlap(json);
  if (kind == "lambda-not-delta") return lambda_not_delta(json);
  fail("'" + kind + "' is no kind of witness");
}

/// "[json.exception.NAME.NUMBER] words" without what a reader has no use for.
std::string words_of(const Json::exception& error) {
  const std::string reason = error.what();
  return reason.substr(reason.find("] ") + 2);
}

Outcome outcome_from(const std::string& name) {
  for (const Outcome one : {Outcome::holds, Outcome::violated, Outcome::not_applicable, Outcome::undecided}) {
    if (name == outcome_name(one)) return one;
  }
  fail("'" + name + "' is no verdict");
}

}  // namespace

Witness witness_from_json(const Json& json) {
  try {
    Witness witness = read_witness(json);
    require(witness_json(witness) == json, "the witness has other members or numbers than its kind");
    return witness;
  } catch (const Json::exception& error) {
    throw InputError("no witness: " + words_of(error));
  }
}

Verdict verdict_from_json(const Json& json) {
  Verdict verdict;
  verdict.outcome = outcome_from(text_in(json, "verdict"));
  if (json.contains("reason")) verdict.reason = text_in(json, "reason");
  if (json.contains("witness")) verdict.witness = witness_from_json(json["witness"]);
  return verdict;
}

std::int64_t count_in(const Json& object, const char* member) {
  if (!object.is_object() || !object.contains(member)) fail(std::string("there is no '") + member + "'");
  const Json& value = object.at(member);
  const bool count = value.is_number_integer() && value >= 0 && value <= std::numeric_limits<std::int64_t>::max();
  if (!count) fail(std::string("'") + member + "' is no count");
  return value.get<std::int64_t>();
}

std::string text_in(const Json& object, const char* member) {
  if (!object.is_object() || !object.contains(member)) fail(std::string("there is no '") + member + "'");
  if (!object.at(member).is_string()) fail(std::string("'") + member + "' is no text");
  return object.at(member).get<std::string>();
}

}  // namespace asts
