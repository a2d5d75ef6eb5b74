#include "launcher/bus/event_groups.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
using Lines = std::vector<std::string>;

TEST(EventGroups, TheSameSentenceIsSaidOnceAndThenCounted) {
  EventGroups groups;
  std::int64_t now = kSecond;
  EXPECT_EQ(groups.take({"bridge: device: timeout"}, now), Lines{"bridge: device: timeout"});
  for (int i = 0; i < 12; ++i)
    EXPECT_TRUE(groups.take({"bridge: device: timeout"}, now += kSecond / 10).empty());
  EXPECT_EQ(groups.take({}, 62 * kSecond),
            Lines{"bridge: device: timeout (12 times more in a minute)"});
  EXPECT_TRUE(groups.take({}, 123 * kSecond).empty());
  EXPECT_EQ(groups.take({"bridge: device: timeout"}, 124 * kSecond).size(), 1u)
      << "after a while it is news again";
}

TEST(EventGroups, NumbersDoNotMakeItAnotherSentence) {
  EventGroups groups;
  EXPECT_EQ(groups.take({"guard: 12.5 mm", "guard: 9 mm", "guard: stop"}, kSecond),
            (Lines{"guard: 12.5 mm", "guard: stop"}));
  EXPECT_EQ(groups.take({}, 62 * kSecond), Lines{"guard: 9 mm (once more in a minute)"});
}

}  // namespace
}  // namespace twinbus
