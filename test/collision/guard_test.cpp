#include "control/guard/guard.h"
#include "control/guard/guard_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "robot/collision/collision_pairs.h"
#include "robot/collision/links/link_geometry.h"
#include "test/collision/guard_rig.h"
#include "test/collision/rated_drive.h"
#include "common/allocation/no_alloc.h"
#include "test/obstacles.h"

namespace twinbus {
namespace {

constexpr std::uint64_t kGuardSeed = 7;

std::size_t bus(const std::string& name) {
  const Model& model = hrp1s();
  const int joint = model.find_joint(name);
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
    if (model.bus_joints[k] == joint) return k;
  }
  throw std::runtime_error("no joint " + name);
}

std::int64_t arm_mask() {
  const Model& model = hrp1s();
  std::int64_t mask = 0;
  for (const Hand& hand : model.hands) {
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
      for (const int joint : hand.joints)
        mask |= model.bus_joints[k] == joint ? std::int64_t{1} << k : 0;
    }
  }
  return mask;
}

// With a margin of their own for these pairs [m].
Model with_margins(const std::vector<CollisionPair>& pairs, double margin) {
  Model model = hrp1s();
  for (const CollisionPair& p : pairs) model.near_pairs.push_back({p.link_a, p.link_b, margin});
  return model;
}

struct Watch {  // what really happens, seen without the guard
  explicit Watch(const Model& model) : collision(model), kinematics(model) {}
  double nearest(const GuardRig& rig) {
    kinematics.update(rig.configuration());
    PairDistance pair;
    return collision.near_pairs(kinematics, 0.2, &pair, 1) > 0 ? pair.distance : 0.2;
  }
  Collision collision;
  Kinematics kinematics;
};

struct RatedMotions {
  const Model& model = hrp1s();
  Configuration home = named_posture(model, "half_sitting");
  SelfCollision exact{model, build_geometry(model)};
  Watch watch{model};
  RatedDrive drive{model};
};

TEST(Guard, StandingStillIsClearOfMasks) {
  const Model& model = hrp1s();
  Guard guard(model, {});
  for (const char* pose : {"half_sitting", "zero", "initial"}) {
    GuardRig rig(model, named_posture(model, pose));
    guard.reset();
    for (int i = 0; i < 20; ++i) {
      const GuardReport& report = rig.tick(guard);
      EXPECT_EQ(report.hold_mask, 0) << pose;
      EXPECT_FALSE(report.stop_asked);
      EXPECT_LT(report.verdict, GuardVerdict::kWillCollide);
    }
  }
}

TEST(Guard, AnArmCommandedIntoTheBodyStopsBeforeIt) {
  const Model& model = hrp1s();
  Watch watch(model);
  for (const double speed : {0.5, 2.0, 100.0}) {  // of the command [rad/s]; the last is a step
    Guard guard(model, {});
    GuardRig rig(model, named_posture(model, "half_sitting"));
    const std::size_t roll = bus("LARM_SHOULDER_R");
    const std::size_t yaw = bus("LARM_SHOULDER_Y");
    const std::size_t elbow = bus("LARM_ELBOW");
    double nearest = 1.0;
    bool held = false;
    for (int i = 0; i < 1500; ++i) {
      const double step = speed * model.period();
      rig.command.q[roll] = std::max(-0.26, rig.command.q[roll] - step);
      rig.command.q[yaw] = std::max(-1.5, rig.command.q[yaw] - step);
      rig.command.q[elbow] = std::max(-1.8, rig.command.q[elbow] - step);
      held = rig.tick(guard).hold_mask != 0;
      nearest = std::min(nearest, watch.nearest(rig));
      ASSERT_GT(nearest, 0.0) << "tick " << i << " speed " << speed;
    }
    EXPECT_TRUE(held) << "the controller is still asking";
    EXPECT_NE(guard.report().hold_mask & arm_mask(), 0);
    EXPECT_GT(nearest, 0.004);
    EXPECT_LT(nearest, speed < 10.0 ? 0.04 : 0.2)
        << "stopped long before it had to, speed " << speed;
    double fastest = 0.0;
    for (std::size_t k = 0; k < 29; ++k)
      fastest = std::max(fastest, std::abs(static_cast<double>(rig.state.qd[k])));
    EXPECT_LT(fastest, 1e-3);
  }
}

