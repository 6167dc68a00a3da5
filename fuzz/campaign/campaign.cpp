#include "fuzz/campaign/campaign.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <deque>
#include <unordered_set>

#include "lib/exact/errors.hpp"

namespace asts {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPollMilliseconds = 100;
constexpr auto kProgressEvery = std::chrono::milliseconds(250);

/// A unit that was begun and is not recorded yet.
struct OpenUnit {
  UnitOrder order;
  bool told = false;                 ///< which of its meshes are new is settled
  std::vector<std::uint64_t> fresh;  ///< these
  std::unordered_set<std::uint64_t> is_fresh;
  std::vector<UnitDeath> deaths;
  std::optional<UnitRecord> record;  ///< when it is done
  UnitTimes times;
};

/// A worker and what it does: a unit, or a task, or nothing.
struct Seat {
  std::unique_ptr<Worker> worker;
  std::optional<std::int64_t> unit;
  std::optional<std::size_t> task;
  std::vector<std::uint64_t> meshes;  ///< that wait for an answer

  bool idle() const { return !unit && !task; }
};

class Campaign {
 public:
  Campaign(const CampaignPlan& plan, const CampaignRun& run, RunDirectory* folder)
      : plan_(plan), run_(run), folder_(folder), state_(plan), begin_(Clock::now()) {}

  CampaignResult go() {
    open_folder();
    cases_before_ = state_.cases();
    next_unit_ = state_.next_unit();
    next_told_ = next_unit_;
    next_task_ = state_.next_finding();
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
    if (next_unit_ >= units_for(plan_, cases())) return false;
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
    if (!again_.empty()) {
      seat.unit = again_.front();
      again_.pop_front();
    } else if (next_task_ < state_.tasks().size()) {
      seat.task = next_task_++;
    } else if (may_begin_units()) {
      seat.unit = next_unit_;
      open_[next_unit_].order = {next_unit_, cases(), {}};
      ++next_unit_;
    } else {
      return;
    }
    if (!seat.worker) seat.worker = std::make_unique<Worker>(plan_, run_.limits);
    if (seat.unit) {
      seat.worker->start(open_.at(*seat.unit).order);
    } else {
      seat.worker->start(state_.tasks()[*seat.task]);
    }
  }

  void wait() {
    std::vector<pollfd> files;
    for (const Seat& seat : seats_) files.push_back({seat.worker ? seat.worker->file() : -1, POLLIN, 0});
    const int ready = poll(files.data(), files.size(), kPollMilliseconds);
    for (std::size_t i = 0; i < seats_.size(); ++i) {
      if (ready > 0 && files[i].revents != 0) hear(seats_[i]);
      if (seats_[i].worker) seats_[i].worker->stop_if_stuck();
    }
    answer_in_order();
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
        seat.meshes = std::move(message.meshes);
        waiting_[*seat.unit] = &seat;
        break;
      case Worker::Message::Kind::unit: {
        OpenUnit& unit = open_.at(*seat.unit);
        unit.record = unit_from_json(message.object);
        unit.times = std::move(message.times);
        seat.unit.reset();
        break;
      }
      case Worker::Message::Kind::finding:
        findings_[*seat.task] = std::move(message.object);
        seat.task.reset();
        break;
    }
  }

  /// Which meshes are new is settled in the order of the units, so that it does not depend on who is faster. A unit
  /// that is done again keeps what it was told.
  void answer_in_order() {
    while (!waiting_.empty() && waiting_.begin()->first <= next_told_) {
      const auto [number, seat] = *waiting_.begin();
      waiting_.erase(waiting_.begin());
      OpenUnit& unit = open_.at(number);
      if (!unit.told) settle(unit, seat->meshes);
      std::vector<bool> fresh;
      for (const std::uint64_t mesh : seat->meshes) fresh.push_back(unit.is_fresh.contains(mesh));
      seat->worker->answer(fresh);
    }
  }

  void settle(OpenUnit& unit, const std::vector<std::uint64_t>& meshes) {
    for (const std::uint64_t mesh : meshes) {
      if (state_.is_new(mesh) && open_meshes_.insert(mesh).second) unit.fresh.push_back(mesh);
    }
    unit.is_fresh.insert(unit.fresh.begin(), unit.fresh.end());
    unit.told = true;
    pass_told();
  }

  void pass_told() {
    for (auto unit = open_.find(next_told_); unit != open_.end() && unit->second.told; ++unit) ++next_told_;
  }

  void bury(Seat& seat) {
    const UnitDeath death = seat.worker->death();
    seat.worker.reset();
    if (seat.task) {
      const FindingTask& task = state_.tasks()[*seat.task];
      findings_[*seat.task] = unminimized(plan_, task, task.says + "its minimization ended: " + death.says);
    } else if (seat.unit) {
      waiting_.erase(*seat.unit);
      bury_unit(*seat.unit, death);
    }
    seat.task.reset();
    seat.unit.reset();
  }

  /// The unit is done again without the case. Where no case is to blame, it is given up.
  void bury_unit(std::int64_t number, const UnitDeath& death) {
    OpenUnit& unit = open_.at(number);
    std::vector<std::int64_t>& skipped = unit.order.skipped;
    unit.deaths.push_back(death);
    if (death.number && std::find(skipped.begin(), skipped.end(), *death.number) == skipped.end()) {
      skipped.push_back(*death.number);
      again_.push_back(number);
      return;
    }
    unit.told = true;
    pass_told();
    unit.record.emplace().unit = number;
    const Unit what = unit_of(plan_, number);
    if (what.kind == Unit::Kind::block) unit.record->end = std::min(what.first_case + kBlockCases, cases());
  }

  void record() {
    while (!open_.empty() && open_.begin()->first == state_.next_unit() && open_.begin()->second.record) {
      OpenUnit& unit = open_.begin()->second;
      unit.record->fresh = unit.fresh;
      unit.record->deaths = unit.deaths;
      if (folder_ != nullptr) {
        folder_->add_times(unit.record->unit, unit.times);
        folder_->add_unit(unit_json(*unit.record));
      }
      count_times(unit.times, unit.record->cases);
      state_.add_unit(*unit.record);
      for (const std::uint64_t mesh : unit.fresh) open_meshes_.erase(mesh);
      open_.erase(open_.begin());
    }
    for (auto found = findings_.find(state_.next_finding()); found != findings_.end();
         found = findings_.find(state_.next_finding())) {
      const FindingRecord record = finding_from_json(found->second);
      if (folder_ != nullptr) folder_->add_finding(found->second, record.finding);
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
  std::map<std::int64_t, OpenUnit> open_;
  std::map<std::int64_t, Seat*> waiting_;          ///< units whose meshes wait for an answer
  std::unordered_set<std::uint64_t> open_meshes_;  ///< first met by units in open_
  std::deque<std::int64_t> again_;                 ///< units to be done again
  std::map<std::size_t, std::string> findings_;    ///< of tasks that are done and not recorded yet
  std::int64_t next_unit_ = 0;
  std::int64_t next_told_ = 0;
  std::size_t next_task_ = 0;
  CaseTimes times_;
};

}  // namespace

CampaignResult run_campaign(const CampaignPlan& plan, const CampaignRun& run, RunDirectory* folder) {
  return Campaign(plan, run, folder).go();
}

}  // namespace asts
