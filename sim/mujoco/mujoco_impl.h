// Inside of MujocoWorld, shared by sim/mujoco/mujoco_*.cpp and nobody else.

#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "sim/mujoco/mjcf_world.h"
#include "sim/mujoco/mujoco_library.h"
#include "sim/mujoco/mujoco_world.h"

namespace twinbus {

// The robot with what the configuration changes of it.
Model changed_by(const Model& nominal, const WorldConfig& config);

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

struct MujocoWorld::Impl {
  Impl(const Model& nominal, const WorldConfig& c)
      : config(c), model(changed_by(nominal, c)), kinematics(model), configuration(model), mujoco(MujocoLibrary::get()) {}
  ~Impl() {
    if (data != nullptr) mujoco.delete_data(data);
    if (scratch != nullptr) mujoco.delete_data(scratch);
    if (simulated != nullptr) mujoco.delete_model(simulated);
  }

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
    return 0.5 * config.backlash * std::clamp(servo.tau / kPlayTorque, -1.0, 1.0);
  }

  WorldConfig config;
  Model model;  // as simulated
  Kinematics kinematics;
  Configuration configuration;
  const MujocoLibrary& mujoco;
  mjModelOpaque* simulated = nullptr;
  mjDataOpaque *data = nullptr, *scratch = nullptr;

  // Places in qpos and qvel.
  struct Place {
    std::size_t q = 0, v = 0;
  };
  Place base;
  std::vector<Place> joints, loose;
  std::vector<int> bodies;                  // of links
  std::vector<MjcfText::Geom> geom_owners;  // by number; link -1: not of the robot
  std::vector<MujocoServo> servos;

  std::vector<double> qpos, qvel, forces, xfrc, warmstart, start_qpos, start_qvel, start_warmstart;
  MujocoLibrary::Armatures armatures;  // of the simulated model
  struct Push {
    int link;
    Eigen::Vector3d point, force;
  };
  std::vector<Push> pushes;
  std::vector<ContactPoint> contacts;
  double elastic = 0.0;  // [J]
  bool frozen = false;
  bool pushed = false;  // forces are set
};

// Of a free joint, as MuJoCo has it: position and quaternion; linear velocity in the world, angular in the body's axes.
void write_mujoco_pose(const Eigen::Isometry3d& pose, double* to) noexcept;
Eigen::Isometry3d read_mujoco_pose(const double* from) noexcept;
void write_mujoco_velocity(const Eigen::Matrix3d& axes, const Eigen::Vector3d& linear, const Eigen::Vector3d& angular,
                           double* to) noexcept;

}  // namespace twinbus
