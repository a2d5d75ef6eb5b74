#include "launcher/figures/walk_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/pose_math.h"
#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus::inline launcher {

namespace {

constexpr double kLoaded = 0.05, kLifted = 0.02;  // of the weight: a sole stands; it stands no more
constexpr double kLeadIn = 3.0, kLeadOut = 0.1;   // of a walk, not counted [s]
constexpr int kLowest = -500, kHighest = 500;     // margins kept apart [mm]

constexpr double kLeastTime = 1.0;   // of what is left of a walk, to be judged [s]
constexpr double kOnTheSpot = 0.01;  // [m/s], [rad/s]

bool walks_on_the_spot(const std::array<double, 3>& asked) {
  return std::hypot(asked[0], asked[1], asked[2]) < kOnTheSpot;
}

}  // namespace

WalkFigures::WalkFigures(const Model& model, const Scene& scene)
    : weight_(std::max(1e-9, kGravity * model.total_mass())),
      soles_(model.soles[0].link >= 0 || model.soles[1].link >= 0 ? 2 : 0),
      margins_(static_cast<std::size_t>(kHighest - kLowest + 1), 0) {
  for (const TimedWalk& walk : scene.walks) {
    Stretch stretch;
    stretch.from = walk.at + kLeadIn;
    stretch.until = walk.at + walk.duration - kLeadOut;
    stretch.asked = {static_cast<double>(walk.request.vx), static_cast<double>(walk.request.vy),
                     static_cast<double>(walk.request.wz)};
    stretches_.push_back(stretch);
  }
}

void WalkFigures::add(const SimTruth& truth, Mode mode, const std::array<double, 2>& asked,
                      double time) {
  const double x = truth.base_position[0], y = truth.base_position[1];
  const double yaw = yaw_of(truth.base_attitude);
  if (last_time_ < 0.0) first_ = {x, y};
  const bool walking = mode == Mode::kWalk;
  bool left_landed = false;
  for (std::size_t foot = 0; foot < soles_; ++foot) {
    const auto force = static_cast<double>(truth.foot_force[foot][2]);
    const auto at_x = static_cast<double>(truth.foot_position[foot][0]);
    const auto at_y = static_cast<double>(truth.foot_position[foot][1]);
    Stance& stance = stance_[foot];
    if (force < kLifted * weight_) stance.loaded = false;
    if (force > kLoaded * weight_ && !stance.loaded) {
      stance = {true, at_x, at_y};
      if (walking) ++steps_;
      left_landed = left_landed || foot == 0;
    }
    if (stance.loaded)
      slip_max_ = std::max(slip_max_, std::hypot(at_x - stance.x, at_y - stance.y));
    if (walking) force_square_ += std::pow((force - asked[foot]) / weight_, 2);
  }
  if (walking) {
    ++counted_;
    const double mm = std::floor(1e3 * static_cast<double>(truth.zmp_margin));
    ++margins_[mm > kLowest ? static_cast<std::size_t>(std::min<double>(mm, kHighest) - kLowest) : 0];  // one that is none: the worst
  }
  if (last_time_ >= 0.0) {
    const double turned = std::remainder(yaw - last_[2], 6.283185307179586);
    const double heading = last_[2] + 0.5 * turned;
    const double dx = x - last_[0], dy = y - last_[1];
    for (Stretch& stretch : stretches_) {
      if (!(time >= stretch.from && time < stretch.until)) continue;
      stretch.moved[0] += std::cos(heading) * dx + std::sin(heading) * dy;
      stretch.moved[1] += std::cos(heading) * dy - std::sin(heading) * dx;
      stretch.moved[2] += turned;
      stretch.time += time - last_time_;
      if (!left_landed) continue;
      if (stretch.begun) {
        stretch.whole = stretch.moved;
        stretch.whole_time = stretch.time;
      } else {
        stretch.begun = true;
        stretch.moved = {};
        stretch.time = 0.0;
      }
    }
  }
  last_ = {x, y, yaw};
  last_time_ = time;
}

double WalkFigures::margin_percentile(double share) const {
  std::int64_t left = std::llround(share * static_cast<double>(counted_));
  for (std::size_t i = 0; i < margins_.size(); ++i) {
    left -= margins_[i];
    if (left < 0) return 1e-3 * (static_cast<double>(i) + kLowest);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double WalkFigures::force_error() const {
  if (counted_ == 0) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(force_square_ / static_cast<double>(2 * counted_));
}

double WalkFigures::velocity_error() const {
  double worst = std::numeric_limits<double>::quiet_NaN();
  for (const Stretch& stretch : stretches_) {
    if (!(stretch.time > kLeastTime) || walks_on_the_spot(stretch.asked)) continue;
    const bool whole = stretch.whole_time > 0.0;
    const auto& moved = whole ? stretch.whole : stretch.moved;
    const double seconds = whole ? stretch.whole_time : stretch.time;
    const double x = moved[0] / seconds - stretch.asked[0];
    const double y = moved[1] / seconds - stretch.asked[1];
    const double z = moved[2] / seconds - stretch.asked[2];
    const double speed = std::hypot(stretch.asked[0], stretch.asked[1]);
    double error = 0.0;
    if (speed > 0.0) error = std::hypot(x, y) / speed;
    if (std::abs(stretch.asked[2]) > 0.0)
      error = std::max(error, std::abs(z) / std::abs(stretch.asked[2]));
    if (!(worst >= error)) worst = error;
  }
  return worst;
}

double WalkFigures::travel() const {
  return std::hypot(last_[0] - first_[0], last_[1] - first_[1]);
}

}  // namespace twinbus::launcher
