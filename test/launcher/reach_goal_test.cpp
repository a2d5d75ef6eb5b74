// Goals in any frame and for any tool become goals of the hand in the ground frame.

#include "launcher/operate/reach_goal.h"

#include <gtest/gtest.h>

#include "common/process/arguments.h"
#include "launcher/operate/asked_hand.h"
#include "launcher/operate/bus_joint_name.h"
#include "launcher/operate/operate.h"
#include "robot/description/load.h"
#include "robot/description/named_hands.h"
#include "test/carried_arms.h"
#include "test/error_of.h"

namespace twinbus {
namespace {

Eigen::Isometry3d pose(const Eigen::Vector3d& place, double yaw) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = place;
  pose.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

// The words of reach, attach, release and grip.
TEST(AskedHand, IsCalledByItsNameAndAnUnknownOneIsAnsweredWithAll) {
  const Model three = test::three_arms();
  EXPECT_EQ(asked_hand("attach", three, "west").name, "west");
  EXPECT_EQ(spoken_name(three, asked_hand("attach", three, "west")), "arm west");
  EXPECT_EQ(test::error_of([&] { (void)asked_hand("attach", three, "wset"); }),
            "attach: three_arms has no arm called wset (did you mean west?); say one of: east, north, west");
  const Model two = load_robot("hrp1s");
  EXPECT_EQ(spoken_name(two, asked_hand("attach", two, "left")), "the left hand");
  EXPECT_THROW((void)asked_hand("attach", two, "tail"), UsageError);
  Model none = two;
  none.hands = {};
  EXPECT_NE(test::error_of([&] { (void)asked_hand("release", none, "left"); }).find("has no hand"), std::string::npos);
}

// As it stands in half_sitting, turned and away from where it first stood.
class Standing : public ::testing::Test {
 protected:
  Standing() : model_(load_robot("hrp1s")), estimator_(model_) {
    RobotState state;
    state.run_id = 1;
    state.model_hash = model_.hash;
    state.period_ns = model_.period_ns;
    state.joint_count = static_cast<std::int16_t>(model_.bus_count());
    state.attitude = {1.0F, 0.0F, 0.0F, 0.0F};
    const std::vector<double>& q = model_.poses[static_cast<std::size_t>(model_.find_pose("half_sitting"))].q;
    for (std::size_t k = 0; k < static_cast<std::size_t>(model_.bus_count()); ++k)
      state.q[k] = q[static_cast<std::size_t>(model_.bus_joints[k])];
    estimator_.update(state);
  }
  Model model_;
  Estimator estimator_;
};

TEST_F(Standing, AFrameIsWhereTheRobotHasIt) {
  const Eigen::Isometry3d to_ground = estimator_.ground_in_world().inverse();
  const Eigen::Isometry3d base = to_ground * estimator_.kinematics().link_in_world(0);
  EXPECT_TRUE(frame_in_ground(reach_frame(model_, "ground"), model_, estimator_, {})->isApprox(Eigen::Isometry3d::Identity()));
  EXPECT_TRUE(frame_in_ground(reach_frame(model_, "base"), model_, estimator_, {})->isApprox(base));
  EXPECT_GT(base.translation().z(), 0.4);
  // The base is known to be 2 m ahead in the world and turned to the left: what lies there is in front of the robot.
  const Eigen::Isometry3d in_world = pose({2.0, 1.0, base.translation().z()}, 0.5 * M_PI);
  const ReachFrame world = reach_frame(model_, "world");
  EXPECT_TRUE(stands_still(world));
  EXPECT_FALSE(frame_in_ground(world, model_, estimator_, {})) << "nobody told";
  const Eigen::Vector3d there = *frame_in_ground(world, model_, estimator_, in_world) * Eigen::Vector3d(2.0, 1.4, 0.7);
  EXPECT_NEAR(there.x() - base.translation().x(), 0.4, 1e-6);
  EXPECT_NEAR(there.y() - base.translation().y(), 0.0, 1e-6);
  EXPECT_NEAR(there.z(), 0.7, 1e-6);
  const Frame& some = model_.frames.back();
  EXPECT_TRUE(frame_in_ground(reach_frame(model_, some.name), model_, estimator_, {})
                  ->isApprox(to_ground * estimator_.kinematics().link_in_world(some.link) * some.in_link));
  EXPECT_NE(test::error_of([&] { (void)reach_frame(model_, "wrld"); }).find("none of ground, base and world"), std::string::npos);
}

TEST(AimHand, TheToolComesToThePlace) {
  const Eigen::Isometry3d hand = pose({0.3, 0.2, 0.9}, 0.4), tool = pose({0.0, 0.0, 0.15}, 0.0), place = pose({0.5, 0.1, 1.0}, 1.0);
  ArmGoal goal;
  const auto aimed = [&] {
    Eigen::Isometry3d at = Eigen::Isometry3d::Identity();
    at.translation() << goal.position[0], goal.position[1], goal.position[2];
    at.linear() = Eigen::Quaterniond(goal.orientation[0], goal.orientation[1], goal.orientation[2], goal.orientation[3]).matrix();
    return at;
  };
  aim_hand(place, true, tool, hand, goal);
  EXPECT_EQ(goal.kind, ArmGoalKind::kPose);
  EXPECT_TRUE((aimed() * tool).isApprox(place, 1e-12));
  aim_hand(place, false, tool, hand, goal);
  EXPECT_EQ(goal.kind, ArmGoalKind::kPose);
  EXPECT_TRUE((aimed() * tool).translation().isApprox(place.translation(), 1e-12));
  EXPECT_TRUE(aimed().linear().isApprox(hand.linear(), 1e-12)) << "it keeps its turn";
  // The hand's own frame, as ever: the planner may turn the hand.
  aim_hand(place, false, Eigen::Isometry3d::Identity(), hand, goal);
  EXPECT_EQ(goal.kind, ArmGoalKind::kPosition);
  EXPECT_EQ(goal.position[0], 0.5);
}

// A joint that a message counts is told by its name.
TEST(PoseCommand, NamesTheJointThatRestsTheFarthestFromItsPose) {
  RobotState state;
  ModeRequest request;
  state.joint_count = 29;
  request.joint_mask = 0b1011;
  request.q[0] = 0.01, request.q[1] = -0.25, request.q[2] = 1.0;  // the third was not asked for
  EXPECT_EQ(what_rests(state, request).find("joint 1 on the bus (--robot names it) rests 0.250 rad or m short of it: "), 0U) << what_rests(state, request);
}

TEST(BusJointName, IsTheRobotsOwnOrTheNumber) {
  const Model model = load_robot("hrp1s");
  for (const std::size_t k : {std::size_t{0}, std::size_t{14}})
    EXPECT_EQ(bus_joint_name("hrp1s", model.hash, k), model.joints[static_cast<std::size_t>(model.bus_joints[k])].name);
  for (const char* other : {"biped12", "no_such_robot"})
    EXPECT_EQ(bus_joint_name(other, model.hash, 14), "joint 14 on the bus (--robot names it)") << other;
  EXPECT_NE(bus_joint_name("hrp1s", model.hash, 48).find("joint 48"), std::string::npos);
}

}  // namespace
}  // namespace twinbus
