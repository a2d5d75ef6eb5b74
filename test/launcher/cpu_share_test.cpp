#include "launcher/stack/cpu_share.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace twinbus {
namespace {

TEST(CpuShare, FindsTheTimesBehindANameWithBracketsAndBlanks) {
  const std::string stat =
      "42 (a (b) c) S 1 42 42 0 -1 4194304 100 0 0 0 250 50 0 0 20 0 3 0 100 1 1";
  EXPECT_DOUBLE_EQ(cpu_seconds_in(stat, 100.0), 3.0);
}

TEST(CpuShare, ProcessesThatAreNotThereUseNothing) {
  EXPECT_LT(cpu_seconds_in("", 100.0), 0.0);
  EXPECT_LT(cpu_seconds_in("42 (x) S 1", 100.0), 0.0);
  EXPECT_LT(cpu_seconds(-1), 0.0);
  CpuShare shares;
  EXPECT_EQ(shares.of(-1, 1), 0.0);
  EXPECT_EQ(shares.recent(-1, 1), 0.0);
}

TEST(CpuShare, IsCountedFromTheFirstQuestion) {
  CpuShare shares;
  EXPECT_EQ(shares.of(getpid(), 1'000'000'000), 0.0);
  EXPECT_LT(shares.of(getpid(), 1'000'000'000'000), 0.1);
}

}  // namespace
}  // namespace twinbus
