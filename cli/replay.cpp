#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/input.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
#include "reports/collection.hpp"

namespace asts::cli {

namespace {

struct Collected {
  std::string name;  ///< without the folder
  CollectedName about;
  Case content;
};

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

Collected read_collected(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const auto about = parse_collection_name(name);
  if (!about) throw InputError(file.string() + ": its name begins with the id of no claim and no property");
  Collected collected{name, *about, read_input(file.string()).content};
  if (about->hash && *about->hash != collection_hash(collected.content)) {
    throw InputError(file.string() + ": is not the case that its name was given for: the hash is " +
                     collection_hash(collected.content));
  }
  return collected;
}

/// How a replay came out.
struct Replayed {
  Verdict verdict;
  bool as_recorded = false;
};

Replayed replay_one(const Collected& collected) {
  Replayed result{try_on_case(collected.about.statement, collected.content).verdict, false};
  const bool violated = result.verdict.outcome == Outcome::violated;
  const std::string& kind = collected.about.kind;
  const bool same_kind = violated && (kind.empty() || kind == kind_of(*result.verdict.witness));
  result.as_recorded = expected_violated(collected.about.statement)
                           ? same_kind
                           : !violated && result.verdict.outcome != Outcome::undecided;
  return result;
}

std::string kind_text(const Verdict& verdict) { return verdict.witness ? kind_of(*verdict.witness) : std::string(); }

std::string replayed_text(const Collected& collected, const Replayed& replayed, Format format) {
  const Statement& statement = collected.about.statement;
  const char* expected = expected_violated(statement) ? "violated" : "not-violated";
  const std::string kind = kind_text(replayed.verdict);
  if (format == Format::json) {
    nlohmann::ordered_json json{{"file", collected.name},
                                {statement.claim != nullptr ? "claim" : "property", statement.id()},
                                {"expected", expected},
                                {"verdict", outcome_name(replayed.verdict.outcome)}};
    if (!kind.empty()) json["kind"] = kind;
    json["as_recorded"] = replayed.as_recorded;
    return json.dump() + "\n";
  }
  return fmt::format("{}: {}: {}{}{}\n", collected.name, statement.id(), outcome_name(replayed.verdict.outcome),
                     kind.empty() ? "" : " (" + kind + ")",
                     replayed.as_recorded ? "" : fmt::format(", but was to be {}", expected));
}

}  // namespace

int replay(const ReplayOptions& options) {
  std::vector<Collected> collection;
  for (const auto& file : case_files(options.folder)) collection.push_back(read_collected(file));
  std::size_t as_recorded = 0;
  for (const Collected& collected : collection) {
    stop_if_interrupted();
    show_progress(collected.name);
    const Replayed replayed = replay_one(collected);
    as_recorded += replayed.as_recorded ? 1 : 0;
    print(replayed_text(collected, replayed, options.format));
  }
  if (options.format == Format::text)
    print(fmt::format("{} of {} cases are as recorded\n", as_recorded, collection.size()));
  return as_recorded == collection.size() ? kHolds : kViolated;
}

}  // namespace asts::cli
