#include "fuzz/campaign/sealed_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

/// "[json.exception.NAME.NUMBER] words" without what a reader has no use for.
std::string words_of(const nlohmann::json::exception& error) {
  const std::string reason = error.what();
  return reason.substr(reason.find("] ") + 2);
}

std::uint64_t size_of_file(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw InputError(path + ": is no file");
  return std::filesystem::file_size(path);
}

}  // namespace

SealedLines::SealedLines(const std::string& path) : path_(path), size_(size_of_file(path)), lines_(path) {}

std::optional<std::string> SealedLines::next() {
  auto object = lines_.next();
  if (!object && lines_.end() != size_) {
    throw InputError(fmt::format("{}:{}: the record is cut off or damaged", path_, lines_.line() + 1));
  }
  return object;
}

void SealedLines::at_this_line(const std::function<void()>& take) const {
  try {
    take();
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}:{}: {}", path_, lines_.line(), words_of(error)));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}:{}: {}", path_, lines_.line(), error.what()));
  }
}

std::string content_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  if (!file || std::filesystem::is_directory(path)) throw InputError(path + ": cannot be read");
  return content.str();
}

nlohmann::ordered_json json_of_file(const std::string& path) {
  const std::string text = content_of_file(path);
  try {
    return nlohmann::ordered_json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    throw InputError(fmt::format("{}:{}: is cut off or no JSON", path, 1 + std::count(text.begin(), end, '\n')));
  }
}

}  // namespace asts
