#include "fuzz/validation/validate_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "fuzz/validation/literal_case.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "tests/reference/claim_witness.hpp"

namespace asts {

namespace {

using Json = nlohmann::json;

/// The case of a record: the one it carries, or the file that it names.
Case case_of(const Json& record, const std::string& file, const std::string& place) {
  if (record.contains("mesh")) return parse_case(record.at("mesh").get<std::string>(), place + ": mesh");
  const std::string name = record.at("case").get<std::string>();
  const std::filesystem::path beside = std::filesystem::path(file).parent_path() / name;
  return read_case_file(std::filesystem::exists(name) ? name : beside.string());
}

/// What a record is about, and what speaks against the record itself; empty when nothing does.
struct LiteralRecord {
  reference::ClaimSubject subject;
  std::string objection;
};

/// A record of claims alone may lack `elements`: it may be about a sequence whose mesh is too large to be made.
std::string objection_to_elements(const Json& record, reference::ClaimSubject& subject) {
  if (!record.contains("elements") && !record.contains("properties")) return {};
  try {
    const auto elements = subject.element_count();
    if (!elements || record.at("elements") == *elements) return {};
    return fmt::format("the mesh has {} elements, not {}", *elements, record.at("elements").dump());
  } catch (const reference::Rejected& reason) {
    return reason.what();
  }
}

LiteralRecord literal_record(const Json& record, const std::string& file, const std::string& place) {
  const Case content = case_of(record, file, place);
  const Json& step = record.at("step");
  const std::size_t most = content.steps.size();
  if (!step.is_number_unsigned() || step > most || (record.contains("mesh") && step != most)) {
    return {literal::subject(content, 0),
            fmt::format("step {} is not what the record's case of {} steps says", step.dump(), most)};
  }
  LiteralRecord result{literal::subject(content, step.get<std::size_t>()), {}};
  result.objection = objection_to_elements(record, result.subject);
  return result;
}

constexpr std::array kVerdicts{"holds", "violated", "not-applicable", "undecided"};

bool is_violated(const Json& entry) {
  const std::string verdict = entry.at("verdict").get<std::string>();
  if (std::find(kVerdicts.begin(), kVerdicts.end(), verdict) == kVerdicts.end()) {
    throw InputError("'" + verdict + "' is no verdict");
  }
  return verdict == "violated";
}

/// What is decided of a witness of one kind of statement.
using Decide = reference::Validation (*)(reference::ClaimSubject&, const std::string& id, const Json& witness);

reference::Validation decide_property(reference::ClaimSubject& subject, const std::string& id, const Json& witness) {
  return reference::validate_witness(subject.setting(), subject.mesh(), id, witness);
}

/// The version of reports/WITNESS.md that is decided here.
constexpr int kKnownFormat = 1;

class RecordValidator {
 public:
  RecordValidator(const Json& record, const std::string& file, const std::string& place)
      : record_(record), file_(file), place_(place) {}

  /// Throws InputError for a version of the form that is not known; a record without one has version 1.
  std::vector<ValidatedWitness> validate() {
    if (record_.contains("witness_format") && record_.at("witness_format") != kKnownFormat) {
      throw InputError("witness_format is " + record_.at("witness_format").dump() + ", and only 1 is known");
    }
    if (record_.contains("properties")) add_all("property", record_.at("properties"), decide_property);
    if (record_.contains("claims")) add_all("claim", record_.at("claims"), reference::validate_claim_witness);
    return std::move(findings_);
  }

 private:
  void add_all(const char* statement, const Json& entries, Decide decide) {
    for (const auto& [id, entry] : entries.items()) {
      if (is_violated(entry)) findings_.push_back({statement, id, validation_of(id, entry, decide)});
    }
  }

  reference::Validation validation_of(const std::string& id, const Json& entry, Decide decide) {
    if (!entry.contains("witness")) return {false, "the verdict is violated, but there is no witness"};
    if (!literal_) literal_ = literal_record(record_, file_, place_);
    if (!literal_->objection.empty()) return {false, literal_->objection};
    return decide(literal_->subject, id, entry.at("witness"));
  }

  const Json& record_;
  const std::string& file_;
  const std::string& place_;
  std::optional<LiteralRecord> literal_;
  std::vector<ValidatedWitness> findings_;
};

}  // namespace

std::optional<Json> parse_record(const std::string& line) {
  Json content = Json::parse(line, nullptr, false);
  if (content.is_discarded() || !content.is_object()) return std::nullopt;
  if (!content.contains("properties") && !content.contains("claims")) return std::nullopt;
  return content;
}

std::vector<ValidatedWitness> validate_record(const Json& record, const std::string& file, const std::string& place) {
  try {
    return RecordValidator(record, file, place).validate();
  } catch (const Json::exception& error) {
    const std::string reason = error.what();  // "[json.exception.NAME.NUMBER] words"
    throw InputError(place + ": malformed record: " + reason.substr(reason.find("] ") + 2));
  } catch (const CaseFileError&) {
    throw;  // names its own place
  } catch (const InputError& error) {
    throw InputError(place + ": malformed record: " + error.what());
  }
}

}  // namespace asts
