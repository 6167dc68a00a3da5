#include "tests/benchmarks/inputs.hpp"

#include "lib/gen/draw.hpp"
#include "lib/gen/growing_case.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/refine/refinement.hpp"

namespace asts::benchmarks {

namespace {

Setting setting_of(const Input& input) {
  return {{input.degree, input.degree, input.degree}, input.grading, {16, 16, 16}};
}

Case case_of(const Input& input) { return generate_workload(input.workload, setting_of(input), input.elements); }

}  // namespace

std::string Input::name() const {
  return std::string(workload_names()[static_cast<std::size_t>(workload)]) + "/p" + std::to_string(degree) + "/m" +
         std::to_string(grading) + "/" + std::to_string(elements);
}

std::vector<Input> all_inputs() {
  std::vector<Input> inputs;
  for (const Workload workload : {Workload::sphere, Workload::corner, Workload::random}) {
    for (const int degree : {3, 5}) {
      for (const int grading : {2, 3}) {
        for (const int elements : {10'000, 100'000, 1'000'000}) inputs.push_back({workload, degree, grading, elements});
      }
    }
  }
  return inputs;
}

std::unique_ptr<Replay> replayed(const Case& content) {
  auto replay = std::make_unique<Replay>(content);
  while (!replay->done()) replay->advance();
  return replay;
}

Prepared::Prepared(const Input& input) : content_(case_of(input)), shorter_(content_) { shorter_.steps.pop_back(); }

const std::string& Prepared::text() {
  if (text_.empty()) text_ = write_case(content_);
  return text_;
}

const Replay& Prepared::replay() {
  if (!replay_) replay_ = replayed(content_);
  return *replay_;
}

const RefinementTree& Prepared::tree_before() {
  if (!before_) before_ = replayed(shorter_);
  return before_->tree();
}

MeshUnderTest& Prepared::mesh() {
  if (!mesh_) mesh_ = std::make_unique<MeshUnderTest>(tree());
  return *mesh_;
}

Prepared& prepared(const Input& input) {
  static std::string name;
  static std::unique_ptr<Prepared> current;
  if (name == input.name()) return *current;
  current.reset();
  current = std::make_unique<Prepared>(input);
  name = input.name();
  return *current;
}

Case with_single_marks(const Input& input, int steps) {
  Case result = case_of(input);
  const std::unique_ptr<Replay> base = replayed(result);
  RefinementTree tree = base->tree();
  Draw draw(1);
  for (int i = 0; i < steps; ++i) {
    const std::int32_t leaf = draw.choose(leaves_of(tree));
    result.steps.push_back({Step::Kind::refine, {lower_corner(tree, leaf)}});
    refine(tree, std::span(&leaf, 1));
  }
  return result;
}

}  // namespace asts::benchmarks
