// The damped oscillation of a robot that stands with its joints held, was pushed out of its posture
// and is let go, as in Fig. 12 of the paper: what a linear model says of it, and what a run shows.
//
// The linear model is of the whole robot, base and joints:  M x'' + C x' + K x = 0  about the
// posture, where K is of servos, sole corners and gravity, C of servos and sole corners.  Its modes
// come in pairs -decay +- i 2 pi / period; the one told is that which is seen most in a joint after
// a steady push on a point is over.

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "sim/world/world.h"

namespace twinbus::inline launcher {

struct Swing {
  double period = 0.0;  // [s]
  double decay = 0.0;   // of the amplitude [1/s]
};

struct SteadyPush {
  int link = -1;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // in the link frame [m]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // world [N]; only its direction matters
};

// q: [joint_count], held.  None if the robot does not stand in it or nothing of it swings.
// Coulomb friction of joints and contacts, play and limits of effort are not in it.
std::optional<Swing> swing_of(const Model& model, const WorldConfig& world,
                              const Eigen::VectorXd& q, const SteadyPush& push, int joint);

// Of values one `step` [s] after the other, from the release on.  From the extremes: neighbours are
// half a period apart, and their differences, in which no offset is left, die out as the swing does.
// None with fewer than five extremes that stand out of the values' last tenth.
std::optional<Swing> swing_seen(const std::vector<double>& values, double step);

}  // namespace twinbus::launcher
