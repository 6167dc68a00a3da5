#include "fuzz/campaign/campaign.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <deque>
#include <limits>

#include "fuzz/campaign/open_units.hpp"
#include "lib/exact/errors.hpp"

namespace asts {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPollMilliseconds = 100;
constexpr auto kProgressEvery = std::chrono::milliseconds(250);

/// A worker and what it does: a unit, or a task, or nothing.
struct Seat {
  std::unique_ptr<Worker> worker;
  std::optional<std::int64_t> unit;
  std::optional<std::size_t> task;

  bool idle() const { return !unit && !task; }
};

class Campaign {
 public:
  Campaign(const CampaignPlan& plan, const CampaignRun& run, RunDirectory* folder)
      : plan_(plan), run_(run), folder_(folder), state_(plan), begin_(Clock::now()) {
    open_folder();
    cases_before_ = state_.cases();
    next_task_ = state_.next_finding();
    units_.emplace(plan_, state_, cases());
  }

  CampaignResult go() {
    for (int i = 0; i < run_.jobs; ++i) seats_.emplace_back();
    bool stopped = false;
    while (!(stopped = run_.stop && run_.stop()) && assign()) wait();
    return {state_.summary(), times_, stopped};
  }

 private:
  /// Random cases that the campaign is to have; without a number of them, no end.
  std::int64_t cases() const { return run_.cases > 0 ? run_.cases : std::numeric_limits<std::int64_t>::max() / 2; }

  void open_folder() {
    if (folder_ == nullptr) return;
    if (folder_->begun()) {
      folder_->restore(state_, cases());
    } else {
      folder_->begin(plan_, run_.cases);
    }
  }

  bool may_begin_units() const {
    if (units_->next() >= units_for(plan_, cases())) return false;
    return !run_.time || Clock::now() - begin_ < *run_.time;
  }

  /// Gives work to the idle. False when there is none, and all are idle.
  bool assign() {
    bool any_busy = false;
    for (Seat& seat : seats_) {
      if (seat.idle()) begin_work(seat);
      any_busy |= !seat.idle();
    }
    return any_busy;
  }

  /// First what has to be done again, as others wait for it; then tasks, so that findings come early.
  void begin_work(Seat& seat) {
    seat.unit = units_->take_again();
    if (!seat.unit && !tasks_again_.empty()) {
      seat.task = tasks_again_.front();
      tasks_again_.pop_front();
    } else if (!seat.unit && next_task_ < state_.tasks().size()) {
      seat.task = next_task_++;
    }
    if (seat.idle() && may_begin_units()) seat.unit = units_->begin();
    if (seat.idle()) return;
    if (!seat.worker) seat.worker = std::make_unique<Worker>(plan_, run_.limits);
    if (seat.unit) {
      seat.worker->start(units_->order(*seat.unit));
    } else {
      seat.worker->start(task_of(*seat.task));
    }
  }

  void wait() {
    std::vector<pollfd> files;
    for (const Seat& seat : seats_) files.push_back({seat.worker ? seat.worker->file() : -1, POLLIN, 0});
    const int ready = poll(files.data(), files.size(), kPollMilliseconds);
    for (std::size_t i = 0; i < seats_.size(); ++i) {
      if (ready > 0 && files[i].revents != 0) {
        hear(seats_[i]);
      } else if (ready >= 0 && seats_[i].worker) {
        seats_[i].worker->stop_if_stuck();
      }
    }
    answer();
    record();
    show_progress();
  }

  void hear(Seat& seat) {
    std::vector<Worker::Message> messages;
    const bool alive = seat.worker->read_messages(messages);
    for (Worker::Message& message : messages) take(seat, message);
    if (!alive) bury(seat);
  }

  void take(Seat& seat, Worker::Message& message) {
    switch (message.kind) {
      case Worker::Message::Kind::meshes:
        units_->has_meshes(*seat.unit, std::move(message.meshes));
        break;
      case Worker::Message::Kind::unit:
        units_->is_done(*seat.unit, unit_from_json(message.object), std::move(message.times));
        seat.unit.reset();
        break;
      case Worker::Message::Kind::finding:
        findings_[*seat.task] = std::move(message.object);
        seat.task.reset();
        break;
    }
  }

