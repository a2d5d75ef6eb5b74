#include "robot/hand/grippers.h"

namespace twinbus {

std::vector<double> opened(const Gripper& gripper, double share) {
  std::vector<double> q(gripper.joints.size());
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = gripper.closed[i] + share * (gripper.open[i] - gripper.closed[i]);
  return q;
}

}  // namespace twinbus
