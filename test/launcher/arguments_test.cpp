#include "common/process/arguments.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

Syntax syntax() {
  return {
      "up",    "[SCENE]",
      "about", {{"--for", "S", "seconds"}, {"--lockstep", "", "flag"}, {"--set", "K=V", "pairs"}},
      0,       2};
}

TEST(Arguments, TakesOptionsInBothFormsAndWords) {
  const Arguments a(syntax(), {"stand", "--for", "5", "--set=a=1", "--set", "b=2", "--lockstep"});
  EXPECT_EQ(a.word(0), "stand");
  EXPECT_DOUBLE_EQ(a.number("--for", 0, 0, 10), 5.0);
  EXPECT_TRUE(a.has("--lockstep"));
  EXPECT_EQ(a.all("--set"), (std::vector<std::string>{"a=1", "b=2"}));
}

TEST(Arguments, NegativeNumbersAreWords) {
  const Arguments a(syntax(), {"-0.3", "-.5"});
  EXPECT_DOUBLE_EQ(a.word_number(0, "VX", -1, 1), -0.3);
  EXPECT_DOUBLE_EQ(a.word_number(1, "VY", -1, 1), -0.5);
}

TEST(Arguments, MistakesAreUsageErrorsThatNameTheNearestOption) {
  EXPECT_THROW(Arguments(syntax(), {"--for"}), UsageError);
  EXPECT_THROW(Arguments(syntax(), {"a", "b", "c"}), UsageError);
  EXPECT_THROW(Arguments(syntax(), {"--lockstep=1"}), UsageError);
  try {
    Arguments(syntax(), {"--lokstep"});
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("--lockstep"), std::string::npos) << error.what();
  }
}

TEST(Arguments, NumbersMustBeWholeFiniteAndInRange) {
  for (const char* bad : {"nan", "inf", "5x", "", "11", "-1", "1e999"}) {
    const Arguments a(syntax(), {std::string("--for=") + bad});
    EXPECT_THROW((void)a.number("--for", 0, 0, 10), UsageError) << bad;
  }
}

}  // namespace
}  // namespace twinbus
