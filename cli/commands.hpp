#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asts::cli {

/// Exit codes of the interface contract.
enum ExitCode : int { kHolds = 0, kViolated = 1, kBadInput = 2, kFailure = 3, kInterrupted = 130 };

enum class Format { text, json };

struct CheckOptions {
  std::vector<std::string> cases;
  std::vector<std::string> properties;
  std::vector<std::string> claims;
  bool final_only = false;
  std::uint64_t pair_budget = 0;  ///< 0: none
  int jobs = 1;
  std::string folder;  ///< the run directory for `asts report`; empty: none
  Format format = Format::text;
};

struct ClaimsOptions {
  Format format = Format::text;
};

struct RefineOptions {
  std::string case_file;
  std::string write_file;
  int jobs = 1;
  Format format = Format::text;
};

struct SettingOptions {
  std::vector<int> degree{3, 3, 3};
  int grading = 2;
  std::vector<int> domain;
};

struct GenerateOptions {
  std::string workload;
  SettingOptions setting{.domain = {16, 16, 16}};
  std::int64_t elements = 1000;
};

struct DrawOptions {
  std::string case_file;
  std::string claim;
  std::string property;
  std::string folder;
  Format format = Format::text;
};

struct ExportOptions {
  std::string case_file;
  std::string out;
  std::string claim;
  std::string property;
  std::string node;
  bool perturbed_regions = false;
  Format format = Format::text;
};

struct EnumerateOptions {
  SettingOptions setting{.domain = {4, 4, 5}};
  int max_subdivisions = 0;
  bool admissible = false;
  bool no_symmetry = false;
  std::vector<std::string> claims;
  std::vector<std::string> properties;
  Format format = Format::text;
};

struct LedgerOptions {
  std::vector<std::string> claims;
  bool long_run = false;
  std::uint64_t seed = 1;
  std::optional<std::int64_t> cases;
  int jobs = 1;
  bool times = false;
  std::vector<std::string> rendered;
  Format format = Format::text;
};

struct MinimizeOptions {
  std::string case_file;
  std::string claim;
  std::string property;
  std::string out;
  std::string collect;
  std::string draw;
  std::string snippet;
  std::int64_t budget = 0;  ///< evaluations; 0: no bound
  bool prove = false;
  std::int64_t prove_meshes = 100'000'000;
  Format format = Format::text;
};

struct ReplayOptions {
  std::string folder;
  Format format = Format::text;
};

struct ReportOptions {
  std::string folder;
  std::string out;
};

struct CampaignOptions {
  std::vector<std::string> claims;
  std::optional<std::int64_t> cases;
  std::optional<std::int64_t> seconds;
  std::optional<std::uint64_t> seed;
  int jobs = 1;
  std::string folder;
  bool resume = false;
  std::int64_t timeout = 60;   ///< seconds
  std::int64_t memory = 4096;  ///< MB
  std::string replayed;        ///< the folder of a collection
  Format format = Format::text;
};

struct ValidateOptions {
  std::vector<std::string> files;
  Format format = Format::text;
};

/// Each command writes its results to stdout and returns the exit code. Input errors are thrown as InputError before
/// anything is written.
int campaign(const CampaignOptions& options);
int check(const CheckOptions& options);
int claims(const ClaimsOptions& options);
int draw(const DrawOptions& options);
int enumerate(const EnumerateOptions& options);
int export_mesh(const ExportOptions& options);
int ledger(const LedgerOptions& options);
int refine(const RefineOptions& options);
int generate(const GenerateOptions& options);
int minimize(const MinimizeOptions& options);
int replay(const ReplayOptions& options);
int report(const ReportOptions& options);
int validate(const ValidateOptions& options);

}  // namespace asts::cli
