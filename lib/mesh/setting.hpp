#pragma once

#include "lib/mesh/axis.hpp"
#include "lib/mesh/case.hpp"

namespace asts {

/// What a mesh, its patches and its splines depend on besides the elements: degree p, grading m, and the domain
/// (0,X~) x (0,Y~) x (0,Z~) of Definition 2.1.
struct Setting {
  PerAxis<int> degree{3, 3, 3};
  int grading = 2;
  PerAxis<int> domain{1, 1, 1};
};

inline Setting setting_of(const Case& test_case) { return {test_case.degree, test_case.grading, test_case.domain}; }

}  // namespace asts
