#include "robot/description/walking_config.h"

#include "robot/description/robot_yaml.h"

namespace twinbus {

Walking read_walking(const ConfigNode& node) {
  Walking w;
  w.single_support = node.number("single_support", 0.1, 5.0, w.single_support);
  w.double_support = node.number("double_support", 0.01, 5.0, w.double_support);
  w.width = node.number("width", 0.0, 2.0, w.width);
  w.lift = node.number("lift", 0.0, 0.5, w.lift);
  w.com_height = node.number("com_height", 0.0, 5.0, w.com_height);
  w.zmp_forward = node.number("zmp_forward", -0.5, 0.5, w.zmp_forward);
  w.zmp_inward = node.number("zmp_inward", -0.2, 0.2, w.zmp_inward);
  w.fastest = node.number("fastest", 0.0, 10.0, w.fastest);
  w.preview = node.choice("pattern", {"closed_form", "preview"}, 0) == 1;
  w.gait = static_cast<PointGait>(node.choice("gait", {"trot", "crawl", "by_speed"}, 0));
  w.own_attitude = node.choice("attitude", {"imu", "estimated"}, 0) == 1;
  node.finish();
  return w;
}

Walking walking_of(const Model& model) { return robot_yaml_of(model).walking; }

}  // namespace twinbus
