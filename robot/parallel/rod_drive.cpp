#include "robot/parallel/rod_drive.h"

#include <cmath>
#include <numbers>

#include "common/math/pose_math.h"

namespace twinbus::inline robot {

namespace {

constexpr double kNoLever = 1e-9;  // [m]
constexpr int kRounds = 30;
constexpr double kFarthest = 0.3;  // that a round of Newton's method turns a joint [rad]
constexpr double kFound = 1e-12;   // [rad]

double wrapped(double angle) noexcept { return std::remainder(angle, 2.0 * std::numbers::pi); }

}  // namespace

RodDrive::RodDrive(const SerialJoints& joints, const std::array<RodMotor, 2>& motors) : joints_(joints), motors_(motors) {
  const Reached zero = reach(Eigen::Vector2d::Zero());
  for (std::size_t i = 0; i < 2; ++i) {
    const RodMotor& motor = motors_[i];
    Loop& loop = loops_[i];
    const Eigen::Vector3d crank = motor.arm - motor.center, end = zero.child * motor.rod;
    loop.along = crank.dot(motor.axis) * motor.axis;
    loop.across = crank - loop.along;
    loop.ahead = motor.axis.cross(loop.across);
    loop.length = (end - motor.arm).norm();
    // At q = 0 atan2 has the sign of B = s . (a x r), and both terms cancel.
    loop.branch = (end - motor.arm).dot(loop.ahead) < 0.0 ? 1.0 : -1.0;
    if (!crank_angle(i, end, loop.zero)) loop.zero = 0.0;
  }
}

RodDrive::Reached RodDrive::reach(const Eigen::Vector2d& q) const noexcept {
  Reached out;
  out.first_at = joints_.first.translation();
  out.first_axis = joints_.first.linear() * joints_.first_axis;
  Eigen::Isometry3d between = joints_.first;
  between.linear() = joints_.first.linear() * rotation_about(joints_.first_axis, q[0]);
  out.child = between * joints_.second;
  out.second_at = out.child.translation();
  out.second_axis = out.child.linear() * joints_.second_axis;
  out.child.linear() = out.child.linear() * rotation_about(joints_.second_axis, q[1]);
  return out;
}

bool RodDrive::crank_angle(std::size_t motor, const Eigen::Vector3d& rod_end, double& angle) const noexcept {
  const Loop& loop = loops_[motor];
  const Eigen::Vector3d d = rod_end - motors_[motor].center;
  const double a = d.dot(loop.across), b = d.dot(loop.ahead), size = std::hypot(a, b);
  const double c = 0.5 * (d.squaredNorm() + loop.along.squaredNorm() + loop.across.squaredNorm() - loop.length * loop.length) -
                   d.dot(loop.along);
  if (!(std::abs(c) <= size) || !(size > 0.0)) return false;
  angle = std::atan2(b, a) + loop.branch * std::acos(c / size);
  return true;
}

bool RodDrive::at(const Eigen::Vector2d& q, RodPosture& posture) const noexcept {
  const Reached now = reach(q);
  Eigen::Matrix2d levers;  // of the rods about the joints [m]
  for (int i = 0; i < 2; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Loop& loop = loops_[k];
    const Eigen::Vector3d end = now.child * motors_[k].rod;
    double angle = 0.0;
    if (!crank_angle(k, end, angle)) return false;
    posture.motors[i] = wrapped(angle - loop.zero);
    const double sine = std::sin(posture.motors[i]), cosine = std::cos(posture.motors[i]);
    const Eigen::Vector3d ahead = cosine * loop.ahead - sine * loop.across;  // d (end of the crank) / d theta
    const Eigen::Vector3d crank = loop.along + cosine * loop.across + sine * loop.ahead;
    const Eigen::Vector3d along_rod = (end - motors_[k].center - crank) / loop.length;
    const double lever = along_rod.dot(ahead);
    if (!(std::abs(lever) > kNoLever)) return false;
    levers(i, 0) = along_rod.dot(now.first_axis.cross(end - now.first_at));
    levers(i, 1) = along_rod.dot(now.second_axis.cross(end - now.second_at));
    posture.jacobian.row(i) = levers.row(i) / lever;
    posture.crank_sine[i] = -loop.branch * lever / ahead.norm();
  }
  // Singular values of two by two: half the sum and difference of the norms of its two parts.
  const double sum = std::hypot(levers(0, 0) + levers(1, 1), levers(1, 0) - levers(0, 1));
  const double difference = std::hypot(levers(0, 0) - levers(1, 1), levers(1, 0) + levers(0, 1));
  posture.foot_share = sum + difference > 0.0 ? std::abs(sum - difference) / (sum + difference) : 0.0;
  return true;
}

bool RodDrive::joints(const Eigen::Vector2d& motors, Eigen::Vector2d& q, RodPosture& posture) const noexcept {
  if (!motors.allFinite()) return false;  // a greatest coefficient passes by a NaN
  Eigen::Vector2d now = q;
  RodPosture reached;
  for (int round = 0; round < kRounds; ++round) {
    if (!at(now, reached) || !(reached.foot_share > 0.0)) return false;
    const Eigen::Vector2d miss = motors - reached.motors;
    if (miss.cwiseAbs().maxCoeff() <= kFound) {
      q = now;
      posture = reached;
      return true;
    }
    Eigen::Vector2d step = reached.jacobian.inverse() * miss;
    const double most = step.cwiseAbs().maxCoeff();
    if (!std::isfinite(most)) return false;
    if (most > kFarthest) step *= kFarthest / most;
    now += step;
  }
  return false;
}

}  // namespace twinbus::robot