// Another source takes over in mid-motion: until it is told something itself, it obeys what the one before it was told, and the
// guard goes on as it was.  One that stands elsewhere, or later, is looked at anew.
TEST(Guard, GoesOnAsItWasWhenASourceTakesOverInMidMotion) {
  const Model& model = hrp1s();
  GuardWatch watch(model, {});
  GuardRig rig(model, named_posture(model, "half_sitting"));
  GuardReport report;
  for (int i = 0; i < 600; ++i) {
    const double step = 2.0 * model.period();
    rig.command.q[bus("LARM_SHOULDER_R")] = std::max(-0.26, rig.command.q[bus("LARM_SHOULDER_R")] - step);
    rig.command.q[bus("LARM_SHOULDER_Y")] = std::max(-1.5, rig.command.q[bus("LARM_SHOULDER_Y")] - step);
    rig.command.q[bus("LARM_ELBOW")] = std::max(-1.8, rig.command.q[bus("LARM_ELBOW")] - step);
    rig.command.tick = rig.state.tick;
    watch.on_command(rig.command);
    report = watch.judge(rig.state);
    rig.tick(report);
  }
  ASSERT_NE(report.hold_mask & arm_mask(), 0);  // it is still asked to go deeper
  rig.state.run_id = 2;
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(watch.judge(rig.state).hold_mask, report.hold_mask) << i;
    ++rig.state.tick;
  }
  rig.state.run_id = 3;
  rig.state.tick += 100;
  EXPECT_EQ(watch.judge(rig.state).hold_mask, 0);  // nobody has told it anything
}

// Set-points that follow the measured joints, as those of legs in balance, are elsewhere where the other robot stands a little
// otherwise.  That is a step of the set-point, and no motion of the leg: it asks for no stop.
TEST(Guard, ARobotThatStandsALittleOtherwiseTakesOverWithoutAStop) {
  const Model& model = hrp1s();
  for (const double off : {0.02, -0.02, 0.04, -0.04}) {
    GuardWatch watch(model, {});
    GuardRig rig(model, named_posture(model, "half_sitting"));
    GuardReport report;
    const auto judge = [&] {
      ++rig.state.tick;
      rig.command.tick = rig.state.tick;
      rig.command.run_id = rig.state.run_id;
      watch.on_command(rig.command);
      report = watch.judge(rig.state);
    };
    rig.state.run_id = 1;
    for (int i = 0; i < 20; ++i) judge();
    ASSERT_FALSE(report.stop_asked);
    rig.state.run_id = 2;
    const std::size_t hip = bus("LLEG_HIP_R");
    rig.state.q[hip] += off;
    rig.command.q[hip] += off;
    for (int i = 0; i < 20; ++i) {
      judge();
      EXPECT_FALSE(report.stop_asked) << off << " rad, tick " << i;
      EXPECT_EQ(report.hold_mask, 0) << off << " rad, tick " << i;
    }
  }
}

