#include "common/process/priority.h"

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace twinbus::inline common {

namespace {
constexpr int kHighest = 80;  // FIFO priority of anything in a stack
constexpr int kNice = 10;
}  // namespace

bool may_enter_real_time() noexcept {
  const char* fifo = std::getenv("TWINBUS_FIFO");
  if (fifo != nullptr && std::strcmp(fifo, "0") == 0) return false;
  int policy = 0;
  sched_param before = {}, wanted = {};
  if (pthread_getschedparam(pthread_self(), &policy, &before) != 0) return false;
  wanted.sched_priority = kHighest;
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted) != 0) return false;
  pthread_setschedparam(pthread_self(), policy, &before);
  return true;
}

void give_way() noexcept { (void)setpriority(PRIO_PROCESS, 0, kNice); }

RealTime enter_real_time(int priority, const char* program) {
  std::string why;
  const RealTime real_time = enter_real_time(priority, &why);
  if (!why.empty()) std::fprintf(stderr, "%s: %s\n", program, why.c_str());
  return real_time;
}

const char* to_text(RealTime real_time) noexcept {
  return real_time == RealTime::kNone ? "no real-time priority" : "FIFO priority";
}

}  // namespace twinbus::common
