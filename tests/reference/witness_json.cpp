#include "tests/reference/witness_json.hpp"

#include <algorithm>
#include <limits>

namespace asts::reference {

using nlohmann::json;

namespace {

bool all_digits(const std::string& part) {
  return !part.empty() && std::all_of(part.begin(), part.end(), [](char c) { return '0' <= c && c <= '9'; });
}

/// Decimal digits without a leading zero (but "0" itself).
bool plain_integer(const std::string& part) {
  return all_digits(part) && (part.size() == 1 || part[0] != '0');
}

Integer integer_of(const std::string& digits) {
  Integer result;
  mpz_set_str(result.backend().data(), digits.c_str(), 10);
  return result;
}

Rational power_of_ten(std::size_t exponent) {
  Integer unit;
  mpz_ui_pow_ui(unit.backend().data(), 10, exponent);
  return Rational(unit);
}

[[noreturn]] void not_a(const std::string& kind, const json& value) {
  throw Rejected("not a " + kind + ": " + value.dump(-1, ' ', true, json::error_handler_t::replace).substr(0, 120));
}

}  // namespace

void require_keys(const json& object, std::initializer_list<const char*> keys, const std::string& what) {
  if (!object.is_object()) throw Rejected(what + " is not an object");
  for (const char* key : keys)
    if (!object.contains(key)) throw Rejected(what + " lacks the key \"" + key + "\"");
  for (const auto& entry : object.items())
    if (std::find(keys.begin(), keys.end(), entry.key()) == keys.end())
      throw Rejected(what + " has a key that is none of its kind");
}

Rational read_number(const json& value) {
  if (!value.is_string()) not_a("number", value);
  const std::string whole = value.get<std::string>();
  const bool negative = !whole.empty() && whole[0] == '-';
  const std::string body = whole.substr(negative ? 1 : 0);
  const std::size_t slash = body.find('/');
  const std::string top = body.substr(0, slash), bottom = slash == std::string::npos ? "1" : body.substr(slash + 1);
  if (!plain_integer(top) || !plain_integer(bottom) || bottom == "0" || (negative && top == "0"))
    not_a("number", value);
  const Integer numerator = integer_of(top), denominator = integer_of(bottom);
  if (slash != std::string::npos && (denominator == 1 || gcd(numerator, denominator) != 1))
    not_a("number in lowest terms", value);
  const Rational result = Rational(numerator) / Rational(denominator);
  return negative ? Rational(-result) : result;
}

Rational read_decimal(const json& value) {
  if (!value.is_string()) not_a("decimal", value);
  const std::string whole = value.get<std::string>();
  const bool negative = !whole.empty() && whole[0] == '-';
  const std::size_t e = whole.find('e');
  const std::string body = whole.substr(negative ? 1 : 0, e == std::string::npos ? e : e - (negative ? 1 : 0));
  const std::size_t dot = body.find('.');
  const std::string before = body.substr(0, dot), after = dot == std::string::npos ? "0" : body.substr(dot + 1);
  if (!plain_integer(before) || !all_digits(after) || whole == "-0") not_a("decimal", value);
  Rational result = Rational(integer_of(before)) + Rational(integer_of(after)) / power_of_ten(after.size());
  if (e != std::string::npos) {
    const std::string exponent = whole.substr(e + 1);
    const bool small = !exponent.empty() && exponent[0] == '-';
    const std::string digits = exponent.substr(small ? 1 : 0);
    if (!plain_integer(digits) || digits.size() > 6) not_a("decimal", value);
    const Rational factor = power_of_ten(std::stoul(digits));
    result = small ? Rational(result / factor) : Rational(result * factor);
  }
  return negative ? Rational(-result) : result;
}

std::size_t read_count(const json& value, const std::string& what) {
  if (!value.is_number_unsigned()) throw Rejected(what + " is not a count");
  return value.get<std::size_t>();
}

std::vector<Rational> read_numbers(const json& array) {
  if (!array.is_array()) not_a("list of numbers", array);
  std::vector<Rational> result;
  for (const json& entry : array) result.push_back(read_number(entry));
  return result;
}

Point read_point(const json& value) {
  const std::vector<Rational> numbers = read_numbers(value);
  if (numbers.size() != dimension) not_a("point", value);
  return {numbers[0], numbers[1], numbers[2]};
}

Box read_box(const json& value, const std::string& what) {
  require_keys(value, {"lower", "upper"}, what);
  return {read_point(value["lower"]), read_point(value["upper"])};
}

ElementText read_element(const json& value, const std::string& what) {
  require_keys(value, {"lower", "upper", "level"}, what);
  ElementText result{{read_point(value["lower"]), read_point(value["upper"])}, std::nullopt};
  const json& level = value["level"];
  if (level.is_null()) return result;
  const bool small = !level.is_number_unsigned() || level.get<std::uint64_t>() <= 1'000'000'000;
  if (!level.is_number_integer() || !small) throw Rejected(what + ": the level is neither null nor an integer");
  result.level = level.get<long long>();
  return result;
}

std::size_t read_axis(const json& value) {
  for (std::size_t a = 0; a < dimension; ++a)
    if (value.is_string() && value.get<std::string>() == axis_name(a)) return a;
  not_a("axis", value);
}

const char* axis_name(std::size_t axis) {
  static const char* const names[] = {"x", "y", "z"};
  return names[axis];
}

ActiveNodeText read_active_node(const json& value, const std::string& what) {
  require_keys(value, {"node", "index_vectors", "support"}, what);
  require_keys(value["index_vectors"], {"x", "y", "z"}, what + ": index_vectors");
  ActiveNodeText result{read_point(value["node"]), {}, read_box(value["support"], what + ": support")};
  for (std::size_t a = 0; a < dimension; ++a) result.vectors[a] = read_numbers(value["index_vectors"][axis_name(a)]);
  return result;
}

namespace {

/// N of "2*cos(pi/N)".
int read_generator(const json& value, const CosineField& common) {
  const std::string before = "2*cos(pi/", after = ")";
  if (!value.is_string()) not_a("generator", value);
  const std::string whole = value.get<std::string>();
  if (whole.size() <= before.size() + 1 || !whole.starts_with(before) || !whole.ends_with(after))
    not_a("generator", value);
  const std::string digits = whole.substr(before.size(), whole.size() - before.size() - after.size());
  if (!plain_integer(digits) || digits.size() > 6) not_a("generator", value);
  const int n = std::stoi(digits);
  if (n < 2 || common.n() % n != 0)
    throw Rejected("the generator " + whole + " is not in the field of 2*cos(pi/" + std::to_string(common.n()) + ")");
  return n;
}

}  // namespace

Number read_value(const json& value, const CosineField& common, const std::string& what) {
  if (value.is_string()) return common.rational(read_number(value));
  require_keys(value, {"coefficients", "generator", "minimal_polynomial", "enclosure"}, what);
  const CosineField& field = CosineField::get(read_generator(value["generator"], common));
  if (read_numbers(value["minimal_polynomial"]) != field.minimal())
    throw Rejected(what + ": the minimal polynomial is not " + text(field.minimal()));
  Number own = read_numbers(value["coefficients"]);
  if (own.empty() || own.size() > field.degree())
    throw Rejected(what + ": more coefficients than the field's degree, or none");
  own.resize(field.degree());
  if (is_rational(own)) throw Rejected(what + ": a rational value must be written as a number");
  const json& bounds = value["enclosure"];
  if (!bounds.is_array() || bounds.size() != 2) throw Rejected(what + ": the enclosure is not two decimals");
  const Number lower = field.rational(read_decimal(bounds[0])), upper = field.rational(read_decimal(bounds[1]));
  if (field.sign(field.subtract(own, lower)) < 0 || field.sign(field.subtract(upper, own)) < 0)
    throw Rejected(what + ": the enclosure " + bounds.dump() + " does not enclose " + text(field, own));
  return field.embed(own, common);
}

}  // namespace asts::reference
