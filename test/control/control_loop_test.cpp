#include "control/loop/control_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "common/math/index.h"
#include "test/control/hrp1s.h"
#include "test/control/sim_rig.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

struct Rig : SimRig {
  explicit Rig(ControlConfig config = {}) : SimRig(test::hrp1s(), flat_scene(), {}, config) {}
};

ModeRequest pose_request(Rig& rig, float duration) {
  return {.sender_id = 99, .run_id = rig.state().run_id, .sequence = 1, .mode = Mode::kPose, .duration = duration};
}

// The torque that the servo law gives at what was measured [N m].
double law(const JointCommand& c, const RobotState& s, std::size_t k) {
  return static_cast<double>(c.tau[k]) + static_cast<double>(c.kp[k]) * (c.q[k] - s.q[k]) +
         static_cast<double>(c.kd[k]) * static_cast<double>(c.qd[k] - s.qd[k]);
}

struct Jump {
  double position = 0.0;  // [rad] beyond the set-point's own velocity
  double torque = 0.0;    // share of the effort limit
};

// The largest step from one tick to the next over some seconds.
Jump largest_jump(Rig& rig, double seconds) {
  const Model& model = test::hrp1s();
  Jump worst;
  const auto ticks = static_cast<int>(seconds / model.period());
  for (int n = 0; n < ticks; ++n) {
    const JointCommand before = rig.command();
    const RobotState measured = rig.state();
    if (!rig.tick()) {
      ADD_FAILURE() << "the rig gave up at tick " << rig.ticks();
      return worst;
    }
    const JointCommand& now = rig.command();
    for (std::size_t k = 0; k < static_cast<std::size_t>(model.bus_count()); ++k) {
      const double effort = model.joints[static_cast<std::size_t>(model.bus_joints[k])].effort;
      const double moved = now.q[k] - before.q[k] -
                           model.period() * 0.5 * static_cast<double>(now.qd[k] + before.qd[k]);
      worst.position = std::max(worst.position, std::abs(moved));
      worst.torque = std::max(
          worst.torque, std::abs(law(now, rig.state(), k) - law(before, measured, k)) / effort);
    }
  }
  return worst;
}

TEST(ControlLoop, AnswersNothingBeforeAStateAndNoSourceThatIsNotActive) {
  ControlLoop loop(test::hrp1s(), {});
  JointCommand command;
  EXPECT_FALSE(loop.step(0, command));
  Rig rig;
  ASSERT_TRUE(rig.run(0.02));
  for (const Role role : {Role::kParked, Role::kStandbyTrack, Role::kStandbyShadow}) {
    RobotState state = rig.state();
    state.role = role;
    loop.on_state(state, 0);
    EXPECT_FALSE(loop.step(0, command));
  }
}

TEST(ControlLoop, ARepeatedTickGivesTheSameCommandAgain) {
  Rig rig;
  ASSERT_TRUE(rig.run(0.1));
  JointCommand again;
  rig.loop().on_state(rig.state(), 0);
  ASSERT_TRUE(rig.loop().step(0, again));
  EXPECT_EQ(again.tick, rig.command().tick);
  EXPECT_EQ(again.q, rig.command().q);
  EXPECT_EQ(again.tau, rig.command().tau);
}

TEST(ControlLoop, ACommandNamesTheSourceItIsFor) {
  Rig rig;
  ASSERT_TRUE(rig.run(0.01));
  EXPECT_EQ(rig.command().run_id, rig.state().run_id);
  EXPECT_EQ(rig.command().term, rig.state().term);
  EXPECT_EQ(rig.command().model_hash, test::hrp1s().hash);
  EXPECT_EQ(rig.command().tick, rig.state().tick);
}

