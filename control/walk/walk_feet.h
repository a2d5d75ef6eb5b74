// What pose of each sole to ask of position servos so that the ground carries what was shared.
//
// A loaded sole gives way: it sinks by f/k and turns by M/k_turn, so the pose asked for is the one that it will have
// (feed-forward).  What is still missed moves it on (admittance), a = w (M - M*) / k_turn - a / T, likewise the difference
// of the feet's forces moves them apart in height.  A foot in the air is put where it must be in the world although the
// base is not where the plan has it, tilted as the ground is believed to be there; one that landed elsewhere than planned
// stays there and is taken into the plan.  What a standing sole had to turn is the slope of its ground, and is kept while
// it stands.

#pragma once

#include <Eigen/Geometry>
#include <array>

#include "control/legs/foot_compliance.h"
#include "control/walk/rattle_filter.h"
#include "control/walk/walk_gains.h"
#include "control/walk/walk_pattern.h"
#include "robot/description/model.h"

namespace twinbus::inline control {

// Where the base is asked to be and where it is, world.
struct BaseError {
  Eigen::Isometry3d asked = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d measured = Eigen::Isometry3d::Identity();
};

class WalkFeet {
 public:
  WalkFeet(const Model& model, const WalkFeetGains& gains);

  // soles: as they are, world; loads: as measured, sole axes.
  void start(const WalkPattern& pattern, const std::array<Eigen::Isometry3d, 2>& soles,
             const std::array<FootLoad, 2>& loads) noexcept;
  // wanted, measured: moments about the sole frames, in their axes; share: of the load that a foot is to carry.
  void update(const WalkPattern& pattern, const std::array<FootLoad, 2>& wanted,
              const std::array<FootLoad, 2>& measured, const std::array<double, 2>& share,
              const BaseError& base, double dt) noexcept;

  // Soles were sent elsewhere meanwhile: they stay there, and come into the plan as after a landing.
  void take_over(const WalkPattern& pattern, const std::array<Eigen::Isometry3d, 2>& sent) noexcept;

  const std::array<Eigen::Isometry3d, 2>& target() const noexcept { return target_; }

 private:
  struct Foot {
    Eigen::Vector2d turning = Eigen::Vector2d::Ones();   // stiffness, roll and pitch [N m/rad]
    Eigen::Vector2d admits = Eigen::Vector2d::Ones();    // the same, as the admittance takes it [N m/rad]
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();    // of the sole, in its frame [m]
    double stiffness = 1.0;                              // [N/m]
    RattleFilter filter;                                 // of its moment
    Eigen::Vector2d bend = Eigen::Vector2d::Zero();      // feed-forward: roll, pitch [rad]
    double sink = 0.0;                                   // feed-forward [m]
    Eigen::Vector2d admitted = Eigen::Vector2d::Zero();  // [rad]
    Eigen::Vector3d offset = Eigen::Vector3d::Zero(), offset_turn = Eigen::Vector3d::Zero();
    Eigen::Vector3d last = Eigen::Vector3d::Zero();
    Eigen::Matrix3d last_turn = Eigen::Matrix3d::Identity();
    Eigen::Vector3d tilt = Eigen::Vector3d::Zero();  // that it landed with [rad]
    bool was_swinging = false;
  };
  void give_way(Foot& foot, const FootLoad& load, double share) noexcept;
  void compose(std::size_t f) noexcept;

  WalkFeetGains gains_;
  double weight_;       // [N]
  RattleFilter apart_;  // of the difference of the feet's forces
  double lift_ = 0.0;   // of the left foot over the right one [m]
  std::array<Foot, 2> feet_;
  std::array<Eigen::Isometry3d, 2> target_;
};

}  // namespace twinbus::control
