// The height of the ground that a walking robot goes by: follows the footholds without a jump, critically damped,
//
//     h'' = w^2 (h* - h) - 2 w h'
//
// so that a step up or down costs a smooth push of the legs.

#pragma once

namespace twinbus::inline control {

class GroundFollow {
 public:
  explicit GroundFollow(double rate) noexcept : rate_(rate) {}

  void rest(double height) noexcept {
    height_ = height;
    velocity_ = acceleration_ = 0.0;
  }
  void advance(double wanted, double dt) noexcept {
    acceleration_ = rate_ * (rate_ * (wanted - height_) - 2.0 * velocity_);
    velocity_ += acceleration_ * dt;
    height_ += velocity_ * dt;
  }
  double height() const noexcept { return height_; }              // [m]
  double velocity() const noexcept { return velocity_; }          // [m/s]
  double acceleration() const noexcept { return acceleration_; }  // [m/s^2]

 private:
  double rate_;  // w [1/s]
  double height_ = 0.0, velocity_ = 0.0, acceleration_ = 0.0;
};

}  // namespace twinbus::control
