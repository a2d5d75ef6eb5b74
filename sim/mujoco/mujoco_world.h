// The simulated world as MuJoCo integrates it: the world in which most learned controllers were trained.
//
// The servo of a joint in a step of length h is MuJoCo's position servo, with the spring of its start and the damper of its end
// (a spring too stiff for that, h kp > kd + rotor / h, is that of the end too, as in the other engines); so is its damping D:
//
//     tau = kp (q_ref - q) + kd (qd_ref - qd+) + tau_ff ,  |tau| <= effort
//
// MuJoCo's implicit integrators solve its contacts before they add dampers, and stiff servos then drag the feet over the
// ground.  Here what multiplies qd+ is an armature, h (kd + D), set anew in each step, and the rest a force: so the
// contacts are solved with it, and MuJoCo is told anew (mj_setConst) how easily its bodies are moved, from which it takes how hard
// contacts are: with what it computed for limp joints stiff feet would bounce.  A step that ends with a servo beyond its limit is repeated with that limit as its torque.
//
// Rotors, friction loss, stops and contacts are MuJoCo's own, with the defaults of its contacts (solref 0.02 1): soft, and
// friction that creeps.  How deep a foot sinks in follows from how easily it is moved (0.4 mm under hrp1s), so stiffness and damping
// of soles are not used.
//
// Not known here, and refused: contacts other than spring_damper and soft (which stand for MuJoCo's own), contact.continuous, orders
// above 1, explicit flight, scales of stiffness and damping, different ground under each sole, loops and grasps, loose meshes,
// further robots.

#pragma once

#include <memory>

#include "sim/world/world.h"

namespace twinbus {

class MujocoWorld final : public World {
 public:
  // The model must outlive this.  Throws std::runtime_error as make_world() says, if there is no MuJoCo (mujoco_library.h), and
  // for what is not known here.
  MujocoWorld(const Model& model, const WorldConfig& config);
  ~MujocoWorld() override;

  Status set(const Configuration& configuration, const Eigen::VectorXd* tau = nullptr) noexcept override;
  Status set_servo(int joint, const ServoTarget& target) noexcept override;
  Status push(int link, const Eigen::Vector3d& point, const Eigen::Vector3d& force) noexcept override;
  // The ground stays where it is: nothing is remembered.
  void set_corner_offset(int sole, int corner, double offset) noexcept override;
  double corner_offset(int sole, int corner) const noexcept override;
  // Friction too: MuJoCo solves both at once.
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

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus
