#include "viewer_log/server/page_request.h"

#include <gtest/gtest.h>

#include "lcmtypes/msg/motion_defaults.h"
#include "robot/description/model.h"
#include "robot/description/named_hands.h"
#include "test/carried_arms.h"
#include "viewer_log/server/page_inbox.h"

namespace twinbus {
namespace {

bool read(const std::string& text, bool trusted, PageRequest& request) {
  std::string problem;
  const bool read = read_page_request(text, trusted, request, problem);
  EXPECT_TRUE(read || !problem.empty()) << text;
  return read;
}

TEST(PageRequest, AnyoneMayStop) {
  PageRequest request;
  for (bool trusted : {false, true}) {
    ASSERT_TRUE(read(R"({"do":"stop","kind":2})", trusted, request));
    EXPECT_EQ(request.what, PageRequest::What::kStop);
    EXPECT_EQ(request.stop, StopKind::kHold);
  }
}

TEST(PageRequest, AStopWithADamagedKindIsStillAStop) {
  PageRequest request;
  for (const char* text :
       {R"({"do":"stop"})", R"({"do":"stop","kind":0})", R"({"do":"stop","kind":99})",
        R"({"do":"stop","kind":"x"})", R"({"do":"stop","kind":-1e300})"}) {
    ASSERT_TRUE(read(text, false, request)) << text;
    EXPECT_EQ(request.stop, StopKind::kBalanced) << text;
  }
}

TEST(PageRequest, APoseIsJointsByName) {
  PageRequest request;
  ASSERT_TRUE(read(R"({"do":"pose","joints":{"KNEE":0.5,"ELBOW":-1}})", true, request));
  EXPECT_EQ(request.what, PageRequest::What::kPose);
  ASSERT_EQ(request.joints.size(), 2u);
  for (const char* text : {R"({"do":"pose"})", R"({"do":"pose","joints":{}})", R"({"do":"pose","joints":[1]})",
                           R"({"do":"pose","joints":{"KNEE":"x"}})", R"({"do":"pose","joints":{"KNEE":1e300}})",
                           R"({"do":"pose","joints":{"KNEE":null}})"}) {
    EXPECT_FALSE(read(text, true, request)) << text;
  }
  std::string many = R"({"do":"pose","joints":{)";
  for (int i = 0; i <= kMaxJoints; ++i) many += (i ? ",\"J" : "\"J") + std::to_string(i) + "\":0";
  EXPECT_FALSE(read(many + "}}", true, request));
}

TEST(PageRequest, ActingNeedsTheToken) {
  PageRequest request;
  for (const char* text :
       {R"({"do":"clear"})", R"({"do":"switch","run":5})", R"({"do":"mode","mode":"sway"})",
        R"({"do":"walk","vx":0.1,"vy":0,"wz":0})", R"({"do":"cancel"})", R"({"do":"pose","joints":{"KNEE":0.5}})",
        R"({"do":"reach","side":"left","at":[0.3,0.2,1]})"}) {
    EXPECT_FALSE(read(text, false, request)) << text;
    EXPECT_TRUE(read(text, true, request)) << text;
  }
}

TEST(PageRequest, ReadsModesAndSources) {
  PageRequest request;
  ASSERT_TRUE(read(R"({"do":"mode","mode":"squat"})", true, request));
  EXPECT_EQ(request.mode, Mode::kBalance);
  EXPECT_EQ(request.motion, Motion::kSquat);
  EXPECT_EQ(request.amplitude, defaults_of(Motion::kSquat).amplitude);
  EXPECT_EQ(request.frequency, defaults_of(Motion::kSquat).frequency);
  ASSERT_TRUE(read(R"({"do":"mode","mode":"hold"})", true, request));
  EXPECT_EQ(request.mode, Mode::kHold);
  EXPECT_EQ(request.motion, Motion::kNone);
  ASSERT_TRUE(read(R"({"do":"switch","run":9007199254740991})", true, request));
  EXPECT_EQ(request.run_id, 9007199254740991);
}

TEST(PageRequest, ReadsVelocitiesAndHandGoals) {
  PageRequest request;
  ASSERT_TRUE(read(R"({"do":"walk","vx":-0.25,"vy":0.5,"wz":1})", true, request));
  EXPECT_EQ(request.what, PageRequest::What::kWalk);
  EXPECT_FLOAT_EQ(request.vx, -0.25f);
  EXPECT_FLOAT_EQ(request.vy, 0.5f);
  EXPECT_FLOAT_EQ(request.wz, 1.0f);
  ASSERT_TRUE(read(R"({"do":"reach","side":"right","at":[0.3,-0.2,1]})", true, request));
  EXPECT_EQ(request.what, PageRequest::What::kReach);
  EXPECT_EQ(request.hand, "right");
  EXPECT_DOUBLE_EQ(request.at[1], -0.2);
}

// Whether there is such an arm is known where the robot is.
TEST(PageInbox, AnArmIsAskedForByItsName) {
  const Model model = test::three_arms();
  PageInbox inbox;
  const auto ask = [&](const std::string& name) { return inbox.on_message(model, "", R"({"do":"reach","side":")" + name + R"(","at":[0.3,0,0.7]})", true); };
  EXPECT_EQ(ask("west"), "");
  const std::string refusal = ask("wset");
  EXPECT_NE(refusal.find("no arm called wset; it has east, north, west"), std::string::npos) << refusal;
  std::vector<PageRequest> requests;
  (void)inbox.take(requests);
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(number_of(model, *hand_called(model, requests.front().hand)), 4);
}

TEST(PageRequest, RefusesEverythingElse) {
  PageRequest request;
  for (const char* text : {"",
                           "x",
                           "[]",
                           "null",
                           "{}",
                           R"({"do":1})",
                           R"({"do":"dance"})",
                           R"({"do":"mode"})",
                           R"({"do":"mode","mode":"walk fast"})",
                           R"({"do":"switch"})",
                           R"({"do":"switch","run":0})",
                           R"({"do":"switch","run":-1})",
                           R"({"do":"switch","run":1.5})",
                           R"({"do":"switch","run":9007199254740992})",
                           R"({"do":"switch","run":18446744073709551615})",
                           R"({"do":"switch","run":"1"})",
                           R"({"do":"walk"})",
                           R"({"do":"walk","vx":3,"vy":0,"wz":0})",
                           R"({"do":"walk","vx":1e400,"vy":0,"wz":0})",
                           R"({"do":"walk","vx":"1","vy":0,"wz":0})",
                           R"({"do":"reach","side":"","at":[0,0,0]})",
                           R"({"do":"reach","side":3,"at":[0,0,0]})",
                           R"({"do":"reach","side":"left"})",
                           R"({"do":"reach","side":"left","at":[0,0]})",
                           R"({"do":"reach","side":"left","at":[0,0,1e9]})",
                           R"({"do":"reach","side":"left","at":[0,0,null]})",
                           "{\"do\":\"cle",
                           "\xff\xfe"}) {
    EXPECT_FALSE(read(text, true, request)) << text;
  }
  EXPECT_FALSE(read(std::string(4000, '['), true, request));
}

TEST(PageRequest, ASetupMayOnlySaveTheRobot) {
  PageRequest request;
  ASSERT_TRUE(read(R"({"do":"setup","setup":{"scene":"stand"}})", true, request));
  EXPECT_FALSE(request.saves);
  ASSERT_TRUE(read(R"({"do":"setup","setup":{"scene":"stand","save":7}})", true, request));
  EXPECT_TRUE(request.saves);
  for (const char* number : {"-1", "\"x\"", "1.5", "null", "9007199254740993"}) {
    const std::string text = std::string(R"({"do":"setup","setup":{"scene":"stand","save":)") + number + "}}";
    EXPECT_FALSE(read(text, true, request)) << number;
  }
  EXPECT_FALSE(read(R"({"do":"setup","setup":{"scene":"stand","save":7}})", false, request));  // who only watches
}

// Unless it is a stop: what copies or writes JSON calls itself for every level.
TEST(PageRequest, DeepBracketsAreRefused) {
  PageRequest request;
  const std::string deep = std::string(500'000, '[') + std::string(500'000, ']');
  EXPECT_FALSE(read(R"({"do":"setup","setup":{"scene":"stand","limbs":)" + deep + "}}", true, request));
  EXPECT_FALSE(read(R"({"do":"walk","vy":0,"wz":0,"vx":)" + deep + "}", true, request));
  EXPECT_TRUE(read(R"({"do":"stop","kind":)" + deep + "}", false, request));
  EXPECT_TRUE(read(R"({"do":"setup","setup":{"scene":"stand","limbs":{"soles":{"left":{"at":[0,0,0]}}}}})", true, request));
}

TEST(PageRequest, NotesAreJsonWhateverTheText) {
  EXPECT_EQ(note_frame("a \"b\""), R"({"text":"a \"b\"","type":"note"})");
  EXPECT_NE(note_frame("\xff"), "");
}

}  // namespace
}  // namespace twinbus
