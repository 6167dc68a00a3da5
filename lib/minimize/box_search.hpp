#pragma once

#include <span>

#include "lib/minimize/case_size.hpp"
#include "lib/minimize/oracle.hpp"

namespace asts {

/// An explicit mesh on its way down, as PathSearch for cases of steps.
class BoxSearch {
 public:
  /// REQUIRES: the oracle says that the case violates.
  BoxSearch(Oracle& oracle, const Case& start);

  const Case& current() const { return current_; }
  const CaseSize& size() const { return size_; }
  Oracle& oracle() const { return oracle_; }

  /// If the candidate is smaller and violates, it becomes the current case.
  bool propose(const Case& candidate);

 private:
  Oracle& oracle_;
  Case current_;
  CaseSize size_;
};

struct BoxPass {
  const char* name;
  bool (*run)(BoxSearch& search);
};

/// Layers and coordinates are taken away, the others replaced by simpler ones: what often leaves a mesh that
/// subdivisions make.
std::span<const BoxPass> simplifying_passes();
/// Planes are taken away, boxes merged, degrees and m lowered, axes permuted and reflected.
std::span<const BoxPass> merging_passes();

}  // namespace asts
