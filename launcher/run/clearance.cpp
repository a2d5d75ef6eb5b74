#include "launcher/run/clearance.h"

#include <algorithm>
#include <limits>

#include "common/math/index.h"
#include "geometry/bounds/shape_mesh.h"

namespace twinbus::inline launcher {

Clearance::RobotBalls Clearance::balls_of(const Model& model) {
  RobotBalls balls;
  for (const Link& link : model.links) {
    Eigen::AlignedBox3d box;
    double outside = 0.0;
    for (const Shape& shape : link.collision) {
      for (const Eigen::Vector3d& point : shape_mesh(shape, outside).points) box.extend(point);
    }
    for (const Sole& sole : model.soles) {
      if (sole.link < 0 || &model.links[at(sole.link)] != &link) continue;
      for (int corner = 0; corner < kSoleCorners; ++corner) box.extend(Eigen::Vector3d(sole.frame * sole_corner(sole, corner)));
    }
    if (box.isEmpty()) balls.links.push_back({Eigen::Vector3d::Zero(), -1.0});
    else balls.links.push_back({box.center(), 0.5 * box.diagonal().norm()});
  }
  return balls;
}

Clearance::Clearance(const Model& model, const WorldConfig& config)
    : above_(model.links.size(), std::numeric_limits<double>::infinity()), ground_(model, config) {
  if (config.loose.empty() && config.robots.empty()) return;
  own_ = balls_of(model);
  for (const OtherRobot& robot : config.robots) robots_.push_back(balls_of(*robot.model));
  for (const LooseBody& body : config.loose) loose_.push_back({body.solid, body.solid_pose});
  nearest_.assign(model.links.size(), std::numeric_limits<double>::infinity());
}

void Clearance::look(const World& world) {
  ground_.clearance(world, above_);
  for (std::size_t i = 0; i < nearest_.size(); ++i) {
    const Ball& ball = own_.links[i];
    if (ball.radius < 0.0) continue;
    const Eigen::Vector3d center = world.link_in_world(static_cast<int>(i)) * ball.center;
    const auto meet = [&](double distance) { nearest_[i] = std::min(nearest_[i], distance - ball.radius); };
    for (std::size_t k = 0; k < loose_.size(); ++k) {
      const Eigen::Isometry3d pose = world.loose(static_cast<int>(k)).pose * loose_[k].in_body;
      meet(distance_to(loose_[k].solid, pose.inverse() * center).value);
    }
    for (std::size_t r = 0; r < robots_.size(); ++r) {
      for (std::size_t l = 0; l < robots_[r].links.size(); ++l) {
        const Ball& of = robots_[r].links[l];
        if (of.radius < 0.0) continue;
        meet((world.robot_link(static_cast<int>(r), static_cast<int>(l)) * of.center - center).norm() - of.radius);
      }
    }
  }
}

}  // namespace twinbus::launcher