TEST(ControlLoop, NoModeChangeJumps) {
  Rig rig;
  ASSERT_TRUE(rig.run(0.3));
  const auto check = [&](const char* what, double seconds) {
    const Jump jump = largest_jump(rig, seconds);
    EXPECT_LT(jump.position, 1e-3) << what;
    EXPECT_LT(jump.torque, 0.05) << what;
    EXPECT_FALSE(rig.record().fell) << what;
  };
  check("stand", 0.1);
  rig.ask(Mode::kBalance, Motion::kSway, 0.02, 0.5);
  check("sway begins", 1.2);
  rig.ask(Mode::kHold);
  check("hold in mid-sway", 0.5);
  rig.ask(Mode::kBalance);
  check("balance again", 0.5);
  rig.ask(Mode::kBalance, Motion::kSquat, 0.03, 0.5);
  check("squat begins", 0.8);
  rig.ask(Mode::kStop);
  check("stop in mid-squat", 0.5);
}

TEST(ControlLoop, ABalancingRobotMovesItsArmsToAPoseAndGoesOnBalancing) {
  const Model& model = test::hrp1s();
  Rig rig;
  ASSERT_TRUE(rig.run(0.1));
  ModeRequest request = pose_request(rig, 0.5F);
  std::size_t moved = 0;
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
    if (model.bus_joints[k] == model.hands[0].joints.front()) moved = k;
  }
  request.joint_mask = std::int64_t{1} << moved;
  request.q[moved] = rig.command().q[moved] - 0.2;
  rig.loop().on_mode_request(request);
  const Jump jump = largest_jump(rig, 0.8);
  EXPECT_LT(jump.position, 1e-3);
  EXPECT_NEAR(rig.command().q[moved], request.q[moved], 1e-6);
  EXPECT_EQ(rig.loop().status().mode, Mode::kPose);
  EXPECT_FALSE(rig.record().fell);
  EXPECT_EQ(rig.loop().status().mode_sequence, 1);
}

TEST(ControlLoop, WalkingIsDeclinedWithASentenceWhileTheRobotDoesNotStand) {
  Rig rig;
  ASSERT_TRUE(rig.run(0.05));
  rig.ask(Mode::kHold);
  ASSERT_TRUE(rig.run(0.05));
  (void)rig.loop().take_sentence();
  rig.ask(Mode::kWalk);
  RobotState state = rig.state();
  state.wrench[0].fill(0.0F);
  state.wrench[1].fill(0.0F);
  ++state.tick;
  rig.loop().on_state(state, state.time_ns);
  JointCommand command;
  ASSERT_TRUE(rig.loop().step(state.time_ns, command));
  EXPECT_EQ(rig.loop().status().mode, Mode::kHold);
  const char* sentence = rig.loop().take_sentence();
  ASSERT_NE(sentence, nullptr);
  EXPECT_NE(std::string(sentence).find("walking"), std::string::npos);
  EXPECT_EQ(rig.loop().take_sentence(), nullptr) << "said once";
}

