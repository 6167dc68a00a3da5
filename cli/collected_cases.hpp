#pragma once

#include <string>
#include <vector>

#include "reports/collection.hpp"

namespace asts::cli {

/// A case of a collection.
struct CollectedCase {
  std::string name;  ///< of its file, without the folder
  CollectedName about;
  Case content;
};

/// All cases of a folder, by name. Throws InputError when there is none, when one cannot be read, when a name says
/// nothing, or when its hash is that of another case.
std::vector<CollectedCase> read_collection(const std::string& folder);

}  // namespace asts::cli
