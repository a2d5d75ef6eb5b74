// Where the feet go: the next foothold for a velocity command, and how far and fast this robot's legs can.
//
// In one step of duration T the middle between the feet moves by (vx T, vy T) and turns by wz T:
//
//     foothold = foot + half width to the middle, (vx T, vy T) on, half width out again
//
// Only the foot on that side steps sideways (2 vy T, the other 0), and toes open more than they close (1.5 to 0.5): legs
// that would otherwise cross do not.

#pragma once

#include <Eigen/Core>

#include "robot/description/model.h"
#include "robot/description/walking_config.h"

namespace twinbus::inline control {

struct Foothold {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // of the sole frame, world [m]
  double height = 0.0;                                 // of the ground there [m]
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();  // of the ground under the sole

  double yaw() const noexcept { return yaw_; }  // [rad]
  void set_yaw(double yaw) noexcept;
  Eigen::Matrix3d rotation() const noexcept;
  // Sole axes -> world axes, and back.
  Eigen::Vector2d turn(const Eigen::Vector2d& v) const noexcept {
    return {cosine_ * v.x() - sine_ * v.y(), sine_ * v.x() + cosine_ * v.y()};
  }
  Eigen::Vector2d unturn(const Eigen::Vector2d& v) const noexcept {
    return {cosine_ * v.x() + sine_ * v.y(), -sine_ * v.x() + cosine_ * v.y()};
  }

 private:
  double yaw_ = 0.0, cosine_ = 1.0, sine_ = 0.0;  // turned often, set once a tick
};

// How this robot walks: robot.yaml's `walking`, and what follows from its legs and soles.
struct Gait {
  double single_support = 0.5, double_support = 0.1;  // [s]
  double first_double = 0.7, last_double = 0.5;  // before the first step and after the last [s]
  double shortest_single = 0.22;                 // of a step taken to catch the robot [s]
  double hurry = 0.03;          // double support after a step that was moved far [s]
  double width = 0.2;           // between the sole frames [m]
  double standing_width = 0.2;  // in the pose that robots stand in [m]
  double rough_wider = 0.0;     // so much wider on rough ground: narrow soles hold less there, steps inward hold the rest [m]
  double lift = 0.05;           // of the swing foot [m]
  double com_height = 0.7;      // above the ground [m]
  double zmp_forward = 0.03, zmp_inward = 0.005;  // of the reference ZMP under a sole [m]
  double max_forward = 0.45, max_back = 0.35;     // of a foothold before the other foot [m]
  double min_width = 0.155, max_width = 0.5;      // [m]
  double max_turn = 0.5;                          // of a foothold from the other foot [rad]
  double inner = 0.07;             // of a sole from its frame towards the other foot [m]
  double toe = 0.18, heel = 0.07;  // of a sole before and behind its frame [m]
  bool leans = false;              // soles that no ankle rolls: they carry on the edge to which the leg leans
  bool preview = false;            // the reference is that of preview control
  Eigen::Vector2d swing_acceleration{1e3, 1e3};   // of a foot, forward and to the side: what the hips are asked for [m/s^2]
  double ankle_share = 0.9;        // share of the sole on which step adjustment counts
  Eigen::Vector2d sole_low{-0.1, -0.07}, sole_high{0.1, 0.07};  // of the ZMP in the sole frame [m]
  Eigen::Vector3d most_velocity{0.5, 0.2, 0.8};  // vx, vy, wz, each alone [m/s, m/s, rad/s]
  Eigen::Vector3d acceleration{0.5, 0.4, 1.5};   // of the velocity command

  double period() const noexcept { return single_support + double_support; }
  // Between the sole frames, so that feet that turn so far a step [rad] keep heels and toes apart.
  double turning_width(double turning) const noexcept;
  // Whether the legs reach a foothold while `foot` stands on `from`: forward and to the side at once, what is left of the
  // one is a share of the other.
  bool reaches(const Foothold& from, int foot, const Foothold& next) const noexcept;
  // What can be done of a command: all shares of what can be done alone together at most one.
  Eigen::Vector3d possible(const Eigen::Vector3d& velocity) const noexcept;
  // The shares of `most` that a velocity asks for, together; what cannot be done is not asked for.
  static double share_of(const Eigen::Vector3d& velocity, const Eigen::Vector3d& most) noexcept;
};

// margin: kept from the sole edges [m].  Throws std::runtime_error with one sentence when robot.yaml asks for
// what the legs cannot do.
Gait gait_of(const Model& model, const Walking& walking, double margin);

// +1: foot 0, the left one; -1: the right one.
inline double side_of(int foot) noexcept { return foot == 0 ? 1.0 : -1.0; }

// Where the other foot goes while `foot` stands on `from`; period: of a step [s], width: between the feet [m].
Foothold next_foothold(const Foothold& from, int foot, const Eigen::Vector3d& velocity,
                       double period, double width) noexcept;

// `next`, moved out from `from`, on which `foot` stands, so far that each sole lies with the least gap between two soles beyond the
// inner edge of the other, as long as that is: then neither foot passes near the other one when it swings, wherever in
// front of or behind it the step begins and ends.
Foothold kept_apart(const Gait& gait, const Foothold& from, int foot, Foothold next) noexcept;

// Where the reference ZMP is while `foot` alone carries the robot, world.
Eigen::Vector2d zmp_on(const Gait& gait, const Foothold& at, int foot) noexcept;

}  // namespace twinbus::control
