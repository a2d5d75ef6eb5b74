// A scene of the maps as MuJoCo reads it.

#include <algorithm>
#include <cmath>
#include <string>

#include "test/bench/maps/failure_scenes.h"

namespace twinbus {

namespace {

std::string triple(const Eigen::Vector3d& v) { return mjcf_numbers({v.x(), v.y(), v.z()}); }

std::string placed(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.linear());
  return " pos='" + triple(pose.translation()) + "' quat='" + mjcf_numbers({q.w(), q.x(), q.y(), q.z()}) + "'";
}

// MuJoCo's contact has a time constant and a damping ratio, no stiffness: those of the mass on the springs of all its points.
std::string springs_of(const LooseBody& body) {
  const double points = body.solid.shape == SolidShape::kSphere ? 1.0 : 4.0;
  const double omega = std::sqrt(points * body.stiffness / body.mass);
  const double ratio = std::clamp(0.5 * points * body.damping / (body.mass * omega), 0.05, 1.0);
  return " solref='" + mjcf_numbers({1.0 / (ratio * omega), ratio}) + "'";
}

std::string geom_of(const LooseBody& body) {
  const Eigen::Vector3d& size = body.solid.size;
  if (body.solid.shape == SolidShape::kSphere) return "type='sphere' size='" + mjcf_numbers({size.x()}) + "'";
  return "type='box' size='" + triple(0.5 * size) + "'";
}

std::string of_bodies(const FailureScene& scene) {
  const WorldConfig& config = scene.config;
  std::string out =
      "<mujoco>\n<option gravity='0 0 -9.81' cone='elliptic' tolerance='1e-10'/>\n"
      "<worldbody>\n<geom type='plane' size='100 100 1' friction='" +
      mjcf_numbers({config.ground_friction}) + " 0 0'/>\n";
  // Of two geoms the higher priority says the contact: the body, whose spring and friction are the scene's.
  const std::string rest = " priority='1' condim='3' ";
  for (const Obstacle& obstacle : config.obstacles)
    out += "<geom type='box' size='" + triple(0.5 * obstacle.size) + "'" + placed(obstacle.pose) + "/>\n";
  int index = 0;
  for (const LooseBody& body : config.loose) {
    const Eigen::Vector3d inertia = inertia_of(body.solid, body.mass).diagonal();
    out += "<body name='loose" + std::to_string(index++) + "'" + placed(body.start.pose) + "><freejoint/><inertial pos='0 0 0' mass='" +
           mjcf_numbers({body.mass}) + "' diaginertia='" + triple(inertia) + "'/><geom " + geom_of(body) + rest + springs_of(body) +
           " friction='" + mjcf_numbers({body.friction}) + " 0 0'/></body>\n";
  }
  return out + "</worldbody>\n</mujoco>\n";
}

// Closed loops: points of two links held together.
std::string with_loops(const FailureScene& scene, std::string xml) {
  std::string equality;
  for (const Tie& tie : scene.config.ties)
    equality += "<connect body1='link" + std::to_string(tie.a.link) + "' body2='link" + std::to_string(tie.b.link) + "' anchor='" +
                triple(tie.a.point) + "' solref='0.002 1'/>";
  const std::size_t end = xml.rfind("</mujoco>");
  if (!equality.empty() && end != std::string::npos) xml.insert(end, "<equality>" + equality + "</equality>\n");
  return xml;
}

}  // namespace

nlohmann::json mujoco_scene(const FailureScene& scene) {
  nlohmann::json found = {{"step", scene.config.step},     {"duration", scene.duration}, {"every", scene.every},
                          {"scale", scene.scale},          {"conservative", scene.conservative},
                          {"links", scene.watch_robot ? scene.robot.model.link_count() : 0},
                          {"loose", nlohmann::json::array()}};
  if (scene.watch_robot) {
    found["xml"] = with_loops(scene, mjcf(scene.robot));
    return found;
  }
  found["xml"] = of_bodies(scene);
  for (const LooseBody& body : scene.config.loose) {  // a free joint turns in the axes of its body
    const Eigen::Vector3d &v = body.start.velocity, w = body.start.pose.linear().transpose() * body.start.angular_velocity;
    found["loose"].push_back({v.x(), v.y(), v.z(), w.x(), w.y(), w.z()});
  }
  return found;
}

}  // namespace twinbus
