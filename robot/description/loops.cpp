#include "robot/description/loops.h"

#include <vector>

#include "common/text/strict_yaml.h"

namespace twinbus::inline robot {

namespace {

constexpr double kFar = 1000.0;  // [m]

Eigen::Vector3d point_of(const ConfigNode& node, const std::string& key) {
  const std::vector<double> v = node.numbers(key, 3, {0.0, 0.0, 0.0});
  const Eigen::Vector3d point(v[0], v[1], v[2]);
  if (!(point.cwiseAbs().maxCoeff() <= kFar)) node.fail(key, "must be within 1000 m");
  return point;
}

}  // namespace

Loop read_loop(const ConfigNode& node) {
  Loop loop;
  loop.link = node.text("link");
  loop.point = point_of(node, "point");
  loop.to = node.text("to", loop.to);
  loop.at = point_of(node, "at");
  loop.stiffness = node.number("stiffness", 1.0, 1e10, loop.stiffness);
  loop.damping = node.number("damping", 0.0, 1e8, 1e-3 * loop.stiffness);
  if (node.has("length")) loop.length = node.number("length", 0.0, kFar);
  node.finish();
  return loop;
}

}  // namespace twinbus::robot
