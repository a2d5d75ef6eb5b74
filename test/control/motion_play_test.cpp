// Motions played by the control loop on the simulated robot.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "common/math/index.h"
#include "control/loop/control_loop.h"
#include "robot/motion/motion_clip.h"
#include "test/control/made_motion.h"
#include "test/control/sim_rig.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

using test::hrp1s;
using test::made_motion;

MotionClip arms_and_squat(double seconds) {
  return {hrp1s(), made_motion(seconds, [](double time, auto& joints) {
            test::squat(time, joints);
            test::wave_arm(time, joints);
          }), {}};
}

Scene flat_ground() {
  Scene scene;
  scene.name = "flat";
  return scene;
}

struct Player : SimRig {
  Player() : SimRig(hrp1s(), flat_ground(), {}, {}) { EXPECT_TRUE(run(0.5)); }

  void say(const MotionClip& clip, std::int64_t id, int frames = kMostMotionFrames) {
    for (MotionPiece piece : clip.pieces(id)) {
      piece.run_id = state().run_id;
      if (piece.first < frames) loop().on_motion(piece);
    }
  }
  bool plays() { return loop().status().motion == Motion::kPlayed; }
  // Until it plays no more; how long it took [s], -1 when it does not end.
  double play_out(double most) {
    for (double time = 0.0; time < most; time += hrp1s().period()) {
      if (!tick()) return -1.0;
      note();
      if (!plays() && time > 0.1) return time;
    }
    return -1.0;
  }
  // The largest step of a set-point beyond its own velocity [rad].
  void note() {
    for (std::size_t k = 0; k < at(hrp1s().bus_count()); ++k) {
      const double moved = command().q[k] - before_.q[k] - hrp1s().period() * 0.5 * static_cast<double>(command().qd[k] + before_.qd[k]);
      if (before_.tick + 1 == command().tick) jump = std::max(jump, std::abs(moved));
    }
    before_ = command();
  }
  std::string sentence() {
    const char* said = loop().take_sentence();
    return said != nullptr ? said : "";
  }
  void walk(double velocity, double seconds) {
    ask(Mode::kWalk);
    for (double time = 0.0; time < seconds; time += hrp1s().period()) {
      WalkCommand command;
      command.run_id = state().run_id;
      command.sequence = ++walked_;
      command.vx = static_cast<float>(velocity);
      command.timeout = 0.3F;
      loop().on_walk_command(command, state().time_ns);
      ASSERT_TRUE(tick());
    }
  }

  double jump = 0.0;

 private:
  JointCommand before_;
  std::int32_t walked_ = 0;
};

int bus(const char* joint) { return hrp1s().bus_index[at(hrp1s().find_joint(joint))]; }

TEST(MotionPlay, ArmsGoExactlyAsTheMotionSaysAndTheRobotGoesDownAndUp) {
  const MotionClip clip = arms_and_squat(4.0);
  Player robot;
  const auto height = [&] { return static_cast<double>(robot.loop().status().com[2]); };
  const double stood = height();
  robot.say(clip, 5);
  ASSERT_TRUE(robot.tick());
  EXPECT_TRUE(robot.plays());
  double lowest = stood, worst = 0.0, begun = -1.0;
  NoAlloc no_alloc;
  for (int i = 0; robot.plays() && i < 10'000; ++i) {
    ASSERT_TRUE(robot.tick());
    robot.note();
    lowest = std::min(lowest, height());
    const double time = static_cast<double>(i) * hrp1s().period();
    // In the first wave the clock comes up to speed; the angle at its top is passed all the same.
    const double top = clip.at_time(1.0).q[at(bus("RARM_SHOULDER_R"))];
    worst = std::max(worst, std::abs(robot.command().q[at(bus("RARM_SHOULDER_R"))]));
    if (begun < 0.0 && worst > 0.95 * std::abs(top)) begun = time;
  }
  EXPECT_FALSE(robot.plays()) << "it ends";
  EXPECT_NEAR(worst, std::abs(clip.at_time(1.0).q[at(bus("RARM_SHOULDER_R"))]), 1e-3);
  EXPECT_GT(begun, 2.0) << "it goes to the first frame before";
  EXPECT_NEAR(stood - lowest, clip.depth(), 0.1 * clip.depth());
  EXPECT_LT(robot.jump, 1e-3);
  ASSERT_TRUE(robot.run(1.5));
  EXPECT_NEAR(height(), stood, 2e-3);
  EXPECT_NEAR(robot.command().q[at(bus("RARM_ELBOW"))], clip.stand()[at(bus("RARM_ELBOW"))], 5e-3) << "back";
  EXPECT_FALSE(robot.record().fell);
  EXPECT_GT(robot.record().zmp_margin_min, 0.02);
  EXPECT_EQ(robot.sentence(), "");
}

