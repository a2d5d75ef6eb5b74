// Questions to a robot's description that need no simulation: kinematics, distances, arm motions.  The base is at the origin.

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "planner/arm_planner.h"
#include "robot/collision/collision.h"
#include "robot/description/model.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus {

class RobotQuery {
 public:
  using Rows = std::vector<std::vector<double>>;

  // robot: a name in config/robots or a folder.  Throws std::runtime_error as load_robot does.
  explicit RobotQuery(const std::string& robot);

  const Model& model() const { return *model_; }

  // q: [bus_count], bus order [rad or m].  All throw std::invalid_argument for another length, for a number that is not finite and for
  // a link that is not there, and name the nearest.

  // [4][4] of a link of the URDF in the base frame [m].
  Rows link_pose(const std::vector<double>& q, const std::string& link);
  // Centre of mass in the base frame [m].
  std::vector<double> com(const std::vector<double>& q);
  // [6][bus_count]: linear, then angular velocity of the link's origin in base axes for a unit speed of each joint on the bus.
  Rows jacobian(const std::vector<double>& q, const std::string& link);

  struct Near {
    std::string link_a, link_b;
    double distance = 0.0;  // [m]; below zero: depth
  };
  // The `most` nearest pairs of links that are checked and nearer than 1 m, nearest first.
  std::vector<Near> nearest(const std::vector<double>& q, int most);

  struct Path {
    std::string text;                 // what the planner says of it
    std::vector<std::string> joints;  // of the columns
    std::vector<double> time;         // of the knots [s]; empty: no path
    Rows q, qd;                       // [knots][joints]; cubic Hermite between knots
  };
  // A motion of an arm from posture q that keeps clear of the body and brings the hand to a place of the base frame [m].
  // hand: left or right; speed: share of the joints' velocity limits, up to 1; equal seeds, equal paths.
  Path plan(const std::vector<double>& q, const std::string& hand, const Eigen::Vector3d& position, double speed,
            std::uint64_t seed);

 private:
  void place(const std::vector<double>& q);
  const Frame& frame(const std::string& link) const;

  std::unique_ptr<Model> model_;
  Kinematics kinematics_;
  Configuration configuration_;
  std::unique_ptr<Collision> collision_;  // with the first question
  std::unique_ptr<ArmPlanner> planner_;
};

}  // namespace twinbus
