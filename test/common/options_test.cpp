#include "common/process/options.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

struct Example {
  Options options{"tool", "Does things."};
  std::string scene = "stand", engine = "ode";
  double rate = 1.0;
  std::int64_t seed = 1;
  bool lockstep = false;
  std::vector<std::pair<std::string, std::string>> settings;
  std::string error;
  Example() {
    options.positional("SCENE", scene, false, "what to simulate");
    options.number("--rate", "X", rate, 0.1, 100.0, "times real time");
    options.integer("--seed", "N", seed, 0, 1000, "of the noise");
    options.flag("--lockstep", lockstep, "wait for the controller");
    options.settings("--set", settings, "changes a setting");
    options.choice("--engine", {"ode", "articulated"}, engine, "who integrates");
  }
  bool parse(const std::vector<std::string>& arguments) {
    return options.try_parse(arguments, error);
  }
};

TEST(Options, ReadsEveryKind) {
  Example e;
  EXPECT_TRUE(e.parse({"sway", "--rate=2.5", "--seed", "7", "--lockstep", "--set", "a=1", "--set",
                       "b=c=d", "--engine", "articulated"}));
  EXPECT_EQ(e.scene, "sway");
  EXPECT_EQ(e.rate, 2.5);
  EXPECT_EQ(e.seed, 7);
  EXPECT_TRUE(e.lockstep);
  ASSERT_EQ(e.settings.size(), 2u);
  EXPECT_EQ(e.settings[1].second, "c=d");
  EXPECT_EQ(e.engine, "articulated");
  EXPECT_TRUE(e.options.given("--rate"));
  EXPECT_FALSE(e.options.given("--help"));
}

TEST(Options, MistakesAreNamed) {
  const auto error = [](const std::vector<std::string>& arguments) {
    Example e;
    EXPECT_FALSE(e.parse(arguments));
    return e.error;
  };
  EXPECT_EQ(error({"--lock-step"}), "option --lock-step is not known; did you mean --lockstep?");
  EXPECT_EQ(error({"--rate", "nan"}), "--rate nan is not a finite number");
  EXPECT_EQ(error({"--rate", "0"}), "--rate 0 is out of range, 0.1 to 100");
  EXPECT_EQ(error({"--seed", "1.5"}), "--seed 1.5 is not a whole number");
  EXPECT_EQ(error({"--seed", "99999999999999999999"}),
            "--seed 99999999999999999999 is not a whole number");
  EXPECT_EQ(error({"--seed"}), "option --seed needs a value, N");
  EXPECT_EQ(error({"--lockstep=1"}), "option --lockstep takes no value");
  EXPECT_EQ(error({"a", "b"}), "argument b is not expected");
  EXPECT_EQ(error({"--set", "a"}), "--set a must be KEY=VALUE");
  EXPECT_EQ(error({"--engine", "od"}), "--engine od is not known; did you mean ode?");
}

TEST(Options, HelpListsAllWithDefaults) {
  Example e;
  EXPECT_TRUE(e.parse({"--help"}));
  EXPECT_TRUE(e.options.help_asked());
  for (const char* part : {"usage: tool [SCENE] [OPTION...]", "Does things.", "--rate X",
                           "(default: 1)", "--engine ode|articulated", "Exit status"}) {
    EXPECT_NE(e.options.help().find(part), std::string::npos) << part;
  }
}

TEST(Options, RequiredAndRest) {
  Options options("tool", "x");
  std::string first, error;
  std::vector<std::string> rest;
  options.positional("FIRST", first, true, "the first");
  options.rest("MORE", rest, "others");
  EXPECT_FALSE(options.try_parse({}, error));
  EXPECT_EQ(error, "FIRST is missing: the first");
  EXPECT_TRUE(options.try_parse({"a", "b", "--", "--c"}, error));
  EXPECT_EQ(rest, (std::vector<std::string>{"b", "--c"}));
}

TEST(Options, CommonOptionsFollowTheEnvironment) {
  ::setenv("LCM_DEFAULT_URL", "udpm://239.1.1.1:5?ttl=0", 1);
  EXPECT_EQ(CommonOptions().url, "udpm://239.1.1.1:5?ttl=0");
  ::unsetenv("LCM_DEFAULT_URL");
  EXPECT_NE(CommonOptions().url.find(":17667?ttl=0"), std::string::npos);
  Options options("tool", "x");
  CommonOptions common;
  add_common(options, common);
  std::string error;
  EXPECT_TRUE(options.try_parse({"--run-id", "12", "--prefix", "R1_"}, error)) << error;
  EXPECT_EQ(common.id, 12);
  EXPECT_EQ(common.prefix, "R1_");
}

}  // namespace
}  // namespace twinbus
