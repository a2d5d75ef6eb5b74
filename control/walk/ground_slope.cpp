#include "control/walk/ground_slope.h"

namespace twinbus::inline control {

namespace {
constexpr double kLearns = 0.5;     // g
constexpr double kSteepest = 0.25;  // that is taken for ground to walk on
constexpr double kForgets = 0.3;    // share of an error that a step replaces
constexpr double kBetter = 0.35;    // of the squares: then it is believed
constexpr double kNoBetter = 0.8;   // then no longer
constexpr double kUneven = 0.025;   // errors of level ground below this need no slope
}  // namespace

void GroundSlope::stood_on(const Eigen::Vector2d& gradient) noexcept {
  level_error_ += kForgets * (gradient.squaredNorm() - level_error_);
  slope_error_ += kForgets * ((gradient - found_).squaredNorm() - slope_error_);
  found_ += kLearns * (gradient - found_);
  if (found_.norm() > kSteepest) found_ *= kSteepest / found_.norm();
  const double share = believed_ ? kNoBetter : kBetter;
  believed_ = level_error_ > kUneven * kUneven && slope_error_ < share * level_error_;

}

}  // namespace twinbus::control
