#pragma once

#include <string>

#include "lib/mesh/case.hpp"
#include "properties/statement.hpp"

namespace asts {

/// A C++ program of its own that shows how a case violates a statement: it builds the case value by value, with exact
/// numbers, tries the statement, prints one line, and exits with 0 exactly if the statement is violated with a witness
/// of the given kind. To be compiled with the project's root as include path and linked with asts_properties. Equal
/// arguments give equal bytes.
std::string case_snippet(const Case& test_case, const Statement& statement, const std::string& kind);

/// The same with the kind of violation that the case has. Throws InputError when it has none.
std::string case_snippet(const Case& test_case, const Statement& statement);

}  // namespace asts
