#include "control/guard/servo_predictor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "robot/dynamics/inverse_dynamics.h"
#include "robot/dynamics/joint_friction.h"
#include "robot/dynamics/joint_inertia.h"
#include "robot/kinematics/brake.h"
#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

constexpr int kDelayTicks = 2;
constexpr double kLag = 0.005;  // [s]

std::size_t bus(const std::string& name) {
  const Model& model = test::hrp1s();
  return static_cast<std::size_t>(model.bus_index[static_cast<std::size_t>(model.find_joint(name))]);
}

// A robot whose base stands and whose joints follow the equation of the header, in small explicit steps: the other way to
// compute what the predictor says.
struct ServoRig {
  const Model& model;
  ServoPredictor servos;
  Configuration now{model};
  Kinematics kinematics{model};
  RobotState state;
  JointCommand command;

  explicit ServoRig(double lag = kLag, const Model& robot = test::hrp1s()) : model(robot), servos(model, kDelayTicks, lag) {
    command.flags = kCommandNoFade;
    command.joint_count = state.joint_count = static_cast<std::int16_t>(model.bus_count());
    for (std::size_t k = 0; k < count(); ++k) {
      command.kp[k] = static_cast<float>(joint(k).kp);
      command.kd[k] = static_cast<float>(joint(k).kd);
    }
    const std::vector<double>& pose = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))].q;
    for (std::size_t k = 0; k < count(); ++k) command.q[k] = state.q[k] = pose[static_cast<std::size_t>(model.bus_joints[k])];
  }
  std::size_t count() const { return static_cast<std::size_t>(model.bus_count()); }
  const Joint& joint(std::size_t k) const { return model.joints[static_cast<std::size_t>(model.bus_joints[k])]; }
  void look(std::int64_t mask = 0, std::int64_t kept = 0, std::int64_t others = 0) {
    ++state.tick;
    ++command.tick;
    set_joints(model, state, now);
    kinematics.update(now);
    servos.follow(state, command, mask, kinematics, now, kept, others);
  }
  void soften(std::size_t k, float kp, float kd) {
    command.kp[k] = kp;
    command.kd[k] = kd;
  }

  // Where these joints are `time` from now, from where they are.
  std::vector<double> integrate(const std::vector<std::size_t>& joints, double time) const {
    constexpr double h = 2e-6;
    std::vector<int> of_model;
    for (const std::size_t k : joints) of_model.push_back(model.bus_joints[k]);
    JointInertia inertia(model);
    inertia.update(kinematics, of_model);
    InverseDynamics dynamics(model);
    Eigen::VectorXd none = Eigen::VectorXd::Zero(model.joint_count()), bias(model.joint_count());
    dynamics.solve(kinematics, now, none, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), {}, bias);
    const std::size_t n = joints.size();
    std::vector<double> moved(n, 0.0), v(n), nothing(n, 0.0), a(n);
    for (std::size_t i = 0; i < n; ++i) v[i] = static_cast<double>(state.qd[joints[i]]);
    std::vector<double> factor(static_cast<std::size_t>(JointInertia::kFactor));
    inertia.factor(nothing.data(), factor.data());
    for (double t = 0.0; t < time - 0.5 * h; t += h) {
      for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = joints[i];
        const double tau = static_cast<double>(command.kp[k]) * (command.q[k] - state.q[k] - moved[i]) +
                           static_cast<double>(command.kd[k]) * (static_cast<double>(command.qd[k]) - v[i]) +
                           static_cast<double>(command.tau[k]);
        a[i] = std::clamp(tau, -joint(k).effort, joint(k).effort) - joint(k).damping * v[i] - bias[of_model[i]];
      }
      inertia.solve(factor.data(), a.data());
      for (std::size_t i = 0; i < n; ++i) {
        v[i] += h * a[i];
        moved[i] += h * v[i];
      }
    }
    return moved;
  }
  double brake_comes() const { return (kDelayTicks + 1) * model.period(); }
};

TEST(ServoPredictor, AStiffServoNearItsSetPointIsLeftToItsSetPoint) {
  ServoRig f;
  for (std::size_t k = 0; k < f.count(); ++k) f.command.q[k] += 0.01;
  f.look();
  EXPECT_EQ(f.servos.soft(), 0);
}

