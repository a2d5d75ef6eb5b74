// When which foot of a trot, of a crawl, or of two feet that step in turn, is in the air, and where it comes down.
//
// Trot: diagonal pairs step in turn; between two steps all four feet stand.  A foot of four comes down (Raibert, 1986) where, seen from
// the hip, half of the way of a stance and the capture point say:
//
//     p = hip + v_asked T_stance / 2 + (v - v_asked) / omega,      omega = sqrt(g / h)
//
// Crawl: one foot at a time, hind left, front left, hind right, front right, and backwards the front one of a side first; before each
// all four stand while the weight shifts (crawl_pattern).
//
// One of two, T after the other one, comes down where the capture point xi will be then, less what lets it go on as asked with
// feet W apart (Khadiv et al., Walking control based on step timing adaptation, T-RO 2020):
//
//     p = xi(T) - (vx T / (E - 1), vy T / (E - 1) -+ W / (E + 1)),      E = exp(omega T),      xi(t) = p_0 + (xi - p_0) exp(omega t)
//
// The period is that of a pendulum as long as the robot is high, times a constant.

#pragma once

#include <array>
#include <cmath>

#include "control/point_feet/point_feet_body.h"
#include "robot/description/walking_config.h"

namespace twinbus::inline control {

class StepGait {
 public:
  // Two feet step in turn, whatever is asked.
  explicit StepGait(const PointFeetBody& body, PointGait wanted = PointGait::kTrot) noexcept;

  double omega() const noexcept { return omega_; }  // [1/s]
  double period() const noexcept { return crawls_ ? kCrawlPeriods * period_ : period_; }
  double stance_time() const noexcept { return stance_share() * period(); }
  double swing_time() const noexcept { return swing_share() * period(); }
  // From one foot's being put down to the other's, and how much of it is left while `leg` is in the air; the load changes in the
  // middle of the time when both stand [s].
  double step_time() const noexcept { return 0.5 * period_; }
  double until_load(int leg) const noexcept { return (1.0 - swing_done(leg)) * swing_time() + 0.5 * (kDuty - 0.5) * period_; }
  // Of the capture point from the foot that stands, in shares of the way between two feet, as a step begins.
  double inward() const noexcept { return 1.0 / (1.0 + std::exp(omega_ * step_time())); }
  // Of a foot of two from where the capture point will be, in the heading, velocity asked for; width: between the feet.
  Eigen::Vector2d from_capture_point(int leg, const Eigen::Vector2d& velocity, double width) const noexcept;
  double lift() const noexcept { return lift_; }            // of a foot [m]
  // vx, vy, wz, each alone; in whichever gait is faster of those wanted.
  const Eigen::Vector3d& most_velocity() const noexcept { return wanted_ == PointGait::kCrawl ? most_crawl_ : most_; }
  // Of what is asked, all at once: within an ellipsoid of these.
  Eigen::Vector3d possible(const Eigen::Vector3d& velocity) const noexcept;
  // Lowers them, of a robot whose robot.yaml says how fast it walks forward; 0: it does not [m/s].
  void limit(double fastest) noexcept;
  double farthest() const noexcept { return farthest_; }    // of a foothold from below its hip [m]

  // Whether it is to crawl at such a velocity; who trots goes on until it is clearly slower.
  bool crawls_at(const Eigen::Vector3d& velocity) const noexcept;
  // Whether a crawl at such a velocity goes backwards; one that does already, until it goes clearly forward.
  bool backwards_at(const Eigen::Vector3d& velocity) const noexcept;

  bool steps() const noexcept { return steps_; }
  bool crawls() const noexcept { return crawls_; }  // now, or the last time that it stepped
  // The pair of that leg is in the air first.
  void begin(int leg = 0) noexcept;
  // One foot at a time, after a shift.
  void begin_crawl(bool backwards) noexcept;
  // A crawl that is being lost becomes a trot at once: the foot in the air stays there, its pair joins it.
  void trot_on() noexcept;
  // Stops as soon as all feet stand.
  void end() noexcept { ends_ = true; }
  void go_on() noexcept { ends_ = false; }
  bool ends() const noexcept { return ends_; }
  void rest() noexcept { steps_ = ends_ = false; }
  // may_lift: whether the next foot of a crawl may leave the ground; until then the weight goes on shifting.
  void advance(double dt, bool may_lift = true) noexcept;

  bool swings(int leg) const noexcept;
  double swing_done(int leg) const noexcept;   // 0 to 1, of a foot in the air
  double stance_done(int leg) const noexcept;  // 0 to 1, of one that stands

  // Of a crawl, whose period has four quarters, each a shift and a step: the leg of a quarter, which one it is, and how long the
  // shift and the step of this one still last [s].
  int leg_of(int quarter) const noexcept { return (backwards_ ? kBackwards : kForward)[static_cast<std::size_t>(quarter % 4)]; }
  bool backwards() const noexcept { return backwards_; }
  int quarter() const noexcept { return static_cast<int>(4.0 * phase_) % 4; }
  double shift_left() const noexcept;
  double step_left() const noexcept;
  double shift_time() const noexcept { return 0.25 * kShift * period(); }

 private:
  static constexpr std::array<int, 4> kForward{2, 0, 3, 1}, kBackwards{0, 2, 1, 3};
  static constexpr double kDuty = 0.58;
  static constexpr double kCrawlPeriods = 4.0;  // of a trot
  static constexpr double kShift = 0.4;         // of a quarter
  double swing_share() const noexcept { return crawls_ ? 0.25 * (1.0 - kShift) : 1.0 - kDuty; }
  double stance_share() const noexcept { return crawls_ ? 1.0 - swing_share() : kDuty; }
  double phase_of(int leg) const noexcept;
  double in_quarter() const noexcept { return 4.0 * phase_ - std::floor(4.0 * phase_); }

  double omega_, period_, lift_, farthest_;
  Eigen::Vector3d most_, most_crawl_;
  PointGait wanted_;
  bool steps_ = false, ends_ = false, crawls_ = false, backwards_ = false;
  double phase_ = 0.0;
};

// As robot.yaml says.  Throws std::runtime_error with one sentence when the robot has no point feet.
StepGait step_gait_of(const Model& model);

}  // namespace twinbus::control
