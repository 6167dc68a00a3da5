#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "lib/minimize/exhaust.hpp"
#include "lib/minimize/minimize.hpp"
#include "properties/statement.hpp"

namespace asts {

/// What is known of a minimized case beyond Minimized.
struct MinimizedReport {
  std::string case_name;
  Statement statement;
  Minimized minimized;
  Trial trial;  ///< of the statement for the smallest case
  struct Proof {
    Scope scope;
    bool complete = false;  ///< the scope has every smaller mesh of its settings
    std::int64_t meshes = 0;
    std::int64_t excluded = 0;  ///< settings without active nodes, of which no mesh need be tried
    std::int64_t violating = 0;
  };
  std::optional<Proof> proof;
};

/// "1-minimal", "exhaustive", "budget" or "interrupted".
std::string guarantee_of(const MinimizedReport& report);

/// "2 subdivisions, 2 steps, 4 x 4 x 5 cubes, p = (3,3,3), m = 2, level 2".
std::string size_text(const Case& test_case, const CaseSize& size);
/// The same for programs.
nlohmann::ordered_json size_json(const Case& test_case, const CaseSize& size);

/// The case with comment lines that say what it is a counterexample to, and how large it is. Depends on the case and
/// the kind of the violation alone: minimizing it again gives the same bytes.
std::string minimized_case_text(const MinimizedReport& report);

/// How it was found and how sure it is that it is the smallest, for a person; several lines.
std::string minimized_summary(const MinimizedReport& report);

/// One line of JSON that asts validate reads.
std::string minimized_json(const MinimizedReport& report);

}  // namespace asts
