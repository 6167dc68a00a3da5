#include "tests/minimize/planted_faults.hpp"

#include <array>

#include "lib/exact/errors.hpp"
#include "tests/minimize/fault_predicates.hpp"
#include "tests/minimize/start_meshes.hpp"

namespace asts {

namespace {

constexpr int kMostTries = 50'000;
constexpr std::int64_t kLargestStartSize = 30;

using Decide = Violation (*)(const Case&, Planted);

/// As in start_cases.cpp, for a predicate.
Case violating(std::uint64_t seed, Decide decide, StartSteps steps) {
  Draw draw(seed * 0x9E3779B97F4A7C15ULL + 1);
  StartLimits limits;
  limits.steps = steps;
  limits.max_cubes = 200;
  limits.max_elements = 400;
  for (int tries = 0; tries < kMostTries; ++tries) {
    const Case first = random_steps(draw, limits);
    const Violation kind = decide(first, Planted::yes);
    if (!kind) continue;
    const auto keeps = [&](const Case& other) { return decide(other, Planted::yes) == kind; };
    const auto start = with_more_steps(draw, first, draw.between(kLeastStartSize, kLargestStartSize), limits, keeps);
    if (start) return *start;
  }
  throw InternalError("no start was found");
}

template <Decide decide>
PlantedFault planted(const char* name, const char* fault, PathForm form, StartSteps steps) {
  return {name, fault, form, [](const Case& test_case) { return decide(test_case, Planted::yes); },
          [steps](std::uint64_t seed) { return violating(seed, decide, steps); }};
}

struct Entry {
  PlantedFault fault;
  Decide decide;
};

template <Decide decide>
Entry entry(const char* name, const char* fault, PathForm form, StartSteps steps) {
  return {planted<decide>(name, fault, form, steps), decide};
}

const std::array<Entry, 8>& entries() {
  static const std::array<Entry, 8> kEntries{
      entry<short_environment>("short-environment", "refining is admissible; environments one element too small",
                               PathForm::sequence, StartSteps::refine_only),
      entry<single_round>("single-round", "refining is admissible; the closure has one round", PathForm::sequence,
                          StartSteps::refine_only),
      entry<closed_environment>("closed-environment", "no coarser element in a patch; closed environments",
                                PathForm::mesh, StartSteps::refine_only),
      entry<level_of_few_splits>("level-of-few-splits", "levels tell sizes; splits along z are counted once",
                                 PathForm::mesh, StartSteps::mixed),
      entry<late_index_vector>("late-index-vector", "nodes are middle entries; vectors along y are one entry late",
                               PathForm::mesh, StartSteps::mixed),
      entry<mixed_frame>("mixed-frame", "active nodes are in the active region; its frame along y is that along z",
                         PathForm::mesh, StartSteps::mixed),
      entry<overlap_along_all_axes>("overlap-along-all-axes",
                                    "admissible is dual-compatible; overlap along three axes is asked for",
                                    PathForm::mesh, StartSteps::refine_only),
      entry<slices_of_domain>("slices-of-domain", "regions do not meet; slices are cut from the closed domain",
                              PathForm::mesh, StartSteps::mixed)};
  return kEntries;
}

}  // namespace

std::span<const PlantedFault> planted_faults() {
  static const auto kFaults = [] {
    std::vector<PlantedFault> faults;
    for (const Entry& one : entries()) faults.push_back(one.fault);
    return faults;
  }();
  return kFaults;
}

std::optional<std::string> violation_without_fault(const PlantedFault& fault, const Case& test_case) {
  for (const Entry& one : entries()) {
    if (one.fault.name == std::string(fault.name)) return one.decide(test_case, Planted::no);
  }
  throw InputError("no planted fault has this name");
}

}  // namespace asts
