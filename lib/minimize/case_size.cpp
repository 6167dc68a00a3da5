#include "lib/minimize/case_size.hpp"

#include <algorithm>
#include <set>
#include <vector>

namespace asts {

namespace {

std::strong_ordering compare(const CompactRational& a, const CompactRational& b) {
  if (a == b) return std::strong_ordering::equal;
  return a.value() < b.value() ? std::strong_ordering::less : std::strong_ordering::greater;
}

template <class List, class Compare>
std::strong_ordering compare_lists(const List& a, const List& b, Compare compare_entries) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (const auto order = compare_entries(a[i], b[i]); order != 0) return order;
  }
  return a.size() <=> b.size();
}

std::strong_ordering compare_points(const Point& a, const Point& b) { return compare_lists(a, b, compare); }

std::strong_ordering compare_steps(const Step& a, const Step& b) {
  if (a.kind != b.kind) return a.kind <=> b.kind;
  return compare_lists(a.marks, b.marks, compare_points);
}

std::strong_ordering compare_boxes(const ElementLine& a, const ElementLine& b) {
  if (const auto order = compare_points(a.lower, b.lower); order != 0) return order;
  return compare_points(a.upper, b.upper);
}

}  // namespace

CaseSize size_of_boxes(const Case& boxes) {
  CaseSize size{true, static_cast<std::int64_t>(boxes.elements.size()), 0, 1, 0, boxes.grading, 0};
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    size.volume *= boxes.domain[axis];
    size.degree += boxes.degree[axis];
    std::set<Rational> fractions;
    for (const ElementLine& box : boxes.elements) {
      const Rational lower = box.lower[axis].value();
      if (denominator(lower) != 1) fractions.insert(lower);
    }
    size.depth += static_cast<std::int64_t>(fractions.size());
  }
  return size;
}

std::strong_ordering compare_numbers(const Case& a, const Case& b) {
  if (const auto order = a.domain <=> b.domain; order != 0) return order;
  if (const auto order = a.degree <=> b.degree; order != 0) return order;
  if (const auto order = compare_lists(a.steps, b.steps, compare_steps); order != 0) return order;
  return compare_lists(a.elements, b.elements, compare_boxes);
}

}  // namespace asts
