// The three stops as the controller sees them: STATE shows that the gate has stopped, or STOP is heard.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "control/loop/control_loop.h"
#include "test/control/hrp1s.h"
#include "test/control/sim_rig.h"
#include "test/rounds.h"

namespace twinbus {
namespace {

struct StopRig : SimRig {
  StopRig() : SimRig(test::hrp1s(), flat_scene(), {}, {}) {}
  // What STATE shows of the gate from now on.
  void stopped(StopKind kind) {
    state().stop_kind = kind;
    state().role = kind == StopKind::kNone ? Role::kActive : Role::kStopped;
  }
};

ModeRequest pose_request(StopRig& rig) {
  ModeRequest pose;
  pose.run_id = rig.state().run_id;
  pose.sender_id = 77;
  pose.mode = Mode::kPose;
  return pose;
}

TEST(Stop, ABalancedStopEndsTheMotionStandingAndThenDropsItsFlag) {
  StopRig rig;
  ASSERT_TRUE(rig.run(0.2));
  rig.ask(Mode::kBalance, Motion::kSway, 0.02, 0.5);
  ASSERT_TRUE(rig.run(1.0));
  StopRequest stop;
  stop.kind = StopKind::kBalanced;
  rig.loop().on_stop(stop);
  rig.stopped(StopKind::kBalanced);
  ASSERT_TRUE(rig.tick());
  EXPECT_EQ(rig.command().flags & kCommandStopping, kCommandStopping);
  int ticks = 1;
  while ((rig.command().flags & kCommandStopping) != 0 && ticks < 1000) {
    ASSERT_TRUE(rig.tick());
    ++ticks;
  }
  EXPECT_LT(ticks, 1000) << "the gate waits two seconds at most";
  EXPECT_FALSE(rig.record().fell);
  EXPECT_EQ(rig.loop().status().motion, Motion::kNone);
  EXPECT_LT(std::abs(rig.truth().com_velocity[1]), 0.02F);
}

TEST(Stop, WhileTheGateHoldsTheSetPointsFollowTheRobotAndNoModeIsTaken) {
  for (const StopKind kind : {StopKind::kHold, StopKind::kOff}) {
    StopRig rig;
    ASSERT_TRUE(rig.run(0.2));
    rig.stopped(kind);
    rig.ask(Mode::kHold);
    ASSERT_TRUE(rig.tick());
    EXPECT_EQ(rig.loop().status().mode, Mode::kStop);
    ASSERT_NE(rig.loop().take_sentence(), nullptr);
    // Whatever moves the robot meanwhile: the set-point of an arm joint is where the joint is.
    RobotState moved = rig.state();
    moved.q[8] -= 0.3;
    ++moved.tick;
    rig.loop().on_state(moved, moved.time_ns);
    JointCommand command;
    ASSERT_TRUE(rig.loop().step(moved.time_ns, command));
    EXPECT_NEAR(command.q[8], moved.q[8], 1e-9);
    // Cleared: the first command is there too.
    moved.stop_kind = StopKind::kNone;
    moved.role = Role::kActive;
    ++moved.tick;
    rig.loop().on_state(moved, moved.time_ns);
    ASSERT_TRUE(rig.loop().step(moved.time_ns, command));
    EXPECT_NEAR(command.q[8], moved.q[8], 1e-9);
    EXPECT_EQ(rig.loop().status().mode, Mode::kBalance);
  }
}

TEST(Stop, IdleAskedOfAStandingRobotDuringAStopIsRefused) {
  StopRig rig;
  ASSERT_TRUE(rig.run(0.1));
  rig.stopped(StopKind::kHold);
  ASSERT_TRUE(rig.tick());
  rig.ask(Mode::kIdle);
  ASSERT_TRUE(rig.run(0.02));
  EXPECT_EQ(rig.loop().status().mode, Mode::kStop);
  rig.stopped(StopKind::kNone);
  ASSERT_TRUE(rig.tick());
  EXPECT_EQ(rig.loop().status().mode, Mode::kBalance);
  EXPECT_GT(rig.command().kp[3], 0.0F);
}

TEST(Stop, AnArmPathIsNotTakenDuringAStop) {
  StopRig rig;
  ASSERT_TRUE(rig.run(0.1));
  rig.stopped(StopKind::kHold);
  ASSERT_TRUE(rig.tick());
  ArmPathPiece piece;
  piece.run_id = rig.state().run_id;
  piece.path_id = 3;
  piece.pieces = piece.joint_count = piece.knot_count = 1;
  piece.joint[0] = static_cast<std::int16_t>(test::hrp1s().hands[0].joints.front());
  (void)rig.loop().take_sentence();
  rig.loop().on_arm_path(piece);
  ASSERT_TRUE(rig.tick());
  bool of_path = false;
  const char* why = rig.loop().take_sentence(&of_path);
  ASSERT_NE(why, nullptr);
  EXPECT_NE(std::string(why).find("clear the stop first"), std::string::npos) << why;
  EXPECT_TRUE(of_path);
  rig.loop().on_arm_path(piece);  // heard again
  rig.stopped(StopKind::kNone);
  ASSERT_TRUE(rig.run(0.02));
  EXPECT_EQ(rig.loop().status().arm_path_id, 0);
  rig.loop().take_sentence(&of_path);
  EXPECT_FALSE(of_path);
}

TEST(Stop, NoModeAndNoPoseMakesAStandingRobotFall) {
  StopRig rig;
  ASSERT_TRUE(rig.run(0.5));
  rig.ask(Mode::kIdle);
  ASSERT_TRUE(rig.run(0.5));
  EXPECT_EQ(rig.loop().status().mode, Mode::kBalance);
  const char* why = rig.loop().take_sentence();
  ASSERT_NE(why, nullptr);
  EXPECT_NE(std::string(why).find("--let-go"), std::string::npos) << why;

  const Model& model = test::hrp1s();
  ModeRequest pose = pose_request(rig);
  pose.duration = 2.0F;
  // One knee alone; every joint at 3 rad.
  for (int k = 0; k < model.bus_count(); ++k) {
    if (model.joints[static_cast<std::size_t>(model.bus_joints[static_cast<std::size_t>(k)])]
            .name != "LLEG_KNEE")
      continue;
    pose.joint_mask = std::int64_t{1} << k;
    pose.q[static_cast<std::size_t>(k)] = rig.state().q[static_cast<std::size_t>(k)] + 1.0;
  }
  ASSERT_NE(pose.joint_mask, 0);
  pose.sequence = 1;
  rig.loop().on_mode_request(pose);
  ASSERT_TRUE(rig.run(3.0));
  EXPECT_EQ(rig.loop().status().mode, Mode::kBalance);
  why = rig.loop().take_sentence();
  ASSERT_NE(why, nullptr);
  EXPECT_NE(std::string(why).find("foot"), std::string::npos) << why;

  pose.sequence = 2;
  pose.joint_mask = (std::int64_t{1} << model.bus_count()) - 1;
  pose.q.fill(3.0);
  rig.loop().on_mode_request(pose);
  ASSERT_TRUE(rig.run(3.0));
  EXPECT_EQ(rig.loop().status().mode, Mode::kBalance);
  EXPECT_FALSE(rig.record().fell);

  // A pose that stands is taken.
  const int sitting = model.find_pose("half_sitting");
  ASSERT_GE(sitting, 0);
  pose.sequence = 3;
  for (int k = 0; k < model.bus_count(); ++k) {
    pose.q[static_cast<std::size_t>(k)] =
        model.poses[static_cast<std::size_t>(sitting)]
            .q[static_cast<std::size_t>(model.bus_joints[static_cast<std::size_t>(k)])];
  }
  rig.loop().on_mode_request(pose);
  ASSERT_TRUE(rig.run(3.0));
  EXPECT_EQ(rig.loop().status().mode, Mode::kPose);
  EXPECT_FALSE(rig.record().fell);
}

// A request is obeyed or answered, also when a stop comes while its way is looked along.
TEST(Stop, APoseThatAStopPreventsIsToldOf) {
  const Model& model = test::hrp1s();
  StopRig rig;
  ASSERT_TRUE(rig.run(0.3));
  ModeRequest pose = pose_request(rig);
  pose.sequence = 1;
  pose.duration = 1.0F;
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
    if (model.bus_joints[k] == model.hands[0].joints.front()) pose.joint_mask = std::int64_t{1} << k;
  }
  pose.q = rig.state().q;
  rig.loop().on_mode_request(pose);
  ASSERT_TRUE(rig.tick());
  rig.stopped(StopKind::kHold);
  ASSERT_TRUE(rig.tick());
  const char* why = rig.loop().take_sentence();
  ASSERT_NE(why, nullptr);
  EXPECT_NE(std::string(why).find("not begun"), std::string::npos) << why;
  EXPECT_EQ(rig.loop().status().mode, Mode::kStop);
}

// Every named pose of the robot after every other, at once and slowly: the legs take the body along.
TEST(Stop, NamedPosesOneAfterTheOtherAreStoodOrRefused) {
  const Model& model = test::hrp1s();
  StopRig rig;
  ASSERT_TRUE(rig.run(0.5));
  ModeRequest pose = pose_request(rig);
  pose.joint_mask = (std::int64_t{1} << model.bus_count()) - 1;
  int taken = 0;
  for (std::size_t i = 0; i < 3 * model.poses.size() * model.poses.size(); ++i) {
    const std::size_t which = i % 2 == 0 ? i / 2 % model.poses.size() : (i / 2 + 1 + i / 10) % model.poses.size();
    const NamedPose& named = model.poses[which];
    for (int k = 0; k < model.bus_count(); ++k) {
      pose.q[static_cast<std::size_t>(k)] = named.q[static_cast<std::size_t>(model.bus_joints[static_cast<std::size_t>(k)])];
    }
    pose.sequence = static_cast<std::int32_t>(i + 1);
    pose.duration = static_cast<float>(i % 3) * 0.7F;
    if (i % 4 == 0) rig.ask(Mode::kBalance);
    rig.loop().on_mode_request(pose);
    for (int t = 0; t < 1200; ++t) {
      ASSERT_TRUE(rig.tick());
      ASSERT_FALSE(rig.record().fell) << i << ": " << named.name << " in " << pose.duration << " s";
    }
    taken += rig.loop().status().mode == Mode::kPose;
  }
  std::printf("%d of %zu taken\n", taken, 3 * model.poses.size() * model.poses.size());
  EXPECT_GT(taken, 10);
}

// Of arms and waist, from balance and from hold, slow and at once: taken and stood, or refused with what would be.
TEST(Stop, PosesOfArmsAndWaistAreStoodOrRefusedForWhatWouldTouchOrFall) {
  const Model& model = test::hrp1s();
  StopRig rig;
  ASSERT_TRUE(rig.run(0.5));
  std::mt19937 random(34);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  ModeRequest pose = pose_request(rig);
  int taken = 0, touching = 0, falling = 0;
  for (int i = 0; i < test::rounds(60); ++i) {
    rig.ask(i % 4 == 3 ? Mode::kHold : Mode::kBalance);
    ASSERT_TRUE(rig.run(0.7));
    (void)rig.loop().take_sentence();
    pose.sequence = i + 1;
    pose.joint_mask = 0;
    pose.duration = static_cast<float>(i % 3 == 0 ? 0.0 : 1.5);
    std::string asked;
    for (int k = 0; k < model.bus_count(); ++k) {
      const Joint& joint = model.joints[static_cast<std::size_t>(model.bus_joints[static_cast<std::size_t>(k)])];
      if (joint.name.find("LEG") != std::string::npos || uniform(0.0, 1.0) < 0.6) continue;
      pose.joint_mask |= std::int64_t{1} << k;
      pose.q[static_cast<std::size_t>(k)] = uniform(joint.lower, joint.upper);
      asked += joint.name + "=" + std::to_string(pose.q[static_cast<std::size_t>(k)]) + " ";
    }
    if (pose.joint_mask == 0) continue;
    rig.loop().on_mode_request(pose);
    for (int t = 0; t < 1500; ++t) {
      ASSERT_TRUE(rig.tick());
      ASSERT_NE(rig.loop().guard_report().verdict, GuardVerdict::kInCollision) << i << ": " << asked;
      ASSERT_FALSE(rig.record().fell) << i << (i % 4 == 3 ? " from hold: " : ": ") << asked;
    }
    if (rig.loop().status().mode == Mode::kPose) {
      ++taken;
      EXPECT_EQ(rig.loop().guard_report().hold_mask, 0) << i << ": " << asked << "is taken and not reached";
      continue;
    }
    const char* why = rig.loop().take_sentence();
    ASSERT_NE(why, nullptr) << i << ": " << asked;
    const std::string sentence = why;
    touching += sentence.find("would touch") != std::string::npos;
    falling += sentence.find("would fall") != std::string::npos;
    EXPECT_TRUE(sentence.find("would touch") != std::string::npos || sentence.find("would fall") != std::string::npos) << sentence;
  }
  std::printf("%d taken, %d would touch, %d would fall\n", taken, touching, falling);
  EXPECT_GT(taken, test::rounds(5));
  EXPECT_GT(touching, test::rounds(5));
}

}  // namespace
}  // namespace twinbus