// A robot whose legs cannot do it says so and goes on standing; a shallower squat is still done.
TEST(ControlLoop, ASquatThatTheLegsCannotDoIsRefusedBeforeAnythingMoves) {
  struct Case {
    const char* joint;
    double upper, effort;
    const char* says;
  };
  for (const Case& c : {Case{"LLEG_KNEE", 0.0, 0.0, ""}, Case{"LLEG_KNEE", 0.2, 0.0, "limits"},
                        Case{"RLEG_KNEE", 0.0, 1.3, "efforts"}}) {
    Rig standing;
    ASSERT_TRUE(standing.run(0.3));
    Model model = test::hrp1s();
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
      Joint& joint = model.joints[static_cast<std::size_t>(model.bus_joints[k])];
      if (joint.name != c.joint) continue;
      // A little more than standing needs, less than the bottom of a deep squat.
      if (c.upper > 0.0) joint.upper = standing.state().q[k] + c.upper;
      if (c.effort > 0.0)
        joint.effort = c.effort * std::abs(static_cast<double>(standing.state().tau[k]));
    }
    SimRig rig(model, test::hrp1s(), Scene{}, {}, {});
    ASSERT_TRUE(rig.run(0.3));
    (void)rig.loop().take_sentence();
    rig.ask(Mode::kBalance, Motion::kSquat, 0.08, 0.3);
    ASSERT_TRUE(rig.tick());
    const char* sentence = rig.loop().take_sentence();
    if (*c.says == 0) {
      EXPECT_EQ(sentence, nullptr);
      EXPECT_EQ(rig.loop().status().motion, Motion::kSquat);
      continue;
    }
    ASSERT_NE(sentence, nullptr) << c.says;
    EXPECT_NE(std::string(sentence).find(c.says), std::string::npos) << sentence;
    const float height = rig.truth().com[2];
    ASSERT_TRUE(rig.run(2.0));
    EXPECT_NEAR(rig.truth().com[2], height, 0.004);
    EXPECT_EQ(rig.loop().status().motion, Motion::kNone);
    rig.ask(Mode::kBalance, Motion::kSquat, 0.005, 0.3);
    ASSERT_TRUE(rig.run(0.5));
    EXPECT_EQ(rig.loop().status().motion, Motion::kSquat) << "a shallower one";
  }
}

TEST(ControlLoop, AStateThatNoRobotCanBeInIsRiddenOut) {
  Rig rig;
  ASSERT_TRUE(rig.run(0.2));
  const JointCommand before = rig.command();
  for (int bad = 0; bad < 3; ++bad) {
    RobotState state = rig.state();
    state.tick += bad + 1;
    if (bad == 0) state.q[5] = std::numeric_limits<double>::quiet_NaN();
    if (bad == 1) state.attitude = {0.0F, 0.0F, 0.0F, 0.0F};
    if (bad == 2) state.wrench[0][2] = 1e9F;
    rig.loop().on_state(state, state.time_ns);
    JointCommand command;
    ASSERT_TRUE(rig.loop().step(state.time_ns, command));
    for (std::size_t k = 0; k < 29; ++k) {
      ASSERT_EQ(command.q[k], before.q[k]);
      ASSERT_EQ(command.qd[k], 0.0F);
      ASSERT_TRUE(std::isfinite(command.tau[k]));
    }
    EXPECT_NE(rig.loop().take_sentence(), nullptr);
  }
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(rig.tick());
  const Jump jump = largest_jump(rig, 0.2);
  EXPECT_LT(jump.torque, 0.05);
  EXPECT_FALSE(rig.record().fell);
}

TEST(ControlLoop, AFirstStateThatNoRobotCanBeInIsNotAnswered) {
  Rig rig;
  ASSERT_TRUE(rig.tick());
  RobotState state = rig.state();
  state.q[5] = std::numeric_limits<double>::infinity();
  ControlLoop loop(test::hrp1s(), {});
  loop.on_state(state, 0);
  JointCommand command;
  EXPECT_FALSE(loop.step(0, command));
}

TEST(ControlLoop, AGuardHoldsArmsButNeverLegsAndOnlyWhileItSpeaks) {
  const Model& model = test::hrp1s();
  ControlConfig config;
  config.guard_in_loop = false;
  Rig rig(config);
  ASSERT_TRUE(rig.run(0.05));
  std::size_t arm = 0, leg = 0;
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
    if (model.bus_joints[k] == model.hands[0].joints.front()) arm = k;
    if (model.bus_joints[k] == model.leg_joints.front()) leg = k;
  }
  ModeRequest request = pose_request(rig, 1.0F);
  request.joint_mask = std::int64_t{1} << arm;
  request.q[arm] = rig.command().q[arm] - 0.4;
  rig.loop().on_mode_request(request);
  rig.ask(Mode::kNone);
  ASSERT_TRUE(rig.run(0.3));
  GuardReport report;
  report.run_id = rig.state().run_id;
  report.hold_mask = (std::int64_t{1} << arm) | (std::int64_t{1} << leg);
  const auto hear = [&] {
    report.tick = rig.state().tick;
    rig.loop().on_guard(report, rig.state().time_ns);
  };
  for (int i = 0; i < 100; ++i) {
    hear();
    ASSERT_TRUE(rig.tick());
  }
  EXPECT_EQ(rig.command().qd[arm], 0.0F) << "held";
  const double held = rig.command().q[arm];
  EXPECT_GT(held, request.q[arm] + 0.05);
  EXPECT_FALSE(rig.record().fell) << "a masked leg would fell the robot";
  // The guard falls silent: after its time-out the arm goes on.
  ASSERT_TRUE(rig.run(model.guard_timeout - 3.0 * model.period()));
  EXPECT_EQ(rig.command().q[arm], held);
  ASSERT_TRUE(rig.run(2.0));
  EXPECT_NEAR(rig.command().q[arm], request.q[arm], 1e-6);
}

