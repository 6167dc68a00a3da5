#include <iomanip>
#include <sstream>

#include "tests/reference/witness_json.hpp"

namespace asts::reference {

std::string text(const Rational& value) {
  return value.str();
}

std::string text(const Point& point) {
  return "(" + text(point[0]) + ", " + text(point[1]) + ", " + text(point[2]) + ")";
}

std::string text(const Box& box) {
  std::string result;
  for (std::size_t a = 0; a < dimension; ++a)
    result += (a > 0 ? " x [" : "[") + text(box.lower[a]) + ", " + text(box.upper[a]) + "]";
  return result;
}

std::string text(const std::vector<Rational>& numbers) {
  std::string result;
  for (const Rational& number : numbers) result += (result.empty() ? "" : ", ") + text(number);
  return "(" + result + ")";
}

std::string text(const CosineField& field, const Number& value) {
  if (is_rational(value)) return text(value[0]);
  std::ostringstream out;
  bool first = true;
  for (std::size_t k = 0; k < value.size(); ++k) {
    if (value[k] == 0) continue;
    out << (first ? "" : " + ") << "(" << text(value[k]) << ")";
    if (k > 0) out << "*g^" << k;
    first = false;
  }
  // The decimal is for the reader alone; nothing is decided by it.
  out << " with g = 2*cos(pi/" << field.n() << "), about " << std::setprecision(6)
      << static_cast<double>(field.enclosure(value, 64)[0]);
  return out.str();
}

}  // namespace asts::reference
