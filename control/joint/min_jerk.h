// One coordinate on its way to a place of rest: the quintic that leaves with the present position,
// velocity and acceleration and arrives with none of the last two.  Re-aimed at any instant it
// stays smooth.

#pragma once

#include <algorithm>

namespace twinbus::inline control {

class MinJerk {
 public:
  // Rests at position.
  void rest(double position) noexcept {
    *this = MinJerk{};
    position_ = end_ = position;
  }

  // From where it is now to target in duration seconds (at least one millisecond).
  void aim(double target, double duration) noexcept {
    aim_from(position_, velocity_, acceleration_, target, duration);
  }

  void aim_from(double position, double velocity, double acceleration, double target,
                double duration) noexcept {
    const double t = std::max(1e-3, duration);
    const double d = target - position;
    c_ = {position,
          velocity,
          0.5 * acceleration,
          (10.0 * d - 6.0 * velocity * t - 1.5 * acceleration * t * t) / (t * t * t),
          (-15.0 * d + 8.0 * velocity * t + 1.5 * acceleration * t * t) / (t * t * t * t),
          (6.0 * d - 3.0 * velocity * t - 0.5 * acceleration * t * t) / (t * t * t * t * t)};
    end_ = target;
    duration_ = t;
    time_ = 0.0;
    moving_ = true;
    evaluate();
  }

  void advance(double dt) noexcept {
    if (!moving_) return;
    time_ += dt;
    if (time_ >= duration_) {
      rest(end_);
    } else {
      evaluate();
    }
  }

  double position() const noexcept { return position_; }
  double velocity() const noexcept { return velocity_; }
  double acceleration() const noexcept { return acceleration_; }
  double target() const noexcept { return end_; }
  double time_left() const noexcept { return moving_ ? duration_ - time_ : 0.0; }  // [s]
  bool moving() const noexcept { return moving_; }

 private:
  struct Coefficients {
    double c0 = 0.0, c1 = 0.0, c2 = 0.0, c3 = 0.0, c4 = 0.0, c5 = 0.0;
  };
  void evaluate() noexcept {
    const double t = time_;
    position_ = c_.c0 + t * (c_.c1 + t * (c_.c2 + t * (c_.c3 + t * (c_.c4 + t * c_.c5))));
    velocity_ = c_.c1 + t * (2.0 * c_.c2 + t * (3.0 * c_.c3 + t * (4.0 * c_.c4 + t * 5.0 * c_.c5)));
    acceleration_ = 2.0 * c_.c2 + t * (6.0 * c_.c3 + t * (12.0 * c_.c4 + t * 20.0 * c_.c5));
  }

  Coefficients c_;
  double time_ = 0.0, duration_ = 0.0, end_ = 0.0;
  double position_ = 0.0, velocity_ = 0.0, acceleration_ = 0.0;
  bool moving_ = false;
};

}  // namespace twinbus::control
