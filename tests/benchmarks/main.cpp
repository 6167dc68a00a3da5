#include "tests/benchmarks/measure.hpp"

/// Names are WORKLOAD/DEGREE/GRADING/ELEMENTS/STAGE for what depends on a mesh; --benchmark_list_tests lists all,
/// --benchmark_filter chooses.
int main(int argc, char** argv) {
  using namespace asts::benchmarks;
  for (const Input& input : all_inputs()) {
    add_refinement_benchmarks(input);
    add_spline_benchmarks(input);
    add_lambda_benchmarks(input);
  }
  add_sequence_benchmarks();
  add_search_benchmarks();
  add_reference_benchmarks();
  add_p8est_benchmarks();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
