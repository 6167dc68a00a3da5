#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "lib/gen/draw.hpp"
#include "lib/gen/random_case.hpp"
#include "lib/mesh/case.hpp"

/// What the start cases of the minimizer's quality tests are made of: large random cases, and random additions to a
/// case that keep what a test is about.
namespace asts {

/// The least size of a start.
inline constexpr std::int64_t kLeastStartSize = 10;
inline constexpr int kLargestStartSide = 9;

/// Elements subdivided in the last mesh; of explicit boxes those beyond the number of unit cubes. A sequence of
/// `refine` alone is followed without its mesh when m is large (lib/refine/subdivided_elements.hpp).
std::int64_t size_of(const Case& test_case);

using Keeps = std::function<bool(const Case&)>;

/// The steps that starts consist of.
enum class StartSteps { mixed, refine_only };

struct StartLimits {
  StartSteps steps = StartSteps::mixed;
  int max_degree = 7;
  int least_grading = 2;
  int max_grading = 4;
  std::int64_t max_cubes = 250;     ///< of the domain, as far as its degrees allow
  std::int64_t max_elements = 600;  ///< of the last mesh
};

/// Degrees, m and a domain with sides up to 9; p+1 cubes and more along most axes.
Setting start_setting(Draw& draw, const StartLimits& limits);

/// A case of random steps of one or several marks each, or one of the biased ones of lib/gen, in part with a small
/// active region; no explicit mesh.
Case random_steps(Draw& draw, const StartLimits& limits);

/// Adds random steps, and marks to steps, at any place of a case for as long as `keeps` says so, until it has the size.
/// Nothing when too many additions in a row are refused.
std::optional<Case> with_more_steps(Draw& draw, Case test_case, std::int64_t size, const StartLimits& limits,
                                    const Keeps& keeps);

/// The last mesh of a case as boxes in random order.
Case as_boxes(Draw& draw, const Case& test_case);

/// Explicit boxes: cuts of one box or of several in a row at random places, as above.
std::optional<Case> with_more_cuts(Draw& draw, Case test_case, std::int64_t size, const Keeps& keeps);

}  // namespace asts
