#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lib/gen/case_bytes.hpp"

namespace asts::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// What is wrong with the program when it is given these bytes, in words, with the case where there is one; nothing
/// when nothing is. What crashes or hangs is left to the fuzzer and the sanitizers.
using Fault = std::optional<std::string>;

/// Bytes as a case (lib/gen/case_bytes.hpp), all claims on its last mesh and on its sequence, each on the meshes and
/// up to the size that the Ledger tries it on. Wrong: a violated claim that is not known to be refuted; a violation
/// whose witness the literal code does not accept (asked for small meshes); an exception other than ResourceError.
Fault claims_fault(Bytes bytes);

/// Bytes as a case. Wrong: the mesh kernel and the literal code make different meshes of it, or decide one of the five
/// properties differently; a violation without a witness, or with one that the literal code does not accept.
Fault differential_fault(Bytes bytes);

/// Bytes as the text of a case file. Wrong: neither a case nor a CaseFileError with a line of the text; a case that
/// changes when it is written and read again; for a small case, a replay or a tiling that throws anything but what is
/// documented.
Fault case_reader_fault(Bytes bytes);

/// Bytes as a record of witnesses (fuzz/validation/validate_record.hpp). Wrong: any exception but InputError. Files
/// that a record names are not opened, and large cases are not decided.
Fault witness_reader_fault(Bytes bytes);

struct Target {
  const char* name;  ///< as in fuzz_NAME, replay_NAME and fuzz/corpora/NAME
  Fault (*fault)(Bytes);
  const ByteCaseLimits* limits;  ///< with which case_of_bytes decodes the bytes; nullptr where they are text
};

std::span<const Target> all_targets();
/// nullptr if there is none.
const Target* find_target(std::string_view name);

/// The same, where an exception is a fault too: what entry points, replayers and tests call.
Fault checked_fault(const Target& target, Bytes bytes);

}  // namespace asts::fuzz
