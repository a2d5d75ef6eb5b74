// Speed of joints that two motors turn over rods, as their motors give it: near a dead centre the motors run fast while the joints
// hardly move, so it is limited posture by posture.

#pragma once

#include "robot/dynamics/pair_torque.h"

namespace twinbus::inline robot {

// Where a set-point may be after one tick: on the way from `from` to `to`, so near that no motor turns by more than `share` of what its
// speed allows in dt [s], and how fast it may say it is.  from, to: of the two joints, both where the rods reach.  True: cut.
inline bool limit_speed(const ParallelJoints& pair, const Eigen::Vector2d& from, double dt, double share, Eigen::Vector2d& to,
                        Eigen::Vector2d& qd) noexcept {
  RodPosture before, after;
  if (!pair.drive.at(from, before) || !pair.drive.at(to, after)) return false;
  const Eigen::Vector2d most(pair.drive.motor(0).speed, pair.drive.motor(1).speed);
  const double way = ((after.motors - before.motors).cwiseAbs().array() / (share * dt * most.array())).maxCoeff();
  const double speed = ((after.jacobian * qd).cwiseAbs().array() / most.array()).maxCoeff();
  if (way > 1.0) to = from + (to - from) / way;
  if (speed > 1.0) qd /= speed;
  return way > 1.0 || speed > 1.0;
}

}  // namespace twinbus::robot
