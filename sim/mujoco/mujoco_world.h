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

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "robot/description/parallel_joints.h"
#include "robot/kinematics/kinematics.h"
#include "sim/mujoco/mjcf_world.h"
#include "sim/mujoco/mujoco_library.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

struct MujocoServo {
  ServoTarget target;
  double limit = 0.0;
  double play = 0.0;  // servo side minus link side [rad]
  double tau = 0.0;
  double rotor = 0.0;    // [kg m^2]
  double damping = 0.0;  // of the joint [N m s/rad]
  bool follows = false;  // another joint
  bool bounded = false;
  double weighed = -1.0;  // armature for which MuJoCo knows how easily bodies are moved

  // Of what damps at the end of a step of length h: kd, and h kp where the spring is too stiff to be that of the start.
  double gain(double h) const noexcept {
    return target.kd + (h * h * target.kp > rotor + h * (target.kd + damping) ? h * target.kp : 0.0);
  }
  // Below its limit.
  double armature(double h) const noexcept { return rotor + h * (damping + (follows ? 0.0 : gain(h))); }
};

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
  void set_corner_offset(int, int, double) noexcept override {}
  double corner_offset(int, int) const noexcept override { return 0.0; }
  // Friction too: MuJoCo solves both at once.
  void estimate_contact_forces() noexcept override;
  Status step() noexcept override;

  const Configuration& configuration() const noexcept override { return configuration_; }
  double encoder(int joint) const noexcept override { return configuration_.q[joint] + servo(joint).play; }
  double tau(int joint) const noexcept override { return servo(joint).tau; }
  Eigen::Isometry3d link_in_world(int link) const noexcept override { return kinematics_.link_in_world(link); }
  Eigen::Vector3d point_velocity(int link, const Eigen::Vector3d& point) const noexcept override {
    return kinematics_.point_velocity(link, point);
  }
  Eigen::Vector3d angular_velocity(int link) const noexcept override { return kinematics_.angular_velocity(link); }
  double mass() const noexcept override { return kinematics_.mass(); }
  Eigen::Vector3d com() const noexcept override { return kinematics_.com(); }
  Eigen::Vector3d com_velocity() const noexcept override { return kinematics_.com_velocity(); }
  const std::vector<ContactPoint>& contacts() const noexcept override { return contacts_; }
  int loose_count() const noexcept override { return static_cast<int>(loose_.size()); }
  LooseState loose(int body) const noexcept override;
  Status set_loose(int body, const LooseState& state) noexcept override;
  Eigen::Isometry3d robot_link(int, int) const noexcept override { return Eigen::Isometry3d::Identity(); }
  Status hold(int, bool) noexcept override { return Status::kWrongSize; }
  double corner_stiffness(int sole) const noexcept override;
  double corner_damping(int sole, double force) const noexcept override;
  double elastic_energy() const noexcept override { return elastic_; }

 private:
  struct Unloaded {};  // with it made, the destructor runs whatever load() throws
  MujocoWorld(const Model& model, const WorldConfig& config, Unloaded);

  const MujocoServo& servo(int joint) const noexcept { return servos_[static_cast<std::size_t>(joint)]; }
  void load();
  void find_places();
  void find_geoms(const std::map<std::string, MjcfText::Geom>& geoms);
  int body_of(int link) const;
  void write_state() noexcept;
  void read_state() noexcept;
  bool sane() const noexcept;
  void weigh() noexcept;
  void drive() noexcept;
  bool read_torques() noexcept;
  bool advance() noexcept;
  void go_back() noexcept;
  void apply_pushes() noexcept;
  void read_contacts() noexcept;
  double flank(const MujocoServo& servo) const noexcept {
    return 0.5 * config_.backlash * std::clamp(servo.tau / kPlayTorque, -1.0, 1.0);
  }

  WorldConfig config_;
  Model model_;  // as simulated
  Kinematics kinematics_;
  Configuration configuration_;
  const MujocoLibrary& mujoco_;
  mjModelOpaque* simulated_ = nullptr;
  mjDataOpaque *data_ = nullptr, *scratch_ = nullptr;

  // Places in qpos and qvel.
  struct Place {
    std::size_t q = 0, v = 0;
  };
  Place base_;
  std::vector<Place> joints_, loose_;
  std::vector<int> bodies_;                  // of links
  std::vector<MjcfText::Geom> geom_owners_;  // by number; link -1: not of the robot
  std::vector<MujocoServo> servos_;
  std::vector<ParallelJoints> pairs_;  // of joints that share motors

  std::vector<double> qpos_, qvel_, forces_, xfrc_, warmstart_, start_qpos_, start_qvel_, start_warmstart_;
  MujocoLibrary::Armatures armatures_;  // of the simulated model
  struct Push {
    int link;
    Eigen::Vector3d point, force;
  };
  std::vector<Push> pushes_;
  std::vector<ContactPoint> contacts_;
  double elastic_ = 0.0;  // [J]
  bool frozen_ = false;
  bool pushed_ = false;  // forces are set
};

// The robot with what the configuration changes of it.
Model changed_by(const Model& nominal, const WorldConfig& config);

// Of a free joint, as MuJoCo has it: position and quaternion; linear velocity in the world, angular in the body's axes.
void write_mujoco_pose(const Eigen::Isometry3d& pose, double* to) noexcept;
Eigen::Isometry3d read_mujoco_pose(const double* from) noexcept;
void write_mujoco_velocity(const Eigen::Matrix3d& axes, const Eigen::Vector3d& linear, const Eigen::Vector3d& angular,
                           double* to) noexcept;

}  // namespace twinbus::sim
