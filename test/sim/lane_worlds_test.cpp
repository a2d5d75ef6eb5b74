// Four worlds in the lanes of a vector: each does to the bit what it does alone there, and what engine articulated does but for rounding.

#include "sim/lanes/lane_worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "robot/description/load.h"
#include "sim/world/static_equilibrium.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

struct Standing4 {
  explicit Standing4(const std::string& robot) : model(load_robot(robot)), standing(model_standing()) {}
  Standing model_standing() {
    const NamedPose& pose = model.poses[at(model.find_pose("half_sitting"))];
    const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(pose.q.data(), model.joint_count());
    const double corner = model.soles[0].stiffness / kSoleCorners;
    return stand(model, q, 1.0, {corner, corner}, {0.0, 0.0}, false);
  }
  // World number `which`: each is disturbed in another way.
  WorldConfig config(int which) const {
    WorldConfig config;
    config.step = 1e-3;
    config.mass_scale = 1.0 + 0.01 * which;
    config.ground_friction = which == 3 ? 0.02 : 0.8;  // it slides
    config.friction_scale = which == 2 ? 2.0 : 1.0;
    config.joint_friction = which == 2 ? 0.5 : 0.0;
    config.backlash = which == 2 ? 1e-3 : 0.0;
    config.loose = loose;
    return config;
  }
  void begin(World& world, int which) const {
    Configuration start = standing.configuration;
    start.base_velocity = Eigen::Vector3d(0.03 * which, -0.02 * which, 0.0);
    if (which == 1) start.base.translation().z() += 0.01;  // it lands
    ASSERT_EQ(world.set(start, &standing.tau), Status::kOk);
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[at(j)];
      ASSERT_EQ(world.set_servo(j, {.q = start.q[j], .tau = standing.tau[j], .kp = joint.kp, .kd = joint.kd}), Status::kOk);
    }
  }
  void push(World& world, int which, int step) const {
    if (step < 100 || step >= 150) return;
    EXPECT_EQ(world.push(0, world.link_in_world(0).translation(), {40.0 * which, 20.0, 0.0}), Status::kOk);
  }
  std::unique_ptr<LaneWorlds> lanes(const std::vector<int>& which) const {
    std::vector<std::unique_ptr<World>> worlds;
    for (const int each : which) worlds.push_back(std::make_unique<ArticulatedWorld>(model, config(each)));
    auto together = std::make_unique<LaneWorlds>(std::vector<const Model*>(which.size(), &model), std::move(worlds));
    for (std::size_t k = 0; k < which.size(); ++k) begin(together->world(static_cast<int>(k)), which[k]);
    return together;
  }
  Model model;
  Standing standing;
  std::vector<LooseBody> loose;
};

std::vector<double> state_of(const World& world) {
  std::vector<double> state;
  const auto keep = [&](const auto& numbers) { state.insert(state.end(), numbers.data(), numbers.data() + numbers.size()); };
  const Configuration& now = world.configuration();
  keep(now.base.matrix());
  keep(now.base_velocity);
  keep(now.base_angular_velocity);
  keep(now.q);
  keep(now.qd);
  for (int i = 0; i < world.loose_count(); ++i) keep(world.loose(i).pose.matrix());
  for (const ContactPoint& contact : world.contacts()) keep(contact.force);
  for (int j = 0; j < now.q.size(); ++j) state.push_back(world.tau(j));
  state.push_back(world.elastic_energy());
  return state;
}

struct Ran {
  std::vector<std::vector<double>> ends;  // of the worlds asked for, in their order
  double in_lanes = 0.0;
};
Ran run(const Standing4& rig, const std::vector<int>& which, int steps) {
  const auto lanes = rig.lanes(which);
  LaneWorlds& worlds = *lanes;
  std::array<Status, kWorldLanes> status;
  for (int i = 0; i < steps; ++i) {
    for (std::size_t k = 0; k < which.size(); ++k) rig.push(worlds.world(static_cast<int>(k)), which[k], i);
    worlds.step((1 << which.size()) - 1, status);
    for (std::size_t k = 0; k < which.size(); ++k) EXPECT_EQ(status[k], Status::kOk);
  }
  Ran ran;
  for (std::size_t k = 0; k < which.size(); ++k) ran.ends.push_back(state_of(worlds.world(static_cast<int>(k))));
  ran.in_lanes = static_cast<double>(worlds.in_lanes()) / static_cast<double>(worlds.steps());
  return ran;
}

