#include "common/process/process.h"

#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <random>

#include "common/file/disk_cache.h"
#include "common/process/command_word.h"
#include "common/text/printable.h"

namespace twinbus::inline common {

namespace {

volatile std::sig_atomic_t quit_signals = 0;

extern "C" void on_quit_signal(int number) {
  if (quit_signals != 0) _exit(128 + number);
  quit_signals = 1;
}

// Touches stack that the loop may use later, so that locking has something to lock.
void touch_stack() {
  volatile char block[256 * 1024];
  for (std::size_t i = 0; i < sizeof(block); i += 1024) block[i] = 0;
}

bool is_set_to(const char* variable, const char* value) {
  const char* set = std::getenv(variable);
  return set != nullptr && std::strcmp(set, value) == 0;
}

// A CPU that sleeps deeply between two ticks wakes late for the next.  The kernel keeps them awake
// as long as this file is open, that is until the process ends.
void keep_cpus_awake() {
  if (is_set_to("TWINBUS_CPU_SLEEP", "1")) return;
  const int file = open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC);
  if (file < 0) return;  // the doctor says so
  const std::int32_t allowed_us = 0;
  if (write(file, &allowed_us, sizeof allowed_us) != sizeof allowed_us) close(file);
}

// Where the system sets no limit: with one, memory that is asked for later would be refused.
void lock_memory_if_free() {
  rlimit limit = {};
  if (getrlimit(RLIMIT_MEMLOCK, &limit) == 0 && limit.rlim_cur == RLIM_INFINITY) (void)mlockall(MCL_CURRENT | MCL_FUTURE);
}

}  // namespace

void catch_quit_signals() {
  struct sigaction action = {};
  action.sa_handler = on_quit_signal;
  sigemptyset(&action.sa_mask);
  // No SA_RESTART: a blocking call returns so that the loop sees the request.
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool quit_requested() noexcept { return quit_signals != 0; }

std::int64_t monotonic_ns() noexcept {
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

std::int64_t wall_us() noexcept {
  timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  return std::int64_t{now.tv_sec} * 1'000'000 + now.tv_nsec / 1000;
}

void sleep_until_ns(std::int64_t due_ns) noexcept {
  if (due_ns <= 0) return;
  timespec due;
  due.tv_sec = static_cast<time_t>(due_ns / 1'000'000'000);
  due.tv_nsec = static_cast<long>(due_ns % 1'000'000'000);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr) == EINTR &&
         !quit_requested()) {
  }
}

int run_process(const char* name, int (*run)(int, char**), int argc, char** argv) noexcept {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // whoever waits for a line, in a file or pipe, has it when it is said
  try {
    use_user_cache();
    return run(argc, argv);
  } catch (const std::exception& error) {
    print_typed(stderr, "%s: %s\n", name, printable(error.what(), kLongestError, true).c_str());
    return 1;
  }
}

std::int64_t random_id() {
  static std::mt19937_64 generator = [] {
    std::random_device device;
    std::seed_seq seed{device(), device(), device(), device(), static_cast<unsigned>(getpid())};
    return std::mt19937_64(seed);
  }();
  return std::uniform_int_distribution<std::int64_t>(1, (std::int64_t{1} << 53) - 1)(generator);
}

RealTime enter_real_time(int priority, std::string* why) {
  const auto tell = [&](const std::string& text) {
    if (why != nullptr) *why = text;
  };
  tell("");
  // Without FIFO priority the kernel may wake a sleeper 50 us late on purpose, to save wake-ups.
  (void)prctl(PR_SET_TIMERSLACK, 1UL);
  if (is_set_to("TWINBUS_FIFO", "0")) {
    lock_memory_if_free();
    tell("no FIFO priority, as asked by TWINBUS_FIFO=0");
    return RealTime::kNone;
  }
  sched_param parameters = {};
  parameters.sched_priority = priority;
  const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
  if (error != 0) {
    lock_memory_if_free();
    tell(std::string("no FIFO priority (") + std::strerror(error) +
         "): run with CAP_SYS_NICE, or allow it with ulimit -r");
    return RealTime::kNone;
  }
  touch_stack();
  keep_cpus_awake();
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    tell(std::string("memory not locked (") + std::strerror(errno) +
         "): allow it with ulimit -l unlimited");
    return RealTime::kFifo;
  }
  return RealTime::kFifoLocked;
}

void go_ahead_of_ordinary_programs() noexcept {
  if (is_set_to("TWINBUS_FIFO", "0")) return;
  sched_param parameters = {};
  parameters.sched_priority = 10;
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters);
}

}  // namespace twinbus::common
