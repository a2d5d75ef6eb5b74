// Whether loose bodies keep or gain energy, and whether those that nothing turns keep their momentum.

#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/scene/scene.h"
#include "sim/world/world.h"

namespace twinbus::inline launcher {

class LooseWatch {
 public:
  explicit LooseWatch(const Scene& scene);

  // Each tick.
  void add(const World& world);

  bool begun() const { return begun_; }
  double first() const { return first_; }  // energy of all [J]
  double drift() const { return drift_; }  // the most that it was off the first [J]
  double gain() const { return gain_; }    // the most that it was above the first [J]

  struct Spin {
    int body;
    double first_energy = 0.0;                                 // of turning [J]
    Eigen::Vector3d first_momentum = Eigen::Vector3d::Zero();  // angular, in world
    double energy_drift = 0.0, momentum_drift = 0.0;           // most so far, relative
    int middle = 1;                                            // axis of the middle inertia
    double side = 0.0;                                         // along which it turned last, +-1
    int flips = 0;                                             // how often that changed
  };
  // As Criteria::spins.
  const std::vector<Spin>& spins() const { return spins_; }

 private:
  std::vector<double> mass_;              // [kg]
  std::vector<Eigen::Matrix3d> inertia_;  // the body's axes [kg m^2]
  std::vector<Spin> spins_;
  bool begun_ = false;
  double first_ = 0.0, drift_ = 0.0, gain_ = 0.0;
};

}  // namespace twinbus::launcher
