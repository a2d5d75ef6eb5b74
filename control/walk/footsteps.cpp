#include "control/walk/footsteps.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "robot/kinematics/leg_motion.h"
#include "control/legs/leg_reach.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "common/math/index.h"
#include "robot/kinematics/kinematics.h"
#include "common/math/pose_math.h"
#include "robot/dynamics/pair_torque.h"

namespace twinbus::inline control {

namespace {
// Shares of what the legs reach at walking height, so that a recovery step is still possible.
constexpr double kReachForward = 0.8, kReachBack = 0.62, kReachSideways = 0.53;
constexpr double kCommandStride = 0.95;  // of the longest foothold that a command may ask for
constexpr double kBetween = 0.035;       // between two soles side by side [m]
constexpr double kSidewaysEase =
    0.5;  // soles are narrow: a change to the side takes twice the time
constexpr double kUsualWidth = 0.13;  // of a sole; a narrower one holds less of what steps to the side and turns throw about [m]
constexpr double kUsualShare = 0.2;   // and of the straight leg
constexpr double kWiderShare = 0.25;  // of the way that a foot may go aside, at most, that a robot stands wider on rough ground
constexpr double kMostTurn = 0.65;    // of a step that a command may ask for [rad]
constexpr double kBent = 0.88, kLeastBent = 0.93;  // hip to ankle, share of the straight leg
constexpr double kKneeShare = 0.85;  // of its torque that carrying the robot at rest may take
constexpr double kSwingShare = 0.5;  // of their efforts that a step in a hurry asks of the hips
constexpr double kTurn = 0.6;        // share of a hip's range that a command may use
constexpr double kZmpForward = 0.03;  // before a sole frame, if the ankles are strong enough [m]
constexpr double kAnkleShare = 0.35;  // of an ankle's torque that holds it there
constexpr double kLeanShare = 0.9;   // of half of a sole that leans: where it carries
constexpr double kPitch = 0.7;        // cosine: an axis so nearly to the left pitches the foot
// Of the turn of a step: how far the foot on the inside opens, and how far the other one closes.
constexpr double kOpens = 1.5, kCloses = 0.5;

constexpr double kHalfTurn = 3.14159265358979323846;  // [rad]

// In the pose that robots are said to stand and walk in.
struct Stance {
  double com_above_hips, width;  // [m]
};
Stance stance_of(const Model& model, int hip_link) {
  Kinematics kinematics(model);
  kinematics.update(Configuration(model, "half_sitting"));
  const auto sole = [&](std::size_t f) -> Eigen::Vector3d {
    return kinematics.link_in_world(model.soles[f].link) * model.soles[f].frame.translation();
  };
  return {kinematics.com().z() - kinematics.link_in_world(hip_link).translation().z(),
          (sole(0) - sole(1)).y()};
}
// From hip to ankle: bent so far that the stride is left, but no farther than one knee carries the robot, which the leg
// above it leads past the weight by half its length times the sine of half its bend.
double standing_length(const Model& model, const LegReach& reach) {
  const double lever =
      kKneeShare * model.joints[at(reach.knee)].effort / (model.total_mass() * kGravity);
  const double bend = std::min(1.0, lever / (0.5 * reach.longest));  // sine of half of it
  return reach.longest * std::clamp(std::sqrt(1.0 - bend * bend), kBent, kLeastBent);
}
// The torque that holds the zero-moment point before the ankle is its lever times the weight: an ankle takes kAnkleShare
// of its own for that, and the rest is left to the stabilizer.
double held_by_ankle(const Model& model, int foot) {
  const int knee = leg_reach(model, foot).knee;
  Configuration configuration(model);
  Kinematics kinematics(model);
  kinematics.update(configuration);
  const PairTorque torque(model);
  double lever = kZmpForward;
  const Configuration standing = model.find_pose("half_sitting") >= 0 ? Configuration(model, "half_sitting") : configuration;
  for (const int joint : leg_chain(model, foot)) {
    if (joint <= knee) continue;
    if (std::abs(kinematics.axis_in_world(joint).y()) < kPitch) continue;  // it rolls the foot
    lever = std::min(lever, kAnkleShare * torque.effort_in(joint, standing.q) / (model.total_mass() * kGravity));
  }
  return lever;
}
}  // namespace

void Foothold::set_yaw(double yaw) noexcept {
  if (yaw == yaw_) return;
  yaw_ = yaw;
  cosine_ = std::cos(yaw);
  sine_ = std::sin(yaw);
}

Eigen::Matrix3d Foothold::rotation() const noexcept {
  Eigen::Matrix3d m;
  m << cosine_, -sine_, 0.0, sine_, cosine_, 0.0, 0.0, 0.0, 1.0;
  return m;
}

Eigen::Vector3d Gait::possible(const Eigen::Vector3d& velocity) const noexcept {
  if (!velocity.allFinite()) return Eigen::Vector3d::Zero();
  Eigen::Vector3d most = most_velocity, can = velocity;
  if (velocity.x() < 0.0) most.x() *= max_back / max_forward;
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (!(most[k] > 0.0)) can[k] = 0.0;
  }
  const double share = share_of(can, most);
  return share > 1.0 ? Eigen::Vector3d(can / share) : can;
}

