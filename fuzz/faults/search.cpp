/// search_for_faults SEED SECONDS [CASE...]: looks for a fault of the code as a campaign does, and says after how many
/// meshes it found one. Each mesh of a case (those given first, then random ones) is decided by the fast and by the
/// literal code, and by all claims that nothing has refuted.
///
/// Prints a line for each mesh before it is looked at, so that the count survives a crash; then "caught: WHAT" with
/// exit code 1, or "nothing" with 0.

#include <chrono>
#include <iostream>
#include <stdexcept>

#include "lib/gen/case_stream.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/replay.hpp"
#include "properties/ledger/trials.hpp"
#include "properties/properties.hpp"
#include "reports/witness_json.hpp"
#include "tests/reference/claim_subject.hpp"
#include "tests/reference/decide.hpp"
#include "tests/reference/validate.hpp"

namespace asts {
namespace {

/// The literal code takes some milliseconds for a mesh of this size.
constexpr std::size_t kMostLiteralElements = 200;

[[noreturn]] void caught(const std::string& what) { throw std::runtime_error(what); }

reference::Point literal(const Point& point) { return {point[0].value(), point[1].value(), point[2].value()}; }

reference::Setting literal(const Setting& setting) { return {setting.degree, setting.grading, setting.domain}; }

reference::Mesh literal(const Mesh& mesh) {
  reference::Mesh result;
  for (const Box& element : mesh.elements) {
    reference::Box& box = result.emplace_back();
    for (Axis axis = 0; axis < kDimension; ++axis) {
      box.lower[at(axis)] = mesh.coordinate(axis, element.lower[at(axis)]);
      box.upper[at(axis)] = mesh.coordinate(axis, element.upper[at(axis)]);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

const char* name(reference::Verdict verdict) {
  return verdict == reference::Verdict::holds      ? "holds"
         : verdict == reference::Verdict::violated ? "violated"
                                                   : "not-applicable";
}

std::vector<const Claim*> unrefuted() {
  std::vector<const Claim*> result;
  for (const Claim& claim : all_claims()) {
    if (!claim.refuted) result.push_back(&claim);
  }
  return result;
}

class Search {
 public:
  explicit Search(std::chrono::seconds time) : end_(std::chrono::steady_clock::now() + time) {}

  bool has_time() const { return std::chrono::steady_clock::now() < end_; }

  void look_at(const Case& content, const char* bias) {
    std::cout << "mesh " << ++meshes_ << '\n' << std::flush;
    if (write_case(parse_case(write_case(content), "case")) != write_case(content)) caught("a case is read otherwise");
    TrialSubject subject(0, content, bias);
    if (content.explicit_mesh) {
      reference::Mesh boxes;
      for (const ElementLine& line : content.elements) boxes.push_back({literal(line.lower), literal(line.upper)});
      MeshUnderTest mesh(mesh_of(setting_of(content), content.elements));
      return look_at_mesh(subject, mesh, boxes);
    }
    reference::Mesh boxes = reference::initial_mesh(literal(setting_of(content)));
    Replay replay(content);
    for (const Step& step : content.steps) {
      if (boxes.size() <= kMostLiteralElements) boxes = after(content, boxes, step);
      replay.advance();
      if (++subject.step > 1) std::cout << "mesh " << ++meshes_ << '\n' << std::flush;
      MeshUnderTest mesh(replay.tree());
      look_at_mesh(subject, mesh, boxes);
    }
    if (Trials::is_sequence(content)) trials_.on_sequence(subject);
  }

 private:
  static reference::Mesh after(const Case& content, const reference::Mesh& boxes, const Step& step) {
    reference::LiteralStep literal_step{step.kind == Step::Kind::refine, {}};
    for (const Point& mark : step.marks) literal_step.marks.push_back(literal(mark));
    return reference::after_step(literal(setting_of(content)), boxes, literal_step);
  }

  void look_at_mesh(TrialSubject& subject, MeshUnderTest& mesh, reference::Mesh boxes) {
    std::sort(boxes.begin(), boxes.end());
    if (boxes.size() <= kMostLiteralElements) compare(mesh, boxes);
    subject.looks_at(mesh, fingerprint_of(mesh.mesh()));
    trials_.on_mesh(subject, mesh);
  }

  static void compare(MeshUnderTest& mesh, const reference::Mesh& boxes) {
    if (literal(mesh.mesh()) != boxes) caught("literal: other elements");
    const reference::Setting setting = literal(mesh.mesh().setting);
    const reference::Verdicts expected = reference::decide(setting, boxes);
    const std::array verdicts{expected.admissible, expected.nested_patches, expected.analysis_suitable,
                              expected.dual_compatible, expected.dual_basis};
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      const Property& property = all_properties()[i];
      const Verdict verdict = decide(property, mesh);
      if (outcome_name(verdict.outcome) != std::string(name(verdicts[i])))
        caught(std::string("literal: ") + property.id);
      if (!verdict.witness) continue;
      const auto json = nlohmann::json::parse(witness_json(*verdict.witness).dump());
      if (!reference::validate_witness(setting, boxes, property.id, json).valid)
        caught(std::string("literal: the witness against ") + property.id);
    }
  }

  static Trials::Options options() {
    Trials::Options options;
    options.violated = [](std::size_t place, const TrialSubject*, const Verdict&) {
      caught(std::string("claim: ") + unrefuted()[place]->id);
    };
    return options;
  }

  std::chrono::steady_clock::time_point end_;
  std::int64_t meshes_ = 0;
  Trials trials_{unrefuted(), options()};
};

void run(std::uint64_t seed, int seconds, std::span<char*> files) {
  Search search{std::chrono::seconds(seconds)};
  for (const char* file : files) search.look_at(read_case_file(file), "file");
  for (std::int64_t number = 0; search.has_time(); ++number) {
    const RandomCase random = make_case(plan_case(seed, number));
    search.look_at(random.content, bias_name(random.bias));
  }
}

}  // namespace
}  // namespace asts

int main(int count, char** words) {
  if (count < 3) {
    std::cerr << "search_for_faults SEED SECONDS [CASE...]\n";
    return 2;
  }
  try {
    asts::run(std::stoull(words[1]), std::stoi(words[2]), std::span(words, static_cast<std::size_t>(count)).subspan(3));
  } catch (const std::exception& error) {
    const std::string what = error.what();
    std::cout << "caught: " << what.substr(0, what.find('\n')) << '\n';
    return 1;
  }
  std::cout << "nothing\n";
  return 0;
}
