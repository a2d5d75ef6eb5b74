// A world with a twin of twice its step beside it: what the two do not agree on is doubted (Doubt::kCoarse), in that step.
// Compared are the centres of mass of links and loose bodies: the origin of a link that hangs on the wall never moves.
//
// Of a method of order 1 the distance of the two is the error of the finer one, of order 2 three times that: dynamics that magnify
// an error magnify it in the twin as well.  It costs half as much again.  A controller that looks at one of them would drive the
// other where it should not go: once a servo is given another target, nothing more is said and the twin stands still.

#pragma once

#include <memory>
#include <vector>

#include "sim/world/world.h"

namespace twinbus {

class TwinnedWorld final : public World {
 public:
  static constexpr double kApart = 2.5e-3;  // beyond it a step is doubted [m]

  // The model must outlive this.  Throws std::runtime_error as make_world() does.
  TwinnedWorld(const Model& model, const WorldConfig& config);

  Status set(const Configuration& configuration, const Eigen::VectorXd* tau = nullptr) noexcept override;
  Status set_servo(int joint, const ServoTarget& target) noexcept override;
  Status push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept override;
  void set_corner_offset(int sole, int corner, double offset) noexcept override;
  double corner_offset(int sole, int corner) const noexcept override { return world_->corner_offset(sole, corner); }
  void estimate_contact_forces() noexcept override { world_->estimate_contact_forces(); }
  Status step() noexcept override;

  const Configuration& configuration() const noexcept override { return world_->configuration(); }
  double encoder(int joint) const noexcept override { return world_->encoder(joint); }
  double tau(int joint) const noexcept override { return world_->tau(joint); }
  Eigen::Isometry3d link_in_world(int link) const noexcept override { return world_->link_in_world(link); }
  Eigen::Vector3d point_velocity(int link, const Eigen::Vector3d& point) const noexcept override {
    return world_->point_velocity(link, point);
  }
  Eigen::Vector3d angular_velocity(int link) const noexcept override { return world_->angular_velocity(link); }
  double mass() const noexcept override { return world_->mass(); }
  Eigen::Vector3d com() const noexcept override { return world_->com(); }
  Eigen::Vector3d com_velocity() const noexcept override { return world_->com_velocity(); }
  const std::vector<ContactPoint>& contacts() const noexcept override { return world_->contacts(); }
  int loose_count() const noexcept override { return world_->loose_count(); }
  LooseState loose(int body) const noexcept override { return world_->loose(body); }
  Status set_loose(int body, const LooseState& state) noexcept override;
  Eigen::Isometry3d robot_link(int robot, int link) const noexcept override { return world_->robot_link(robot, link); }
  Status hold(int tie, bool holds) noexcept override;
  double corner_stiffness(int sole) const noexcept override { return world_->corner_stiffness(sole); }
  double corner_damping(int sole, double force) const noexcept override { return world_->corner_damping(sole, force); }
  double elastic_energy() const noexcept override { return world_->elastic_energy(); }

 private:
  struct Point {
    Eigen::Vector3d place, velocity;
  };
  void look(const World& world, std::vector<Point>& points) const noexcept;
  double apart() const noexcept;

  std::unique_ptr<World> world_, twin_;
  std::vector<Eigen::Vector3d> coms_;           // of links, in the link's axes
  double step_;                                 // of the world [s]
  std::vector<Point> before_, after_, points_;  // the twin's at both ends of its step, the world's
  std::vector<ServoTarget> targets_;
  bool halfway_ = false;  // of the twin's step
  bool stepped_ = false;  // since set()
  bool watched_ = true;
};

}  // namespace twinbus
