#include "lib/minimize/oracle.hpp"

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"

namespace asts {

Oracle::Oracle(Predicate predicate, const Case& start, Options options)
    : predicate_(std::move(predicate)), options_(std::move(options)), evaluations_(1) {
  const ViolationKind violation = predicate_(start);
  require(violation.has_value(), "the case does not violate what it is to be minimized for");
  kind_ = *violation;
  known_.emplace(write_case(start), true);
}

bool Oracle::asks(const Case& test_case) {
  std::string text = write_case(test_case);
  if (const auto found = known_.find(text); found != known_.end()) return found->second;
  if (options_.stop && options_.stop()) throw Stopped{false};
  if (options_.budget > 0 && evaluations_ >= options_.budget) throw Stopped{true};
  ++evaluations_;
  const ViolationKind violation = evaluate(test_case);
  if (options_.evaluated) options_.evaluated();
  if (violation && *violation != kind_) others_.try_emplace(*violation, test_case);
  return known_[std::move(text)] = violation == kind_;
}

ViolationKind Oracle::evaluate(const Case& test_case) {
  try {
    return predicate_(test_case);
  } catch (const ResourceError&) {
    return std::nullopt;
  }
}

}  // namespace asts
