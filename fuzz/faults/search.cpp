/// search_for_faults SEED SECONDS [CASE...]: looks for a fault of the code as a campaign does, and says after how many
/// meshes it found one. Each mesh of a case (those given first, then random ones) is decided by the fast and by the
/// literal code, and by all claims that nothing has refuted.
///
/// Prints a line for each mesh before it is looked at, so that the count survives a crash; then "caught: WHAT" with
/// exit code 1, or "nothing" with 0.

#include <chrono>
#include <iostream>
#include <stdexcept>

#include "fuzz/validation/compare_with_literal.hpp"
#include "fuzz/validation/literal_case.hpp"
#include "lib/gen/case_stream.hpp"
#include "lib/mesh/case_file.hpp"
#include "properties/case_meshes.hpp"
#include "properties/ledger/trials.hpp"

namespace asts {
namespace {

/// The literal code takes some milliseconds for a mesh of this size.
constexpr std::size_t kMostLiteralElements = 200;

[[noreturn]] void caught(const std::string& what) { throw std::runtime_error(what); }

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
    say_mesh();
    if (write_case(parse_case(write_case(content), "case")) != write_case(content)) caught("a case is read otherwise");
    TrialSubject subject(0, content, bias);
    const reference::Setting setting = literal::setting(setting_of(content));
    reference::Mesh boxes = content.explicit_mesh ? literal::boxes(content) : reference::initial_mesh(setting);
    for_each_mesh(content, [&](std::size_t step, MeshUnderTest& mesh) {
      if (step == 0 && !content.steps.empty()) return;
      if (step > 1) say_mesh();
      if (step > 0 && boxes.size() <= kMostLiteralElements) {
        boxes = reference::after_step(setting, boxes, literal::step(content.steps[step - 1]));
      }
      subject.step = step;
      if (boxes.size() <= kMostLiteralElements) compare(mesh, setting, boxes);
      subject.looks_at(mesh, fingerprint_of(mesh.mesh()));
      trials_.on_mesh(subject, mesh);
    });
    if (Trials::is_sequence(content)) trials_.on_sequence(subject);
  }

 private:
  void say_mesh() { std::cout << "mesh " << ++meshes_ << '\n' << std::flush; }

  static void compare(MeshUnderTest& mesh, const reference::Setting& setting, const reference::Mesh& boxes) {
    if (const auto difference = compare_with_literal(mesh, setting, boxes)) caught("literal: " + difference->about);
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
