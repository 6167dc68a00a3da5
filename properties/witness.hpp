#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lib/exact/cosine_field.hpp"
#include "lib/exact/rational.hpp"
#include "lib/mesh/axis.hpp"

namespace asts {

/// Witnesses of violated properties, in index coordinates, so that a person can check them by hand. What each kind says
/// is written in reports/WITNESS.md, which these types follow name by name.

using ExactPoint = PerAxis<Rational>;

struct ExactBox {
  ExactPoint lower;
  ExactPoint upper;
};

struct ElementInfo {
  ExactBox box;
  std::optional<std::int32_t> level;  ///< Definition 2.2, when it is an integer
};

struct ActiveNodeInfo {
  ExactPoint node;
  PerAxis<std::vector<Rational>> index_vectors;  ///< Definition 4.4
  ExactBox support;
};

/// `admissible`, kind coarser-in-patch.
struct CoarserInPatchWitness {
  ElementInfo element;
  ExactBox environment;
  ElementInfo coarser;
};

/// `admissible`, kind outside-class.
struct OutsideClassWitness {
  ElementInfo element;
};

/// `nested-patches`, kind patch-not-nested.
struct PatchNotNestedWitness {
  ElementInfo inner;
  ElementInfo outer;
  ElementInfo element;
};

/// One of the two perturbed regions at the common point: `in` belongs to N_axis(slice), `out` does not.
struct PerturbationInfo {
  Axis axis;
  Rational slice;
  ActiveNodeInfo in;
  ActiveNodeInfo out;
};

/// `analysis-suitable`, kind perturbed-regions-meet.
struct RegionsMeetWitness {
  ExactPoint point;
  PerturbationInfo first;
  PerturbationInfo second;
};

/// Why two index vectors do not overlap: a coordinate that one has and the other lacks inside its range.
struct NoOverlapInfo {
  Axis axis;
  Rational coordinate;
  bool in_v;  ///< else in w
};

/// `dual-compatible`, kind no-partial-overlap.
struct NoPartialOverlapWitness {
  ActiveNodeInfo v;
  ActiveNodeInfo w;
  std::vector<NoOverlapInfo> axes;
};

/// `dual-basis`, kind lambda-not-delta.
struct LambdaNotDeltaWitness {
  ActiveNodeInfo v;
  ActiveNodeInfo w;
  PerAxis<FieldElement> factors;
  FieldElement value;
  int expected;
  std::int64_t failures;
  std::int64_t pairs;
};

/// A number, a list of numbers, a text or a node of a claim's witness.
using ClaimValue = std::variant<std::string, std::int64_t, Rational, std::vector<Rational>, ExactPoint, ExactBox,
                                ElementInfo, ActiveNodeInfo, FieldElement>;

/// Any claim that is none of the five properties: what is wrong in words, and the numbers involved by name, in the
/// order in which a reader needs them.
struct ClaimWitness {
  std::string kind;
  std::string says;
  std::vector<std::pair<std::string, ClaimValue>> values;
};

using Witness = std::variant<CoarserInPatchWitness, OutsideClassWitness, PatchNotNestedWitness, RegionsMeetWitness,
                             NoPartialOverlapWitness, LambdaNotDeltaWitness, ClaimWitness>;

/// The word for the way in which something is violated: reports/WITNESS.md.
std::string kind_of(const Witness& witness);

}  // namespace asts
