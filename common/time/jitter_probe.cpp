#include "common/time/jitter_probe.h"

#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <latch>
#include <thread>
#include <vector>

#include "common/process/process.h"

namespace twinbus::inline common {

namespace {

constexpr std::size_t kMostCpus = 8;  // of a larger machine the first ones are watched
constexpr std::size_t kRemembered = 16;
constexpr std::int64_t kWakesPerTick = 4;
constexpr std::int64_t kStandstill = 8;  // late by this part of a period

// One CPU's timer.  Its thread writes, the loop reads.
struct Watch {
  struct Standstill {
    std::atomic<std::int64_t> from_ns{0}, to_ns{0};
  };
  std::array<Standstill, kRemembered> standstills;
  std::atomic<std::int64_t> due_ns{0};  // it sleeps until then
  std::thread thread;
};

void pin_to(int cpu) {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<std::size_t>(cpu), &one);
  (void)pthread_setaffinity_np(pthread_self(), sizeof one, &one);
}

bool set_fifo(int priority) {
  sched_param parameters = {};
  parameters.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

}  // namespace

struct JitterProbe::Shared {
  std::int64_t period_ns = 0;
  int priority = 0;
  std::atomic<bool> quit{false};
  std::atomic<std::int64_t> last_missed_tick{0}, missed{0};
  std::atomic<int> refused{0};
  std::vector<std::unique_ptr<Watch>> watches;

  // A tick that several CPUs miss counts once.
  void count_missed(std::int64_t tick) noexcept {
    std::int64_t last = last_missed_tick.load();
    while (tick > last) {
      if (!last_missed_tick.compare_exchange_weak(last, tick)) continue;
      missed.fetch_add(1);
      return;
    }
  }

  void run(Watch& watch, int cpu, std::latch& started) noexcept {
    pin_to(cpu);
    const bool allowed = set_fifo(priority);
    if (!allowed) refused.fetch_add(1);
    started.count_down();
    if (!allowed) return;
    const std::int64_t interval = std::max<std::int64_t>(period_ns / kWakesPerTick, 1);
    // Between the instants at which the loop has work: a tick begins at a multiple of the period.
    const std::int64_t phase = interval * 4 / 5;
    std::int64_t due = (monotonic_ns() / period_ns + 2) * period_ns + phase;
    std::size_t next = 0;
    while (!quit.load(std::memory_order_relaxed)) {
      watch.due_ns.store(due);
      sleep_until_ns(due);
      const std::int64_t now = monotonic_ns();
      if (now - due > period_ns / kStandstill) {
        Watch::Standstill& standstill = watch.standstills[next++ % kRemembered];
        standstill.to_ns.store(0);
        standstill.from_ns.store(due);
        standstill.to_ns.store(now);
        const std::int64_t first = (due + period_ns - 1) / period_ns;
        for (std::int64_t tick = first; now - tick * period_ns > period_ns / 2; ++tick) {
          count_missed(tick);
        }
      }
      due += (std::max<std::int64_t>((now - due) / interval, 0) + 1) * interval;
    }
  }
};

JitterProbe::JitterProbe(std::int64_t period_ns, int priority) : shared_(std::make_unique<Shared>()) {
  shared_->period_ns = std::max<std::int64_t>(period_ns, 1);
  shared_->priority = priority;
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
  std::vector<int> cpus;
  for (int cpu = 0; cpu < CPU_SETSIZE && cpus.size() < kMostCpus; ++cpu) {
    if (CPU_ISSET(static_cast<std::size_t>(cpu), &allowed)) cpus.push_back(cpu);
  }
  Shared& s = *shared_;
  std::latch started(static_cast<std::ptrdiff_t>(cpus.size()));
  for (const int cpu : cpus) {
    s.watches.push_back(std::make_unique<Watch>());
    Watch& watch = *s.watches.back();
    watch.thread = std::thread([&s, &watch, &started, cpu] { s.run(watch, cpu, started); });
  }
  started.wait();
}

JitterProbe::~JitterProbe() {
  shared_->quit.store(true);
  for (const auto& watch : shared_->watches) watch->thread.join();
}

bool JitterProbe::running() const noexcept {
  return !shared_->watches.empty() && shared_->refused.load() == 0;
}

std::int64_t covered_ns(std::span<Interval> intervals, std::int64_t from_ns,
                        std::int64_t to_ns) noexcept {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.from_ns < b.from_ns; });
  std::int64_t covered = 0, reached = from_ns;
  for (const Interval& interval : intervals) {
    const std::int64_t begin = std::max(interval.from_ns, reached);
    const std::int64_t end = std::min(interval.to_ns, to_ns);
    if (begin >= end) continue;
    covered += end - begin;
    reached = end;
  }
  return covered;
}

std::int64_t JitterProbe::stood_still_ns(std::int64_t from_ns, std::int64_t to_ns) const noexcept {
  std::array<Interval, kMostCpus*(kRemembered + 1)> known;
  std::size_t count = 0;
  const std::int64_t now = monotonic_ns();
  for (const auto& watch : shared_->watches) {
    const std::int64_t due = watch->due_ns.load();
    if (due > 0 && now - due > shared_->period_ns / kStandstill) known[count++] = {due, now};
    for (const Watch::Standstill& s : watch->standstills) {
      known[count++] = {s.from_ns.load(), s.to_ns.load()};
    }
  }
  return covered_ns({known.data(), count}, from_ns, to_ns);
}

std::int64_t JitterProbe::missed() const noexcept { return shared_->missed.load(); }

}  // namespace twinbus::common
