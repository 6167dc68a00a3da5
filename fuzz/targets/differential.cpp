#include "fuzz/targets/targets.hpp"
#include "fuzz/validation/compare_with_literal.hpp"
#include "fuzz/validation/literal_case.hpp"
#include "lib/gen/case_bytes.hpp"
#include "lib/mesh/case_file.hpp"
#include "properties/case_meshes.hpp"

namespace asts::fuzz {

namespace {

Fault compare(const Case& content) {
  reference::ClaimSubject subject = literal::subject(content);
  Fault fault;
  with_last_mesh(content, [&](MeshUnderTest& mesh) {
    const auto difference = compare_with_literal(mesh, subject.setting(), subject.mesh());
    if (difference) fault = difference->about + ": " + difference->says;
  });
  return fault;
}

}  // namespace

Fault differential_fault(Bytes bytes) {
  const Case content = case_of_bytes(bytes, kTinyCases);
  try {
    const Fault fault = compare(content);
    if (!fault) return fault;
    return *fault + "\n" + write_case(content);
  } catch (const std::exception& error) {
    return std::string("an exception that is not documented: ") + error.what() + "\n" + write_case(content);
  }
}

}  // namespace asts::fuzz
