#include "control/walk/walk_feet.h"

#include <algorithm>
#include <cmath>

#include "robot/dynamics/inverse_dynamics.h"
#include "common/math/pose_math.h"

namespace twinbus::inline control {

namespace {
constexpr double kLoaded = 0.05;  // of the weight: admittance works
constexpr double kWanted = 0.02;  // share of a foot below which it has nothing to admit
constexpr double kQuick = 4.0;    // a foot in the air is corrected fully after a quarter of its way

Eigen::Vector3d in_plan(const Foothold& at) noexcept {
  return {at.position.x(), at.position.y(), at.height};
}

// Of a plane that rises by `gradient` [rad].
Eigen::Vector3d tilt_of(const Eigen::Vector2d& gradient) noexcept {
  return {std::atan(gradient.y()), -std::atan(gradient.x()), 0.0};
}
}  // namespace

WalkFeet::WalkFeet(const Model& model, const WalkFeetGains& gains)
    : gains_(gains), weight_(kGravity * model.total_mass()), apart_({weight_, 1.0}, gains.rattle_force) {
  for (std::size_t f = 0; f < 2; ++f) {
    const Sole& sole = model.soles[f];
    const double half_width = 0.5 * (sole.left + sole.right);
    const double half_length = 0.5 * (sole.front + sole.back);
    feet_[f].stiffness = std::max(1e3, sole.stiffness);
    feet_[f].turning =
        feet_[f].stiffness * Eigen::Vector2d(half_width * half_width, half_length * half_length);
    const Eigen::Vector2d at_edge = weight_ * Eigen::Vector2d(half_width, half_length);
    feet_[f].admits = feet_[f].turning.cwiseMin(at_edge / gains.least_bend);
    feet_[f].filter = RattleFilter(at_edge, gains.rattle_moment);
    feet_[f].centre << 0.5 * (sole.front - sole.back), 0.5 * (sole.left - sole.right);
  }
}

// Four springs at the corners; a load off the centre turns the sole about it.
void WalkFeet::give_way(Foot& foot, const FootLoad& load, double share) noexcept {
  const Eigen::Vector2d about_centre =
      load.moment - load.force * Eigen::Vector2d(foot.centre.y(), -foot.centre.x());
  const Eigen::Vector2d bend = -about_centre.cwiseQuotient(foot.turning);
  const double sink =
      load.force / foot.stiffness - bend.y() * foot.centre.x() + bend.x() * foot.centre.y();
  foot.bend += share * (bend - foot.bend);
  foot.sink += share * (sink - foot.sink);
}

void WalkFeet::start(const WalkPattern& pattern, const std::array<Eigen::Isometry3d, 2>& soles,
                     const std::array<FootLoad, 2>& loads) noexcept {
  lift_ = 0.0;
  apart_.start();
  for (std::size_t f = 0; f < 2; ++f) {
    Foot& foot = feet_[f];
    foot.admitted.setZero();
    foot.filter.start();
    foot.tilt.setZero();
    foot.was_swinging = false;
    give_way(foot, loads[f], 1.0);
    const Foothold& at = pattern.foot(static_cast<int>(f));
    const Eigen::Matrix3d bend = rotation_of({foot.bend.x(), foot.bend.y(), 0.0});
    foot.last = soles[f].translation() + Eigen::Vector3d(0.0, 0.0, foot.sink);
    foot.last_turn = soles[f].linear() * bend.transpose();
    foot.offset = foot.last - in_plan(at);
    foot.offset_turn = rotation_vector(foot.last_turn * at.rotation().transpose());
    compose(f);
  }
}

void WalkFeet::take_over(const WalkPattern& pattern, const std::array<Eigen::Isometry3d, 2>& sent) noexcept {
  for (std::size_t f = 0; f < 2; ++f) {
    Foot& foot = feet_[f];
    const bool swings = pattern.swings(static_cast<int>(f));
    const Foothold& at = swings ? pattern.swing().place() : pattern.foot(static_cast<int>(f));
    const Eigen::Vector2d turn = foot.bend + foot.admitted;
    foot.last_turn = sent[f].linear() * rotation_of({turn.x(), turn.y(), 0.0}).transpose();
    foot.last = sent[f].translation() - Eigen::Vector3d(0.0, 0.0, (f == 0 ? 0.5 : -0.5) * lift_ - foot.sink);
    foot.offset = foot.last - in_plan(at);
    foot.offset_turn = rotation_vector(foot.last_turn * (rotation_of(foot.tilt) * at.rotation()).transpose());
    foot.was_swinging = swings;
    compose(f);
  }
}

void WalkFeet::compose(std::size_t f) noexcept {
  const Foot& foot = feet_[f];
  const Eigen::Vector2d turn = foot.bend + foot.admitted;
  target_[f].linear() = foot.last_turn * rotation_of({turn.x(), turn.y(), 0.0});
  target_[f].translation() =
      foot.last + Eigen::Vector3d(0.0, 0.0, (f == 0 ? 0.5 : -0.5) * lift_ - foot.sink);
}

void WalkFeet::update(const WalkPattern& pattern, const std::array<FootLoad, 2>& wanted,
                      const std::array<FootLoad, 2>& measured, const std::array<double, 2>& share,
                      const BaseError& base, double dt) noexcept {
  const WalkFeetGains& g = gains_;
  double lift_rate = -lift_ / g.force_leak;
  if (!pattern.single()) {
    const double between = apart_.update({measured[0].force - measured[1].force, 0.0}, true, dt).x();
    lift_rate -= g.force / std::min(feet_[0].stiffness, weight_ / g.least_sink) * (wanted[0].force - wanted[1].force - between);
  }
  lift_ = std::clamp(lift_ + dt * lift_rate, -g.most_lift, g.most_lift);

  const Eigen::Matrix3d to_asked = base.asked.linear() * base.measured.linear().transpose();
  for (std::size_t f = 0; f < 2; ++f) {
    Foot& foot = feet_[f];
    const bool swings = pattern.swings(static_cast<int>(f));
    give_way(foot, wanted[f], dt / (dt + g.filter));
    const bool loaded = measured[f].force > kLoaded * weight_ && share[f] > kWanted;
    const Eigen::Vector2d leak = dt / g.ankle_leak * foot.admitted;
    const Eigen::Vector2d moment = foot.filter.update(measured[f].moment, loaded, dt);
    Eigen::Vector2d turned = -leak;
    if (loaded) turned += dt * g.ankle * (moment - wanted[f].moment).cwiseQuotient(foot.admits);
    foot.admitted = (foot.admitted + turned).cwiseMax(-g.most_turn).cwiseMin(g.most_turn);

    const Foothold& at = swings ? pattern.swing().place() : pattern.foot(static_cast<int>(f));
    const Eigen::Vector3d place = in_plan(at);
    const double blend =
        dt / g.upright_filter * std::min(1.0, kQuick * pattern.swing().progress());
    if (swings) foot.tilt += blend * (tilt_of(pattern.slope().gradient()) - foot.tilt);
    const Eigen::Matrix3d heading = rotation_of(foot.tilt) * at.rotation();
    if (foot.was_swinging && !swings) {  // landed: the command stays where it is
      foot.offset = foot.last - place;
      foot.offset_turn = rotation_vector(foot.last_turn * heading.transpose());
    }
    foot.was_swinging = swings;
    if (swings) {
      const Eigen::Vector3d seen =
          to_asked * (place - base.measured.translation()) + base.asked.translation();
      Eigen::Vector3d turn = rotation_vector(to_asked);
      turn.z() = 0.0;
      foot.offset += blend * (g.upright * (seen - place) - foot.offset);
      foot.offset_turn += blend * (g.upright * turn - foot.offset_turn);
    } else {
      foot.offset *= std::max(0.0, 1.0 - dt / g.landing);
      const double forget = std::max(0.0, 1.0 - dt / g.flat);
      foot.offset_turn.x() *= forget;
      foot.offset_turn.y() *= forget;
      foot.offset_turn.z() *= std::max(0.0, 1.0 - dt / g.landing);
      const Eigen::Vector2d slope = at.turn(leak);
      foot.offset_turn.head<2>() += slope;
    }
    foot.last = place + foot.offset;
    foot.last_turn = rotation_of(foot.offset_turn) * heading;
    compose(f);
  }
}

}  // namespace twinbus::control
