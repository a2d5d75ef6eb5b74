#include "bridge/adaptor/mailbox.h"

#include <gtest/gtest.h>

#include <thread>

namespace twinbus {
namespace {

struct TwoHalves {
  std::int64_t a = 0;
  std::int64_t filler[60]{};
  std::int64_t b = 0;
};

TEST(Mailbox, GivesTheNewestOnceAndNothingTwice) {
  Mailbox<int> box;
  int value = -1;
  EXPECT_FALSE(box.take(value));
  box.put(1);
  box.put(2);
  EXPECT_TRUE(box.take(value));
  EXPECT_EQ(value, 2);
  EXPECT_FALSE(box.take(value));
  EXPECT_EQ(value, 2);
}

TEST(Mailbox, NeverGivesHalfAValueNorAnOlderOne) {
  Mailbox<TwoHalves> box;
  constexpr std::int64_t kLast = 20'000;
  std::thread writer([&] {
    TwoHalves pair;
    for (std::int64_t i = 1; i <= kLast; ++i) {
      pair.a = pair.b = i;
      box.put(pair);
    }
  });
  TwoHalves seen;
  std::int64_t last = 0;
  while (last < kLast) {
    if (!box.take(seen)) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_EQ(seen.a, seen.b);
    ASSERT_GT(seen.a, last);
    last = seen.a;
  }
  writer.join();
}

}  // namespace
}  // namespace twinbus
