#include "common/process/process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <set>

namespace twinbus {
namespace {

TEST(Process, IdsAreRandomAndFitAJavaScriptNumber) {
  std::set<std::int64_t> seen;
  for (int i = 0; i < 1000; ++i) {
    const std::int64_t id = random_id();
    EXPECT_GE(id, 1);
    EXPECT_LT(id, std::int64_t{1} << 53);
    seen.insert(id);
  }
  EXPECT_EQ(seen.size(), 1000u);
}

TEST(Process, TheSteadyClockGoesOn) {
  const std::int64_t start = monotonic_ns();
  EXPECT_GE(monotonic_ns(), start);
  sleep_until_ns(start - 1);  // past: returns at once
  sleep_until_ns(-5);
}

TEST(Process, OneSignalAsksToQuit) {
  catch_quit_signals();
  EXPECT_FALSE(quit_requested());
  std::raise(SIGTERM);
  EXPECT_TRUE(quit_requested());
}

}  // namespace
}  // namespace twinbus
