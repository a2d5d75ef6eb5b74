// What two joints may do that two motors turn over rods: the box of joint angles that lies inside the motors' ranges and away from
// singular postures, and the boxes of speed and torque inside the motors' limits.

#pragma once

#include <optional>
#include <string>

#include "robot/parallel/rod_drive.h"

namespace twinbus::inline robot {

// Nearer to singular than this the pair is not used: RodPosture::crank_sine and foot_share.
inline constexpr double kLeastCrankSine = 0.15;
inline constexpr double kLeastFootShare = 0.1;

// Whether a posture may be used: closed, in the motors' ranges, not singular.  Why not, in words for people: not_used_for().
bool usable(const RodDrive& drive, const Eigen::Vector2d& q, RodPosture& posture) noexcept;
// Empty: it may be used.  Else what is in the way: motor or rod, value and limit.
std::string not_used_for(const RodDrive& drive, const Eigen::Vector2d& q);

struct JointBox {
  Eigen::Vector2d lower = Eigen::Vector2d::Zero(), upper = Eigen::Vector2d::Zero();  // [rad]
};
// The posture that a range grows from: 0, or the end nearest to it.
Eigen::Vector2d middle_of(const JointBox& limits) noexcept;
// A box inside `limits` of which every posture may be used: limits and all if they may; else they are drawn in alike towards their
// middle, and then each end goes out again as far as the others let it.  None: the middle itself may not be used.
std::optional<JointBox> usable_box(const RodDrive& drive, const JointBox& limits) noexcept;

// Over all postures of a box.
struct DriveMargins {
  double crank_sine = 1.0, foot_share = 1.0;                // the least
  Eigen::Vector2d lower = Eigen::Vector2d::Zero(), upper = Eigen::Vector2d::Zero();  // the motors' angles [rad]
};
DriveMargins margins_in(const RodDrive& drive, const JointBox& box) noexcept;
// Joint speeds that together ask no more of any motor than its limit, in any posture of the box; wanted: not more than, [rad/s].
Eigen::Vector2d speed_box(const RodDrive& drive, const JointBox& box, const Eigen::Vector2d& wanted) noexcept;

// Largest torque of each joint while the other has none [N m].
Eigen::Vector2d torque_alone(const RodDrive& drive, const RodPosture& posture) noexcept;
// Torques that the joints may have both, whatever their signs: the largest box inside the motors' parallelogram that is as wide and
// high as torque_alone [N m].
Eigen::Vector2d torque_box(const RodDrive& drive, const RodPosture& posture) noexcept;

}  // namespace twinbus::robot
