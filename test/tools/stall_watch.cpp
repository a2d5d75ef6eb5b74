// Tells a stall of the machine from a fault of ours: a bare timer per processor, above every
// process of the stack.
//
//   stall_watch [--over US]
//
// Nothing but the host can delay it.  Prints "ready", then a line "PROCESSOR FROM_NS TO_NS"
// (steady clock) each time it wakes more than US late (default 1000).  A signal ends it.

#include <pthread.h>
#include <sched.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <thread>
#include <vector>

namespace {

constexpr std::int64_t kEvery_ns = 1'000'000;
constexpr int kPriority = 95;

std::int64_t now_ns() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return std::int64_t{1'000'000'000} * t.tv_sec + t.tv_nsec;
}

void watch(int processor, std::int64_t over_ns) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<unsigned>(processor), &set);
  pthread_setaffinity_np(pthread_self(), sizeof set, &set);
  sched_param parameter{};
  parameter.sched_priority = kPriority;
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter) != 0) {
    std::fprintf(stderr, "stall_watch: no FIFO priority; its lines may be faults of the stack\n");
  }
  for (std::int64_t due = now_ns() + kEvery_ns;; due += kEvery_ns) {
    const timespec at{due / 1'000'000'000, due % 1'000'000'000};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) != 0) {
    }
    const std::int64_t now = now_ns();
    if (now - due <= over_ns) continue;
    std::printf("%d %lld %lld\n", processor, static_cast<long long>(due),
                static_cast<long long>(now));
    std::fflush(stdout);
    due = now;
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::int64_t over_ns = 1'000'000;
  if (argc == 3 && std::strcmp(argv[1], "--over") == 0) {
    over_ns = 1000 * std::atoll(argv[2]);
  } else if (argc != 1) {
    std::fprintf(stderr, "usage: stall_watch [--over US]\n");
    return 2;
  }
  std::printf("ready\n");
  std::fflush(stdout);
  std::vector<std::thread> threads;
  const auto processors = static_cast<int>(std::thread::hardware_concurrency());
  for (int i = 0; i < processors; ++i) threads.emplace_back(watch, i, over_ns);
  for (std::thread& thread : threads) thread.join();
  return 0;
}
