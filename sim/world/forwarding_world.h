// A world that shows another one: what is asked of it is asked of that.

#pragma once

#include <vector>

#include "sim/world/world.h"

namespace twinbus::inline sim {

class ForwardingWorld : public World {
 public:
  double corner_offset(int sole, int corner) const noexcept override { return shown().corner_offset(sole, corner); }
  const Configuration& configuration() const noexcept override { return shown().configuration(); }
  double encoder(int joint) const noexcept override { return shown().encoder(joint); }
  double tau(int joint) const noexcept override { return shown().tau(joint); }
  double servo_work() const noexcept override { return shown().servo_work(); }
  double work() const noexcept override { return shown().work(); }
  Eigen::Isometry3d link_in_world(int link) const noexcept override { return shown().link_in_world(link); }
  Eigen::Vector3d point_velocity(int link, const Eigen::Vector3d& point) const noexcept override {
    return shown().point_velocity(link, point);
  }
  Eigen::Vector3d angular_velocity(int link) const noexcept override { return shown().angular_velocity(link); }
  double mass() const noexcept override { return shown().mass(); }
  Eigen::Vector3d com() const noexcept override { return shown().com(); }
  Eigen::Vector3d com_velocity() const noexcept override { return shown().com_velocity(); }
  const std::vector<ContactPoint>& contacts() const noexcept override { return shown().contacts(); }
  int loose_count() const noexcept override { return shown().loose_count(); }
  LooseState loose(int body) const noexcept override { return shown().loose(body); }
  bool asleep(int body) const noexcept override { return shown().asleep(body); }
  Eigen::Isometry3d robot_link(int robot, int link) const noexcept override { return shown().robot_link(robot, link); }
  double corner_stiffness(int sole) const noexcept override { return shown().corner_stiffness(sole); }
  double corner_damping(int sole, double force) const noexcept override { return shown().corner_damping(sole, force); }
  double elastic_energy() const noexcept override { return shown().elastic_energy(); }

 protected:
  virtual const World& shown() const noexcept = 0;
};

}  // namespace twinbus::sim
