#include "reports/check_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/witness_json.hpp"
#include "reports/witness_text.hpp"

namespace asts {

namespace {

/// What does not hold, for a person. `statement` is a property or a claim.
template <class Statement>
std::string failure_text(const Statement& statement, const Verdict& verdict) {
  std::string result = fmt::format("  {}: {} ({})\n", outcome_name(verdict.outcome), statement.id, statement.source);
  if (!verdict.reason.empty()) result += fmt::format("      {}\n", verdict.reason);
  if (!verdict.witness) return result;
  return result + fmt::format("      it should be that {}; but\n", statement.statement) +
         witness_text(*verdict.witness);
}

bool has_witness(const CheckRecord& record) {
  const auto violated = [](const Verdict& verdict) { return verdict.outcome == Outcome::violated; };
  return std::any_of(record.entries.begin(), record.entries.end(),
                     [&](const auto& entry) { return violated(entry.verdict); }) ||
         std::any_of(record.claims.begin(), record.claims.end(),
                     [&](const auto& entry) { return violated(entry.trial.verdict); });
}

}  // namespace

std::string check_json(const CheckRecord& record) {
  nlohmann::ordered_json json{{"case", record.case_name}, {"step", record.step}};
  if (record.mesh) {
    json["elements"] = record.mesh->elements;
    json["new_elements"] = record.mesh->new_elements;
    json["max_level"] =
        record.mesh->max_level ? nlohmann::ordered_json(*record.mesh->max_level) : nlohmann::ordered_json(nullptr);
    json["active_nodes"] = record.mesh->active_nodes;
    json["properties"] = nlohmann::ordered_json::object();
  }
  for (const CheckRecord::Entry& entry : record.entries) {
    json["properties"][entry.property->id] = verdict_json(entry.verdict);
  }
  for (const CheckRecord::ClaimEntry& entry : record.claims) {
    nlohmann::ordered_json verdict = verdict_json(entry.trial.verdict);
    verdict["met"] = entry.trial.met;
    json["claims"][entry.claim->id] = verdict;
  }
  if (has_witness(record)) json["witness_format"] = kWitnessFormat;
  if (!record.mesh_case.empty()) json["mesh"] = record.mesh_case;
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string check_text(const CheckRecord& record) {
  std::string result = fmt::format("{}: step {}:", record.case_name, record.step);
  if (const auto& mesh = record.mesh) {
    result += fmt::format(" {} elements ({} new), {}, {} active nodes:", mesh->elements, mesh->new_elements,
                          mesh->max_level ? fmt::format("level {}", *mesh->max_level) : "no integer levels",
                          mesh->active_nodes);
  }
  std::string held;
  int held_count = 0;
  std::string rest;
  const auto add = [&](const auto& statement, const Verdict& verdict) {
    if (verdict.outcome == Outcome::holds) {
      held += std::string(held.empty() ? "" : ", ") + statement.id;
      ++held_count;
    } else {
      rest += failure_text(statement, verdict);
    }
  };
  for (const CheckRecord::Entry& entry : record.entries) add(*entry.property, entry.verdict);
  for (const CheckRecord::ClaimEntry& entry : record.claims) add(*entry.claim, entry.trial.verdict);
  const bool all = rest.empty() && held_count > 1;
  if (held_count > 0) result += fmt::format(" {} {}", all ? "all" : held, held_count == 1 ? "holds" : "hold");
  result += "\n";
  return result + rest;
}

std::string refine_json(const RefineRecord& record) {
  const nlohmann::ordered_json json{{"step", record.counts.step},
                                    {"marked", record.counts.marked},
                                    {"subdivided", record.counts.subdivided},
                                    {"elements", record.elements},
                                    {"new_elements", record.new_elements}};
  return json.dump() + "\n";
}

std::string refine_text_header() {
  return fmt::format("{:>6}  {:>10}  {:>10}  {:>12}  {:>12}\n", "step", "marked", "subdivided", "elements",
                     "new elements");
}

std::string refine_text(const RefineRecord& record) {
  return fmt::format("{:>6}  {:>10}  {:>10}  {:>12}  {:>12}\n", record.counts.step, record.counts.marked,
                     record.counts.subdivided, record.elements, record.new_elements);
}

}  // namespace asts
