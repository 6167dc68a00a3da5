#pragma once

#include <string>

#include "tests/benchmarks/tables/measured.hpp"

/// Markdown tables of what was measured. What is not there is left out, or stands as "-".
namespace asts::benchmarks {

/// Three digits and no exponent: 1234, 12.3, 0.0123.
std::string three_digits(double value);
/// The same with k for thousands and M for millions.
std::string with_prefix(double value);

/// What the project promises, with what was measured, and whether it is kept.
std::string promises_table(const Rows& rows, const Processes& processes);

/// The whole program, by name: wall clock, processor time, peak memory.
std::string process_table(const Processes& processes);

/// The stages of a workload such as "sphere/p3/m2": milliseconds at 10^4, 10^5, 10^6 elements, how much the last step
/// adds, elements a second and bytes an element at 10^6.
std::string stage_table(const Rows& rows, const std::string& workload);

/// One line an input, one column a stage.
std::string matrix_table(const Rows& rows);

/// Everything whose name begins so, with its counters.
std::string plain_table(const Rows& rows, const std::string& beginning);

/// The literal code beside the library, with the ratio.
std::string reference_table(const Rows& rows);

}  // namespace asts::benchmarks
