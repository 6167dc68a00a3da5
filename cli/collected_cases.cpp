#include "cli/collected_cases.hpp"

#include <algorithm>
#include <filesystem>

#include "cli/input.hpp"
#include "lib/exact/errors.hpp"

namespace asts::cli {

namespace {

std::vector<std::filesystem::path> case_files(const std::string& folder) {
  std::error_code error;
  std::filesystem::directory_iterator entries(folder, error);
  if (error) throw InputError(folder + ": is no folder that can be read");
  std::vector<std::filesystem::path> files;
  for (const auto& entry : entries) {
    if (entry.path().extension() == ".case") files.push_back(entry.path());
  }
  if (files.empty()) throw InputError(folder + ": has no case");
  std::sort(files.begin(), files.end());
  return files;
}

CollectedCase read_collected(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const auto about = parse_collection_name(name);
  if (!about) throw InputError(file.string() + ": its name begins with the id of no claim and no property");
  CollectedCase collected{name, *about, read_input(file.string()).content};
  if (about->hash && *about->hash != collection_hash(collected.content)) {
    throw InputError(file.string() + ": is not the case that its name was given for: the hash is " +
                     collection_hash(collected.content));
  }
  return collected;
}

}  // namespace

std::vector<CollectedCase> read_collection(const std::string& folder) {
  std::vector<CollectedCase> collection;
  for (const auto& file : case_files(folder)) collection.push_back(read_collected(file));
  return collection;
}

}  // namespace asts::cli
