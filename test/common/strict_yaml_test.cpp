#include "common/text/strict_yaml.h"

#include <gtest/gtest.h>

#include <limits>

#include "test/error_of.h"

namespace twinbus::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ConfigNode, ReadsValues) {
  const ConfigNode node = ConfigNode::parse(
      "a: 1.5\nb: [1, 2, 3]\nc: {d: text, e: true}\nf:\n  - {g: 7}\n  - {g: 8}\nh: [x, y]\n",
      "f.yaml");
  EXPECT_EQ(node.number("a", 0, 2), 1.5);
  EXPECT_EQ(node.numbers("b", 3), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(node.map("c").text("d"), "text");
  EXPECT_TRUE(node.map("c").flag("e", false));
  EXPECT_EQ(node.list("f")[1].integer("g", 0, 10), 8);
  EXPECT_EQ(node.texts("h"), (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(node.number("absent", 0, 1, 0.25), 0.25);
  EXPECT_NO_THROW(node.finish());
}

TEST(ConfigNode, UnknownKeyNamesFileLineAndTheNearestKey) {
  const ConfigNode node = ConfigNode::parse("period: 0.002\nperid: 1\n", "robot.yaml");
  node.number("period", 0, 1);
  EXPECT_EQ(error_of([&] { node.finish(); }),
            "robot.yaml:2: key perid is not known; did you mean period?");
}

TEST(ConfigNode, BadValuesNameFileLineAndKey) {
  const ConfigNode node = ConfigNode::parse(
      "a: nan\nb: 1,5\nc: 3\nd: [1, x]\ne: [1]\nf: {}\ng: maybe\nh: 1.5\ni: .inf\n", "x.yaml");
  EXPECT_NE(error_of([&] { node.number("a", -kInfinity, kInfinity); }).find("x.yaml:1: a"),
            std::string::npos);
  EXPECT_NE(error_of([&] { node.number("b", 0, 10); }).find("x.yaml:2: b must be a finite number"),
            std::string::npos);
  EXPECT_NE(error_of([&] { node.number("c", 0, 2); }).find("out of range, 0 to 2"),
            std::string::npos);
  EXPECT_NE(error_of([&] { node.numbers("d", 2); }).find("number 2"), std::string::npos);
  EXPECT_NE(error_of([&] { node.numbers("e", 2); }).find("list of 2 numbers"), std::string::npos);
  EXPECT_NE(error_of([&] { node.text("f"); }).find("plain text"), std::string::npos);
  EXPECT_NE(error_of([&] { node.flag("g", true); }).find("true or false"), std::string::npos);
  EXPECT_NE(error_of([&] { node.integer("h", 0, 5); }).find("whole number"), std::string::npos);
  EXPECT_NE(error_of([&] { node.number("i", 0, kInfinity); }).find("finite"), std::string::npos);
  EXPECT_NE(error_of([&] { node.number("z", 0, 1); }).find("missing"), std::string::npos);
  EXPECT_NE(error_of([&] {
              node.choice("g", {"yes", "no"}, 0);
            }).find("not known"),
            std::string::npos);
}

TEST(ConfigNode, RefusesWhatIsNoMap) {
  EXPECT_NE(error_of([] { ConfigNode::parse("- 1\n- 2\n", "x.yaml"); }).find("must be a map"),
            std::string::npos);
  EXPECT_NE(error_of([] {
              ConfigNode::parse("a: 1\na: 2\n", "x.yaml");
            }).find("x.yaml:2: key a is there twice"),
            std::string::npos);
  EXPECT_NE(error_of([] { ConfigNode::parse("a: [1\nb: 2", "x.yaml"); }).find("not valid YAML"),
            std::string::npos);
  EXPECT_NE(error_of([] { ConfigNode::load("/nowhere/x.yaml"); }).find("no such file"),
            std::string::npos);
}

// Found by test/fuzz/robot_files_fuzz.
TEST(ConfigNode, WhatIsQuotedFromAHostileFileStaysOnOneLine) {
  const std::string error =
      error_of([] { (void)ConfigNode::parse("a: \"\\\n\"\nb: \"\\\x1b[2J\"", "the_file"); });
  EXPECT_NE(error, "");
  for (const char c : error) EXPECT_GE(c, ' ') << error;
}

TEST(ConfigNode, TextThatDrivesATerminalOrFillsItIsRefused) {
  const auto error = [](const std::string& value) {
    return error_of([&] { (void)ConfigNode::parse("about: " + value, "s.yaml").text("about"); });
  };
  EXPECT_EQ(error("\"\\e[2J\""),
            "s.yaml:1: about has a control character or broken UTF-8; write plain text");
  EXPECT_EQ(error(std::string(1'000'000, 'x')),
            "s.yaml:1: about is longer than 4096 bytes; shorten it");
  EXPECT_EQ(error("Gr\xc3\xb6\xc3\x9f"
                  "e"),
            "");
  EXPECT_LT(error_of([] {
              (void)ConfigNode::parse("a:\n  " + std::string(1'000'000, 'x') + ": 1", "s.yaml")
                  .map("a")
                  .finish();
            }).size(),
            3000U);
}

}  // namespace
}  // namespace twinbus::test
