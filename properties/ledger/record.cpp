#include "properties/ledger/record.hpp"

#include <algorithm>
#include <tuple>

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"

namespace asts {

namespace {

std::size_t marks_of(const Case& content) {
  std::size_t marks = content.elements.size();
  for (const Step& step : content.steps) marks += step.marks.size();
  return marks;
}

/// All of the order but the texts.
auto size_of(const Case& content) {
  std::int64_t volume = 1;
  int degrees = 0;
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    volume *= content.domain[axis];
    degrees += content.degree[axis];
  }
  return std::tuple(content.explicit_mesh, marks_of(content), volume, degrees, content.grading);
}

auto text_of(const Case& content) {
  std::string text = write_case(content);
  const std::size_t size = text.size();
  return std::pair(size, std::move(text));
}

void add(std::map<std::string, std::int64_t>& into, const std::map<std::string, std::int64_t>& other) {
  for (const auto& [name, count] : other) into[name] += count;
}

void widen(LedgerBounds& into, const LedgerBounds& other) {
  for (std::size_t axis = 0; axis < kDimension; ++axis) {
    into.domain[axis] = std::max(into.domain[axis], other.domain[axis]);
    into.degree[axis] = std::max(into.degree[axis], other.degree[axis]);
  }
  into.grading = std::max(into.grading, other.grading);
  into.level = std::max(into.level, other.level);
  into.elements = std::max(into.elements, other.elements);
  into.active_nodes = std::max(into.active_nodes, other.active_nodes);
}

}  // namespace

bool is_smaller(const LedgerViolation& one, const LedgerViolation& other) {
  if (!one.content || !other.content) {
    return one.content.has_value() < other.content.has_value() ||
           (!one.content && !other.content && one.says < other.says);
  }
  const auto size = size_of(*one.content);
  const auto other_size = size_of(*other.content);
  return size != other_size ? size < other_size : text_of(*one.content) < text_of(*other.content);
}

const char* result_name(LedgerResult result) {
  switch (result) {
    case LedgerResult::no_violation:
      return "no-violation";
    case LedgerResult::violated:
      return "violated";
    default:
      return "undecided";
  }
}

LedgerResult LedgerRecord::result() const {
  if (violated > 0) return LedgerResult::violated;
  return met > 0 ? LedgerResult::no_violation : LedgerResult::undecided;
}

void merge(LedgerRecord& into, const LedgerRecord& other) {
  ensure(into.claim == other.claim, "records of one claim are merged");
  into.meshes += other.meshes;
  into.sequences += other.sequences;
  into.alone += other.alone;
  into.holds += other.holds;
  into.violated += other.violated;
  into.not_applicable += other.not_applicable;
  into.undecided += other.undecided;
  into.met += other.met;
  into.trials_met += other.trials_met;
  add(into.biases, other.biases);
  add(into.features, other.features);
  widen(into.bounds, other.bounds);
  if (other.smallest && (!into.smallest || is_smaller(*other.smallest, *into.smallest))) into.smallest = other.smallest;
}

}  // namespace asts