// A robot that is in contact, or inside its margin, may move every joint that takes it apart and
// none that does not.
TEST(Guard, MotionAwayIsNotBlockedAndMotionDeeperIs) {
  const Model& model = hrp1s();
  Watch watch(model);
  std::mt19937_64 random(kGuardSeed + 1);
  constexpr double kRamp = 0.06;  // [rad]
  int away = 0;
  int deeper = 0;
  for (int i = 0; i < 3000 && (away < 60 || deeper < 60); ++i) {
    const Configuration start =
        random_posture(model, named_posture(model, "half_sitting"), 0.6, random);
    watch.kinematics.update(start);
    PairDistance pairs[2];
    const int near = watch.collision.near_pairs(watch.kinematics, 0.02, pairs, 2);
    if (near != 1 || pairs[0].distance > 0.005 || pairs[0].distance < -0.015) continue;
    const std::size_t k = bus(i % 2 == 0 ? "LARM_SHOULDER_R" : "RARM_SHOULDER_P");
    const int joint = model.bus_joints[k];
    const Joint& limits = model.joints[static_cast<std::size_t>(joint)];
    for (const double way : {kRamp, -kRamp}) {
      // What the motion would do without a guard.
      bool parts = true;
      bool joins = true;
      double last = pairs[0].distance;
      Configuration posture = start;
      for (int step = 1; step <= 6; ++step) {
        posture.q[joint] = start.q[joint] + way * step / 6.0;
        watch.kinematics.update(posture);
        PairDistance now;
        const bool is_near = watch.collision.near_pairs(watch.kinematics, 0.5, &now, 1) > 0;
        const double distance = is_near ? now.distance : 0.5;
        parts = parts && distance > last + 2e-4;
        joins = joins && distance < last - 5e-4;
        last = distance;
      }
      const double end = start.q[joint] + way;
      if (parts == joins || !(end < limits.upper && end > limits.lower)) continue;
      Guard guard(model, {});
      GuardRig rig(model, start);
      for (int t = 0; t < 200; ++t) {
        const double left = end - rig.command.q[k];
        rig.command.q[k] += std::clamp(left, -0.0006, 0.0006);
        rig.tick(guard);
        ASSERT_EQ(rig.accepted, GateVerdict::kAccepted);
      }
      const double moved = (rig.state.q[k] - start.q[joint]) / way;
      if (parts) {
        EXPECT_GT(moved, 0.97) << "posture " << i;
        ++away;
      } else {
        EXPECT_LT(moved, 0.25) << "posture " << i;
        ++deeper;
      }
    }
  }
  EXPECT_GT(away, 8);
  EXPECT_GT(deeper, 5);
}

TEST(Guard, AHeldArmComesBackAtOnceWhenAskedTo) {
  const Model& model = hrp1s();
  Guard guard(model, {});
  GuardRig rig(model, named_posture(model, "half_sitting"));
  const std::size_t roll = bus("LARM_SHOULDER_R");
  const double home = rig.command.q[roll];
  for (int i = 0; i < 1500; ++i) {
    rig.command.q[roll] = std::max(-0.26, rig.command.q[roll] - 0.002);
    rig.command.q[bus("LARM_SHOULDER_Y")] =
        std::max(-1.5, rig.command.q[bus("LARM_SHOULDER_Y")] - 0.002);
    rig.command.q[bus("LARM_ELBOW")] = std::max(-1.8, rig.command.q[bus("LARM_ELBOW")] - 0.002);
    rig.tick(guard);
  }
  ASSERT_NE(guard.report().hold_mask, 0);
  rig.command.q[roll] = home + 0.5;
  for (int i = 0; i < 300; ++i) rig.tick(guard);
  EXPECT_GT(rig.state.q[roll], home + 0.45);
}

TEST(Guard, AnObstacleStopsTheArm) {
  const Model& model = hrp1s();
  Guard guard(model, {});
  Watch watch(model);
  const Obstacle shelf = test::box_at({0.45, 0.0, 0.35}, {0.3, 1.0, 0.04});
  guard.set_obstacles({shelf});
  watch.collision.set_obstacles({shelf});
  GuardRig rig(model, named_posture(model, "half_sitting"));
  const std::size_t pitch = bus("LARM_SHOULDER_P");
  double nearest = 1.0;
  for (int i = 0; i < 1000; ++i) {
    rig.command.q[pitch] -= 0.004;
    rig.command.q[pitch] = std::max(-2.5, rig.command.q[pitch]);
    rig.tick(guard);
    nearest = std::min(nearest, watch.nearest(rig));
  }
  EXPECT_GT(nearest, 0.0);
  EXPECT_NE(guard.report().hold_mask, 0);
  EXPECT_LT(rig.state.q[pitch], 0.2);
  EXPECT_GT(rig.state.q[pitch], -1.5);
}

