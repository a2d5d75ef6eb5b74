// Linear inverted pendulum: a walking robot reduced to one equation per axis.
//
// The centre of mass stays on a constraint plane over the support point and is
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

// What a pendulum may move on, measured from the support point: z = kx x + ky y + zc.
//
// The leg pushes along (x, y, z) with f a metre, so x'' = f x / m and z'' = f z / m - g; on the plane z'' = kx x'' + ky y''.
// Together f (z - kx x - ky y) = m g, and with z - kx x - ky y = zc:  x'' = (g / zc) x,  whatever the slope.
struct ConstraintPlane {
  double kx = 0.0, ky = 0.0;
  double zc = 0.7;  // [m]

  double height(double x, double y) const noexcept { return kx * x + ky * y + zc; }
};

class Lipm {
 public:
  // height: centre of mass above the support point [m].
  // Throws std::invalid_argument unless height is finite and positive.
  explicit Lipm(double height);
  // The slope changes nothing but the height.
  explicit Lipm(const ConstraintPlane& plane) : Lipm(plane.zc) {}

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
