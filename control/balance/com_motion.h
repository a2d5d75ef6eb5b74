// Where the centre of mass is asked to be while standing: home, plus sway or squat on command, plus
// a lean by hand.
//
//     sway:   y = a(t) sin(phase)                 (x instead of y when the amplitude asked is
//     negative) squat:  z = -a(t) (1 - cos(phase))          never above home: a straight knee has
//     no inverse
//
// a(t) and the frequency move smoothly, so any request at any time is followed without a jump in
// position or velocity.

#pragma once

#include <Eigen/Core>
#include <array>

#include "control/joint/min_jerk.h"
#include "lcmtypes/msg/messages.h"

namespace twinbus::inline control {

class ComMotion {
 public:
  // Home in the ground frame [m]; the present position and velocity are where the way home begins.
  void start(const Eigen::Vector3d& home, const Eigen::Vector3d& position,
             const Eigen::Vector3d& velocity, double duration) noexcept;
  // amplitude [m], frequency [Hz]; numbers that make no sense are cut to sensible ones.
  void request(Motion motion, double amplitude, double frequency) noexcept;
  // What becomes of an amplitude that is asked for [m].
  static double possible(double amplitude, double frequency) noexcept;
  // Ends the motion as fast as is smooth.
  void stop(double duration) noexcept;
  // Lean away from home [m], followed with a bounded speed and a smooth lag.
  void lean(const Eigen::Vector3d& offset) noexcept { lean_target_ = offset; }

  // A way besides all that, from home, given anew for every advance; who stops giving it is led back smoothly.
  void follow(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity,
              const Eigen::Vector3d& acceleration) noexcept {
    given_ = position;
    given_rate_ = velocity;
    given_acceleration_ = acceleration;
    is_given_ = true;
  }

  void advance(double dt) noexcept;

  const Eigen::Vector3d& position() const noexcept { return position_; }
  const Eigen::Vector3d& velocity() const noexcept { return velocity_; }
  const Eigen::Vector3d& acceleration() const noexcept { return acceleration_; }
  Motion motion() const noexcept { return motion_; }
  bool resting() const noexcept;

 private:
  void evaluate() noexcept;
  void lead_back(double dt) noexcept;

  Motion motion_ = Motion::kNone, next_motion_ = Motion::kNone;
  double next_amplitude_ = 0.0, next_frequency_ = 0.0;
  bool forward_ = false, next_forward_ = false;
  double phase_ = 0.0;
  MinJerk amplitude_, frequency_;
  MinJerk way_x_, way_y_, way_z_;
  Eigen::Vector3d lean_ = Eigen::Vector3d::Zero(), lean_rate_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d lean_target_ = Eigen::Vector3d::Zero(), lean_wanted_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d lean_acceleration_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d given_ = Eigen::Vector3d::Zero(), given_rate_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d given_acceleration_ = Eigen::Vector3d::Zero();
  std::array<MinJerk, 3> back_;
  bool is_given_ = false, was_given_ = false;
  Eigen::Vector3d position_ = Eigen::Vector3d::Zero(), velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration_ = Eigen::Vector3d::Zero();
};

}  // namespace twinbus::control