double Gait::share_of(const Eigen::Vector3d& velocity, const Eigen::Vector3d& most) noexcept {
  Eigen::Vector3d shares = velocity.cwiseQuotient(most);
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (velocity[k] == 0.0) shares[k] = 0.0;  // of none too
  }
  return shares.norm();
}

bool Gait::reaches(const Foothold& from, int foot, const Foothold& next) const noexcept {
  const Eigen::Vector2d place = from.unturn(next.position - from.position);
  const double along = place.x() / (place.x() > 0.0 ? max_forward : max_back);
  const double aside = std::max(0.0, side_of(1 - foot) * place.y() - width) / (max_width - width);
  return along * along + aside * aside <= 1.0 + 1e-6;
}

// Seen along the line halfway between both headings, each sole is turned by half the angle.
double Gait::turning_width(double turning) const noexcept {
  if (turning == 0.0) return width;  // which is no less than min_width
  const auto apart = [&](double turned, double reach) {
    const double half = 0.5 * std::abs(turned);
    return (min_width + 2.0 * reach * std::sin(half)) / std::cos(half);
  };
  return std::clamp(std::max(apart(kOpens * turning, heel), apart(kCloses * turning, toe)), width,
                    max_width);
}

Gait gait_of(const Model& model, const Walking& w, double margin) {
  Gait g;
  g.single_support = w.single_support;
  g.double_support = w.double_support;
  g.lift = w.lift;
  g.preview = w.preview;
  const auto fail = [&](const std::string& why) {
    throw std::runtime_error("robot " + model.name + " cannot walk as its robot.yaml asks: " + why);
  };
  const Sole& left = model.soles[0];
  const Sole& right = model.soles[1];
  const double inner = std::max(left.right, right.left), outer = std::max(left.left, right.right);
  const LegChain leg = leg_chain(model, 0);
  if (!leg.balances()) fail(kNoLegs);
  const LegReach reach = leg_reach(model, 0);
  const double ankle = reach.ankle_height;
  const Stance stance = stance_of(model, leg.joint[0] + 1);
  const double above = stance.com_above_hips;
  g.com_height = w.com_height > 0.0 ? w.com_height : above + ankle + standing_length(model, reach);
  const double hip = g.com_height - above - ankle;
  if (!(hip > 0.3 * reach.longest && hip < 0.99 * reach.longest)) {
    fail("walking.com_height puts the hips " + std::to_string(hip) +
         " m above the ankles; the legs reach " + std::to_string(reach.longest) + " m");
  }
  const double stride = 2.0 * std::sqrt(reach.longest * reach.longest - hip * hip);
  g.min_width = inner + inner + kBetween;
  g.width = w.width > 0.0 ? w.width : std::max(reach.hip_width, g.min_width + 0.03);
  if (!(g.width >= g.min_width)) fail("walking.width lets the soles touch each other");
  g.max_forward = kReachForward * stride;
  g.max_back = kReachBack * stride;
  g.max_width = g.width + kReachSideways * stride;
  const double usual = std::min(kUsualWidth, kUsualShare * reach.longest);
  g.rough_wider = std::clamp(usual - inner - outer, 0.0, kWiderShare * (g.max_width - g.width));
  g.standing_width = std::clamp(stance.width, g.min_width, g.max_width);
  g.inner = inner;
  g.max_turn = 2.0 * kTurn * reach.turn;
  g.swing_acceleration = kSwingShare * reach.swing;
  g.toe = left.front;
  g.heel = left.back;
  const double length = left.front + left.back;
  const double forward = std::isnan(w.zmp_forward) ? std::min(held_by_ankle(model, 0), held_by_ankle(model, 1)) : w.zmp_forward;
  g.zmp_forward = std::clamp(forward, -left.back + 0.25 * length, left.front - 0.25 * length);
  g.zmp_inward = w.zmp_inward;
  // What is left of a line, less the margin, is its middle.
  const double aside = std::max(0.0, std::min(inner, outer) - margin), middle = 0.5 * (left.front - left.back);
  g.sole_low = {std::min(-left.back + margin, middle), -aside};
  g.sole_high = {std::max(left.front - margin, middle), aside};
  g.zmp_inward = std::min(g.zmp_inward, aside);
  // A leg that cannot turn its sole about an axis holds no zero-moment point off it.
  g.leans = leans(model);
  if (g.leans) {
    g.zmp_inward = -kLeanShare * std::min(inner, outer);
    g.sole_low.y() = g.zmp_inward;
    g.sole_high.y() = -g.zmp_inward;
  } else if (free_axis(model, 0) == 1) {
    g.sole_low.x() = g.sole_high.x() = g.zmp_forward = 0.0;
  }
  const double period = g.period();
  g.most_velocity = {kCommandStride * g.max_forward / period,
                     kCommandStride * 0.5 * (g.max_width - g.width) / period,
                     kTurn * reach.turn / (kOpens * period) * 2.0};
  g.most_velocity.z() = std::min(g.most_velocity.z(), kMostTurn / period);
  g.most_velocity.tail<2>() *= std::min(1.0, (inner + outer) / kUsualWidth);
  g.acceleration = g.most_velocity / std::max(0.2, 2.0 * period);
  g.acceleration.y() *= kSidewaysEase;
  if (w.fastest > 0.0) g.most_velocity.x() = std::min(g.most_velocity.x(), w.fastest);
  return g;
}

