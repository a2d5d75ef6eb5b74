// A joint of type floating at the root of a URDF says that the base moves freely, and is left out.

#include <gtest/gtest.h>

#include <string>

#include "robot/description/load.h"
#include "robot/onboarding/base_turn.h"

namespace twinbus {
namespace {

const std::string kBody = "<inertial><mass value='2'/><inertia ixx='0.01' iyy='0.02' izz='0.02' ixy='0' ixz='0' iyz='0'/></inertial>";
const std::string kTrunk = "<link name='trunk'>" + kBody + "</link>";

std::string robot(const std::string& root, const std::string& more = "") {
  return "<robot name='r'>" + root + kTrunk +
         "<joint name='free' type='floating'><parent link='world'/><child link='trunk'/></joint>" + more + "</robot>";
}

TEST(FloatingRoot, IsLeftOut) {
  std::string left_out;
  const std::string text = without_floating_root(robot("<link name='world'/>"), "r.urdf", left_out);
  EXPECT_EQ(left_out, "joint free and link world");
  UrdfRepairs repairs;
  const Model model = load_repaired_urdf(text, "/tmp/r.urdf", {}, repairs);
  ASSERT_EQ(model.link_count(), 1);
  EXPECT_EQ(model.links[0].name, "trunk");
}

TEST(FloatingRoot, StaysWhereItIsMoreThanThat) {
  const std::string side = "<link name='side'>" + kBody + "</link><joint name='s' type='fixed'><parent link='world'/><child link='side'/></joint>";
  const std::string above = "<link name='sky'/><joint name='s' type='fixed'><parent link='sky'/><child link='world'/></joint>";
  for (const std::string& text : {robot("<link name='world'>" + kBody + "</link>"), robot("<link name='world'/>", side),
                                  robot("<link name='world'/>", above), "<robot name='r'>" + kTrunk + "</robot>"}) {
    std::string left_out;
    EXPECT_EQ(without_floating_root(text, "r.urdf", left_out), text);
    EXPECT_EQ(left_out, "");
  }
}

}  // namespace
}  // namespace twinbus