TEST(ControlLoop, AGamepadThatFallsSilentLeansNoMore) {
  Rig rig;
  ASSERT_TRUE(rig.run(0.05));
  Gamepad pad;
  pad.connected = pad.deadman = true;
  pad.run_id = rig.state().run_id;
  pad.left_x = 1.0F;
  const double before = static_cast<double>(rig.loop().status().com_reference[1]);
  for (int i = 0; i < 500; ++i) {
    if (i % 5 == 0) rig.loop().on_gamepad(pad, rig.state().time_ns);
    ASSERT_TRUE(rig.tick());
  }
  const double leaning = static_cast<double>(rig.loop().status().com_reference[1]);
  EXPECT_GT(leaning, before + 0.015);
  ASSERT_TRUE(rig.run(1.5));
  EXPECT_LT(static_cast<double>(rig.loop().status().com_reference[1]),
            before + 0.3 * (leaning - before));
}

TEST(ControlLoop, ThrowingTheStickOverAndOverDoesNotMakeTheFeetCreep) {
  Rig rig;
  ASSERT_TRUE(rig.run(2.5));
  const auto apart = [&] {
    const auto& foot = rig.truth().foot_position;
    return Eigen::Vector2d(static_cast<double>(foot[0][0]) - static_cast<double>(foot[1][0]),
                           static_cast<double>(foot[0][1]) - static_cast<double>(foot[1][1]));
  };
  const Eigen::Vector2d before = apart();
  Gamepad pad;
  pad.connected = pad.deadman = true;
  pad.run_id = rig.state().run_id;
  for (int i = 0; i < 10 * 500; ++i) {  // a second to the left, a second without anybody
    pad.left_x = pad.left_y = (i / 500) % 2 == 0 ? 1.0F : 0.0F;
    if (i % 5 == 0) rig.loop().on_gamepad(pad, rig.state().time_ns);
    ASSERT_TRUE(rig.tick());
  }
  EXPECT_LT((apart() - before).norm(), 2e-5) << "of the soles, after five leans [m]";
  EXPECT_FALSE(rig.record().fell);
}

TEST(ControlLoop, AGamepadWithoutItsDeadManOrForAnotherRunDoesNothing) {
  for (const bool other_run : {false, true}) {
    Rig rig;
    ASSERT_TRUE(rig.run(0.05));
    const double before = static_cast<double>(rig.loop().status().com_reference[1]);
    Gamepad pad;
    pad.connected = true;
    pad.deadman = other_run;
    pad.run_id = rig.state().run_id + (other_run ? 1 : 0);
    pad.left_x = 1.0F;
    for (int i = 0; i < 200; ++i) {
      rig.loop().on_gamepad(pad, rig.state().time_ns);
      ASSERT_TRUE(rig.tick());
    }
    EXPECT_NEAR(static_cast<double>(rig.loop().status().com_reference[1]), before, 1e-3);
  }
}