TEST(Guard, LegsAreNeverMaskedButAskForAStop) {
  const Model& model = hrp1s();
  Guard guard(model, {});
  GuardRig rig(model, named_posture(model, "half_sitting"));
  bool asked = false;
  std::int64_t legs = 0;
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
    for (const int leg : model.leg_joints)
      legs |= model.bus_joints[k] == leg ? std::int64_t{1} << k : 0;
  }
  for (int i = 0; i < 600; ++i) {
    rig.command.q[bus("LLEG_HIP_R")] -= 0.002;
    rig.command.q[bus("RLEG_HIP_R")] += 0.002;
    const GuardReport& report = rig.tick(guard);
    EXPECT_EQ(report.hold_mask & legs, 0);
    if (report.stop_asked && !asked) {  // it says of whom, how near, by which joint
      const GuardCause& cause = guard.cause();
      ASSERT_TRUE(cause.found && cause.link_b >= 0);
      EXPECT_LT(cause.then, cause.margin);
      EXPECT_GT(cause.now, cause.then);
      ASSERT_GE(cause.joint, 0);
      EXPECT_NE(model.joints[static_cast<std::size_t>(cause.joint)].name.find("LEG_HIP_R"), std::string::npos);
      std::array<char, 300> text{};
      describe(model, {}, cause, text);
      EXPECT_NE(std::string(text.data()).find(model.links[static_cast<std::size_t>(cause.link_a)].name), std::string::npos);
      EXPECT_NE(std::string(text.data()).find("LEG_HIP_R at "), std::string::npos) << text.data();
      std::array<char, 20> little{};
      describe(model, {}, cause, little);  // cut off, not beyond
      EXPECT_EQ(little.back(), '\0');
    }
    asked = asked || report.stop_asked;
  }
  EXPECT_TRUE(asked);
}

// Of two links that are near by design robot.yaml says how much is kept, and of them alone.
TEST(Guard, KeepsLessOfPairsThatAreNearByDesign) {
  const auto stopped_at = [](const Model& model, GuardCause& cause) {
    Guard guard(model, {});
    GuardRig rig(model, named_posture(model, "half_sitting"));
    for (int i = 0; i < 6000; ++i) {
      rig.command.q[bus("LLEG_HIP_R")] -= 0.0002;
      rig.command.q[bus("RLEG_HIP_R")] += 0.0002;
      if (!rig.tick(guard).stop_asked) continue;
      cause = guard.cause();
      return i;
    }
    return -1;
  };
  GuardCause usual, own, other;
  const int first = stopped_at(hrp1s(), usual);
  ASSERT_GE(first, 0);
  EXPECT_EQ(usual.margin, 0.010);
  const std::vector<CollisionPair> all = pairs_to_check(hrp1s());
  std::vector<CollisionPair> rest;
  for (const CollisionPair& p : all) {
    if (p.link_a != usual.link_a || p.link_b != usual.link_b) rest.push_back(p);
  }
  ASSERT_EQ(rest.size() + 1, all.size());
  EXPECT_EQ(stopped_at(with_margins(rest, 0.004), other), first) << "the margin of others says nothing";
  const Model model = with_margins(all, 0.004);
  EXPECT_GT(stopped_at(model, own), first);
  EXPECT_DOUBLE_EQ(own.margin, 0.004);
  EXPECT_LT(own.then, 0.004);
  EXPECT_GT(own.then, 0.0);
  std::array<char, 300> text{};
  describe(model, {}, own, text);
  EXPECT_NE(std::string(text.data()).find("; 4 mm are kept"), std::string::npos) << text.data();
}

