#pragma once

#include <optional>
#include <string>

#include "lib/mesh/case.hpp"
#include "lib/mesh/mesh.hpp"

namespace asts::cli {

/// A case that was read, with its mesh when it is an explicit one: all that can be wrong with it has been looked at.
struct Input {
  std::string name;  ///< as given on the command line
  Case content;
  std::optional<Mesh> mesh;
};

/// Reads a file, or standard input for "-". Throws InputError that names the file and, where there is one, the line.
Input read_input(const std::string& path);

}  // namespace asts::cli
