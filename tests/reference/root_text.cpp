#include "tests/reference/root_text.hpp"

#include "tests/reference/witness_json.hpp"

namespace asts::reference {

namespace {

/// The exact part alone, terms of powers 0, 1, 2 with the sign in front.
std::string terms_of(const RootSum& value) {
  std::string result;
  const std::string root = std::to_string(value.m);
  const auto append = [&](const Rational& coefficient, const std::string& power) {
    if (coefficient == 0) return;
    const Rational size = abs(coefficient);
    if (result.empty())
      result = coefficient < 0 ? "-" : "";
    else
      result += coefficient < 0 ? " - " : " + ";
    if (power.empty() || size != 1) result += text(size) + (power.empty() ? "" : " ");
    result += power;
  };
  append(value.a, "");
  append(value.b, root + "^(1/3)");
  append(value.c, root + "^(2/3)");
  return result.empty() ? "0" : result;
}

/// One term without its sign: "1/3 5^(1/3)".
void add_term(RootSum& sum, const std::string& term, bool negative) {
  const std::string root = std::to_string(sum.m) + "^(";
  const std::size_t place = term.find(root);
  const bool after_blank = place == 0 || (place != std::string::npos && term[place - 1] == ' ');
  if (place != std::string::npos && !after_blank) throw Rejected("not a term: " + term);
  const std::string number = place == std::string::npos ? term : place == 0 ? "1" : term.substr(0, place - 1);
  const std::string power = place == std::string::npos ? "" : term.substr(place + root.size());
  const Rational size = read_number(number);
  if (!power.empty() && power != "1/3)" && power != "2/3)") throw Rejected("not a term: " + term);
  (power.empty() ? sum.a : power == "1/3)" ? sum.b : sum.c) += negative ? Rational(-size) : size;
}

/// Reads " + " and " - " between terms, and "-" in front of the first.
RootSum read_terms(std::string rest, int m) {
  RootSum sum{m};
  bool negative = rest.starts_with("-");
  if (negative) rest = rest.substr(1);
  for (;;) {
    const std::size_t end = std::min(rest.find(" + "), rest.find(" - "));
    add_term(sum, rest.substr(0, end), negative);
    if (end == std::string::npos) return sum;
    negative = rest[end + 1] == '-';
    rest = rest.substr(end + 3);
  }
}

int compare(const Rational& number, const RootSum& value) { return sign(RootSum{value.m, number} - value); }

/// "between 7.77 and 7.78".
void require_enclosure(const std::string& words, const RootSum& value, const std::string& what) {
  const std::string before = "between ", middle = " and ";
  const std::size_t place = words.find(middle);
  if (!words.starts_with(before) || place == std::string::npos) throw Rejected(what + ": no enclosure: " + words);
  const Rational lower = read_decimal(words.substr(before.size(), place - before.size()));
  const Rational upper = read_decimal(words.substr(place + middle.size()));
  if (compare(lower, value) > 0 || compare(upper, value) < 0)
    throw Rejected(what + ": the decimals do not enclose " + terms_of(value));
}

/// Rounded to a multiple of 10^-12 away from or towards minus infinity.
std::string decimal(const RootSum& value, bool up) {
  constexpr int places = 12;
  Integer unit;
  mpz_ui_pow_ui(unit.backend().data(), 10, places);
  Integer lower = 0, upper = 1;
  const RootSum scaled = (sign(value) < 0 ? RootSum{value.m} - value : value) * Rational(unit);
  while (compare(Rational(upper), scaled) < 0) upper *= 2;
  while (upper - lower > 1) {
    const Integer half = (lower + upper) / 2;
    (compare(Rational(half), scaled) <= 0 ? lower : upper) = half;
  }
  const bool negative = sign(value) < 0;
  std::string digits = (up != negative ? upper : lower).str();
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  digits.insert(digits.size() - places, ".");
  return (negative ? "-" : "") + digits;
}

}  // namespace

RootSum read_root_sum(const nlohmann::json& value, int m, const std::string& what) {
  if (!value.is_string()) throw Rejected(what + " is no text");
  const std::string whole = value.get<std::string>(), comma = ", ";
  const std::size_t place = whole.find(comma);
  const RootSum sum = read_terms(whole.substr(0, place), m);
  if (terms_of(sum) != whole.substr(0, place)) throw Rejected(what + ": it is written " + terms_of(sum));
  const bool rational = sum.b == 0 && sum.c == 0;
  if (rational != (place == std::string::npos))
    throw Rejected(what + ": an irrational number has two decimals around it, a rational one has none");
  if (!rational) require_enclosure(whole.substr(place + comma.size()), sum, what);
  return sum;
}

void require_equal(const RootSum& claimed, const RootSum& actual, const std::string& what) {
  if (sign(claimed - actual) != 0) throw Rejected(what + " is " + text(actual) + ", not " + text(claimed));
}

std::string text(const RootSum& value) {
  if (const auto number = rational_value(value)) return text(*number);
  return terms_of(value) + ", between " + decimal(value, false) + " and " + decimal(value, true);
}

}  // namespace asts::reference
