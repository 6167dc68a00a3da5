#include "properties/ledger/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "cli/commands.hpp"
#include "cli/processes.hpp"
#include "cli/statements.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"
#include "reports/checked_in_ledger.hpp"
#include "reports/ledger_report.hpp"

namespace asts::cli {

namespace {

/// A line of progress for every so many cases.
constexpr std::int64_t kProgress = 64;

LedgerPlan plan_of(const LedgerOptions& options) {
  LedgerPlan plan;
  plan.claims = chosen_claims(options.claims);
  if (plan.claims.empty()) {
    for (const Claim& claim : all_claims()) plan.claims.push_back(&claim);
  }
  plan.seed = options.seed;
  plan.extent = options.long_run ? Extent::long_run : Extent::short_run;
  plan.cases = options.cases;
  plan.shares = options.jobs;
  return plan;
}

/// Progress, and a point where an interrupt ends the run.
Ledger::Watch watch_by(const std::function<void(const std::string&)>& show) {
  return [show](const char* what, std::int64_t done, std::int64_t total) {
    stop_if_interrupted();
    if (done % kProgress == 0) show(fmt::format("{}: {} of {}", what, done, total));
  };
}

std::string times_text(const LedgerPlan& plan, const Ledger& ledger) {
  std::string result;
  for (std::size_t place = 0; place < plan.claims.size(); ++place) {
    const std::int64_t trials = ledger.records()[place].trials();
    const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(ledger.times()[place]).count();
    result += fmt::format("{}: {} ms, {} trials, {} us each\n", plan.claims[place]->id, microseconds / 1000, trials,
                          trials == 0 ? 0 : microseconds / trials);
  }
  return result;
}

/// What a run gives: its records, complete or as far as it came.
struct Run {
  std::vector<LedgerRecord> records;
  bool interrupted = false;
};

Run run_here(const LedgerPlan& plan, bool times) {
  Ledger ledger(plan, violation_text);
  bool interrupted = false;
  try {
    ledger.run(watch_by(show_progress));
  } catch (const Interrupted&) {
    interrupted = true;
  }
  show_progress({});
  if (times) warn(times_text(plan, ledger));
  return {ledger.records(), interrupted};
}

/// One share of the run in another process, which sends the records as JSON, and before them progress.
void run_share(LedgerPlan plan, int share, const Send& send) {
  plan.share = share;
  Ledger ledger(plan, violation_text);
  try {
    ledger.run(watch_by(send));
  } catch (const Interrupted&) {
  }
  for (const LedgerRecord& record : ledger.records()) {
    std::string line = ledger_json(record);
    line.pop_back();
    send(line);
  }
}

Run run_shares(const LedgerPlan& plan) {
  Run run;
  for (const Claim* claim : plan.claims) run.records.emplace_back().claim = claim->id;
  const auto arrived = [&](int share, const std::string& line) {
    if (!line.starts_with('{')) return show_progress(fmt::format("{}: {}", share + 1, line));
    const LedgerRecord record = ledger_from_json(line);
    const auto same = [&](const LedgerRecord& one) { return one.claim == record.claim; };
    merge(*std::find_if(run.records.begin(), run.records.end(), same), record);
  };
  run_in_processes(
      plan.shares, [&](int share, const Send& send) { run_share(plan, share, send); }, arrived);
  try {
    stop_if_interrupted();
  } catch (const Interrupted&) {
    run.interrupted = true;
  }
  return run;
}

int exit_code(const Run& run) {
  if (run.interrupted) return kInterrupted;
  const auto any = [&](auto is) { return std::any_of(run.records.begin(), run.records.end(), is); };
  const auto surprising = [](const LedgerRecord& record) {
    return record.result() == LedgerResult::violated && !find_claim(record.claim)->refuted;
  };
  const auto undecided = [](const LedgerRecord& record) { return record.result() == LedgerResult::undecided; };
  return any(surprising) ? kViolated : any(undecided) ? kFailure : kHolds;
}

int render(const std::vector<std::string>& paths) {
  std::string lines;
  for (const std::string& path : paths) {
    std::ifstream file(path);
    std::ostringstream content;
    if (!file || !(content << file.rdbuf())) throw InputError(path + ": cannot be read");
    lines += content.str();
  }
  try {
    print(ledger_markdown(read_ledger(lines)));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}:{}", fmt::join(paths, "+"), error.what()));
  }
  return kHolds;
}

}  // namespace

int ledger(const LedgerOptions& options) {
  if (!options.rendered.empty()) return render(options.rendered);
  const LedgerPlan plan = plan_of(options);
  const Run run = plan.shares == 1 ? run_here(plan, options.times) : run_shares(plan);
  if (options.format == Format::json) {
    for (const LedgerRecord& record : run.records) print(ledger_json(record));
  } else {
    print(ledger_text(run.records));
  }
  return exit_code(run);
}

}  // namespace asts::cli
