#include "control/walk/walk_pattern.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/math/pose_math.h"

namespace twinbus::inline control {

namespace {
constexpr double kTooLate = 0.08;     // before touchdown, from when on a step is left alone [s]
constexpr double kObeys = 0.20;       // before touchdown, until when it follows the velocity [s]
constexpr double kShortest = 0.10;    // any step may still last [s]
constexpr double kMoved = 0.03;       // a step moved farther is a recovery [m]
constexpr double kEarlyShare = 0.6;   // of the swing, from when on touching counts as landing
constexpr double kLeast = 0.01;       // a piece of the plan [s]
constexpr double kRestMargin = 0.03;  // kept from the edges by where the ZMP comes to rest [m]
constexpr double kUncaught =
    0.02;  // farther from there a robot is not caught by standing still [m]
constexpr double kRestRate = 0.15;  // from there to the middle of the feet [m/s]
constexpr double kRestTime = 0.06;  // least time in which the ZMP goes there [s]
constexpr double kHalfWay = 0.5;    // of a swing, from when on the next step brakes
constexpr int kSpeeds = 4;           // tried between two, beside the first
constexpr double kHaltTime = 0.10;  // from the fastest walk to none [s]
constexpr double kStandingStride =
    0.6;  // share of the longest step over which a robot stands still

constexpr int kStepsShorter = 6;          // steps tried, where one that keeps the feet apart is farther than the legs reach,
constexpr double kShorterBy = 0.85;  // each by this share of the last
constexpr double kBeside = 0.015, kParallel = 0.03;  // so nearly feet stand side by side [m], [rad]
constexpr double kForget = 0.8;     // share of an unevenness that the next landing leaves
constexpr double kMostMore = 0.03;  // a foot is lifted more on uneven ground [m]
constexpr double kSmooth = 0.1, kRough = 0.3;  // of the lift: ground on which a robot dares all of its speed, and on which least
constexpr double kDared = 0.45;     // of the fastest walk, there

double way(double from, double to, double most) noexcept {
  return from + std::clamp(to - from, -most, most);
}
}  // namespace

WalkPattern::WalkPattern(const Gait& gait, const SwingGains& swing)
    : gait_(gait), swing_(swing), period_(gait.period()) {
  if (gait.preview) preview_.emplace(gait.com_height);
}

Eigen::Vector2d WalkPattern::middle() const noexcept {
  return 0.5 * (zmp_on(gait_, feet_[0], 0) + zmp_on(gait_, feet_[1], 1));
}

double WalkPattern::heading() const noexcept {
  const double from = single() ? foot(support_).yaw() : feet_[0].yaw();
  const double to = single() ? swing_.place().yaw() : feet_[1].yaw();
  return from + 0.5 * wrap_angle(to - from);
}

Eigen::Vector2d WalkPattern::apart() const noexcept {
  return feet_[0].unturn(feet_[0].position - feet_[1].position);
}

bool WalkPattern::side_by_side() const noexcept {
  const Eigen::Vector2d way = apart();
  const double width = tidy_ ? gait_.standing_width : gait_.width;
  return std::abs(way.x()) < kBeside && std::abs(way.y() - width) < kBeside &&
         std::abs(wrap_angle(feet_[0].yaw() - feet_[1].yaw())) < kParallel;
}

void WalkPattern::start(const std::array<Foothold, 2>& feet) noexcept {
  feet_ = feet;
  slope_.reset();
  rough_.reset();
  wanted_.setZero();
  velocity_.setZero();
  listed_ = list_count_ = 0;
  walking_ = single_ = false;
  steps_ = square_ = 0;
  time_ = single_time_ = 0.0;
  double_ = kLeast;
  period_ = gait_.period();
  since_landing_ = adjusted_ = uneven_ = 0.0;
  squares_ = tidy_ = false;
  halting_ = unforeseen_ = false;
  rest_ = zmp_from_ = zmp_ = dcm_ = middle();
  if (preview_) preview_->rest(rest_);
}

void WalkPattern::want(const Eigen::Vector3d& velocity) noexcept {
  wanted_ = gait_.possible(velocity);
  if (!wants_to_walk()) return;
  halting_ = false;
  squares_ = tidy_ = false;
}

void WalkPattern::halt() noexcept {
  wanted_.setZero();
  squares_ = tidy_ = false;
  listed_ = list_count_ = 0;
  if (halting_ || !walking_) return;
  halting_ = true;
  before_halt_ = velocity_;
  braking_ = !single_ || swing_.progress() < kHalfWay;
}

void WalkPattern::walk_on(const Eigen::Vector2d& measured_dcm, double omega) noexcept {
  if (!walking_ || halting_ || !wants_to_walk() || list_count_ > 0) return;
  const Eigen::Vector3d now = velocity_;
  Eigen::Vector3d best = now;
  double least = 1e9;
  const auto walk_at = [&](const Eigen::Vector3d& velocity) {
    velocity_ = velocity;
    if (!single_ || double_ + single_time_ - time_ >= kObeys) target_ = planned_ = after(foot(support_), support_, 0);
  };
  for (int k = 0; k <= kSpeeds; ++k) {
    walk_at(now + static_cast<double>(k) / kSpeeds * (before_halt_ - now));
    (void)plan_pieces(omega);
    const double error = (dcm_ - measured_dcm).norm();
    if (!(error < least)) continue;
    least = error;
    best = velocity_;
  }
  walk_at(best);
}

void WalkPattern::follow(const Foothold* list, int count, int first_support) noexcept {
  list_count_ = std::clamp(count, 0, kMostFootholds);
  for (int i = 0; i < list_count_; ++i) list_[static_cast<std::size_t>(i)] = list[i];
  listed_ = 0;
  list_support_ = first_support;
}

// As high as the ground is there, as far as that is known.
Foothold WalkPattern::on_ground(Foothold at, const Foothold& from) const noexcept {
  at.height = from.height + slope_.gradient().dot(at.position - from.position);
  return at;
}

// The foothold after `foot` stands on `from`, so many steps from the one under way.
Foothold WalkPattern::after(const Foothold& from, int foot, int steps_ahead) const noexcept {
  const int i = listed_ + steps_ahead;
  const bool fits = ((i % 2 == 0) ? list_support_ : 1 - list_support_) == foot;
  if (i < list_count_ && fits) {
    Foothold listed = list_[static_cast<std::size_t>(i)];
    return on_ground(listed, from);  // a list knows nothing of the ground
  }
  Eigen::Vector3d velocity = velocity_;
  // Feet that stand too near each other come apart before they turn.
  if (steps_ahead == 0 && apart().y() < gait_.min_width) velocity.z() = 0.0;
  // The last two steps share what the stance is narrower or wider.
  double width = std::max(gait_.turning_width(velocity.z() * period_), gait_.width + rough_share() * gait_.rough_wider);
  if (tidy_ && velocity.squaredNorm() < 1e-12) {
    const bool second = square_ + steps_ahead >= 1;
    width += (second ? 1.0 : 0.5) * (gait_.standing_width - width);
  }
  Foothold next;
  for (int tries = 0; tries < kStepsShorter; ++tries, velocity *= kShorterBy) {
    next = kept_apart(gait_, from, foot, next_foothold(from, foot, velocity, period_, width));
    if (gait_.reaches(from, foot, next)) break;
  }
  return on_ground(next, from);
}

void WalkPattern::begin_step(int support, double double_time) noexcept {
  walking_ = true;
  single_ = false;
  zmp_from_ = zmp_;
  support_ = support;
  time_ = 0.0;
  double_ = double_time;
  single_time_ = gait_.single_support;
  adjusted_ = 0.0;
  target_ = planned_ = after(foot(support_), support_, 0);
}

// One foot may carry most of the robot already, as before the other one after a walk was stopped: stepping with that one
// would take away what holds the robot.
void WalkPattern::capture(const Eigen::Vector2d& measured_dcm, double omega) noexcept {
  const bool about_to = walking_ && !single_ && double_ - time_ > gait_.double_support;
  if (walking_ && !about_to) return;
  const double side = feet_[0].unturn(measured_dcm - middle()).y();
  tidy_ = false;
  square_ = 0;
  const Eigen::Vector2d zmp = zmp_;
  int support = side > 0.0 ? 1 : 0;
  double least = 0.0;
  for (const int foot : {support, 1 - support}) {
    zmp_ = zmp;
    begin_step(foot, gait_.hurry);
    (void)plan_pieces(omega);
    const double cost = adjusted_step(measured_dcm, omega).cost;
    if (foot != support && !(cost < least)) continue;
    support = foot;
    least = cost;
  }
  zmp_ = zmp;
  begin_step(support, gait_.hurry);
  unforeseen_ = true;
}

void WalkPattern::land(const Foothold& where, const Foothold& stood) noexcept {
  braking_ = true;
  slope_.stood_on(stood.gradient);
  const int landed = 1 - support_;
  const Foothold& stands = foot(support_);
  uneven_ = std::max(kForget * uneven_, std::abs(where.height - on_ground(where, stands).height));
  // A sole that its ankle cannot turn about both axes does not tell how the ground is.
  const bool tells = !gait_.leans && gait_.sole_low.x() < gait_.sole_high.x();
  rough_.landed({.way = where.position - stands.position,
                 .rise = where.height - stands.height,
                 .landed = where.gradient,
                 .gradient = stood.gradient,
                 .forward = where.turn(Eigen::Vector2d::UnitX()),
                 .toe = tells ? gait_.toe : 0.0,
                 .heel = tells ? gait_.heel : 0.0},
                slope_.gradient());
  feet_[static_cast<std::size_t>(landed)] = where;
  ++steps_;
  if (listed_ < list_count_) ++listed_;
  if (steps_ > 1 && adjusted_ < kMoved) {
    const double lasted = std::clamp(since_landing_, gait_.period(), 1.15 * gait_.period());
    period_ += 0.3 * (lasted - period_);
  }
  since_landing_ = 0.0;
  square_ = wants_to_walk() || velocity_.norm() > 1e-6 ? 0 : square_ + 1;
  if (square_ >= 2) return stand(middle(), gait_.last_double);
  // What a step came early or late is given to the double support, so that the rhythm stays.
  const double rhythm =
      std::max(0.6 * gait_.double_support, gait_.double_support + double_ + single_time_ - time_);
  begin_step(landed, adjusted_ > kMoved ? gait_.hurry : rhythm);
}

void WalkPattern::stand(const Eigen::Vector2d& rest, double time) noexcept {
  walking_ = single_ = halting_ = false;
  velocity_.setZero();
  rest_ = rest;
  zmp_from_ = zmp_;
  time_ = 0.0;
  double_ = time;
}

// The nearest point that both soles together can carry, well inside.
Eigen::Vector2d WalkPattern::on_both_soles(const Eigen::Vector2d& point) const noexcept {
  const std::array<Eigen::Vector2d, 2> on{zmp_on(gait_, feet_[0], 0), zmp_on(gait_, feet_[1], 1)};
  const Eigen::Vector2d line = on[0] - on[1];
  const double left =
      std::clamp((point - on[1]).dot(line) / std::max(1e-6, line.squaredNorm()), 0.0, 1.0);
  const Eigen::Vector2d rest = point - (on[1] + left * line);
  const Eigen::Vector2d quiet(kRestMargin, kRestMargin);
  Eigen::Vector2d carried = Eigen::Vector2d::Zero();
  for (std::size_t f = 0; f < 2; ++f) {
    const Foothold& foot = feet_[f];
    const Eigen::Vector2d in_sole = foot.unturn(on[f] + rest - foot.position)
                                        .cwiseMax(gait_.sole_low + quiet)
                                        .cwiseMin(gait_.sole_high - quiet);
    carried += (f == 0 ? left : 1.0 - left) * (foot.position + foot.turn(in_sole));
  }
  return carried;
}

// While the ZMP p goes to a point r in T and stays, the DCM comes to rest there if it is at
//     xi = p + (r - p) (1 - e^(-omega T)) / (omega T)   now.
bool WalkPattern::try_to_stand(const Eigen::Vector2d& measured_dcm, double omega) noexcept {
  const double time = std::max(kRestTime, double_ - time_);
  const double x = omega * time;
  const Eigen::Vector2d wanted = zmp_ + (measured_dcm - zmp_) * (x / (1.0 - std::exp(-x)));
  const Eigen::Vector2d rest = on_both_soles(wanted);
  if (!((wanted - rest).norm() < kUncaught)) return false;
  for (int f = 0; f < 2; ++f) {
    if (!((rest - zmp_on(gait_, foot(f), f)).norm() < kStandingStride * gait_.max_forward))
      return false;
  }
  stand(rest, time);
  unforeseen_ = true;
  return true;
}

double WalkPattern::rough_share() const noexcept {
  return std::clamp((rough_.roughness() / gait_.lift - kSmooth) / (kRough - kSmooth), 0.0, 1.0);
}

Eigen::Vector3d WalkPattern::dared() const noexcept {
  const double most = 1.0 - (1.0 - kDared) * rough_share();
  const double share = Gait::share_of(wanted_, gait_.most_velocity);
  return share > most ? Eigen::Vector3d(wanted_ * (most / share)) : wanted_;
}

void WalkPattern::advance(const std::array<bool, 2>& touching,
                          const std::array<Foothold, 2>& measured, double dt) noexcept {
  time_ += dt;
  since_landing_ += dt;
  if (preview_) preview_->advance(dt);
  if (!halting_ || braking_) {
    const Eigen::Vector3d rate =
        halting_ ? Eigen::Vector3d(gait_.most_velocity / kHaltTime) : gait_.acceleration;
    const Eigen::Vector3d wanted = dared();
    for (Eigen::Index k = 0; k < 3; ++k) velocity_[k] = way(velocity_[k], wanted[k], rate[k] * dt);
  }
  if (!walking_) {
    const Eigen::Vector2d to_middle = middle() - rest_;
    if (time_ > double_)
      rest_ += to_middle * std::min(1.0, kRestRate * dt / std::max(1e-9, to_middle.norm()));
    if (side_by_side()) squares_ = false;
    if (!(wants_to_walk() || squares_) || time_ < double_) return;
    squares_ = false;
    int support = wanted_.y() > 0.0 || (wanted_.y() == 0.0 && wanted_.z() >= 0.0) ? 1 : 0;
    if (listed_ < list_count_) support = list_support_;
    begin_step(support, gait_.first_double);
    square_ = 0;
    return;
  }
  const int moves = 1 - support_;
  if (!single_ && time_ >= double_) {
    single_ = true;
    swing_.start(foot(moves));
  }
  if (!single_) {
    target_ = planned_ = after(foot(support_), support_, 0);
    return;
  }
  swing_.advance(target_, double_ + single_time_ - time_, gait_.lift + std::min(uneven_, kMostMore),
                 dt);
  const auto m = static_cast<std::size_t>(moves);
  const bool landed = touching[m] && swing_.progress() > kEarlyShare;
  if (landed || swing_.lost()) land(measured[m], measured[static_cast<std::size_t>(support_)]);
}

StepAdjusted WalkPattern::adjusted_step(const Eigen::Vector2d& measured_dcm, double omega) const noexcept {
  const Foothold& stands = foot(support_);
  const StepNow now{.support = stands,
                    .foot = support_,
                    .moves = single() ? swing_.place() : foot(1 - support_),
                    .velocity = single() ? swing_.velocity() : Eigen::Vector2d::Zero(),
                    .planned = planned_,
                    .dcm = measured_dcm,
                    .offset = dcm_landing_ - target_.position,
                    .left_planned = double_ + gait_.single_support - time_,
                    .left_now = double_ + single_time_ - time_,
                    .shortest = std::max(kShortest, double_ + gait_.shortest_single - time_),
                    .elapsed = time_};
  return adjust_step(gait_, now, omega);
}

void WalkPattern::plan(const Eigen::Vector2d& measured_dcm, double omega) noexcept {
  if (halting_ && !single_) (void)try_to_stand(measured_dcm, omega);
  const double left_now = double_ + single_time_ - time_;
  if (single() && left_now >= kTooLate) {
    if (left_now >= kObeys) planned_ = after(foot(support_), support_, 0);
    target_ = planned_;
    (void)plan_pieces(omega);
    const StepAdjusted step = adjusted_step(measured_dcm, omega);
    target_ = on_ground(step.foothold, foot(support_));
    adjusted_ = step.moved;
    single_time_ = time_ + step.left - double_;
  }
  const std::size_t count = plan_pieces(omega);
  if (!preview_) return;
  if (std::exchange(unforeseen_, false)) preview_->begin(dcm_, zmp_);
  preview_->plan(std::span(pieces_).first(count));
}

int WalkPattern::ahead(Foothold* list, int most) const noexcept {
  if (!walking_) return 0;
  Foothold at = target_;
  int side = 1 - support_;
  for (int k = 0; k < most; ++k, side = 1 - side) {
    if (k > 0) at = after(at, 1 - side, k);
    list[k] = at;
  }
  return most;
}

int WalkPattern::swing_way(Foothold* list, int most) const noexcept {
  constexpr int kParts = 6;  // of the time between two places
  double left = double_ + single_time_ - time_;
  if (!single() || !(left > 0.0)) return 0;
  SwingFoot foot = swing_;
  const double dt = left / (kParts * most);
  for (int k = 0; k < kParts * most; ++k, left -= dt) {
    foot.advance(target_, left, gait_.lift + std::min(uneven_, kMostMore), dt);
    if (k % kParts == kParts - 1) list[k / kParts] = foot.place();
  }
  return most;
}

std::size_t WalkPattern::plan_pieces(double omega) noexcept {
  auto& piece = pieces_;
  std::size_t n = 0, landing = 0;
  const double in_double = double_ - time_;
  const Eigen::Vector2d here = walking_ ? zmp_on(gait_, foot(support_), support_) : rest_;
  zmp_ = here;
  if (in_double > 0.0) {
    zmp_ += (zmp_from_ - here) * std::min(1.0, in_double / double_);
    piece[n++] = {zmp_, here, in_double};
  }
  Eigen::Vector2d xi = here;
  if (walking_) {
    piece[n++] = {here, here, std::max(kLeast, double_ + single_time_ - std::max(time_, double_))};
    landing = n;
    Foothold f = target_;
    int side = 1 - support_;
    Eigen::Vector2d from = here;
    for (int k = 1; k <= kAhead; ++k) {
      const Eigen::Vector2d on = zmp_on(gait_, f, side);
      piece[n++] = {from, on, gait_.double_support};
      piece[n++] = {on, on, gait_.single_support};
      const Foothold next = after(f, side, k);
      from = on;
      xi = 0.5 * (on + zmp_on(gait_, next, 1 - side));
      f = next;
      side = 1 - side;
    }
    piece[n++] = {from, xi, gait_.double_support};
  } else {
    piece[n++] = {here, here, kLeast};
  }
  dcm_landing_ = xi;
  for (std::size_t k = n; k-- > 0;) {
    if (walking_ && k + 1 == landing) dcm_landing_ = xi;
    xi = dcm_before(piece[k], xi, omega);
  }
  dcm_ = xi;
  return n;
}

}  // namespace twinbus::control
