// How near what is loose, or a further robot, comes to each link of the robot in a run, and how near a link comes to what is fixed.

#pragma once

#include <vector>

#include "geometry/shapes.h"
#include "robot/description/model.h"
#include "sim/contact/ground_contacts.h"
#include "sim/world/solid.h"
#include "sim/world/world.h"

namespace twinbus::inline launcher {

class Clearance {
 public:
  // Of the shapes of links balls are taken, of loose bodies their solid or the box around their triangles: what a look
  // finds is never too far.
  // Throws std::runtime_error where a mesh cannot be read.
  Clearance(const Model& model, const WorldConfig& config);
  void look(const World& world);
  // By link [m]; empty where nothing is loose and no further robot is there.
  const std::vector<double>& nearest() const { return nearest_; }
  // Of what is no sole to the ground and obstacles, by link [m]; infinite: it has no shape that could touch.
  const std::vector<double>& above() const { return above_; }

 private:
  struct RobotBalls {
    std::vector<Ball> links;  // in the link frame; radius < 0: it has no shape
  };
  static RobotBalls balls_of(const Model& model);

  RobotBalls own_;
  std::vector<RobotBalls> robots_;
  struct LooseSolid {
    Solid solid;
    Eigen::Isometry3d in_body;
  };
  std::vector<LooseSolid> loose_;
  std::vector<double> nearest_, above_;
  GroundContacts ground_;
};

}  // namespace twinbus::launcher
