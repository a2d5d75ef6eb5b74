#include "control/walk/rattle_filter.h"

#include <algorithm>
#include <cmath>

namespace twinbus::inline control {

namespace {
constexpr double kMean = 0.1;     // in which jumps are averaged [s]
constexpr double kRattles = 0.4;  // from then on it is filtered
}  // namespace

Eigen::Vector2d RattleFilter::update(const Eigen::Vector2d& measured, bool loaded, double dt) noexcept {
  Eigen::Vector2d jump = Eigen::Vector2d::Zero();
  if (loaded && was_loaded_) jump = (measured - last_).cwiseQuotient(largest_);
  const double to_and_fro = -jump.dot(jump_);
  rattle_ += dt / kMean * (std::sqrt(std::max(0.0, to_and_fro)) - rattle_);
  filters_ = filters_ || rattle_ > kRattles;
  late_ += (filters_ && was_loaded_ ? dt / (dt + time_) : 1.0) * (measured - late_);
  jump_ = jump;
  last_ = measured;
  was_loaded_ = loaded;
  return filters_ ? late_ : measured;
}

}  // namespace twinbus::control