  void answer() {
    for (const auto& [unit, fresh] : units_->answers()) {
      const auto has_it = [unit = unit](const Seat& seat) { return seat.unit == unit; };
      std::find_if(seats_.begin(), seats_.end(), has_it)->worker->answer(fresh);
    }
  }

  void bury(Seat& seat) {
    const UnitDeath death = seat.worker->death();
    const std::string tried = seat.worker->tried();
    seat.worker.reset();
    if (seat.task) {
      bury_task(*seat.task, death, tried);
    } else if (seat.unit) {
      units_->has_died(*seat.unit, death);
    }
    seat.task.reset();
    seat.unit.reset();
  }

  /// First it is worked out again with the case as it was drawn, then given up.
  void bury_task(std::size_t number, const UnitDeath& death, const std::string& tried) {
    if (spoiled_.contains(number)) {
      findings_[number] = as_drawn(plan_, task_of(number));
      return;
    }
    FindingTask task = task_of(number);
    task.spoiled = death;
    task.spoiled_by = tried;
    spoiled_[number] = std::move(task);
    tasks_again_.push_back(number);
  }

  FindingTask task_of(std::size_t number) const {
    const auto spoiled = spoiled_.find(number);
    return spoiled != spoiled_.end() ? spoiled->second : state_.tasks()[number];
  }

  void record() {
    while (const auto unit = units_->take_complete()) {
      if (folder_ != nullptr) {
        folder_->add_times(unit->record.unit, unit->times);
        folder_->add_unit(unit_json(unit->record));
      }
      count_times(unit->times, unit->record.cases);
      state_.add_unit(unit->record);
    }
    for (auto found = findings_.find(state_.next_finding()); found != findings_.end();
         found = findings_.find(state_.next_finding())) {
      const FindingRecord record = finding_from_json(found->second);
      if (folder_ != nullptr) folder_->add_finding(found->second, record.findings);
      state_.add_finding(record);
      findings_.erase(found);
    }
  }

  void count_times(const UnitTimes& times, std::int64_t cases) {
    times_.cases += cases;
    times_.total += times.total;
    if (times.slowest <= times_.slowest) return;
    times_.slowest = times.slowest;
    times_.slowest_number = times.slowest_number;
  }

  void show_progress() {
    const auto now = Clock::now();
    if (!run_.progress || now - shown_ < kProgressEvery) return;
    shown_ = now;
    const auto seconds = std::chrono::duration_cast<std::chrono::milliseconds>(now - begin_).count();
    const CampaignSummary& summary = state_.summary();
    run_.progress(fmt::format("{} cases, {} a second, {} distinct meshes, {} of {} hypotheses met, {} findings",
                              summary.cases,
                              (summary.cases - cases_before_) * 1000 / std::max<std::int64_t>(seconds, 1),
                              summary.distinct, state_.claims_met(), summary.records.size(), summary.findings.size()));
  }

  const CampaignPlan& plan_;
  const CampaignRun& run_;
  RunDirectory* folder_;
  CampaignState state_;
  Clock::time_point begin_;
  Clock::time_point shown_{};
  std::int64_t cases_before_ = 0;

  std::deque<Seat> seats_;
  std::optional<OpenUnits> units_;
  std::map<std::size_t, std::string> findings_;  ///< of tasks that are done and not recorded yet
  std::size_t next_task_ = 0;
  std::deque<std::size_t> tasks_again_;
  std::map<std::size_t, FindingTask> spoiled_;  ///< tasks whose working out did not come back
  CaseTimes times_;
};

}  // namespace

CampaignResult run_campaign(const CampaignPlan& plan, const CampaignRun& run, RunDirectory* folder) {
  Campaign campaign(plan, run, folder);
  try {
    return campaign.go();
  } catch (const InputError& error) {
    throw InternalError(std::string("a worker's message: ") + error.what());  // nobody's input is read here
  }
}

}  // namespace asts
