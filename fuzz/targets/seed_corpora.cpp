// seed_corpora OUT CASE...: writes the seeds of all targets to OUT/TARGET/HASH. Cases become bytes where case_bytes.hpp
// can express them; the case reader gets the texts; the witness reader a record for each case, with the witness of
// every violation of it.
//
// seed_corpora --adopt FOLDER FILE|FOLDER...: copies files into FOLDER under the names that a corpus has.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "fuzz/targets/corpus.hpp"
#include "lib/exact/errors.hpp"
#include "lib/gen/case_bytes.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "properties/ledger/trials.hpp"
#include "properties/statement.hpp"
#include "reports/witness_json.hpp"

namespace {

using asts::fuzz::Bytes;

/// Longer texts are no seeds: a fuzzer would spend its time on copies of them.
constexpr std::size_t kLongestText = 3000;
constexpr std::size_t kMostElements = 300;

Bytes bytes_of(const std::string& text) { return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}; }

void write_seed(const std::filesystem::path& folder, Bytes bytes) {
  std::filesystem::create_directories(folder);
  std::ofstream file(folder / asts::fuzz::corpus_name(bytes), std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

std::vector<asts::Statement> statements_for(const asts::Case& content) {
  std::vector<asts::Statement> statements;
  for (const asts::Property& property : asts::all_properties()) statements.push_back({nullptr, &property});
  for (const asts::Claim& claim : asts::all_claims()) {
    if (claim.on_mesh != nullptr || (claim.on_sequence != nullptr && asts::Trials::is_sequence(content))) {
      statements.push_back({&claim, nullptr});
    }
  }
  return statements;
}

std::size_t element_count(const asts::Case& content) {
  if (content.explicit_mesh) return content.elements.size();
  asts::Replay replay(content);
  while (!replay.done()) replay.advance();
  return static_cast<std::size_t>(replay.tree().element_count());
}

/// A record as reports/WITNESS.md has it; nothing when the case violates nothing, or is too large.
std::optional<std::string> record_of(const asts::Case& content) {
  const std::size_t elements = element_count(content);
  if (elements > kMostElements) return std::nullopt;
  nlohmann::ordered_json record{{"step", content.steps.size()}, {"elements", elements}};
  bool violated = false;
  for (const asts::Statement& statement : statements_for(content)) {
    const asts::Verdict verdict = asts::try_on_case(statement, content).verdict;
    if (verdict.outcome != asts::Outcome::violated) continue;
    violated = true;
    record[statement.claim != nullptr ? "claims" : "properties"][statement.id()] = asts::verdict_json(verdict);
  }
  if (!violated) return std::nullopt;
  record["witness_format"] = asts::kWitnessFormat;
  record["mesh"] = asts::write_case(content);
  return record.dump();
}

void write_seeds(const std::filesystem::path& out, const std::string& file) {
  const asts::Case content = asts::read_case_file(file);
  for (const asts::fuzz::Target& target : asts::fuzz::all_targets()) {
    if (target.limits == nullptr) continue;
    if (const auto bytes = asts::bytes_of_case(content, *target.limits)) write_seed(out / target.name, *bytes);
  }
  if (std::filesystem::file_size(file) > kLongestText) return;
  std::ifstream stream(file, std::ios::binary);
  write_seed(out / "case_reader", bytes_of({std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}));
  if (const auto record = record_of(content)) write_seed(out / "witness_reader", bytes_of(*record));
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    asts::require(arguments.size() >= 2, "seed_corpora OUT CASE... or seed_corpora --adopt FOLDER FILE|FOLDER...");
    if (arguments[0] == "--adopt") {
      for (const auto& file : asts::fuzz::read_corpus({arguments.begin() + 2, arguments.end()})) {
        write_seed(arguments[1], file.bytes);
      }
      return 0;
    }
    for (std::size_t i = 1; i < arguments.size(); ++i) write_seeds(arguments[0], arguments[i]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
