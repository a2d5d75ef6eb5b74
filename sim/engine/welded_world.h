// A world of which less is modelled: joints of the robot that are held for good, further robots as one rigid body each.
// Seen from outside it is the whole world: all links, joints and robots are there.
//
// A held joint stands where set() put it, at rest, whatever its servo is asked; tau() of it is what carried it then.  So does a
// held base, what is held to it pressed as it was then; pushes do nothing to it.

#pragma once

#include <array>
#include <memory>
#include <vector>

#include "sim/world/weld.h"
#include "sim/world/forwarding_world.h"

namespace twinbus::inline sim {

class WeldedWorld final : public ForwardingWorld {
 public:
  // config.held: up to [joint_count + 1 + robots], joints, base, further robots; config.rigid_robots: [robots] or empty.  The model must outlive this.  Throws
  // std::runtime_error as make_world() does, and for a tie both of whose ends would be on one body.
  WeldedWorld(const Model& model, const WorldConfig& config);

  // kOutOfRange, too: the robot cannot be simulated with its joints held there.
  Status set(const Configuration& configuration, const Eigen::VectorXd* tau = nullptr) noexcept override;
  Status set_servo(int joint, const ServoTarget& target) noexcept override;
  Status push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept override;
  void set_corner_offset(int sole, int corner, double offset) noexcept override {
    world_->set_corner_offset(sole, corner, offset);
  }
  void estimate_contact_forces() noexcept override;
  Status step() noexcept override;

  const Configuration& configuration() const noexcept override { return now_; }
  double encoder(int joint) const noexcept override;
  double tau(int joint) const noexcept override;
  Eigen::Isometry3d link_in_world(int link) const noexcept override;
  Eigen::Vector3d point_velocity(int link, const Eigen::Vector3d& point) const noexcept override;
  Eigen::Vector3d angular_velocity(int link) const noexcept override;
  const std::vector<ContactPoint>& contacts() const noexcept override { return contacts_; }
  Status set_loose(int body, const LooseState& state) noexcept override { return world_->set_loose(body, state); }
  Eigen::Isometry3d robot_link(int robot, int link) const noexcept override;
  Status hold(int tie, bool holds) noexcept override { return world_->hold(tie, holds); }

 private:
  const World& shown() const noexcept override { return *world_; }
  void build(const Eigen::VectorXd& q);
  void stand();        // finds what a held base stands on
  void look() noexcept;  // what the engine's world is now
  TieEnd end_of(TieEnd end, const WeldedModel& welded) const;
  bool is_joint(int joint) const noexcept { return joint >= 0 && joint < static_cast<int>(welded_->joint.size()); }
  bool is_link(int link) const noexcept { return link >= 0 && link < static_cast<int>(welded_->link.size()); }

  const Model& model_;
  WorldConfig config_;
  std::vector<bool> held_;
  bool still_ = false;  // the base is held, too
  // Owned by pointer: the engine's world keeps references to the model.
  std::unique_ptr<WeldedModel> welded_;
  std::vector<std::unique_ptr<WeldedModel>> robots_;  // null: as it is
  std::unique_ptr<World> world_;
  Configuration now_, inner_;
  Eigen::VectorXd held_tau_, inner_tau_;
  std::vector<std::array<int, 2>> moving_;  // joints that do, and which of the inner model they are
  std::vector<ContactPoint> contacts_, standing_;  // as this is seen; of the inner world, of a held base
};

}  // namespace twinbus::sim
