#include "reports/witness_text.hpp"

#include <fmt/format.h>

namespace asts {

namespace {

constexpr const char* kIndent = "      ";

std::string text(const ExactPoint& point) {
  std::string result;
  for (const Rational& value : point) result += (result.empty() ? "(" : ", ") + to_string(value);
  return result + ")";
}

std::string text(const ExactBox& box, char open, char close) {
  std::string result;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    result += fmt::format("{}{}{}, {}{}", axis == 0 ? "" : " x ", open, to_string(box.lower[axis]),
                          to_string(box.upper[axis]), close);
  }
  return result;
}

std::string text(const ElementInfo& info) {
  return text(info.box, '[', ']') + (info.level ? fmt::format(" of level {}", *info.level) : " (no integer level)");
}

std::string text(const std::vector<Rational>& vector) {
  std::string result;
  for (const Rational& value : vector) result += (result.empty() ? "(" : ", ") + to_string(value);
  return result + ")";
}

std::string polynomial(const std::vector<Rational>& coefficients) {
  std::string result;
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    if (coefficients[k] == 0) continue;
    result += fmt::format("{}({}){}", result.empty() ? "" : " + ", to_string(coefficients[k]),
                          k == 0   ? ""
                          : k == 1 ? " g"
                                   : fmt::format(" g^{}", k));
  }
  return result;
}

std::string text(const FieldElement& value) {
  if (value.is_rational()) return to_string(value.to_rational());
  const DecimalEnclosure enclosure = enclose_decimal(value);
  return fmt::format("{} with g = 2 cos(pi/{}), between {} and {}", polynomial(value.coefficients()),
                     value.field()->n(), enclosure.lower, enclosure.upper);
}

std::string node_lines(const char* name, const ActiveNodeInfo& info) {
  std::string result = fmt::format("{}{} = {}\n", kIndent, name, text(info.node));
  for (Axis axis = 0; axis < kDimension; ++axis) {
    const std::vector<Rational>& vector = info.index_vectors[static_cast<std::size_t>(axis)];
    result += fmt::format("{}  index vector along {}: {}\n", kIndent, axis_name(axis), text(vector));
  }
  return result;
}

/// A point of the line through `node` along `axis`, by its coordinate on it, such as "(7/2, v1_2, v1_3)".
std::string point_on_line(Axis axis, const std::string& coordinate, const char* node) {
  std::string result;
  for (Axis other = 0; other < kDimension; ++other) {
    result += result.empty() ? "(" : ", ";
    result += other == axis ? coordinate : fmt::format("{}_{}", node, other + 1);
  }
  return result + ")";
}

std::string perturbation_lines(const PerturbationInfo& info, const char* in, const char* out) {
  const char* axis = axis_name(info.axis);
  const std::string slice = to_string(info.slice);
  return fmt::format(
             "{0}it is in R_{1}: {2} is in N_{1}({3}), {4} is not, and both supports contain the point;\n"
             "{0}the line through {2} along {1} meets the {1}-orthogonal skeleton at {1} = {3}: {5} is in Xi_{1},\n"
             "{0}the line through {4} does not: {6} is not in Xi_{1}\n",
             kIndent, axis, in, slice, out, point_on_line(info.axis, slice, in), point_on_line(info.axis, slice, out)) +
         node_lines(in, info.in) + node_lines(out, info.out);
}

/// One value of a claim's witness under its name, as whole lines.
struct ValueLines {
  const std::string& name;

  std::string line(const std::string& value) const { return fmt::format("{}{} = {}\n", kIndent, name, value); }
  std::string operator()(const std::string& value) const { return line(value); }
  std::string operator()(std::int64_t count) const { return line(std::to_string(count)); }
  std::string operator()(const Rational& value) const { return line(to_string(value)); }
  std::string operator()(const std::vector<Rational>& values) const { return line(text(values)); }
  std::string operator()(const ExactPoint& value) const { return line(text(value)); }
  std::string operator()(const ExactBox& value) const { return line(text(value, '[', ']')); }
  std::string operator()(const ElementInfo& info) const { return line(text(info)); }
  std::string operator()(const ActiveNodeInfo& info) const { return node_lines(name.c_str(), info); }
  std::string operator()(const FieldElement& value) const { return line(text(value)); }
};

struct ToText {
  std::string operator()(const ClaimWitness& w) const {
    std::string result = fmt::format("{}{}\n", kIndent, w.says);
    for (const auto& [name, value] : w.values) result += std::visit(ValueLines{name}, value);
    return result;
  }
  std::string operator()(const CoarserInPatchWitness& w) const {
    return fmt::format(
        "{0}the element {1} was subdivided,\n"
        "{0}its environment U = {2}\n"
        "{0}meets the element {3}, which is coarser:\n"
        "{0}no order of admissible subdivisions makes this mesh\n",
        kIndent, text(w.element), text(w.environment, '(', ')'), text(w.coarser));
  }
  std::string operator()(const OutsideClassWitness& w) const {
    return fmt::format("{0}the element {1}\n{0}does not arise by level-directed subdivisions of the initial mesh\n",
                       kIndent, text(w.element));
  }
  std::string operator()(const PatchNotNestedWitness& w) const {
    return fmt::format(
        "{0}the element K = {1}\n{0}lies in      L = {2};\n{0}the patch of K has {3},\n{0}that of L does not\n",
        kIndent, text(w.inner), text(w.outer), text(w.element));
  }
  std::string operator()(const RegionsMeetWitness& w) const {
    return fmt::format("{}the point {} is in two perturbed regions:\n", kIndent, text(w.point)) +
           perturbation_lines(w.first, "v1", "v2") + perturbation_lines(w.second, "v3", "v4");
  }
  std::string operator()(const NoPartialOverlapWitness& w) const {
    std::string result =
        fmt::format("{}the supports of v and w share volume, and their index vectors fail to overlap:\n", kIndent);
    result += node_lines("v", w.v) + node_lines("w", w.w);
    for (const NoOverlapInfo& info : w.axes) {
      result += fmt::format(
          "{}along {}: {} is an entry of {}'s vector, lies in the range of {}'s, and is no entry of it\n", kIndent,
          axis_name(info.axis), to_string(info.coordinate), info.in_v ? "v" : "w", info.in_v ? "w" : "v");
    }
    return result;
  }
  std::string operator()(const LambdaNotDeltaWitness& w) const {
    std::string result =
        fmt::format("{0}lambda_v(B_w) = {1}\n{0}instead of {2}, for\n", kIndent, text(w.value), w.expected);
    result += node_lines("v", w.v) + node_lines("w", w.w);
    for (Axis axis = 0; axis < kDimension; ++axis) {
      result += fmt::format("{}factor along {}: {}\n", kIndent, axis_name(axis),
                            text(w.factors[static_cast<std::size_t>(axis)]));
    }
    return result + fmt::format("{}{} of the {} ordered pairs of nodes whose supports share volume fail\n", kIndent,
                                w.failures, w.pairs);
  }
};

}  // namespace

std::string witness_text(const Witness& witness) { return std::visit(ToText{}, witness); }

}  // namespace asts