TEST(ControlLoop, AnotherSourceOfTheSameRobotIsGoneOnWithWithoutAJump) {
  Rig rig;
  ASSERT_TRUE(rig.run(0.2));
  rig.ask(Mode::kBalance, Motion::kSway, 0.02, 0.5);
  ASSERT_TRUE(rig.run(0.6));
  rig.state().run_id = 8;
  rig.state().term = 2;
  const Jump jump = largest_jump(rig, 0.4);
  EXPECT_LT(jump.position, 1e-3);
  EXPECT_LT(jump.torque, 0.05);
  EXPECT_EQ(rig.loop().status().motion, Motion::kSway) << "the motion goes on";
}

TEST(ControlLoop, ATickThatBothSourcesOfASwitchPublishIsComputedOnce) {
  Rig rig;
  ASSERT_TRUE(rig.run(0.2));
  rig.ask(Mode::kBalance, Motion::kSway, 0.02, 0.5);
  ASSERT_TRUE(rig.run(0.6));
  const JointCommand before = rig.command();
  RobotState late = rig.state();
  late.run_id = 8;
  ++late.term;
  for (const std::int64_t behind : {0, 2, 1, 0}) {
    late.tick = rig.state().tick - behind;
    rig.loop().on_state(late, 0);
    JointCommand command;
    ASSERT_TRUE(rig.loop().step(0, command));
    EXPECT_EQ(command.run_id, 8);
    EXPECT_EQ(command.term, late.term);
    EXPECT_EQ(command.tick, late.tick);
    for (std::size_t k = 0; k < static_cast<std::size_t>(before.joint_count); ++k) {
      EXPECT_NEAR(command.q[k], before.q[k], 1e-5) << behind << " ticks behind";
      EXPECT_NEAR(command.tau[k], before.tau[k], 0.1F) << behind << " ticks behind";
    }
  }
  rig.state().run_id = 8;
  ++rig.state().term;
  const Jump jump = largest_jump(rig, 0.4);
  EXPECT_LT(jump.position, 1e-3);
  EXPECT_EQ(rig.loop().status().motion, Motion::kSway) << "the motion goes on";
}

// That takes over, its left hip elsewhere by so much [rad].
RobotState another_robot(Rig& rig, double hip) {
  RobotState other = rig.state();
  other.run_id = 8;
  other.term = 2;
  other.q[13] += hip;
  return other;
}

TEST(ControlLoop, TheLegsOfAnotherRobotAreTakenWhereTheyAre) {
  Rig rig;
  ASSERT_TRUE(rig.run(0.3));
  RobotState other = another_robot(rig, 0.04);
  ++other.tick;
  rig.loop().on_state(other, 0);
  JointCommand command;
  ASSERT_TRUE(rig.loop().step(0, command));
  EXPECT_NEAR(command.q[13], other.q[13], 2e-3);
}

// Both publish the ticks between, so that its first ones are answered without time going on; its gate begins to fade
// there.  Where the other robot's legs are they would pull it over.
TEST(ControlLoop, TheLegsOfAnotherRobotThatComesLateAreTakenWhereTheyAreToo) {
  Rig rig;
  ASSERT_TRUE(rig.run(0.3));
  RobotState other = another_robot(rig, 0.02);
  const double effort = test::hrp1s().joints[at(test::hrp1s().bus_joints[13])].effort;
  JointCommand command;
  double last = 0.0;
  for (int tick = -2; tick < 400; ++tick) {
    other.tick = rig.state().tick + tick;
    rig.loop().on_state(other, 0);
    ASSERT_TRUE(rig.loop().step(0, command));
    EXPECT_EQ(command.run_id, 8);
    EXPECT_NEAR(command.q[13], other.q[13], 2e-3) << tick;
    const double torque = law(command, other, 13);
    EXPECT_LT(std::abs(torque - (tick > -2 ? last : torque)), 0.02 * effort) << tick;
    last = torque;
  }
}

