#include "common/process/arguments.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/process/command_word.h"
#include "test/error_of.h"

namespace twinbus {
namespace {

Syntax syntax() {
  return {"up", 0, 2, R"([SCENE]
about it,
    indented too
  --for S  seconds
  --lockstep  a flag, \
      told long
  --set K=V  pairs
  --robot --force)"};
}

TEST(Arguments, HelpIsPrintedAsItIsWritten) {
  const std::string wanted = R"(usage: ./twinbus up [SCENE] [OPTION...]
about it,
    indented too
  --for S               seconds
  --lockstep            a flag, told long
  --set K=V             pairs
  --robot NAME          of config/robots, or a folder
  --force               writes over a file that is there, with its parts
Exit status: 0 done, 1 failed, 2 wrong arguments.
)";
  EXPECT_EQ(help_text(syntax()), as_typed(wanted));
  EXPECT_THROW(Syntax("up", 0, 0, "\nabout\n  --unknown"), std::logic_error);
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

std::string problem_of(const std::vector<std::string>& words) {
  Syntax one = syntax();
  one.least_words = 1;
  return test::error_of<UsageError>([&] { Arguments(one, words); });
}

// check --propose robot.urdf: the robot became the folder.
TEST(Arguments, AnOptionThatTookTheWordIsNamed) {
  EXPECT_EQ(problem_of({"--for", "stand"}), "up: --for has taken 'stand' as its S; needs [SCENE] (see --help)");
  EXPECT_EQ(problem_of({"--for", "5", "--lockstep"}), "up: needs [SCENE] (see --help)");
}

TEST(Arguments, AnOptionIsNoValueOfAnother) {
  EXPECT_EQ(problem_of({"stand", "--for", "--lockstep"}), "up: --for needs a value, --for S: seconds");
  EXPECT_EQ(problem_of({"stand", "--set=--a=1"}), "");
  EXPECT_EQ(problem_of({"stand", "--for", "-1"}), "");
}

TEST(CommandWord, IsWhatIsTypedHere) {
  const std::string text = "see ./twinbus status; `./twinbus clear` (./twinbus sim go).";
  EXPECT_EQ(as_typed(text, false), text);
  EXPECT_EQ(as_typed(text, true), "see twinbus status; `twinbus clear` (twinbus sim go).");
  EXPECT_EQ(as_typed("./twinbus", true), "twinbus");
  const std::string other = "../twinbus a/./twinbus ./twinbus/x ./twinbus-1 ./twinbus_x";
  EXPECT_EQ(as_typed(other, true), other);
}

TEST(Arguments, NumbersMustBeWholeFiniteAndInRange) {
  for (const char* bad : {"nan", "inf", "5x", "", "11", "-1", "1e999"}) {
    const Arguments a(syntax(), {std::string("--for=") + bad});
    EXPECT_THROW((void)a.number("--for", 0, 0, 10), UsageError) << bad;
  }
}

}  // namespace
}  // namespace twinbus
