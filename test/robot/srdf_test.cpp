#include "robot/srdf.h"

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

}  // namespace
}  // namespace twinbus::test