void expect_the_same_bits(const Standing4& rig) {
  constexpr int kSteps = 400;
  const Ran four = run(rig, {0, 1, 2, 3}, kSteps), turned = run(rig, {3, 2, 0, 1}, kSteps);
  const int place[] = {2, 3, 1, 0};
  for (int w = 0; w < 4; ++w) {
    EXPECT_EQ(four.ends[at(w)], turned.ends[at(place[w])]) << w;
    EXPECT_EQ(four.ends[at(w)], run(rig, {w}, kSteps).ends[0]) << w;
  }
  EXPECT_NE(four.ends[0], four.ends[1]);
}

TEST(LaneWorlds, AWorldDoesTheSameBesideAnyNeighboursAndAlone) {
  for (const char* robot : {"hrp1s", "biped12"}) expect_the_same_bits(Standing4(robot));
}

TEST(LaneWorlds, StandingGoesInLanesAndAsTheEngineDoesIt) {
  for (const char* robot : {"hrp1s", "biped12"}) {
    const Standing4 rig(robot);
    const Ran lanes = run(rig, {0, 2}, 300);
    EXPECT_GT(lanes.in_lanes, 0.9) << robot;
    for (const int w : {0, 2}) {
      ArticulatedWorld world(rig.model, rig.config(w));
      rig.begin(world, w);
      for (int i = 0; i < 300; ++i) {
        rig.push(world, w, i);
        ASSERT_EQ(world.step(), Status::kOk);
      }
      const std::vector<double> alone = state_of(world);
      const std::vector<double>& end = lanes.ends[w == 0 ? 0 : 1];
      ASSERT_EQ(alone.size(), end.size());
      for (std::size_t i = 0; i < end.size(); ++i) EXPECT_NEAR(alone[i], end[i], 1e-6 * (1.0 + std::abs(alone[i]))) << robot << " " << w << " " << i;
    }
  }
}

LooseBody box(double x, double z) {
  LooseBody body;
  body.name = "box";
  body.solid.size << 0.2, 0.1, 0.1;
  body.start.pose.translation() = Eigen::Vector3d(x, 0.0, z);
  body.start.angular_velocity = Eigen::Vector3d(1.0, 2.0, 0.5);
  return body;
}

TEST(LaneWorlds, LooseBodiesFallBesideTheRobotAndOnIt) {
  Standing4 rig("hrp1s");
  rig.loose = {box(2.0, 0.3), box(2.05, 0.6)};
  expect_the_same_bits(rig);
  EXPECT_GT(run(rig, {0, 2}, 300).in_lanes, 0.9);
  rig.loose.push_back(box(0.0, 1.9));
  expect_the_same_bits(rig);
  EXPECT_LT(run(rig, {0, 2}, 300).in_lanes, 0.9);
}

TEST(LaneWorlds, WhatLanesDoNotKnowIsRefusedInASentence) {
  const Standing4 rig("biped12");
  WorldConfig config = rig.config(0);
  EXPECT_EQ(LaneWorlds::why_not(config), "");
  for (const ContactModel other : {ContactModel::kSoft, ContactModel::kPatch, ContactModel::kRigid}) {
    config.contact = other;
    EXPECT_EQ(LaneWorlds::why_not(config), "contact is neither spring_damper nor hunt_crossley");
  }
  config.contact = ContactModel::kHuntCrossley;
  EXPECT_EQ(LaneWorlds::why_not(config), "");
  config.order = 2;
  EXPECT_EQ(LaneWorlds::why_not(config), "solver.order is not 1");
  const auto made = [](const Model& model, const WorldConfig& as) {
    std::vector<std::unique_ptr<World>> worlds;
    worlds.push_back(std::make_unique<ArticulatedWorld>(model, as));
    return worlds;
  };
  EXPECT_THROW(LaneWorlds({&rig.model}, made(rig.model, config)), std::runtime_error);
  const Model other = load_robot("hrp1s");
  auto two = made(rig.model, rig.config(0));
  two.push_back(std::make_unique<ArticulatedWorld>(other, rig.config(0)));
  EXPECT_THROW(LaneWorlds({&rig.model, &other}, std::move(two)), std::runtime_error);
}

TEST(LaneWorlds, AStepAllocatesNothing) {
  const Standing4 rig("hrp1s");
  const auto lanes = rig.lanes({0, 1});
  LaneWorlds& worlds = *lanes;
  std::array<Status, kWorldLanes> status;
  const NoAlloc none;
  for (int i = 0; i < 100; ++i) {
    worlds.step(3, status);
    (void)worlds.world(0).contacts();
  }
  EXPECT_EQ(none.count(), 0);
}

}  // namespace
}  // namespace twinbus
