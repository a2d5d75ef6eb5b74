// When which foot of a trot, or of two feet that step in turn, is in the air, and where it comes down.
//
// Diagonal pairs step in turn; between two steps all four feet stand.  A foot of four comes down (Raibert, 1986) where, seen from
// the hip, half of the way of a stance and the capture point say:
//
//     p = hip + v_asked T_stance / 2 + (v - v_asked) / omega,      omega = sqrt(g / h)
//
// One of two, T after the other one, comes down where the capture point xi will be then, less what lets it go on as asked with
// feet W apart (Khadiv et al., Walking control based on step timing adaptation, T-RO 2020):
//
//     p = xi(T) - (vx T / (E - 1), vy T / (E - 1) -+ W / (E + 1)),      E = exp(omega T),      xi(t) = p_0 + (xi - p_0) exp(omega t)
//
// The period is that of a pendulum as long as the robot is high, times a constant.

#pragma once

#include <cmath>

#include "control/point_feet/point_feet_body.h"

namespace twinbus {

class StepGait {
 public:
  explicit StepGait(const PointFeetBody& body) noexcept;

  double omega() const noexcept { return omega_; }  // [1/s]
  double period() const noexcept { return period_; }
  double stance_time() const noexcept { return kDuty * period_; }
  double swing_time() const noexcept { return (1.0 - kDuty) * period_; }
  // From one foot's being put down to the other's, and how much of it is left while `leg` is in the air; the load changes in the
  // middle of the time when both stand [s].
  double step_time() const noexcept { return 0.5 * period_; }
  double until_load(int leg) const noexcept { return (1.0 - swing_done(leg)) * swing_time() + 0.5 * (kDuty - 0.5) * period_; }
  // Of the capture point from the foot that stands, in shares of the way between two feet, as a step begins.
  double inward() const noexcept { return 1.0 / (1.0 + std::exp(omega_ * step_time())); }
  // Of a foot of two from where the capture point will be, in the heading, velocity asked for; width: between the feet.
  Eigen::Vector2d from_capture_point(int leg, const Eigen::Vector2d& velocity, double width) const noexcept;
  double lift() const noexcept { return lift_; }            // of a foot [m]
  const Eigen::Vector3d& most_velocity() const noexcept { return most_; }  // vx, vy, wz, each alone
  // Of what is asked, all at once: within an ellipsoid of these.
  Eigen::Vector3d possible(const Eigen::Vector3d& velocity) const noexcept;
  // Lowers them, of a robot whose robot.yaml says how fast it walks forward; 0: it does not [m/s].
  void limit(double fastest) noexcept;
  double farthest() const noexcept { return farthest_; }    // of a foothold from below its hip [m]

  bool steps() const noexcept { return steps_; }
  // The pair of that leg is in the air first.
  void begin(int leg = 0) noexcept;
  // Stops as soon as all feet stand.
  void end() noexcept { ends_ = true; }
  void go_on() noexcept { ends_ = false; }
  bool ends() const noexcept { return ends_; }
  void rest() noexcept { steps_ = ends_ = false; }
  void advance(double dt) noexcept;

  bool swings(int leg) const noexcept;
  double swing_done(int leg) const noexcept;   // 0 to 1, of a foot in the air
  double stance_done(int leg) const noexcept;  // 0 to 1, of one that stands
  int periods() const noexcept { return periods_; }  // begun since begin()

 private:
  static constexpr double kDuty = 0.58;
  double phase_of(int leg) const noexcept;

  double omega_, period_, lift_, farthest_;
  Eigen::Vector3d most_;
  bool steps_ = false, ends_ = false;
  double phase_ = 0.0;
  int periods_ = 0;
};

}  // namespace twinbus
