// Whether a world has more energy after a step than before it and than servos and pushes have given.
//
//     gain = kinetic + potential + what springs store, now - before  -  work of servos and pushes
//
// Friction, dampers, stops and backward Euler only take energy: a gain is an error of the step.  The
// work of a servo is its torque times the way of its joint: engine articulated knows it at orders 2 and 3, where a command
// that leaps makes the torque leap within the step; else of the torques before and after whichever gives more.  Of worlds with
// further robots, whose servos nobody sees, nothing is said.

#pragma once

#include <Eigen/Core>
#include <vector>

#include "robot/description/model.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

class EnergyBalance {
 public:
  // The model must outlive this.
  EnergyBalance(const Model& model, const WorldConfig& config);

  // Before the first step, and after every jump.
  void begin(const World& world) noexcept;
  // After a step; pushed: work of pushes in it [J].  True: it is to be doubted.
  bool add(const World& world, double pushed) noexcept;

  // Of all links, then of loose bodies, as of the last call: of their centres of mass, in world, and of links in their own axes
  // too [m/s].  False: nothing is said of this world.
  bool looks() const noexcept { return !silent_; }
  const std::vector<Eigen::Vector3d>& velocities() const noexcept { return velocity_; }
  const std::vector<Eigen::Vector3d>& own_velocities() const noexcept { return own_velocity_; }

  double gain() const noexcept { return gain_; }  // of the last step; below zero: lost [J]

  // The least config.bands with which no step since the world began would have been doubted [J].
  double gain_band() const noexcept { return gain_band_; }
  double rise_band() const noexcept { return rise_band_; }

 private:
  struct Energy {
    double kinetic = 0.0, potential = 0.0, elastic = 0.0;
    double all() const noexcept { return kinetic + potential + elastic; }
  };
  Energy of(const World& world) noexcept;

  const Model& model_;
  bool silent_ = false;
  bool estimated_ = false;  // what contacts store: a gain says nothing then
  double mass_scale_ = 1.0;
  std::vector<Eigen::Matrix3d> loose_inertia_;  // about the centre, the body's axes [kg m^2]
  std::vector<double> loose_mass_;              // [kg]
  Energy before_;
  std::vector<Eigen::Vector3d> velocity_, own_velocity_;
  std::vector<double> q_, tau_;  // of the joints, before
  double gain_ = 0.0;
  double sum_ = 0.0, lowest_ = 0.0;  // of all gains since begin(), and the least it was, or where a rise was said [J]
  double least_ = 0.0;               // and the least it was [J]
  double most_gain_, most_rise_;     // config.bands: what was more than this is doubted [J]
  double gain_band_ = 0.0, rise_band_ = 0.0;
};

}  // namespace twinbus::sim
