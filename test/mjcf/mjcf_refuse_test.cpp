// Models that are wrong, hostile, or no robot: one line with file, line and what to do.

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "robot/mjcf/mjcf_to_urdf.h"
#include "test/temporary_folder.h"

namespace twinbus::test {
namespace {

// The sentence with which a model is refused; empty if it is read.
std::string refusal(const std::string& text, const std::string& file = "t.xml") {
  try {
    const MjcfModel model = read_mjcf_model_text(text, file);
    (void)robot_of_mjcf(model, file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

std::string body(const std::string& inside) {
  return "<mujoco>\n<worldbody>\n<body name='a'>\n" + inside + "\n</body></worldbody></mujoco>";
}

void expect(const std::string& text, const std::string& start, const std::string& part) {
  const std::string sentence = refusal(text);
  EXPECT_EQ(sentence.rfind(start, 0), 0u) << sentence;
  EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
}

TEST(MjcfRefuse, NumbersThatAreNone) {
  const std::pair<const char*, const char*> inside_and_complaint[] = {
      {"<joint axis='0 0 nan'/>", "finite number"},
      {"<joint axis='0 0 0'/>", "no length"},
      {"<joint damping='1e308'/>", "damping"},
      {"<joint armature='-1'/>", "armature"},
      {"<joint range='2 1'/>", "upside down"},
      {"<joint limited='true'/>", "range"},
      {"<joint/><geom size='0'/>", "positive"},
      {"<joint/><geom size='0.1 0.1 0.1 0.1'/>", "4 numbers"},
      {"<joint/><geom size='0.1' pos='1e308 0 0'/>", "pos"},
      {"<joint/><geom size='0.1' quat='0 0 0 0'/>", "quat"},
      {"<joint/><inertial pos='0 0 0' mass='1' diaginertia='1 1 -1'/>", "negative"},
      {"<joint/><inertial pos='0 0 0' mass='inf'/>", "finite"},
  };
  for (const auto& [inside, complaint] : inside_and_complaint) expect(body(inside), "t.xml:4: ", complaint);
}

TEST(MjcfRefuse, ADefaultIsBlamedWhereItStands) {
  expect("<mujoco>\n<default>\n<joint damping='x'/></default>\n<worldbody>\n<body>\n<joint/></body></worldbody></mujoco>",
         "t.xml:3: ", "damping");
}

TEST(MjcfRefuse, NamesThatAreNotThere) {
  expect(body("<joint class='none'/>"), "t.xml:4: ", "default class");
  expect(body("<joint/><geom type='mesh' mesh='none'/>"), "t.xml:4: ", "no mesh");
  expect("<mujoco>\n<worldbody><body><joint name='knee'/><geom size='0.1'/></body></worldbody>\n<actuator>\n<motor joint='kne'/>"
         "</actuator></mujoco>",
         "t.xml:4: ", "knee");
  expect(body("<joint name='j'/><joint name='j'/>"), "t.xml:4: ", "twice");
  expect(body("<joint dampin='1'/>"), "t.xml:4: ", "write damping");
  expect(body("<jiont/>"), "t.xml:4: ", "write joint");
}

TEST(MjcfRefuse, WhatNoRobotHereCanHave) {
  expect(body("<joint type='ball'/><geom size='0.1'/>"), "t.xml:4: ", "three hinges");
  expect(body("<joint/><flexcomp/>"), "t.xml:4: ", "mj_saveLastXML");
  expect(body("<joint/><replicate count='3'/>"), "t.xml:4: ", "mj_saveLastXML");
  expect("<mujoco>\n<deformable>\n<flex/></deformable></mujoco>", "t.xml:3: ", "rigid");
  expect("<mujoco><compiler coordinate='global'/></mujoco>", "t.xml:1: ", "global");
  expect("<mujoco><worldbody><body name='a'><joint/></body></worldbody></mujoco>", "t.xml:1: ", "no mass");
  expect("<mujoco><worldbody><body name='a'><freejoint/><geom size='1'/></body></worldbody></mujoco>", "t.xml:1: ",
         "without a robot");
  const std::string robot = "<freejoint/><geom size='0.1'/><body><joint/><geom size='0.1'/></body></body>\n";
  expect("<mujoco><worldbody><body name='a'>" + robot + "<body name='b'>" + robot + "</worldbody></mujoco>", "t.xml:2: ",
         "second robot");
  expect("<mujoco><worldbody><body name='a'><joint/><geom size='0.1'/></body></worldbody>\n<equality><connect body1='a'"
         " anchor='0 0 0'/></equality></mujoco>",
         "t.xml:2: ", "loop");
}

TEST(MjcfRefuse, KeyframesOfAnotherLength) {
  expect("<mujoco><worldbody><body><joint/><geom size='0.1'/></body></worldbody>\n<keyframe><key qpos='1 2'/></keyframe></mujoco>",
         "t.xml:2: ", "has 2 numbers; the model has 1");
}

TEST(MjcfRefuse, DeepAndBrokenXml) {
  std::string deep = "<mujoco><worldbody>";
  for (int i = 0; i < 10'000; ++i) deep += "<body>";
  expect(deep, "t.xml:1: ", "nested deeper");
  expect("<mujoco><worldbody>", "t.xml:1: ", "not well-formed");
  expect("<robot/>", "t.xml:1: ", "no MJCF");
}

TEST(MjcfRefuse, IncludesThatGoRoundOrNowhere) {
  TemporaryFolder folder;
  const std::string a = folder.write("a.xml", "<mujoco>\n<include file='b.xml'/></mujoco>");
  folder.write("b.xml", "<mujoco>\n\n<include file='a.xml'/></mujoco>");
  const auto told = [](const std::string& file) {
    try {
      (void)import_mjcf(file);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(told(a).find("b.xml:3: include of a.xml: the file is included already"), std::string::npos) << told(a);
  const std::string missing = folder.write("c.xml", "<mujoco>\n<include file='nowhere.xml'/></mujoco>");
  EXPECT_NE(told(missing).find("c.xml:2: include of nowhere.xml"), std::string::npos) << told(missing);
  const std::string away = folder.write("d.xml", "<mujoco>\n<include file='/etc/passwd'/></mujoco>");
  EXPECT_NE(told(away).find("d.xml:2: "), std::string::npos) << told(away);
  EXPECT_NE(told(away).find("relative"), std::string::npos) << told(away);
}

TEST(MjcfRefuse, AMeshThatIsMissingWhereItTouches) {
  const std::string asset = "<mujoco>\n<asset>\n<mesh name='m' file='m.stl'/></asset><worldbody><body><joint/><inertial pos='0 0 0'"
                            " mass='1' diaginertia='1 1 1'/><geom type='mesh' mesh='m'";
  expect(asset + "/></body></worldbody></mujoco>", "t.xml:3: ", "is not there");
  EXPECT_EQ(refusal(asset + " contype='0' conaffinity='0'/></body></worldbody></mujoco>"), "");  // only seen
}

}  // namespace
}  // namespace twinbus::test