// The claim that matters: whatever smooth motion is asked for, nothing ever touches, with the least margin for all either.
class AnyMargin : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Guard, AnyMargin, ::testing::Bool());
TEST_P(AnyMargin, RandomMotionsNeverTouch) {
  const Model model = GetParam() ? with_margins(pairs_to_check(hrp1s()), 0.003) : hrp1s();
  Watch watch(model);
  std::mt19937_64 random(kGuardSeed);
  std::normal_distribution<double> unit;
  int masked = 0;
  int looks = 0;
  for (int run = 0; run < 8; ++run) {
    Guard guard(model, {});
    const Configuration home = named_posture(model, "half_sitting");
    GuardRig rig(model, home);
    const std::int64_t arms = arm_mask();
    // Jerk-limited wandering of every arm joint and the waist.
    PerJoint<double> target{}, v{}, a{};
    for (int i = 0; i < 1000; ++i) {
      for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
        const Joint& joint = model.joints[static_cast<std::size_t>(model.bus_joints[k])];
        const bool waist =
            joint.name == "WAIST_P" || joint.name == "WAIST_R" || joint.name == "CHEST";
        if (((arms >> k) & 1) == 0 && !waist) continue;
        if (i % 250 == 0)
          target[k] =
              joint.lower + (joint.upper - joint.lower) * 0.5 * (1.0 + std::tanh(unit(random)));
        const double w = 6.0;  // third-order follower [rad/s]
        const double jerk =
            w * w * w * (target[k] - rig.command.q[k]) - 3.0 * w * w * v[k] - 3.0 * w * a[k];
        a[k] += jerk * model.period();
        v[k] = std::clamp(v[k] + a[k] * model.period(), -joint.velocity, joint.velocity);
        rig.command.q[k] =
            std::clamp(rig.command.q[k] + v[k] * model.period(), joint.lower, joint.upper);
      }
      masked += rig.tick(guard).hold_mask != 0 ? 1 : 0;
      const double nearest = watch.nearest(rig);
      ASSERT_GT(nearest, 0.0) << "run " << run << " tick " << i;
      ++looks;
    }
  }
  EXPECT_GT(masked, looks / 20) << "the motions were too tame to say anything";
}

// Motions at rated speed whose danger lies between the places that a few even looks along the braked
// way would see (6301), appears when what is asked for slows down on one joint alone (435), or when joints
// that were about to be let go stay held while others go on (6628).
TEST(Guard, NothingIsPassedOverOnTheWayToRest) {
  RatedMotions motions;
  auto& [model, home, exact, watch, drive] = motions;
  for (const std::int64_t number : {435, 6301, 6628}) {
    const Configuration target = drive.draw_target(exact, home, 1, number);
    Guard guard(model, {});
    GuardRig rig(model, home);
    drive.start();
    double nearest = 1.0;
    bool held = false;
    for (int i = 0; i < 1000; ++i) {
      drive.follow(rig, i < 500 ? target : home);
      held = rig.tick(guard).hold_mask != 0 || held;
      nearest = std::min(nearest, watch.nearest(rig));
      ASSERT_GT(nearest, 0.0) << "motion " << number << " tick " << i;
    }
    EXPECT_TRUE(held) << number;
    EXPECT_GT(nearest, 0.008) << number;
    EXPECT_EQ(guard.unproved(), 0) << number;
  }
}

// After a report a brake of all is in time: masks that are not proved let two of these motions touch (56, 435).
TEST(Guard, AfterItsReportABrakeOfAllIsInTime) {
  RatedMotions motions;
  auto& [model, home, exact, watch, drive] = motions;
  std::int64_t all = 0;
  for (const std::size_t k : drive.moved()) all |= std::int64_t{1} << k;
  int forks = 0;
  for (const std::int64_t number : {56, 435, 6628}) {
    const Configuration target = drive.draw_target(exact, home, 1, number);
    Guard guard(model, {});
    GuardRig rig(model, home);
    drive.start();
    for (int i = 0; i < 500; ++i) {
      drive.follow(rig, target);
      const GuardReport report = rig.tick(guard);
      if (report.hold_mask == 0 || report.hold_mask == all || i % 4 != 0) continue;
      ++forks;
      GuardRig fork = rig;
      RatedDrive on = drive;
      double nearest = 1.0;
      for (int t = 0; t < 150; ++t) {
        GuardReport brake = report;
        brake.hold_mask = all;
        on.follow(fork, target);
        fork.tick(brake);
        if (t % 3 == 0) nearest = std::min(nearest, watch.nearest(fork));
      }
      ASSERT_GT(nearest, 0.0) << "motion " << number << " tick " << i;
    }
  }
  EXPECT_GT(forks, 100);
}

