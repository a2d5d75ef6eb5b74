#include "control/point_feet/crawl_pattern.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/index.h"

namespace twinbus::inline control {

namespace {
constexpr double kKeep = 0.4;        // of the radius of the circle in a triangle of the nominal stance
constexpr double kMayLift = 0.3;     // of what is kept
constexpr double kFollowZmp = 0.03;  // a triangle that changes while it carries is followed in so long [s]
constexpr int kAhead = 4;            // steps

struct Triangle {
  std::array<Eigen::Vector2d, 3> corner, inward;  // of the side from a corner to the next one
  Eigen::Vector2d centre;                         // of the circle in it
  double radius = 0.0;

  Triangle(const FourPoints& feet, int lifted) noexcept {
    static constexpr std::array<int, 4> kAround{0, 1, 3, 2};
    std::size_t n = 0;
    for (const int leg : kAround) {
      if (leg != lifted) corner[n++] = feet[at(leg)];
    }
    const Eigen::Vector2d a = corner[1] - corner[0], b = corner[2] - corner[0];
    const double area = a.x() * b.y() - a.y() * b.x(), sign = area > 0.0 ? 1.0 : -1.0;
    std::array<double, 3> length{};
    double around = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector2d side = corner[(i + 1) % 3] - corner[i];
      length[i] = std::max(1e-9, side.norm());
      inward[i] = sign / length[i] * Eigen::Vector2d(-side.y(), side.x());
      around += length[i];
    }
    centre = (length[1] * corner[0] + length[2] * corner[1] + length[0] * corner[2]) / around;
    radius = std::abs(area) / around;
  }
  double from_side(std::size_t side, const Eigen::Vector2d& point) const noexcept {
    return inward[side].dot(point - corner[side]);
  }
  double inside(const Eigen::Vector2d& point) const noexcept {
    return std::min({from_side(0, point), from_side(1, point), from_side(2, point)});
  }
};

// Of a capture point, what so long of a zero-moment point that goes from `from` to `to` makes; left: share of it at the beginning.
Eigen::Vector2d share_of(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double omega_time, double& left) noexcept {
  const double end = std::exp(-omega_time), mean = omega_time > 1e-9 ? (1.0 - end) / omega_time : 1.0;
  const Eigen::Vector2d share = left * (from - end * to + mean * (to - from));
  left *= end;
  return share;
}
}  // namespace

double inside_others(const FourPoints& feet, int lifted, const Eigen::Vector2d& point) noexcept {
  return Triangle(feet, lifted).inside(point);
}

Eigen::Vector2d nearest_inside(const FourPoints& feet, int lifted, const Eigen::Vector2d& point, double keep) noexcept {
  const Triangle triangle(feet, lifted);
  keep = std::min(keep, triangle.radius);
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (triangle.from_side(i, point) < triangle.from_side(nearest, point)) nearest = i;
  }
  Eigen::Vector2d inside = point + std::max(0.0, keep - triangle.from_side(nearest, point)) * triangle.inward[nearest];
  // In a corner another side is too near yet: then towards the middle.
  double share = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double missing = keep - triangle.from_side(i, inside);
    if (missing > 0.0) share = std::max(share, missing / (missing + std::max(1e-12, triangle.radius - keep)));
  }
  inside += share * (triangle.centre - inside);
  return inside;
}

CrawlPattern::CrawlPattern(const PointFeetBody& body) noexcept : stance_(body.stance) {
  foothold_.fill(Eigen::Vector2d::Zero());
  keep_ = 0.0;
  if (body.two()) return;
  keep_ = std::numeric_limits<double>::infinity();
  for (int leg = 0; leg < 4; ++leg) keep_ = std::min(keep_, kKeep * Triangle(stance_, leg).radius);
}

void CrawlPattern::start(const Eigen::Vector2d& com, const Eigen::Vector2d& middle) noexcept {
  position_ = zmp_ = com;
  middle_ = middle;
  velocity_.setZero();
  acceleration_.setZero();
}

void CrawlPattern::move(const Eigen::Vector2d& way) noexcept {
  middle_ += way;
  zmp_ += way;
  position_ += way;
}

bool CrawlPattern::may_lift(const StepGait& gait, const FourPoints& feet, const Eigen::Vector2d& com,
                            const Eigen::Vector2d& capture) const noexcept {
  const int leg = gait.leg_of(gait.quarter());
  return std::min(inside_others(feet, leg, com), inside_others(feet, leg, capture)) > kMayLift * keep_;
}

void CrawlPattern::update(const StepGait& gait, const FourPoints& feet, const Eigen::Vector2d& velocity, double yaw,
                          double yaw_rate, double dt) noexcept {
  middle_ += dt * velocity;
  const double omega = gait.omega(), half = 0.5 * gait.stance_time();
  FourPoints ahead = feet;
  double later = 0.0, left = 1.0;
  Eigen::Vector2d capture = Eigen::Vector2d::Zero(), from = zmp_;
  for (int step = 0; step < kAhead; ++step) {
    const int leg = gait.leg_of(gait.quarter() + step);
    const double shift = step == 0 ? gait.shift_left() : gait.shift_time();
    const double swing = step == 0 ? gait.step_left() : gait.swing_time();
    const Eigen::Vector2d target = nearest_inside(ahead, leg, middle_ + (later + shift + 0.5 * swing) * velocity, keep_);
    if (step == 0) {
      const double follow = shift > 0.0 ? dt / std::max(dt, shift) : std::min(1.0, dt / kFollowZmp);
      zmp_ += follow * (target - zmp_);
      from = zmp_;
    }
    capture += share_of(from, target, omega * shift, left);
    capture += share_of(target, target, omega * swing, left);
    from = target;
    later += shift + swing;
    const Eigen::Vector2d own = Eigen::Rotation2Dd(yaw + (later + half) * yaw_rate) * stance_[at(leg)];
    ahead[at(leg)] = middle_ + (later + half) * velocity + own;
    foothold_[at(leg)] = ahead[at(leg)];
  }
  capture += left * from;
  velocity_ = omega * (capture - position_);
  position_ += dt * velocity_;
  acceleration_ = omega * omega * (position_ - zmp_);
}

}  // namespace twinbus::control