// A joint that something keeps from the first frame, for as long as one likes: asked to end it, or left alone with it.
TEST(MotionPlay, WhatAGuardHoldsOnTheWayToItKeepsNothingElseFromBeingObeyed) {
  const MotionClip clip{hrp1s(), made_motion(4.0, [](double, auto& joints) { joints.emplace_back("RARM_SHOULDER_P", -0.6); }), {}};
  for (const bool asked : {true, false}) {
    Player robot;
    GuardReport report;
    report.run_id = robot.state().run_id;
    report.hold_mask = std::int64_t{1} << bus("RARM_SHOULDER_P");
    std::string said;
    const auto run = [&](double seconds, bool held) {
      for (double time = 0.0; time < seconds; time += hrp1s().period()) {
        report.tick = robot.state().tick;
        if (held) robot.loop().on_guard(report, robot.state().time_ns);
        ASSERT_TRUE(robot.tick());
        said += robot.sentence();
      }
    };
    robot.say(clip, 5);
    run(0.4, false);
    const double begun = robot.command().q[at(bus("RARM_SHOULDER_P"))];
    run(asked ? 1.0 : 8.0, true);
    EXPECT_NEAR(robot.command().q[at(bus("RARM_SHOULDER_P"))], begun, 0.2) << "it is held on its way";
    EXPECT_EQ(said.find("it is not played") != std::string::npos, !asked) << said;
    robot.ask(Mode::kHold);
    run(6.0, true);
    EXPECT_FALSE(robot.plays());
    EXPECT_EQ(robot.loop().status().mode, Mode::kHold) << asked;
    EXPECT_FALSE(robot.record().fell);
  }
}

TEST(MotionPlay, NothingIsAllocatedWhileItPlays) {
  const MotionClip clip = arms_and_squat(1.0);
  Player robot;
  std::vector<MotionPiece> pieces = clip.pieces(5);
  for (MotionPiece& piece : pieces) piece.run_id = robot.state().run_id;
  ControlLoop& loop = robot.loop();
  long allocations = 0;
  for (std::size_t i = 0; i < 3000; ++i) {
    NoAlloc no_alloc;
    if (i < pieces.size()) loop.on_motion(pieces[i]);
    JointCommand command;
    RobotState state = robot.state();
    state.tick += static_cast<std::int64_t>(i) + 1;
    loop.on_state(state, state.time_ns);
    (void)loop.step(state.time_ns, command);
    allocations += no_alloc.count();
  }
  EXPECT_EQ(allocations, 0);
}

TEST(MotionPlay, AWalkIsBroughtToRestFirstAndAskedInTheMotionItGoesOnAfterIt) {
  Player robot;
  robot.walk(0.3, 4.0);
  EXPECT_EQ(robot.loop().status().mode, Mode::kWalk);
  const auto forward = [&] { return static_cast<double>(robot.truth().base_position[0]); };
  const double walked = forward();
  EXPECT_GT(walked, 0.5);
  robot.say(arms_and_squat(4.0), 5);
  bool played = false;
  for (int i = 0; i < 4000 && !played; ++i) {
    ASSERT_TRUE(robot.tick());
    played = robot.plays();
  }
  EXPECT_TRUE(played) << "once it stands";
  EXPECT_EQ(robot.loop().status().mode, Mode::kBalance);
  ASSERT_TRUE(robot.run(3.0));
  ASSERT_TRUE(robot.plays());
  robot.ask(Mode::kWalk);
  EXPECT_GT(robot.play_out(5.0), 0.0) << "ended on its path, and led back";
  const double stood = forward();
  robot.walk(0.3, 4.0);
  EXPECT_EQ(robot.loop().status().mode, Mode::kWalk);
  EXPECT_GT(forward() - stood, 0.5);
  EXPECT_FALSE(robot.record().fell);
  EXPECT_LT(robot.jump, 2e-3);
}

// `mode play` is for a policy that has its motion.
TEST(MotionPlay, ARequestToPlayChangesNothing) {
  Player robot;
  robot.walk(0.2, 1.0);
  robot.ask(Mode::kBalance, Motion::kPlayed);
  ASSERT_TRUE(robot.run(2.5));  // longer than a walk needs to rest
  EXPECT_EQ(robot.loop().status().mode, Mode::kWalk);
  EXPECT_NE(robot.sentence().find("the mode stays as it is"), std::string::npos);
}

