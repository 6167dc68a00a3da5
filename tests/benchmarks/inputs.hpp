#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lib/gen/workloads.hpp"
#include "lib/refine/replay.hpp"
#include "properties/mesh_under_test.hpp"

namespace asts::benchmarks {

/// A workload on 16^3 cubes, with the same degree along all axes, up to the first mesh with so many elements.
struct Input {
  Workload workload;
  int degree;
  int grading;
  std::int64_t elements;

  /// "sphere/p3/m2/100000".
  std::string name() const;
};

/// sphere, corner and random, p = 3 and 5, m = 2 and 3, 10^4, 10^5 and 10^6 elements.
std::vector<Input> all_inputs();

std::unique_ptr<Replay> replayed(const Case& content);

/// What the benchmarks of one input share, made when it is first asked for and not timed.
class Prepared {
 public:
  explicit Prepared(const Input& input);

  const Case& content() const { return content_; }
  const std::string& text();  ///< of the case
  const Replay& replay();     ///< after all steps
  const RefinementTree& tree() { return replay().tree(); }
  const RefinementTree& tree_before();  ///< before the last step
  MeshUnderTest& mesh();
  std::int64_t elements() { return tree().element_count(); }

 private:
  Case content_;
  Case shorter_;  ///< without the last step
  std::string text_;
  std::unique_ptr<Replay> replay_;
  std::unique_ptr<Replay> before_;
  std::unique_ptr<MeshUnderTest> mesh_;
};

/// Of the input that was asked for last; one at a time is kept, since the largest take a gigabyte.
Prepared& prepared(const Input& input);

/// The workload with `steps` more steps, each of which marks one leaf, drawn from a fixed seed: any leaf with the same
/// probability.
Case with_single_marks(const Input& input, int steps);

}  // namespace asts::benchmarks