TEST(ServoPredictor, TheServosOfOurRobotsAreStiff) {
  for (const char* name : {"hrp1s", "hrp2p", "biped12"}) {
    const Model model = load_robot(name);
    ServoPredictor servos(model, kDelayTicks, kLag);
    const Configuration now(model);
    Kinematics kinematics(model);
    kinematics.update(now);
    RobotState state;
    JointCommand command;
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k)
      command.kp[k] = static_cast<float>(model.joints[static_cast<std::size_t>(model.bus_joints[k])].kp);
    for (int i = 0; i < 3; ++i) {
      state.tick = ++command.tick;
      servos.follow(state, command, 0, kinematics, now);
    }
    EXPECT_EQ(servos.soft(), 0) << name;
  }
}

TEST(ServoPredictor, OneSoftServoTakesAllButTheLegsWithIt) {
  ServoRig f;
  f.soften(bus("LARM_ELBOW"), 20.0F, 1.0F);
  f.look();
  EXPECT_TRUE(f.servos.is_soft(bus("LARM_ELBOW")));
  EXPECT_TRUE(f.servos.is_soft(bus("RARM_SHOULDER_P")));
  EXPECT_FALSE(f.servos.is_soft(bus("LLEG_KNEE")));
}

// Gains of all sizes, joints that move one another, at the limit of effort and below it: until the brake comes.
TEST(ServoPredictor, GoesWhereTheEquationLeads) {
  for (const float kp : {5.0F, 40.0F, 150.0F, 400.0F}) {
    for (const double speed : {0.0, 1.5, -3.0}) {
      ServoRig f(0.0);
      const std::vector<std::size_t> arm{bus("LARM_SHOULDER_P"), bus("LARM_SHOULDER_Y"), bus("LARM_ELBOW")};
      for (std::size_t i = 0; i < arm.size(); ++i) {
        f.soften(arm[i], kp, 0.02F * kp);
        f.command.q[arm[i]] += i % 2 == 0 ? -0.3 : 0.3;
      }
      for (int i = 0; i < 200; ++i) f.look();  // the set-point has arrived at what is asked
      for (std::size_t i = 0; i < arm.size(); ++i) f.state.qd[arm[i]] = static_cast<float>(i % 2 == 0 ? -speed : speed);
      f.look();
      std::vector<std::size_t> all;  // they move one another
      for (std::size_t k = 0; k < f.count(); ++k) {
        if (f.servos.is_soft(k)) all.push_back(k);
      }
      std::sort(all.begin(), all.end(), [&](std::size_t a, std::size_t b) { return f.model.bus_joints[a] < f.model.bus_joints[b]; });
      const std::vector<double> moved = f.integrate(all, f.brake_comes());
      for (const std::size_t k : arm) {
        const auto place = static_cast<std::size_t>(std::find(all.begin(), all.end(), k) - all.begin());
        ASSERT_LT(place, all.size());
        EXPECT_NEAR(f.servos.if_obeyed(k).first, moved[place], 0.1 * std::abs(moved[place]) + 3e-3)
            << "kp " << kp << " speed " << speed << " " << f.joint(k).name;
      }
    }
  }
}

TEST(ServoPredictor, FeedForwardAloneMovesAJoint) {
  ServoRig f;
  const std::size_t elbow = bus("LARM_ELBOW");
  f.soften(elbow, 0.0F, 0.0F);
  f.command.tau[elbow] = 15.0F;
  f.look();
  const double along = f.servos.if_obeyed(elbow).rest();
  f.command.tau[elbow] = -15.0F;
  f.look();
  EXPECT_GT(along, 1e-3);
  EXPECT_LT(f.servos.if_obeyed(elbow).rest(), -1e-3);
}

// A set-point as far as a policy puts it moves the joint by what its torque does until the brake, and no more.
// Torque that the description's friction takes up moves nothing, and so foretells nothing: the course of a joint is that of one
// without friction which is not driven against it.
TEST(ServoPredictor, TorqueAgainstFrictionForetellsNoMotion) {
  Model rubs = test::hrp1s();
  for (Joint& joint : rubs.joints) joint.friction = 2.0;
  ServoRig f, g(kLag, rubs);
  const std::size_t k = bus("LARM_ELBOW");
  const auto torque = static_cast<float>(friction_torque(g.joint(k), 0.8));
  EXPECT_NEAR(torque, 0.9 * 2.0, 1e-6);
  for (ServoRig* one : {&f, &g}) {
    one->soften(k, 20.0F, 1.0F);
    one->command.qd[k] = 0.8F;
  }
  g.command.tau[k] = torque;
  for (int i = 0; i < 20; ++i) {
    f.look();
    g.look();
  }
  EXPECT_NEAR(g.servos.if_obeyed(k).rest(), f.servos.if_obeyed(k).rest(), 1e-6);
  g.command.tau[k] = 0.0F;  // who does not drive against it is slower
  g.look();
  f.look();
  EXPECT_LT(g.servos.if_obeyed(k).rest(), f.servos.if_obeyed(k).rest() - 1e-4);
}

