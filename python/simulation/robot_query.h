// Questions to a robot's description that need no simulation: kinematics, distances, arm motions.  The base is at the origin.

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
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
  // Where a hand's frame is wanted, in the base frame; without an orientation any will do.
  struct Place {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
    std::optional<Eigen::Quaterniond> orientation;       // normalised here
  };
  struct Reached {
    bool reached = false;
    std::vector<double> q;        // the posture nearest to the place; only joints of the arm differ from the start's
    double position_error = 0.0;  // [m]
    double rotation_error = 0.0;  // [rad]; 0 without an orientation
  };
  // A posture in which the arm has its hand there, found from posture q on, within the joints' limits; nothing looks at what touches.
  // hand: left, right, or the name of a further arm (robot.yaml, hands).
  Reached inverse(const std::vector<double>& q, const std::string& hand, const Place& place);

  // A motion of an arm from posture q that keeps clear of the body and of the obstacles (poses in the base frame) and brings the hand to
  // a place.  hand: as for inverse; speed: share of the joints' velocity limits, up to 1; equal arguments, equal paths.
  Path plan(const std::vector<double>& q, const std::string& hand, const Place& place, const std::vector<Obstacle>& obstacles,
            double speed, std::uint64_t seed);

 private:
  void place(const std::vector<double>& q);
  const Frame& frame(const std::string& link) const;
  const Hand& arm(const std::string& name) const;

  std::unique_ptr<Model> model_;
  Kinematics kinematics_;
  Configuration configuration_;
  std::unique_ptr<Collision> collision_;  // with the first question
  std::unique_ptr<ArmPlanner> planner_;
};

}  // namespace twinbus
