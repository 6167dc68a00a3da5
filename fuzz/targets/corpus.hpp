#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/targets/targets.hpp"

namespace asts::fuzz {

struct CorpusFile {
  std::string path;
  std::vector<std::uint8_t> bytes;
};

/// The files, and those of folders (not of folders therein), by path. Throws InputError when one cannot be read, or
/// when there is none at all: a corpus that is gone must not look like one without faults.
std::vector<CorpusFile> read_corpus(const std::vector<std::string>& paths);

/// The name of a corpus file: FNV-1a, 64 bits, of its bytes, as 16 hexadecimal digits.
std::string corpus_name(Bytes bytes);

}  // namespace asts::fuzz
