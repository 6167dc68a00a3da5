#include "fuzz/campaign/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "lib/exact/errors.hpp"
#include "lib/mesh/fnv1a.hpp"

namespace asts {

namespace {

constexpr std::string_view kSealBegin = ",\"check\":\"";
constexpr std::string_view kSealEnd = "\"}";
constexpr std::size_t kDigits = 16;

/// Writes all of it; false when that cannot be done.
bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return fdatasync(file) == 0;
}

std::string reason() { return std::strerror(errno); }

/// A new name is on the disk when its folder is.
void sync_folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const int file = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;
  fsync(file);
  close(file);
}

}  // namespace

std::string sealed(std::string_view object) {
  ensure(object.size() > 2 && object.back() == '}', "an object is sealed");
  object.remove_suffix(1);
  return fmt::format("{}{}{:016x}{}", object, kSealBegin, fnv1a(object), kSealEnd);
}

std::optional<std::string> unsealed(std::string_view line) {
  const std::size_t seal = kSealBegin.size() + kDigits + kSealEnd.size();
  if (line.size() <= seal) return std::nullopt;
  const std::string_view object = line.substr(0, line.size() - seal);
  const std::string whole = std::string(object) + "}";
  return sealed(whole) == line ? std::optional(whole) : std::nullopt;
}

JournalReader::JournalReader(std::string path) : path_(std::move(path)), file_(path_, std::ios::binary) {
  if (!file_ && std::filesystem::exists(path_)) throw InputError(path_ + ": cannot be read");
}

/// With its line end, which is not returned.
std::optional<std::string> JournalReader::next_line() {
  std::string line;
  const bool complete = std::getline(file_, line) && !file_.eof();
  if (file_.bad()) throw InputError(path_ + ": cannot be read");
  return complete ? std::optional(line) : std::nullopt;
}

std::optional<std::string> JournalReader::next() {
  auto line = next_line();
  if (!line) return std::nullopt;
  auto object = unsealed(*line);
  if (object) {
    ++line_;
    end_ += line->size() + 1;
    return object;
  }
  while ((line = next_line())) {
    if (unsealed(*line)) throw InputError(fmt::format("{}:{}: the record is damaged", path_, line_ + 1));
  }
  return std::nullopt;
}

Journal::Journal(std::string path, std::uint64_t bytes)
    : path_(std::move(path)), file_(open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0) throw InputError(path_ + ": cannot be opened: " + reason());
  if (ftruncate(file_, static_cast<off_t>(bytes)) != 0 || lseek(file_, 0, SEEK_END) < 0) {
    const std::string why = reason();
    close(file_);
    throw InputError(path_ + ": cannot be continued: " + why);
  }
  sync_folder_of(path_);
}

Journal::~Journal() { close(file_); }

void Journal::append(std::string_view object) {
  if (!write_all(file_, sealed(object) + "\n")) throw ResourceError(path_ + ": cannot be written: " + reason());
}

void replace_file(const std::string& path, std::string_view content) {
  const std::string written = path + ".part";
  const int file = open(written.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const bool complete = file >= 0 && write_all(file, content);
  if (file >= 0) close(file);
  if (!complete || std::rename(written.c_str(), path.c_str()) != 0) {
    throw ResourceError(path + ": cannot be written: " + reason());
  }
  sync_folder_of(path);
}

FolderLock::FolderLock(const std::string& folder)
    : file_(open((folder + "/lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  // a lock of this kind belongs to the process, not to the file that its children inherit
  struct flock lock = {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  if (file_ < 0) throw InputError(folder + ": cannot be written to: " + reason());
  if (fcntl(file_, F_SETLK, &lock) != 0) {
    close(file_);
    throw InputError(folder + ": another campaign is writing to it");
  }
}

FolderLock::~FolderLock() { close(file_); }

}  // namespace asts
