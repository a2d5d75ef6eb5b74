#include "common/text/closest_name.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

TEST(Nearest, FindsTypingMistakes) {
  EXPECT_EQ(nearest_name("stiffnes", {"damping", "stiffness"}), "stiffness");
  EXPECT_EQ(nearest_name("Period", {"period", "timeouts"}), "period");
  EXPECT_EQ(nearest_name("elephant", {"period", "timeouts"}), "");
  EXPECT_EQ(nearest_name("x", {}), "");
  EXPECT_EQ(nearest_name(std::string(5000, 'x'), {"x"}), "");
}

TEST(Nearest, SuggestsOrLists) {
  EXPECT_EQ(suggestion("perod", {"period"}), "; did you mean period?");
  EXPECT_EQ(suggestion("elephant", {"a", "b"}), "; known: a, b");
  EXPECT_EQ(suggestion("elephant", {}), "");
}

}  // namespace
}  // namespace twinbus
