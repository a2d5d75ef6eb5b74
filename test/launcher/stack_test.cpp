#include "launcher/stack/stack.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace twinbus {
namespace {

// The message of the error that parsing this text gives.
std::string complaint(const std::string& text) {
  try {
    (void)parse_stack(text, "s.yaml");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Stack, ProcessesComeAfterThoseTheyWaitFor) {
  const Stack stack = parse_stack(
      "processes:\n"
      "  c: {program: x, after: [a, b]}\n"
      "  b: {program: x, after: [a]}\n"
      "  a: {program: x, ready: STATE_SIM}\n",
      "s.yaml");
  ASSERT_EQ(stack.processes.size(), 3U);
  EXPECT_EQ(stack.processes[0].name, "a");
  EXPECT_EQ(stack.processes[1].name, "b");
  EXPECT_EQ(stack.processes[2].name, "c");
  EXPECT_EQ(stack.processes[0].ready_channel, "STATE_SIM");
}

TEST(Stack, MistakesNameFileLineAndNearestKey) {
  EXPECT_NE(complaint("processes:\n  a:\n    progam: x\n").find("s.yaml:3"), std::string::npos);
  EXPECT_NE(complaint("processes:\n  a:\n    progam: x\n").find("program"), std::string::npos);
  EXPECT_NE(complaint("proceses: {}\n").find("processes"), std::string::npos);
}

TEST(Stack, RefusesWhatCannotRun) {
  for (const char* bad : {
           "",                                          // nothing
           "processes: {}",                             // nobody
           "processes: [a, b]",                         // no map
           "processes: {a: {arguments: []}}",           // no program
           "processes: {a: {program: ../../bin/sh}}",   // a path
           "processes: {a: {program: x, after: [b]}}",  // waits for nobody
           "processes: {a: {program: x, after: [b]}, b: {program: x, after: [a]}}",  // a ring
           "processes: {a: {program: x, grace: .nan}}",                              // no time
           "processes: {a: {program: x, ready_timeout: -1}}",                        //
           "processes: {a: {program: x, restart: maybe}}",                           // no truth
           "activate: b\nprocesses: {a: {program: x}}",  // nobody to activate
           "processes: {'a/../b': {program: x}}",        // would escape the run's folder
           "processes: {a: {program: x",                 // no YAML
       }) {
    EXPECT_FALSE(complaint(bad).empty()) << bad;
  }
}

TEST(Stack, PlaceholdersBecomeAnyNumberOfArguments) {
  StackProcess process;
  process.arguments = {"{scene}", "{none}", "--log={file}", "plain"};
  const Placeholders values = {{"scene", {"stand"}}, {"none", {}}, {"file", {"f.log"}}};
  EXPECT_EQ(fill_in(process, values), (std::vector<std::string>{"stand", "--log=f.log", "plain"}));
  process.arguments = {"{sceen}"};
  EXPECT_THROW((void)fill_in(process, values), std::runtime_error);
}

TEST(Stack, TheInstalledStacksAreValid) {
  EXPECT_FALSE(stack_names().empty());
  for (const std::string& name : stack_names()) EXPECT_NO_THROW((void)load_stack(name)) << name;
}

// Only what can be nothing but simulated begins anew.
TEST(Stack, AStandInRobotIsTheProgramAndTheBridgeToIt) {
  const Stack both = load_stack("both");
  for (const StackProcess& process : both.processes)
    EXPECT_EQ(is_stand_in(process), process.name == "robot" || process.name == "bridge") << process.name;
  StackProcess bridge = *both.find("bridge");
  bridge.hardware = true;
  EXPECT_FALSE(is_stand_in(bridge));
  bridge.hardware = false;
  bridge.arguments = {"--adaptor", "unitree_dds"};
  EXPECT_FALSE(is_stand_in(bridge));
  bridge.arguments = {"--adaptor"};
  EXPECT_FALSE(is_stand_in(bridge));
}

}  // namespace
}  // namespace twinbus