TEST(JointFriction, IsOvercomeWithoutAJump) {
  Joint joint;
  EXPECT_EQ(friction_torque(joint, 1.0), 0.0) << "the file states none";
  joint.friction = 2.0;
  joint.damping = 0.5;
  EXPECT_NEAR(friction_torque(joint, 1.0), kFrictionShare * 2.5, 1e-12);
  EXPECT_NEAR(friction_torque(joint, -1.0), -kFrictionShare * 2.5, 1e-12);
  EXPECT_EQ(friction_torque(joint, 0.0), 0.0);
  EXPECT_NEAR(friction_torque(joint, 0.1 * kFrictionSpeed), 0.1 * friction_torque(joint, kFrictionSpeed), 1e-12);
}

TEST(ServoPredictor, AFarSetPointOfASoftJointIsNotTheWayOfTheJoint) {
  ServoRig f;
  const std::size_t elbow = bus("LARM_ELBOW");
  f.soften(elbow, 10.0F, 1.0F);
  f.command.q[elbow] += 0.86;
  for (int i = 0; i < 200; ++i) f.look();
  EXPECT_LT(std::abs(f.servos.if_obeyed(elbow).rest()), 0.05);
}

// Nor does a stiff servo of its own robot follow at once: its effort and the inertia bound what it does, for joints beside it too.
TEST(ServoPredictor, AFarSetPointOfAStiffServoIsNotTheWayOfTheJoint) {
  ServoRig f;
  const std::size_t elbow = bus("LARM_ELBOW");
  const double start = f.state.q[elbow];
  f.command.q[elbow] = start - 0.5;
  f.look();
  EXPECT_TRUE(f.servos.is_soft(elbow));
  EXPECT_TRUE(f.servos.is_soft(bus("RARM_SHOULDER_P")));
  EXPECT_FALSE(f.servos.is_soft(bus("LLEG_KNEE")));
  EXPECT_LT(f.servos.if_obeyed(elbow).rest(), -1e-3);
  EXPECT_GT(f.servos.if_obeyed(elbow).rest(), -0.25);
  f.command.q[elbow] = start;
  for (int i = 0; i < 20; ++i) f.look();
  EXPECT_TRUE(f.servos.is_soft(elbow)) << "set-points of a policy pass their joints on the way";
  for (int i = 0; i < 200; ++i) f.look();
  EXPECT_EQ(f.servos.soft(), 0);
  f.command.q[bus("LLEG_KNEE")] += 0.1;
  f.look();
  EXPECT_TRUE(f.servos.is_soft(bus("RLEG_HIP_Y")));
  EXPECT_FALSE(f.servos.is_soft(elbow));
}

// The set-point moves as the gate lets it: a command that turns round does not turn the torque at once.
TEST(ServoPredictor, ASetPointTakesItsTime) {
  ServoRig f;
  const std::size_t elbow = bus("LARM_ELBOW");
  const double start = f.state.q[elbow];
  f.soften(elbow, 60.0F, 1.0F);
  f.command.q[elbow] = start - 0.6;
  for (int i = 0; i < 200; ++i) f.look();
  const double before = f.servos.if_obeyed(elbow).rest();
  EXPECT_LT(before, -1e-3);
  f.command.q[elbow] = start + 0.4;
  f.look();
  EXPECT_LT(f.servos.if_obeyed(elbow).rest(), 0.3 * before);
  for (int i = 0; i < 400; ++i) f.look();
  EXPECT_GT(f.servos.if_obeyed(elbow).rest(), 1e-3);
}

