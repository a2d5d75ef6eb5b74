#include "control/walk/swing_foot.h"

#include <algorithm>

#include "common/math/pose_math.h"

namespace twinbus::inline control {

namespace {
constexpr double kAtRest = 0.03;  // from when on before the end nothing moves sideways [s]
}

void SwingFoot::start(const Foothold& from) noexcept {
  place_ = from;
  velocity_.setZero();
  acceleration_.setZero();
  from_height_ = aim_ = from.height;
  progress_ = search_ = 0.0;
}

void SwingFoot::advance(const Foothold& target, double left, double lift, double dt) noexcept {
  aim_ = target.height;
  if (progress_ >= 1.0 || !(left > dt)) {
    if (progress_ >= 1.0) {
      search_ = std::min(gains_.search, search_ + gains_.rush * dt);
      place_.height -= search_ * dt;
    }
    progress_ = 1.0;
    velocity_.setZero();
    acceleration_.setZero();
    return;
  }
  progress_ += (1.0 - progress_) * dt / left;
  const double t = left - gains_.early;
  if (t > kAtRest) {  // the first jerk of the quintic from here to rest at the target
    const Eigen::Vector2d way = target.position - place_.position;
    const Eigen::Vector2d jerk =
        60.0 / (t * t * t) * way - 36.0 / (t * t) * velocity_ - 9.0 / t * acceleration_;
    acceleration_ += jerk * dt;
    velocity_ += acceleration_ * dt;
    place_.position += velocity_ * dt;
    const double turn = wrap_angle(target.yaw() - place_.yaw());
    place_.set_yaw(place_.yaw() + turn * std::min(1.0, 3.0 * dt / (t + dt)));
  } else {
    velocity_.setZero();
    acceleration_.setZero();
  }
  const double s = progress_, arc = s * (1.0 - s);
  const double blend = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
  place_.height =
      from_height_ + (aim_ - gains_.below - from_height_) * blend + lift * 16.0 * arc * arc;
}

}  // namespace twinbus::control
