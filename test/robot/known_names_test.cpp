#include "robot/names/known_names.h"

#include "fixtures.h"
#include "robot/description/srdf.h"
#include "robot/description/urdf.h"

namespace twinbus::test {
namespace {

const std::string kRobot = R"(<robot name="r"><link name="a"/><link name="b">
<inertial><origin xyz="0 0 0.1"/><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<collision><geometry><box size="1 1 1"/></geometry></collision></link>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
)";

std::string with(const std::string& from, const std::string& to) {
  std::string text = kRobot + "</robot>";
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string urdf_error(const std::string& text) {
  return error_of([&] { (void)parse_urdf(text, "r.urdf", {}); });
}

TEST(KnownNames, AMisspeltNameIsRefusedWithTheNameMeant) {
  EXPECT_EQ(urdf_error(with("velocity=", "velocty=")),
            "r.urdf:4: attribute \"velocty\" of <limit> is not known; write velocity");
  EXPECT_EQ(urdf_error(with("<origin", "<xorigin")),
            "r.urdf:2: <xorigin> in <inertial> is not known; write origin");
  EXPECT_EQ(urdf_error(with("<axis", "<Axis")),
            "r.urdf:4: <Axis> in <joint> is not known; write axis");
  const std::string shape = with("<collision>", "<colision>");
  EXPECT_NE(urdf_error(shape).find("XML"), std::string::npos);  // the end tag is another
  EXPECT_EQ(urdf_error(with("<collision><geometry><box size=\"1 1 1\"/></geometry></collision>",
                            "<colision><geometry><box size=\"1 1 1\"/></geometry></colision>")),
            "r.urdf:3: <colision> in <link> is not known; write collision");
  const auto srdf = [](const char* text) {
    return error_of([&] { (void)parse_srdf(text, "r.srdf"); });
  };
  EXPECT_EQ(srdf("<robot name='r'><group_state name='p'>\n<joinx name='j' "
                 "value='0'/></group_state></robot>"),
            "r.srdf:2: <joinx> in <group_state> is not known; write joint");
  EXPECT_EQ(srdf("<robot name='r'><disable_colisions link1='a' link2='b'/></robot>"),
            "r.srdf:1: <disable_colisions> in <robot> is not known; write disable_collisions");
}

TEST(KnownNames, OtherUnknownContentIsListedAsIgnored) {
  const UrdfTree tree = parse_urdf(
      kRobot +
          "<weather wind='3'/><weather/><link name='c' colour='red'/>"
          "<joint name='k' type='fixed'><parent link='b'/><child link='c'/></joint></robot>",
      "r.urdf", {});
  ASSERT_EQ(tree.notes.size(), 2U);
  EXPECT_EQ(tree.notes[0], "r.urdf:5: <weather> in <robot> is not known and ignored, 2 times");
  EXPECT_EQ(tree.notes[1], "r.urdf:5: attribute \"colour\" of <link> is not known and ignored");
  const Srdf srdf = parse_srdf("<robot name='r'><weather/></robot>", "r.srdf");
  ASSERT_EQ(srdf.notes.size(), 1U);
}

TEST(KnownNames, ExtensionsOfOtherProgramsPassInSilence) {
  const UrdfTree tree =
      parse_urdf(kRobot +
                     "<gazebo "
                     "reference='a'><mu1>0.2</mu1></gazebo><mujoco><compiler/></"
                     "mujoco><drake:loop_constraint/>"
                     "<ros2_control name='x' type='system'><hardware/></ros2_control></robot>",
                 "r.urdf", {});
  EXPECT_TRUE(tree.notes.empty());
}

TEST(KnownNames, ASecondElementThatWouldBeLostIsRefused) {
  EXPECT_EQ(urdf_error(with("<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 1\"/><axis xyz=\"1 0 0\"/>")),
            "r.urdf:4: a second <axis> in <joint> would be lost; remove one");
}

TEST(KnownNames, ManyUnknownKindsMakeAShortList) {
  std::string text = kRobot;
  for (int i = 0; i < 3000; ++i) text += "<unheard_of_" + std::to_string(i) + "/>";
  const UrdfTree tree = parse_urdf(text + "</robot>", "r.urdf", {});
  EXPECT_LE(tree.notes.size(), 21U);
  EXPECT_NE(tree.notes.back().find("2980 other kinds"), std::string::npos) << tree.notes.back();
}

}  // namespace
}  // namespace twinbus::test
