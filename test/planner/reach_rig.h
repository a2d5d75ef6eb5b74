// hrp1s standing with its soles on the ground, obstacles around it, and a second opinion about
// every path: FCL's other solver on every pair, looked at densely.

#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "planner/arm_planner.h"
#include "robot/description/load.h"
#include "test/collision/postures.h"
#include "test/obstacles.h"
#include "test/oracles/fcl_oracle.h"

namespace twinbus {

// The ground frame is the world.
inline Configuration standing() {
  Configuration posture = named_posture(hrp1s(), "half_sitting");
  Kinematics kinematics(hrp1s());
  kinematics.update(posture);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Sole& sole : hrp1s().soles)
    middle += 0.5 * (kinematics.link_in_world(sole.link) * sole.frame).translation();
  posture.base.translation() -= middle;
  return posture;
}

inline Obstacle box(double x, double y, double z, double dx, double dy, double dz) {
  return test::box_at({x, y, z}, {dx, dy, dz});
}

inline Obstacle post(double x, double y) {
  Obstacle obstacle;
  obstacle.shape = ObstacleShape::kCylinder;
  obstacle.size = Eigen::Vector3d(0.025, 0.7, 0.0);
  obstacle.pose.translation() = Eigen::Vector3d(x, y, 0.95);
  return obstacle;
}

inline ArmGoal hand_to(ArmSide side, double x, double y, double z) {
  ArmGoal goal;
  goal.goal_id = 1;
  goal.side = side;
  goal.kind = ArmGoalKind::kPosition;
  goal.position = {x, y, z};
  goal.speed = 0.5F;
  return goal;
}

// The ground frame where standing() stands.
inline const Eigen::Isometry3d kGround = Eigen::Isometry3d::Identity();

inline ArmPlan plan_with(const std::vector<Obstacle>& obstacles, const ArmGoal& goal,
                  const Configuration& start, std::uint64_t seed) {
  ArmPlanner planner(hrp1s());
  planner.set_obstacles(obstacles);
  return planner.plan(goal, start, kGround, seed);
}

inline Configuration posture_at(const ArmPlan& plan, const Configuration& start, double time) {
  Configuration posture = start;
  JointPoint q, qd, qdd;
  sample(plan.path, time, q, qd, qdd);
  for (std::size_t k = 0; k < plan.joints.size(); ++k)
    posture.q[plan.joints[k]] = q[static_cast<int>(k)];
  return posture;
}

inline Eigen::Vector3d hand_at(const ArmPlan& plan, const Configuration& start, ArmSide side,
                               double time) {
  const Model& model = hrp1s();
  Kinematics kinematics(model);
  kinematics.update(posture_at(plan, start, time));
  const Hand& hand = model.hands[side == ArmSide::kLeft ? 0 : 1];
  return (kinematics.link_in_world(hand.link) * hand.frame).translation();
}

// Smallest distance of any link to any obstacle along the motion.
inline double nearest_to_obstacles(const std::vector<Obstacle>& obstacles, const ArmPlan& plan,
                                   const Configuration& start) {
  Collision collision(hrp1s());
  collision.set_obstacles(obstacles);
  Kinematics kinematics(hrp1s());
  double nearest = 1.0;
  for (double t = 0.0; t <= plan.duration(); t += 0.002) {
    kinematics.update(posture_at(plan, start, t));
    for (int link = 0; link < hrp1s().link_count(); ++link) {
      for (int o = 0; o < static_cast<int>(obstacles.size()); ++o) {
        PairDistance pair;
        if (collision.pair_nearer_than(kinematics, link, hrp1s().link_count() + o, nearest, pair))
          nearest = std::min(nearest, pair.distance);
      }
    }
  }
  return nearest;
}

class SecondOpinion {
 public:
  explicit SecondOpinion(const std::vector<Obstacle>& obstacles)
      : collision_(hrp1s()), oracle_(hrp1s()), kinematics_(hrp1s()), pairs_(collision_.pairs()) {
    collision_.set_obstacles(obstacles);
    oracle_.set_obstacles(obstacles);
    for (int link = 0; link < hrp1s().link_count(); ++link) {
      if (hrp1s().links[static_cast<std::size_t>(link)].collision.empty()) continue;
      for (int k = 0; k < static_cast<int>(obstacles.size()); ++k)
        pairs_.push_back({link, hrp1s().link_count() + k});
    }
  }

  // How many samples of the motion, `every` seconds apart, touch.
  int touching(const ArmPlan& plan, const Configuration& start, double every) {
    int hits = 0;
    for (double t = 0.0; t < plan.duration() + every; t += every) {
      kinematics_.update(posture_at(plan, start, t));
      for (const CollisionPair& pair : pairs_)
        hits += oracle_.touches(kinematics_, pair) ? 1 : 0;
    }
    return hits;
  }
  // Of all pairs that the arm's joints can change, along the motion, at most `far` [m].
  double nearest(const ArmPlan& plan, const Configuration& start, double every, double far) {
    double nearest = far;
    collision_.check_only_moved_by(plan.joints);
    for (double t = 0.0; t < plan.duration() + every; t += every) {
      kinematics_.update(posture_at(plan, start, t));
      PairDistance pair;
      if (collision_.near_pairs(kinematics_, far, &pair, 1) > 0)
        nearest = std::min(nearest, pair.distance);
    }
    return nearest;
  }

 private:
  Collision collision_;
  FclOracle oracle_;
  Kinematics kinematics_;
  std::vector<CollisionPair> pairs_;
};

}  // namespace twinbus
