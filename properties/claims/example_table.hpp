#pragma once

#include "properties/claims/claim.hpp"

namespace asts {

/// A row of the table of Example 2.10.
struct ExampleRow {
  int grading;
  std::int64_t steps;
  std::int64_t new_elements;
};

/// The setting of the example.
Setting example_setting(int grading);

/// Marks the element at the origin with Algorithm 2.9 until its size is 1/16 in each direction.
ExampleRow run_example(const Setting& setting);

/// `example-table`: the row that was found against the printed one of the same grading. REQUIRES: m is 2, 4 or 16.
Trial judge_example(const ExampleRow& found);

/// A sequence is the example if its setting is, and it marks the corner element alone, by refine, until its size is
/// 1/16 in each direction, and no longer. The corner is the origin's.
Trial try_example(const Case& sequence);
Trial try_example_alone(Extent extent);

}  // namespace asts