Foothold next_foothold(const Foothold& from, int foot, const Eigen::Vector3d& velocity,
                       double period, double width) noexcept {
  const double out = side_of(1 - foot);  // to the side of the foot that moves
  const double turning = velocity.z() * period;
  const double turn = turning * (turning * out > 0.0 ? kOpens : kCloses);
  const double side = velocity.y() * out > 0.0 ? 2.0 * velocity.y() * period : 0.0;
  const double half = 0.5 * width;
  Foothold next = from;
  const double yaw = from.yaw() + turn;
  next.set_yaw(std::abs(yaw) <= kHalfTurn ? yaw : wrap_angle(yaw));  // which takes its time
  next.position = from.position + from.turn({velocity.x() * period, out * half + side});
  next.position += next.turn({0.0, out * half});
  return next;
}

Foothold kept_apart(const Gait& gait, const Foothold& from, int foot, Foothold next) noexcept {
  const double out = side_of(1 - foot);  // to the side of the foot that moves
  const double beyond = gait.min_width - gait.inner;
  const double turn = next.yaw() - from.yaw(), turned = turn == 0.0 ? 1.0 : std::cos(wrap_angle(turn));
  double missing = 0.0;
  for (const double x : {-gait.heel, gait.toe}) {
    const Eigen::Vector2d moves = next.position + next.turn({x, -out * gait.inner});
    const Eigen::Vector2d stands = from.position + from.turn({x, out * gait.inner});
    missing = std::max(missing, beyond - out * from.unturn(moves - from.position).y());
    missing = std::max(missing, (beyond + out * next.unturn(stands - next.position).y()) / std::max(0.5, turned));
  }
  const double left = gait.max_width - out * from.unturn(next.position - from.position).y();
  next.position += from.turn({0.0, out * std::max(0.0, std::min(missing, left))});
  return next;
}

Eigen::Vector2d zmp_on(const Gait& gait, const Foothold& at, int foot) noexcept {
  return at.position + at.turn({gait.zmp_forward, -side_of(foot) * gait.zmp_inward});
}

}  // namespace twinbus::control