TEST(ServoPredictor, AHeldJointRestsSoonerAndStaysSoftWhileItIsHeld) {
  ServoRig f;
  const std::size_t elbow = bus("LARM_ELBOW");
  const std::int64_t mask = std::int64_t{1} << elbow;
  f.soften(elbow, 60.0F, 1.0F);
  f.command.q[elbow] -= 0.7;
  for (int i = 0; i < 200; ++i) f.look();
  f.state.qd[elbow] = -2.0F;
  f.look();
  EXPECT_GT(f.servos.if_held(elbow).rest(), f.servos.if_obeyed(elbow).rest());
  f.look(mask);
  EXPECT_EQ(f.servos.on_hold(), mask);
  f.look(mask);
  const double rest = f.servos.if_held(elbow).rest();
  EXPECT_LT(rest, 0.0);
  EXPECT_GT(rest, f.servos.if_obeyed(elbow).rest());
  f.servos.look_masked(mask, mask);
  EXPECT_NEAR(f.servos.if_masked(elbow).rest(), rest, 0.1 * std::abs(rest));
  f.state.qd[elbow] = 0.0F;
  for (int i = 0; i < 20; ++i) f.look(mask);
  EXPECT_LT(std::abs(f.servos.if_held(elbow).rest()), 0.05);
  EXPECT_TRUE(f.servos.is_soft(elbow));
}

// The shoulder stops at once; the forearm goes on.
TEST(ServoPredictor, WhatRunsIntoItsStopThrowsWhatHangsOnIt) {
  const auto elbow_moves = [](double from_stop) {
    ServoRig f;
    const std::size_t shoulder = bus("LARM_SHOULDER_P"), elbow = bus("LARM_ELBOW");
    for (const std::size_t k : {shoulder, elbow}) f.soften(k, 5.0F, 0.5F);
    f.state.q[shoulder] = f.joint(shoulder).lower + from_stop;
    f.state.qd[shoulder] = -8.0F;
    for (const std::size_t k : {shoulder, elbow}) f.command.q[k] = f.state.q[k];
    f.look();
    return f.servos.if_obeyed(elbow).first;
  };
  EXPECT_LT(std::abs(elbow_moves(0.5)), 0.01);
  EXPECT_GT(std::abs(elbow_moves(0.01)), 0.03);
}

// Braked from all speeds with torques at their limits, no joint is thrown to and fro by the steps of the look.
TEST(ServoPredictor, TorquesAtTheirLimitsComeToRest) {
  for (int turn = 0; turn < 40; ++turn) {
    ServoRig f;
    for (std::size_t k = 0; k < f.count(); ++k) {
      if (!(f.joint(k).name.substr(0, 4) == "LARM")) continue;
      f.soften(k, 30.0F, 2.0F);
      f.state.qd[k] = static_cast<float>(f.joint(k).velocity * std::sin(0.7 * turn + 1.3 * static_cast<double>(k)));
    }
    f.look();
    for (const char* waist : {"WAIST_P", "WAIST_R", "CHEST"})
      EXPECT_LT(std::abs(f.servos.if_held(bus(waist)).rest()), 0.02) << waist << " " << turn;
  }
}

TEST(ServoPredictor, ABrakeBeginsWithoutAJumpBetweenItsSetPointAndTheJoint) {
  BrakeStart before = brake_start(0.0, 1.0, 0.0, 1.0, 5.0, false);
  EXPECT_EQ(before.share, 1.0);
  for (double off = 0.0; off < 0.06; off += 1e-4) {
    const BrakeStart start = brake_start(off, 1.0 + 10.0 * off, 0.0, 1.0, 5.0, false);
    EXPECT_LT(std::abs(start.q - before.q), 5e-4);
    EXPECT_LT(std::abs(start.v - before.v), 5e-3);
    before = start;
  }
  EXPECT_EQ(before.share, 0.0);
  EXPECT_EQ(before.v, 1.0);
  EXPECT_EQ(brake_start(0.001, 1.0, 0.0, 1.0, 5.0, true).share, 0.0);  // a soft servo
}

// A brake of the gate that began a tick sooner, from another speed, is seen by its torque.
// Held, softly, at 2 rad/s with that torque, then at 4 rad/s with none; whether it is taken to be braked from there.
bool is_taken_from_there(float tau) {
  ServoRig f;
  const std::size_t elbow = bus("LARM_ELBOW");
  const std::int64_t mask = std::int64_t{1} << elbow;
  f.soften(elbow, 60.0F, 1.0F);
  f.state.qd[elbow] = -2.0F;
  f.state.tau[elbow] = tau;
  for (int i = 0; i < 5; ++i) f.look(mask);
  f.state.qd[elbow] = -4.0F;
  f.state.tau[elbow] = 0.0F;
  for (int i = 0; i < 2; ++i) f.look(mask);
  return f.servos.if_held(elbow).rest() < -0.9 * 4.0 * 4.0 / (2.0 * brake_deceleration(f.joint(elbow)));
}

