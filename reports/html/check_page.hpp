#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/mesh/case.hpp"
#include "properties/statement.hpp"
#include "reports/check_report.hpp"

namespace asts {

/// What `asts check --out DIR` records, for a report. Every number of the page comes from here.
struct CheckRun {
  std::string version;       ///< of the program that decided
  bool final_only = false;   ///< only the last mesh of each case
  std::uint64_t budget = 0;  ///< pairs for a property; 0: none
  std::vector<const Property*> properties;
  std::vector<const Claim*> claims;

  struct CheckedCase {
    std::string name;  ///< as given on the command line
    std::string file;  ///< in the run directory
    Case content;
  };
  std::vector<CheckedCase> cases;

  struct Mesh {
    std::size_t place = 0;  ///< of its case
    CheckRecord record;
  };
  std::vector<Mesh> meshes;  ///< in the order of the cases and of their steps; fewer than asked after an interrupt

  /// How many meshes were to be decided.
  std::size_t asked() const;
};

/// The steps of a case of which `asts check` decides the meshes.
std::vector<std::int64_t> checked_steps(const Case& content, bool final_only);

/// The report of a run of `asts check`: one HTML page that needs no other file. Depends on the arguments alone.
/// `version` is that of the program that draws the pictures. Cost: that of the pictures, one or a few for each case and
/// statement that it violates.
std::string check_page(const CheckRun& run, const std::string& version);

}  // namespace asts
