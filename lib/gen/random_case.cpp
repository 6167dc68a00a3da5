#include "lib/gen/random_case.hpp"

#include <algorithm>
#include <array>

#include "lib/exact/errors.hpp"
#include "lib/gen/biased_cases.hpp"

namespace asts {

namespace {

constexpr std::array kBiases{
    Bias::marks_anywhere, Bias::marks_clustered,    Bias::marks_corner,      Bias::marks_deep,
    Bias::bare_scattered, Bias::bare_stacked,       Bias::bare_one_left_out, Bias::bare_touching,
    Bias::bare_in_frame,  Bias::boxes_cut,          Bias::boxes_merged,      Bias::boxes_frame,
    Bias::boxes_pinwheel, Bias::boxes_planar,       Bias::boxes_written_out, Bias::marks_edge,
    Bias::marks_face,     Bias::marks_uniform,      Bias::marks_graded,      Bias::bare_smaller_patch,
    Bias::bare_interface, Bias::bare_holes,         Bias::region_point,      Bias::region_segment,
    Bias::region_plane,   Bias::boxes_planar_inside};

constexpr std::array kNames{
    "marks-anywhere",    "marks-clustered",    "marks-corner",      "marks-deep", "bare-scattered", "bare-stacked",
    "bare-one-left-out", "bare-touching",      "bare-in-frame",     "boxes-cut",  "boxes-merged",   "boxes-frame",
    "boxes-pinwheel",    "boxes-planar",       "boxes-written-out", "marks-edge", "marks-face",     "marks-uniform",
    "marks-graded",      "bare-smaller-patch", "bare-interface",    "bare-holes", "region-point",   "region-segment",
    "region-plane",      "boxes-planar-inside"};
static_assert(kNames.size() == kBiases.size());

constexpr std::size_t kPlainBiases = 15;
static_assert(kBiases[kPlainBiases] == Bias::marks_edge);

}  // namespace

const char* bias_name(Bias bias) {
  const auto place = std::find(kBiases.begin(), kBiases.end(), bias);
  ensure(place != kBiases.end(), "a bias without a name");
  return kNames[static_cast<std::size_t>(place - kBiases.begin())];
}

std::span<const Bias> all_biases() { return kBiases; }
std::span<const Bias> plain_biases() { return all_biases().first(kPlainBiases); }
std::span<const Bias> trouble_biases() { return all_biases().subspan(kPlainBiases); }

Setting setting_for(Draw& draw, const CaseLimits& limits, Bias bias) {
  return bias < Bias::marks_edge && bias != Bias::boxes_planar ? random_setting(draw, limits)
                                                               : trouble_setting(draw, limits, bias);
}

RandomCase random_case_in(Draw& draw, const Setting& setting, const CaseLimits& limits, Bias bias) {
  if (bias <= Bias::marks_deep) return admissible_case_in(draw, setting, limits, bias);
  if (bias <= Bias::bare_in_frame) return bare_case_in(draw, setting, limits, bias);
  if (bias <= Bias::boxes_written_out) return box_case_in(draw, setting, limits, bias);
  return trouble_case_in(draw, setting, limits, bias);
}

RandomCase random_trouble_case(Draw& draw, const CaseLimits& limits) {
  const Bias bias = trouble_biases()[draw.index(trouble_biases().size())];
  return random_case_in(draw, setting_for(draw, limits, bias), limits, bias);
}

}  // namespace asts
