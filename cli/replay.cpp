#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/collected_cases.hpp"
#include "cli/commands.hpp"
#include "cli/terminal.hpp"

namespace asts::cli {

namespace {

/// How a replay came out.
struct Replayed {
  Verdict verdict;
  bool as_recorded = false;
};

Replayed replay_one(const CollectedCase& collected) {
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

std::string replayed_text(const CollectedCase& collected, const Replayed& replayed, Format format) {
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
  const std::vector<CollectedCase> collection = read_collection(options.folder);
  std::size_t as_recorded = 0;
  for (const CollectedCase& collected : collection) {
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
