#include "robot/estimation/sole_contact.h"

#include <algorithm>
#include <array>

namespace twinbus::inline robot {

// Corner i is lift_i higher than the origin.  At height h it is pressed by -(h + lift_i), and the
// lowest corners touch first: with n of them touching, force = k/4 sum(-(h + lift_i)), so h = -(4
// force / k + sum lift_i) / n.
double sole_height(const Sole& sole, const Eigen::Matrix3d& rotation, double force) noexcept {
  const Eigen::Vector3d up = rotation.row(2).transpose();
  std::array<double, 4> lift = {
      up.x() * sole.front + up.y() * sole.left, up.x() * sole.front - up.y() * sole.right,
      -up.x() * sole.back + up.y() * sole.left, -up.x() * sole.back - up.y() * sole.right};
  std::sort(lift.begin(), lift.end());
  if (!(force > 0.0) || !(sole.stiffness > 0.0)) return -lift[0];
  double sum = 4.0 * force / sole.stiffness;
  double height = 0.0;
  for (std::size_t n = 0; n < 4; ++n) {
    sum += lift[n];
    height = -sum / static_cast<double>(n + 1);
    if (n == 3 || height + lift[n + 1] >= 0.0) break;  // the next corner is off the ground
  }
  return height;
}

}  // namespace twinbus::robot
