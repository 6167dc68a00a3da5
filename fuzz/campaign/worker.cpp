#include "fuzz/campaign/worker.hpp"

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "fuzz/campaign/worker_process.hpp"
#include "lib/exact/errors.hpp"

namespace asts {

namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kLimitsMemory = false;  // the sanitizer reserves terabytes of addresses
#else
constexpr bool kLimitsMemory = true;
#endif

/// Between two looks at a worker, when nothing stands still.
constexpr auto kLongestPause = std::chrono::seconds(1);

void set_limit(int resource, std::int64_t value) {
  const rlimit limit{static_cast<rlim_t>(value), static_cast<rlim_t>(value)};
  setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

Beacon* new_beacon() {
  void* memory = mmap(nullptr, sizeof(Beacon), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw ResourceError("no memory to share with another process");
  return new (memory) Beacon;
}

void copy_words(Beacon& beacon, const std::string& says) {
  std::strncpy(beacon.says, says.c_str(), Beacon::kMostWords - 1);
}

[[noreturn]] void run_child(const CampaignPlan& plan, const WorkerLimits& limits, int file, Beacon& beacon) {
  // a group of its own: an interrupt from the terminal reaches the campaign, which ends its workers
  setpgid(0, 0);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  set_limit(RLIMIT_CORE, 0);
  if (kLimitsMemory) set_limit(RLIMIT_AS, limits.memory_megabytes << 20);
  run_and_exit([&] { serve(plan, limits.timeout_seconds, file, beacon); },
               [&](const std::string& says) { copy_words(beacon, says); });
}

}  // namespace

Worker::Worker(const CampaignPlan& plan, const WorkerLimits& limits) : limits_(limits), beacon_(new_beacon()) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) throw ResourceError("no line to another process");
  std::fflush(nullptr);
  const pid_t campaign = getpid();
  process_ = fork();
  if (process_ < 0) throw ResourceError("no other process");
  if (process_ == 0) {
    close(ends[0]);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != campaign) std::_Exit(0);
    run_child(plan, limits, ends[1], *beacon_);
  }
  close(ends[1]);
  file_ = ends[0];
  seen_at_ = checked_at_ = std::chrono::steady_clock::now();
}

Worker::~Worker() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  if (file_ >= 0) close(file_);
  munmap(beacon_, sizeof(Beacon));
}

void Worker::send(const std::string& line) {
  busy_ = true;
  seen_at_ = checked_at_ = std::chrono::steady_clock::now();
  try {
    write_line(file_, line);
  } catch (const ResourceError&) {
    // it has died meanwhile: the next read_messages() says so
  }
}

void Worker::start(const UnitOrder& order) { send(order_line(order)); }
void Worker::start(const FindingTask& task) { send(order_line(task)); }
void Worker::answer(const std::vector<bool>& fresh) { send(fresh_line(fresh)); }

bool Worker::read_messages(std::vector<Message>& into) {
  char buffer[1 << 16];
  const ssize_t count = read(file_, buffer, sizeof buffer);
  if (count < 0 && errno == EINTR) return true;
  if (count <= 0) return false;
  rest_.append(buffer, static_cast<std::size_t>(count));
  std::size_t begin = 0;
  for (std::size_t end; (end = rest_.find('\n', begin)) != std::string::npos; begin = end + 1) {
    into.push_back(parse_message(rest_.substr(begin, end - begin)));
    busy_ = false;  // until it is answered, or gets its next order
  }
  rest_.erase(0, begin);
  return true;
}

void Worker::stop_if_stuck() {
  const auto now = std::chrono::steady_clock::now();
  const auto pause = now - checked_at_;
  checked_at_ = now;
  if (pause > kLongestPause) seen_at_ += pause;
  const std::int64_t ticks = beacon_->ticks;
  if (!busy_ || ticks != seen_ticks_) {
    seen_ticks_ = ticks;
    seen_at_ = now;
  } else if (now - seen_at_ > std::chrono::seconds(limits_.timeout_seconds) && !killed_) {
    killed_ = true;
    kill(process_, SIGKILL);
  }
}

UnitDeath Worker::death() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = 0;
  Ending ending = ending_of(status);
  if (ending.kind.empty()) ending = {kCrash, "ended without a word"};
  if (ending.kind == kException) ending.says = beacon_->says;
  if (killed_) ending = {kTimeout, "no end within " + std::to_string(limits_.timeout_seconds) + " s"};
  const Claim* claim = beacon_->claim;
  UnitDeath death{claim != nullptr ? claim->id : "", ending.kind, std::nullopt, beacon_->step, ending.says};
  if (beacon_->has_case) death.number = beacon_->number;
  return death;
}

}  // namespace asts
