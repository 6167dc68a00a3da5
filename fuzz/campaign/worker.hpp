#pragma once

#include <sys/types.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/campaign/death_oracle.hpp"
#include "fuzz/campaign/finding_task.hpp"
#include "fuzz/campaign/unit_work.hpp"

namespace asts {

/// What keeps a trial from taking for ever, or all memory.
struct WorkerLimits {
  std::int64_t timeout_seconds = 60;  ///< for one claim on one mesh or sequence, or the making of one mesh
  std::int64_t memory_megabytes = 4096;
};

/// Where a worker is: memory that it shares with the campaign, so that this is known when it does not come back.
struct Beacon {
  static constexpr std::size_t kMostWords = 1000;
  static constexpr std::size_t kMostCase = 1 << 20;

  std::atomic<std::int64_t> ticks{0};  ///< grows with every piece of work
  std::atomic<std::int64_t> number{0};
  std::atomic<std::int64_t> step{0};
  std::atomic<bool> has_case{false};
  std::atomic<const Claim*> claim{nullptr};
  char says[kMostWords] = {};  ///< what the exception said that ended it
  char tried[kMostCase] = {};  ///< the case that a task tries, as text; empty when it is too long
};

/// A unit as a worker gets it.
struct UnitOrder {
  std::int64_t unit = 0;
  std::int64_t cases = 0;  ///< random cases of the campaign: the last block may have fewer than others
  std::vector<Skip> skipped;
};

/// A process that does units and tasks, one after the other: whatever the code under test does to it, the campaign
/// goes on.
class Worker {
 public:
  /// REQUIRES: this process has no other threads. Throws ResourceError.
  Worker(const CampaignPlan& plan, const WorkerLimits& limits);
  /// Ends the process at once.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// REQUIRES: idle.
  void start(const UnitOrder& order);
  void start(const FindingTask& task);
  /// The answer to Message::meshes: which of them no earlier unit had.
  void answer(const std::vector<bool>& fresh);

  struct Message {
    enum class Kind { meshes, unit, finding } kind;
    std::vector<std::uint64_t> meshes;
    std::string object;  ///< JSON: a UnitRecord, a finding
    UnitTimes times;
  };

  /// A file to poll for messages.
  int file() const { return file_; }
  /// Reads what has arrived. False when the process has ended.
  bool read_messages(std::vector<Message>& into);
  /// Kills the process when it is at one piece of work for longer than the limit. REQUIRES: called often; the time in
  /// which it was not, because the machine or this process stood still, does not count.
  void stop_if_stuck();

  /// How it ended, and where it was. REQUIRES: read_messages() gave false, called once.
  UnitDeath death();
  /// The case that a task was trying, as text; may be empty.
  std::string tried() const { return beacon_->tried; }

 private:
  void send(const std::string& line);

  WorkerLimits limits_;
  Beacon* beacon_;
  pid_t process_ = 0;
  int file_ = -1;
  std::string rest_;  ///< of a line that is not complete
  bool busy_ = false;
  bool killed_ = false;
  std::int64_t seen_ticks_ = 0;
  std::chrono::steady_clock::time_point seen_at_;     ///< when the work began that it is at
  std::chrono::steady_clock::time_point checked_at_;  ///< the last time it was looked at
};

}  // namespace asts
