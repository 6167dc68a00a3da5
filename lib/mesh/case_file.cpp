#include "lib/mesh/case_file.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace asts {
namespace {

[[noreturn]] void fail_with_errno(const std::string& path, int error) {
  throw CaseFileError(path + ": cannot be read: " + std::generic_category().message(error));
}

/// All of the stream. Stops at a NUL byte, which no case has: a device or a huge binary file is not read to its end.
std::string read_text(std::FILE* stream, const std::string& name) {
  constexpr std::size_t kChunk = std::size_t{1} << 20U;
  std::string text;
  std::size_t got = kChunk;
  while (got == kChunk) {
    const std::size_t begin = text.size();
    text.resize(begin + kChunk);
    got = std::fread(text.data() + begin, 1, kChunk, stream);
    if (std::ferror(stream) != 0) fail_with_errno(name, errno);
    text.resize(begin + got);
    if (text.find('\0', begin) != std::string::npos) break;
  }
  return text;
}

}  // namespace

Case read_case_file(const std::string& path) {
  if (path == "-") return parse_case(read_text(stdin, "<stdin>"), "<stdin>");
  const auto close = [](std::FILE* stream) { std::fclose(stream); };
  const std::unique_ptr<std::FILE, decltype(close)> stream(std::fopen(path.c_str(), "rb"), close);
  if (!stream) fail_with_errno(path, errno);
  return parse_case(read_text(stream.get(), path), path);
}

}  // namespace asts
