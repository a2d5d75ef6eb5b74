#include "robot/description/srdf.h"

#include "fixtures.h"

namespace twinbus::test {
namespace {

TEST(Srdf, ReadsPosesAndPairs) {
  const Srdf srdf = parse_srdf(
      "<robot name='r'><group_state name='home' group='a'><joint name='j1' "
      "value='0.5'/></group_state>\n"
      "<group_state name='home' group='b'><joint name='j2' value='-1'/></group_state>\n"
      "<disable_collisions link1='a' link2='b' reason='Adjacent'/></robot>",
      "r.srdf");
  ASSERT_EQ(srdf.poses.size(), 1u);
  EXPECT_EQ(srdf.poses[0].joints.size(), 2u);
  ASSERT_EQ(srdf.disabled.size(), 1u);
  EXPECT_EQ(srdf.disabled[0].link_b, "b");
}

TEST(Srdf, ErrorsNameTheLine) {
  const auto error = [](const std::string& text) {
    return error_of([&] { parse_srdf(text, "r.srdf"); });
  };
  EXPECT_NE(
      error("<robot>\n<group_state name='h'>\n<joint name='j' value='1,5'/></group_state></robot>")
          .find("r.srdf:3"),
      std::string::npos);
  EXPECT_NE(error("<robot>\n<disable_collisions link1='a'/></robot>").find("r.srdf:2"),
            std::string::npos);
  EXPECT_NE(error("<srdf/>").find("not <robot>"), std::string::npos);
  EXPECT_NE(error("").find("empty"), std::string::npos);
}

// The free base is a joint of seven numbers to others; where the robot is, the scene says.
TEST(Srdf, AFreeBaseInAPoseIsLeftOut) {
  const char* const with_base =
      "<robot name='r'><group_state name='home' group='a'><joint name='root_joint' value='0 0 0.6 0 0 0 1'/>"
      "<joint name='j' value='1'/></group_state></robot>";
  const std::vector<SrdfPose> poses = parse_srdf(with_base, "r.srdf").poses;
  ASSERT_EQ(poses.size(), 1u);
  ASSERT_EQ(poses.front().joints.size(), 1u);
  EXPECT_EQ(poses.front().joints.front().first, "j");
}

TEST(Srdf, SizesOfFeetAreReadIfTheyCanBe) {
  const auto feet = [](const std::string& size) {
    return parse_srdf("<robot name='r'><specificities><feet><left><size " + size +
                          "/><anklePosition x='-0.05' y='0' z='0.1'/></left></feet>"
                          "</specificities></robot>",
                      "r.srdf")
        .feet;
  };
  const auto good = feet("height='0.14' width='0.25' depth='0.1'");
  EXPECT_TRUE(good[0].present);
  EXPECT_FALSE(good[1].present);
  EXPECT_EQ(good[0].length, 0.25);
  EXPECT_EQ(good[0].width, 0.14);
  EXPECT_EQ(good[0].ankle_forward, -0.05);
  for (const char* bad : {"height='-1' width='0.25'", "height='nan' width='0.2'",
                          "height='3' width='2'", "width='0.25'"}) {
    EXPECT_FALSE(feet(bad)[0].present) << bad;
  }
}

}  // namespace
}  // namespace twinbus::test
