#include "sim/scene/scene_vectors.h"

namespace twinbus::inline sim {

Eigen::Vector3d bounded(const ConfigNode& node, const std::string& key, double bound,
                        const Eigen::Vector3d* fallback) {
  if (fallback != nullptr && !node.has(key)) return *fallback;
  const Eigen::Vector3d v = Eigen::Vector3d::Map(node.numbers(key, 3).data());
  if (!(v.cwiseAbs().maxCoeff() <= bound)) {
    node.fail(key, "every number must be within +-" + std::to_string(static_cast<int>(bound)));
  }
  return v;
}

Eigen::Quaterniond rpy(const ConfigNode& node) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Eigen::Vector3d angle = kDegree * bounded(node, "rpy_deg", 360.0, &zero);
  return Eigen::AngleAxisd(angle.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angle.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angle.x(), Eigen::Vector3d::UnitX());
}

}  // namespace twinbus::sim