TEST(ServoPredictor, WhereAHeldJointIsHeldIsSeenByItsTorque) { EXPECT_TRUE(is_taken_from_there(1.0F)); }

// A robot that measures no torque says 0: that tells nothing of its servo.
TEST(ServoPredictor, AHeldJointWhoseTorqueIsNotMeasuredStaysWhereItWasTaken) { EXPECT_FALSE(is_taken_from_there(0.0F)); }

// What is held has the set-point where it is held, whichever source has the robot and wherever the client wants it.
TEST(ServoPredictor, AHeldJointStaysWhereItIsHeldWhenTheSourceChanges) {
  ServoRig f;
  const std::size_t elbow = bus("LARM_ELBOW");
  const std::int64_t mask = std::int64_t{1} << elbow;
  f.soften(elbow, 60.0F, 1.0F);
  for (int i = 0; i < 20; ++i) f.look(mask);
  f.command.q[elbow] += 0.25;
  f.look(mask);
  const double before = f.servos.if_held(elbow).rest();
  f.servos.change_source();
  for (int i = 0; i < 3; ++i) f.look(mask);
  EXPECT_NEAR(f.servos.if_held(elbow).rest(), before, 0.01);
}

TEST(ServoPredictor, MasksLookedAtTogetherAreWhatEachIsAlone) {
  ServoRig f, alone;
  const std::size_t elbow = bus("LARM_ELBOW"), shoulder = bus("RARM_SHOULDER_P");
  const std::int64_t one = std::int64_t{1} << elbow, other = std::int64_t{1} << shoulder;
  for (ServoRig* each : {&f, &alone}) {
    each->soften(elbow, 60.0F, 1.0F);
    each->soften(shoulder, 20.0F, 0.2F);
    each->command.q[elbow] -= 0.7;
    each->command.q[shoulder] += 0.5;
    for (int i = 0; i < 3; ++i) each->look();
    each->state.qd[elbow] = -2.0F;
    each->state.qd[shoulder] = 1.5F;
    each->look(one);  // held on its way: one brake has come, the other begins
    for (int i = 0; i < 3; ++i) each->look(one);
  }
  std::int64_t kept = 0, others = 0;
  const auto is_as = [&](std::int64_t mask, std::int64_t next) {
    alone.look(one);  // forgets what was looked at
    f.look(one, kept, others);
    if (kept == 0) f.servos.look_masked(one, other);
    f.servos.look_masked(mask, next);
    alone.servos.look_masked(mask, mask);
    for (std::size_t k = 0; k < f.count(); ++k) {
      const Course &a = f.servos.if_masked(k), &b = alone.servos.if_masked(k);
      EXPECT_EQ(a.first, b.first) << k;
      EXPECT_EQ(a.speed, b.speed) << k;
      EXPECT_EQ(a.rest(), b.rest()) << k;
    }
  };
  is_as(one, other);
  is_as(other, one);
  is_as(one | other, one);
  kept = other, others = one;  // looked at before they are asked for
  is_as(other, other);
  is_as(one | other, one);
  f.servos.look_masked(~std::int64_t{0}, 0);
  EXPECT_EQ(f.servos.if_masked(elbow).rest(), f.servos.if_held(elbow).rest());
  f.servos.look_masked(0, 0);
  EXPECT_EQ(f.servos.if_masked(elbow).rest(), f.servos.if_obeyed(elbow).rest());
}

TEST(ServoPredictor, LegsGoOnAsTheyAreMeasured) {
  ServoRig f;
  const std::size_t knee = bus("LLEG_KNEE");
  f.soften(knee, 50.0F, 1.0F);
  f.command.q[knee] += 0.6;
  f.state.qd[knee] = -0.5F;
  f.look();
  const Course& course = f.servos.if_obeyed(knee);
  EXPECT_DOUBLE_EQ(course.speed, -0.5);
  EXPECT_DOUBLE_EQ(course.brake, brake_deceleration(f.joint(knee)));
}

}  // namespace
}  // namespace twinbus
