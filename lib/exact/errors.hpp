#pragma once

#include <stdexcept>
#include <string>

namespace asts {

/// The caller's fault: input or arguments outside a function's stated domain. The program turns it into exit code 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Our fault: an invariant of this library does not hold. The program turns it into exit code 3.
struct InternalError : std::logic_error {
  using std::logic_error::logic_error;
};

/// A limit was reached that is nobody's fault (2^31 elements, a budget). The program turns it into exit code 3.
struct ResourceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A budget that the caller set was used up before the answer was known.
struct BudgetExhausted : ResourceError {
  using ResourceError::ResourceError;
};

/// Throws InputError unless `condition` holds. Always on.
inline void require(bool condition, const char* what) {
  if (!condition) throw InputError(what);
}

/// Throws InternalError unless `condition` holds. Always on.
inline void ensure(bool condition, const char* what) {
  if (!condition) throw InternalError(what);
}

}  // namespace asts
