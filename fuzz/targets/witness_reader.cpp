#include "fuzz/targets/small_case.hpp"
#include "fuzz/targets/targets.hpp"
#include "fuzz/validation/validate_record.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"

namespace asts::fuzz {

namespace {

constexpr std::int64_t kMostElements = 300;

/// The literal code is not made for large cases. What is no case is small enough.
bool is_small_record(const nlohmann::json& record) {
  const auto mesh = record.find("mesh");
  if (mesh == record.end() || !mesh->is_string()) return true;
  try {
    return is_small(parse_case(mesh->get<std::string>(), "mesh"), kMostElements);
  } catch (const CaseFileError&) {
    return true;
  }
}

}  // namespace

Fault witness_reader_fault(Bytes bytes) {
  auto record = parse_record(std::string(bytes.begin(), bytes.end()));
  if (!record) return std::nullopt;
  record->erase("case");  // a file, which may be anything
  if (!is_small_record(*record)) return std::nullopt;
  try {
    validate_record(*record, "bytes", "bytes:1");
  } catch (const InputError&) {
    // malformed, and said to be
  }
  return std::nullopt;
}

}  // namespace asts::fuzz
