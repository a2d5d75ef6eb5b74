#include "robot/kinematics/pose_request.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/text/closest_name.h"
#include "common/text/formatted.h"

namespace twinbus::inline robot {

std::string add_joint(const Model& model, const std::string& name, double q, ModeRequest& pose) {
  std::vector<std::string> names;
  for (const int j : model.bus_joints) names.push_back(model.joints[static_cast<std::size_t>(j)].name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return model.name + " moves no joint '" + name + "'" + suggestion(name, names);
  const auto k = static_cast<std::size_t>(found - names.begin());
  const Joint& joint = model.joints[static_cast<std::size_t>(model.bus_joints[k])];
  if (!(q >= joint.lower && q <= joint.upper))
    return name + formatted("=%.6g is outside the limits of the joint, %.3f to %.3f", q, joint.lower, joint.upper);
  pose.q[k] = q;
  pose.joint_mask |= std::int64_t{1} << k;
  return {};
}

}  // namespace twinbus::robot
