// The simulated world, integrated by Open Dynamics Engine.
//
// Nothing stiff is applied as a force: servo, rotor inertia and ground are rows of ODE's own solve,
// which makes each of them exactly backward Euler.  With A the solved system, a row with
// constraint-force mixing c and target v obeys
//
//     J qd+ + c lambda = v ,  |lambda| <= limit
//
// so c = 1 / (h kp + kd) and v = c (kp (q_ref - q) + kd qd_ref + tau_ff) give
//
//     lambda = kp (q_ref - q - h qd+) + kd (qd_ref - qd+) + tau_ff          the servo at the end of
//     the step
//
// and c = h / J, v = qd gives lambda = -J (qd+ - qd) / h, the reflected rotor inertia J (exact too,
// and added to the same row while the servo is below its limit).  The mechanical stop keeps a row
// of its own.
//
// The world never hands ODE a number that is not finite, and never lets ODE end the process: what
// goes wrong freezes the world and is returned as Status::kDiverged.

#pragma once

#include <memory>
#include <vector>

#include "sim/world/world.h"

namespace twinbus {

class OdeWorld final : public World {
 public:
  // Throws std::runtime_error as make_world() says.
  OdeWorld(const Model& model, const WorldConfig& config);
  ~OdeWorld() override;

  Status set(const Configuration& configuration,
             const Eigen::VectorXd* tau = nullptr) noexcept override;
  Status set_servo(int joint, const ServoTarget& target) noexcept override;
  Status push(int link, const Eigen::Vector3d& point,
              const Eigen::Vector3d& force) noexcept override;
  void set_corner_offset(int sole, int corner, double offset) noexcept override;
  double corner_offset(int sole, int corner) const noexcept override;
  void estimate_contact_forces() noexcept override;
  Status step() noexcept override;

  const Configuration& configuration() const noexcept override;
  double encoder(int joint) const noexcept override;
  double tau(int joint) const noexcept override;
  Eigen::Isometry3d link_in_world(int link) const noexcept override;
  Eigen::Vector3d point_velocity(int link, const Eigen::Vector3d& point) const noexcept override;
  Eigen::Vector3d angular_velocity(int link) const noexcept override;
  double mass() const noexcept override;
  Eigen::Vector3d com() const noexcept override;
  Eigen::Vector3d com_velocity() const noexcept override;
  const std::vector<ContactPoint>& contacts() const noexcept override;
  int loose_count() const noexcept override;
  LooseState loose(int body) const noexcept override;
  Status set_loose(int body, const LooseState& state) noexcept override;
  Eigen::Isometry3d robot_link(int robot, int link) const noexcept override;
  Status hold(int tie, bool holds) noexcept override;
  double corner_stiffness(int sole) const noexcept override;
  double corner_damping(int sole, double force) const noexcept override;
  double elastic_energy() const noexcept override;

  // Complaints of ODE since the program started, of all worlds.
  static long engine_messages() noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus
