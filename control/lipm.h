// Linear inverted pendulum: a walking robot reduced to one equation per axis.
//
// The centre of mass stays at a constant height above the support point and is
// pushed away from the zero-moment point (ZMP):
//
//     x'' = omega^2 (x - zmp),     omega^2 = g / height
//
// This is eq. (2) of the OpenHRP paper with ankle torque u_p = -m g zmp.  The two
// horizontal axes obey it independently, so one state type serves both.

#pragma once

namespace twinbus {

// One horizontal axis, measured from the support point.
struct LipmState {
  double position = 0.0;  // centre of mass [m]
  double velocity = 0.0;  // [m/s]
};

class Lipm {
 public:
  // height: centre of mass above the support point [m].
  // Throws std::invalid_argument unless height is finite and positive.
  explicit Lipm(double height);

  // Natural frequency [rad/s].
  double omega() const noexcept { return omega_; }

  // State dt seconds later with the ZMP held at zmp [m].  Exact for any dt.
  LipmState advance(const LipmState& state, double zmp, double dt) const noexcept;

  // Where a foot placed now would bring the robot to rest [m].
  double capture_point(const LipmState& state) const noexcept;

  // ZMP [m] that moves the capture point to target [m] in dt seconds, dt > 0.
  double zmp_to_reach(double target, const LipmState& state, double dt) const noexcept;

 private:
  double omega_;
};

}  // namespace twinbus
