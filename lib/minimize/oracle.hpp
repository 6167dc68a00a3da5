#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "lib/mesh/case.hpp"

namespace asts {

/// How a case violates what is asked, in a word; nothing when it does not. Must be the same for equal cases.
using ViolationKind = std::optional<std::string>;
using Predicate = std::function<ViolationKind(const Case&)>;

/// The predicate as the minimizer asks it: each case once, within a budget, until it is told to stop.
class Oracle {
 public:
  /// Thrown by asks() when the budget is used up, or `stop` said so.
  struct Stopped {
    bool budget;
  };

  struct Options {
    std::int64_t budget = 0;          ///< evaluations of the predicate; 0: no bound
    std::function<bool()> stop;       ///< asked before every evaluation; may be empty
    std::function<void()> evaluated;  ///< told after every evaluation; may be empty
  };

  /// Asks for the start. Throws InputError when it does not violate.
  Oracle(Predicate predicate, const Case& start, Options options);

  /// Whether a case violates in the way that is looked for. A case that cannot be decided because a resource ends
  /// (ResourceError) does not. Cases are known again by their canonical text.
  bool asks(const Case& test_case);

  const std::string& kind() const { return kind_; }
  std::int64_t evaluations() const { return evaluations_; }
  /// For each other way in which a case was seen to violate, the first such case.
  const std::map<std::string, Case>& others() const { return others_; }

 private:
  ViolationKind evaluate(const Case& test_case);

  Predicate predicate_;
  std::string kind_;
  Options options_;
  std::int64_t evaluations_;
  std::unordered_map<std::string, bool> known_;
  std::map<std::string, Case> others_;
};

}  // namespace asts
