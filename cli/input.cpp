#include "cli/input.hpp"

#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"

namespace asts::cli {

Input read_input(const std::string& path) {
  Input input{path, read_case_file(path), {}};
  if (!input.content.explicit_mesh) return input;
  try {
    input.mesh = mesh_of(setting_of(input.content), input.content.elements);
  } catch (const InputError& error) {
    throw InputError((path == "-" ? "<stdin>" : path) + ":" + error.what());
  }
  return input;
}

}  // namespace asts::cli
