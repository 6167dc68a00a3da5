#include <string>

#include "lib/mesh/case_file.hpp"

namespace asts {
namespace {

void append(std::string& text, const CompactRational& number) {
  if (!number.is_small()) {
    text += to_string(number.value());
    return;
  }
  text += std::to_string(number.numerator());
  if (number.denominator() != 1) text += '/' + std::to_string(number.denominator());
}

void append(std::string& text, const Point& point) {
  const char* separator = "";
  for (const CompactRational& coordinate : point) {
    text += separator;
    append(text, coordinate);
    separator = " ";
  }
}

void append(std::string& text, const PerAxis<int>& sizes) {
  for (const int size : sizes) text += ' ' + std::to_string(size);
}

void append(std::string& text, const Step& step) {
  text += step.kind == Step::Kind::refine ? "refine" : "subdivide";
  const char* separator = " ";
  for (const Point& mark : step.marks) {
    text += separator;
    append(text, mark);
    separator = "  ";
  }
  text += '\n';
}

}  // namespace

std::string write_case(const Case& test_case) {
  std::string text = "asts-case 1\ndegree";
  append(text, test_case.degree);
  text += "\ngrading " + std::to_string(test_case.grading) + "\ndomain";
  append(text, test_case.domain);
  text += '\n';
  for (const Step& step : test_case.steps) append(text, step);
  for (const ElementLine& element : test_case.elements) {
    text += "element ";
    append(text, element.lower);
    text += "  ";
    append(text, element.upper);
    text += '\n';
  }
  return text;
}

}  // namespace asts