TEST(ControlLoop, ASourceThatWasStartedAnewIsFollowedFromWhereItsRobotIs) {
  const Model& model = test::hrp1s();
  Rig before, after;
  ASSERT_TRUE(before.run(0.2));
  before.ask(Mode::kHold);
  ASSERT_TRUE(before.run(0.2));
  ASSERT_TRUE(after.tick());
  RobotState anew = after.state();
  anew.run_id = 12;
  anew.tick = 1;
  anew.q[8] += 0.3;
  before.loop().on_state(anew, 0);
  JointCommand command;
  ASSERT_TRUE(before.loop().step(0, command));
  EXPECT_NEAR(
      command.q[8], anew.q[8],
      model.joints[static_cast<std::size_t>(model.bus_joints[8])].velocity * model.period());
  EXPECT_EQ(before.loop().status().mode, Mode::kBalance) << "the first mode of a run";
}

// Nothing falls where the base is fixed: the first mode is then to hold, without a word, and whoever asks it to balance is told why not.
TEST(ControlLoop, ARobotOnAFixedBaseHoldsAndIsNotToldThatItCannotBalance) {
  Model arm = test::hrp1s();
  arm.floating_base = false;
  Scene scene = flat_scene();
  scene.fixed_base = true;
  SimRig rig(arm, scene, {}, {});
  ASSERT_TRUE(rig.run(0.02));
  EXPECT_EQ(rig.loop().take_sentence(), nullptr);
  EXPECT_EQ(rig.loop().status().mode, Mode::kHold);
  ModeRequest balance{.sender_id = 99, .run_id = rig.state().run_id, .sequence = 1, .mode = Mode::kBalance};
  rig.loop().on_mode_request(balance);
  ASSERT_TRUE(rig.run(0.02));
  const char* sentence = rig.loop().take_sentence();
  ASSERT_NE(sentence, nullptr);
  EXPECT_NE(std::string(sentence).find("the base is fixed"), std::string::npos) << sentence;
  EXPECT_EQ(rig.loop().status().mode, Mode::kHold);
  for (const Motion motion : {Motion::kSway, Motion::kSquat}) {
    ++balance.sequence;
    balance.motion = motion;
    rig.loop().on_mode_request(balance);
    ASSERT_TRUE(rig.run(0.02));
    sentence = rig.loop().take_sentence();
    ASSERT_NE(sentence, nullptr);
    EXPECT_NE(std::string(sentence).find("./twinbus pose and reach move it"), std::string::npos) << sentence;
    EXPECT_EQ(rig.loop().status().mode, Mode::kHold);
  }
}

TEST(ControlLoop, NoTickAllocatesInAnyMode) {
  if (!allocations_counted()) GTEST_SKIP() << "not counted in this build";
  Rig rig;
  ASSERT_TRUE(rig.run(0.05));
  JointCommand command;
  std::int64_t tick = rig.state().tick;
  int sequence = 0;
  for (const Mode mode :
       {Mode::kBalance, Mode::kHold, Mode::kIdle, Mode::kStop, Mode::kBalance, Mode::kWalk}) {
    for (const Motion motion : {Motion::kSway, Motion::kSquat}) {
      NoAlloc no_alloc;
      ModeRequest request;
      request.run_id = rig.state().run_id;
      request.sender_id = 5;
      request.sequence = ++sequence;
      request.mode = mode;
      request.motion = motion;
      rig.loop().on_mode_request(request);
      for (int i = 0; i < 20; ++i) {
        RobotState state = rig.state();
        state.tick = ++tick;
        state.time_ns = tick * test::hrp1s().period_ns;
        rig.loop().on_state(state, state.time_ns);
        ASSERT_TRUE(rig.loop().step(state.time_ns, command));
      }
      EXPECT_EQ(no_alloc.count(), 0) << static_cast<int>(mode);
    }
  }
}

}  // namespace
}  // namespace twinbus
