#include "reports/minimize_report.hpp"

#include <fmt/format.h>

#include "lib/mesh/case_file.hpp"
#include "reports/witness_json.hpp"

namespace asts {

namespace {

using Json = nlohmann::ordered_json;

const char* source_of(const Statement& statement) {
  return statement.claim != nullptr ? statement.claim->source : statement.property->source;
}

const char* word_for(const Statement& statement) { return statement.claim != nullptr ? "claim" : "property"; }

std::string plural(std::int64_t count, const char* word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

std::int64_t element_count(const CaseSize& size) {
  return size.boxes ? size.subdivisions : size.volume + size.subdivisions * (size.grading - 1);
}

Json passes_json(const std::vector<PassRecord>& passes) {
  Json result = Json::array();
  for (const PassRecord& pass : passes) {
    result.push_back({{"pass", pass.pass}, {"evaluations", pass.evaluations}, {"accepted", pass.accepted}});
  }
  return result;
}

Json others_json(const std::map<std::string, Case>& others) {
  Json result = Json::array();
  for (const auto& [kind, test_case] : others) result.push_back({{"kind", kind}, {"mesh", write_case(test_case)}});
  return result;
}

Json proof_json(const MinimizedReport::Proof& proof) {
  return {{"complete", proof.complete},
          {"max_subdivisions", proof.scope.subdivisions},
          {"max_volume", proof.scope.volume},
          {"max_degree", proof.scope.degree},
          {"max_grading", proof.scope.grading},
          {"meshes", proof.meshes},
          {"settings_without_active_nodes", proof.excluded},
          {"violating", proof.violating}};
}

}  // namespace

std::string guarantee_of(const MinimizedReport& report) {
  const bool proved = report.proof && report.proof->complete;
  return proved && report.minimized.guarantee == Guarantee::one_minimal ? "exhaustive"
                                                                        : guarantee_name(report.minimized.guarantee);
}

nlohmann::ordered_json size_json(const Case& test_case, const CaseSize& size) {
  return {{"form", size.boxes ? "boxes" : "steps"},
          {size.boxes ? "boxes" : "subdivisions", size.subdivisions},
          {"steps", size.steps},
          {"volume", size.volume},
          {"domain", test_case.domain},
          {"degree", test_case.degree},
          {"grading", size.grading},
          {"depth", size.depth}};
}

std::string size_text(const Case& test_case, const CaseSize& size) {
  const auto& [x, y, z] = test_case.domain;
  const auto& [p1, p2, p3] = test_case.degree;
  const std::string setting =
      fmt::format("{} x {} x {} cubes, p = ({},{},{}), m = {}", x, y, z, p1, p2, p3, size.grading);
  if (size.boxes) return fmt::format("{} boxes, {}", size.subdivisions, setting);
  return fmt::format("{}, {}, {}, level {}", plural(size.subdivisions, "subdivision"), plural(size.steps, "step"),
                     setting, size.depth);
}

std::string minimized_case_text(const MinimizedReport& report) {
  return fmt::format("# Counterexample to the {} {} ({}): {}.\n# {}.\n{}", word_for(report.statement),
                     report.statement.id(), source_of(report.statement), report.minimized.kind,
                     size_text(report.minimized.smallest, report.minimized.size),
                     write_case(report.minimized.smallest));
}

std::string minimized_summary(const MinimizedReport& report) {
  const Minimized& minimized = report.minimized;
  std::string result = fmt::format("{} ({}): {}\n{} after {}\n", report.statement.id(), minimized.kind,
                                   size_text(minimized.smallest, minimized.size), guarantee_of(report),
                                   plural(minimized.evaluations, "evaluation"));
  if (report.proof) {
    result += fmt::format("{}: {} meshes and {} settings without active nodes, {} violate, none is smaller\n",
                          scope_text(report.proof->scope), report.proof->meshes, report.proof->excluded,
                          report.proof->violating);
  }
  for (const auto& [kind, other] : minimized.others) result += fmt::format("met on the way: {}\n", kind);
  return result;
}

std::string minimized_json(const MinimizedReport& report) {
  const Minimized& minimized = report.minimized;
  Json json{{"case", report.case_name},
            {word_for(report.statement), report.statement.id()},
            {"kind", minimized.kind},
            {"size", size_json(minimized.smallest, minimized.size)},
            {"guarantee", guarantee_of(report)},
            {"evaluations", minimized.evaluations}};
  if (report.proof) json["proof"] = proof_json(*report.proof);
  json["last_run"] = passes_json(minimized.last_run);
  json["others"] = others_json(minimized.others);
  json["step"] = minimized.smallest.steps.size();
  if (!report.statement.of_sequence()) json["elements"] = element_count(minimized.size);
  Json verdict = verdict_json(report.trial.verdict);
  if (report.statement.claim != nullptr) verdict["met"] = report.trial.met;
  json[report.statement.claim != nullptr ? "claims" : "properties"][report.statement.id()] = verdict;
  json["witness_format"] = kWitnessFormat;
  json["mesh"] = write_case(minimized.smallest);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace asts
