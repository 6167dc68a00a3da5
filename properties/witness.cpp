#include "properties/witness.hpp"

namespace asts {

namespace {

struct KindOf {
  std::string operator()(const CoarserInPatchWitness&) const { return "coarser-in-patch"; }
  std::string operator()(const OutsideClassWitness&) const { return "outside-class"; }
  std::string operator()(const PatchNotNestedWitness&) const { return "patch-not-nested"; }
  std::string operator()(const RegionsMeetWitness&) const { return "perturbed-regions-meet"; }
  std::string operator()(const NoPartialOverlapWitness&) const { return "no-partial-overlap"; }
  std::string operator()(const LambdaNotDeltaWitness&) const { return "lambda-not-delta"; }
  std::string operator()(const ClaimWitness& witness) const { return witness.kind; }
};

}  // namespace

std::string kind_of(const Witness& witness) { return std::visit(KindOf{}, witness); }

}  // namespace asts
