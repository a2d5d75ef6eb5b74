#include "common/process/priority.h"

#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>

#include <cstdlib>
#include <cstring>

namespace twinbus {

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

}  // namespace twinbus