TEST(MotionPlay, ABalancedStopEndsItAndTheRobotStands) {
  Player robot;
  robot.say(arms_and_squat(6.0), 5);
  ASSERT_TRUE(robot.run(3.0));
  ASSERT_TRUE(robot.plays());
  robot.ask(Mode::kStop);
  ASSERT_TRUE(robot.run(1.5));
  EXPECT_FALSE(robot.plays());
  for (std::size_t k = 0; k < at(hrp1s().bus_count()); ++k) EXPECT_LT(std::abs(robot.command().qd[k]), 0.02F) << k;
  EXPECT_FALSE(robot.record().fell);
  robot.say(arms_and_squat(6.0), 5);
  ASSERT_TRUE(robot.run(0.2));
  EXPECT_FALSE(robot.plays()) << "each number is played once";
  robot.say(arms_and_squat(1.0), 6);
  ASSERT_TRUE(robot.run(0.2));
  EXPECT_TRUE(robot.plays());
}

TEST(MotionPlay, WhatAJointCannotDoIsRefusedWithASentence) {
  Player robot;
  const auto said = [&](const test::MotionShape& shape, std::int64_t id) {
    (void)robot.sentence();
    robot.say({hrp1s(), made_motion(2.0, shape), {}}, id);
    EXPECT_TRUE(robot.run(0.2));
    EXPECT_FALSE(robot.plays());
    return robot.sentence();
  };
  EXPECT_NE(said([](double time, auto& j) { j.emplace_back("RARM_ELBOW", 1.2 * test::wave(time)); }, 1).find("leaves its limits"), std::string::npos);
  EXPECT_NE(said([](double time, auto& j) { j.emplace_back("LARM_WRIST_Y", 0.9 * std::sin(12.0 * time)); }, 2).find("faster than its limit"),
            std::string::npos);
  // Into the trunk, in one line.
  EXPECT_NE(said([](double, auto& j) {
              j.emplace_back("RARM_SHOULDER_R", 0.4);
              j.emplace_back("RARM_SHOULDER_Y", 1.5);
              j.emplace_back("RARM_ELBOW", -1.5);
            }, 3).find("is not free"),
            std::string::npos);
  MotionPiece piece;
  piece.run_id = robot.state().run_id;
  piece.motion_id = 4;
  piece.frames = 12;
  piece.count = 6;
  piece.joint_count = 3;
  robot.loop().on_motion(piece);
  ASSERT_TRUE(robot.run(0.1));
  EXPECT_NE(robot.sentence().find("not for this robot"), std::string::npos);
  EXPECT_FALSE(robot.record().fell);
}

TEST(MotionPlay, WhenItsFramesDoNotComeItEndsAndTheRobotStands) {
  Player robot;
  robot.say(arms_and_squat(8.0), 5, 100);
  const double seconds = robot.play_out(20.0);
  EXPECT_GT(seconds, 4.0);
  EXPECT_LT(seconds, 9.0);
  EXPECT_NE(robot.sentence().find("do not come"), std::string::npos);
  EXPECT_LT(robot.jump, 1e-3);
  EXPECT_FALSE(robot.record().fell);
}

TEST(MotionPlay, ALeanOfTheTrunkIsFollowed) {
  MotionFile file = made_motion(4.0, [](double, auto& joints) { joints.emplace_back("LLEG_KNEE", 0.0); });
  for (const double time : file.time) {
    Eigen::Isometry3d& root = file.root.emplace_back(Eigen::Isometry3d::Identity());
    root.linear() = Eigen::AngleAxisd(0.15 * test::wave(0.5 * time), Eigen::Vector3d::UnitY()).toRotationMatrix();
    root.translation().z() = 0.65;
  }
  const MotionClip clip(hrp1s(), file, {});
  EXPECT_NEAR(clip.at_time(2.0).tilt.y(), 0.15, 0.02);
  Player robot;
  robot.say(clip, 5);
  ASSERT_TRUE(robot.tick());
  double most = 0.0;
  for (int i = 0; robot.plays() && i < 10'000; ++i) {
    ASSERT_TRUE(robot.tick());
    const auto& q = robot.truth().base_attitude;
    most = std::max(most, 2.0 * static_cast<double>(q[2]));
  }
  EXPECT_NEAR(most, 0.15, 0.05);
  ASSERT_TRUE(robot.run(1.5));
  EXPECT_LT(std::abs(2.0 * robot.truth().base_attitude[2]), 0.02);
  EXPECT_FALSE(robot.record().fell);
}

}  // namespace
}  // namespace twinbus
