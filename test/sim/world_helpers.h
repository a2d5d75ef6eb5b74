// What tests of worlds do again and again: a standing block, a loose box, settling, the energy of a robot.

#pragma once

#include <gtest/gtest.h>

#include <string>

#include "robot/dynamics/inverse_dynamics.h"
#include "robot/kinematics/kinematics.h"
#include "sim/world/world.h"
#include "common/allocation/no_alloc.h"
#include "test/sim/body_energy.h"

namespace twinbus::test {

inline WorldConfig stepped(double step, int order) {
  WorldConfig config;
  config.step = step;
  config.order = order;
  return config;
}

// test::block() sunk so far into the ground that its soles carry it.
inline Configuration standing_block(const Model& block) {
  Configuration at(block);
  at.base.translation().z() = -block.total_mass() * kGravity / 2e5;
  return at;
}

// Its arm held, four seconds go by.
inline void settle_block(World& world) {
  ASSERT_EQ(world.set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = 100, .kd = 10}), Status::kOk);
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(world.step(), Status::kOk);
}

// So many steps, none of which allocates.
inline void step_without_allocation(World& world, int steps) {
  const NoAlloc guard;
  for (int i = 0; i < steps; ++i) ASSERT_EQ(world.step(), Status::kOk);
  EXPECT_EQ(guard.count(), 0);
}

inline LooseBody loose_box(const std::string& name, double mass, const Eigen::Vector3d& size, const Eigen::Isometry3d& pose,
                           double stiffness, double damping) {
  LooseBody body;
  body.name = name;
  body.solid = {SolidShape::kBox, size};
  body.mass = mass;
  body.start.pose = pose;
  body.stiffness = stiffness;
  body.damping = damping;
  return body;
}

}  // namespace twinbus::test