TEST(Guard, AllocatesNothing) {
  const Model& model = hrp1s();
  Guard guard(model, {});
  GuardRig rig(model, named_posture(model, "half_sitting"));
  std::int64_t allocations = 0;
  for (int i = 0; i < 1000; ++i) {
    rig.command.q[bus("LARM_SHOULDER_R")] = 0.15 - 0.4 * std::sin(0.01 * i);
    rig.command.q[bus("LARM_SHOULDER_Y")] = -1.2 * std::sin(0.007 * i);
    rig.command.q[bus("RARM_ELBOW")] = -1.2 + std::sin(0.005 * i);
    NoAlloc no_alloc;
    rig.tick(guard);
    allocations += no_alloc.count();
  }
  EXPECT_EQ(allocations, 0);
}

// All joints beyond their limits of speed, through one another: what a tick has no looks for is held whole.
TEST(Guard, WhatTakesTooManyLooksIsHeldAndSaidToBe) {
  const Model& model = hrp1s();
  Guard guard(model, {});
  GuardRig rig(model, named_posture(model, "half_sitting"));
  std::int64_t all = 0, legs = 0;
  for (int k = 0; k < model.bus_count(); ++k) {
    const int joint = model.bus_joints[at(k)];
    const bool of_leg = std::find(model.leg_joints.begin(), model.leg_joints.end(), joint) != model.leg_joints.end();
    (of_leg ? legs : all) |= bit(k);
  }
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int gave_up = 0;
  for (int i = 0; i < 400; ++i) {
    for (int k = 0; k < model.bus_count(); ++k) {
      const Joint& joint = model.joints[at(model.bus_joints[at(k)])];
      rig.state.q[at(k)] = rig.command.q[at(k)] = std::lerp(joint.lower, joint.upper, unit(random));
      rig.state.qd[at(k)] = static_cast<float>(unit(random) < 0.5 ? -3.0 * joint.velocity : 3.0 * joint.velocity);
    }
    ++rig.state.tick;
    const std::int64_t before = guard.unproved();
    const GuardReport& report = guard.check(rig.state, nullptr, rig.base);
    EXPECT_EQ(report.hold_mask & legs, 0);
    if (guard.unproved() == before) continue;
    ++gave_up;
    EXPECT_EQ(report.hold_mask & all, all);
    EXPECT_EQ(report.verdict == GuardVerdict::kNear || report.verdict == GuardVerdict::kClear, false);
  }
  EXPECT_GT(gave_up, 20);
  std::array<char, 100> text{};
  describe(model, {}, {.found = true}, text);
  EXPECT_NE(std::string(text.data()).find("looks"), std::string::npos) << text.data();
}

TEST(Guard, WorksWithoutACommand) {
  Guard guard(hrp1s(), {});
  GuardRig rig(hrp1s(), named_posture(hrp1s(), "half_sitting"));
  EXPECT_EQ(guard.check(rig.state, nullptr, rig.base).hold_mask, 0);
  // Moving fast towards the body is enough.
  rig.state.q[bus("LARM_SHOULDER_Y")] = -1.0;
  rig.state.q[bus("LARM_ELBOW")] = -1.6;
  rig.state.qd[bus("LARM_SHOULDER_Y")] = -5.0F;
  rig.state.qd[bus("LARM_SHOULDER_R")] = -5.0F;
  rig.state.tick++;
  EXPECT_NE(guard.check(rig.state, nullptr, rig.base).hold_mask, 0);
}
TEST(Guard, AJointGoesNoFartherThanItsStop) {
  for (const bool stop : {false, true}) {
    Model model = hrp1s();
    GuardRig rig(hrp1s(), named_posture(hrp1s(), "half_sitting"));
    const std::size_t k = bus("LLEG_HIP_R");
    if (stop) model.joints[static_cast<std::size_t>(model.bus_joints[k])].lower = rig.state.q[k];
    Guard guard(model, {});
    rig.state.qd[k] = -12.0F;
    EXPECT_NE(guard.check(rig.state, nullptr, rig.base).stop_asked, stop);
  }
}

}  // namespace
}  // namespace twinbus
