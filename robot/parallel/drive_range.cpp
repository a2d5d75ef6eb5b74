#include "robot/parallel/drive_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/text/formatted.h"

namespace twinbus::inline robot {

namespace {

constexpr int kPoints = 17;    // of a box, along each joint
constexpr int kHalvings = 14;  // of a range

template <class See>
bool everywhere(const JointBox& box, See&& see) {
  for (int i = 0; i < kPoints; ++i) {
    for (int k = 0; k < kPoints; ++k) {
      const Eigen::Vector2d share(static_cast<double>(i) / (kPoints - 1), static_cast<double>(k) / (kPoints - 1));
      if (!see(Eigen::Vector2d(box.lower + share.cwiseProduct(box.upper - box.lower)))) return false;
    }
  }
  return true;
}

bool all_usable(const RodDrive& drive, const JointBox& box) noexcept {
  RodPosture posture;
  return everywhere(box, [&](const Eigen::Vector2d& q) { return usable(drive, q, posture); });
}

// The largest share for which a box may be used; that of 0 may.
template <class Box>
double largest(const RodDrive& drive, Box&& box) noexcept {
  if (all_usable(drive, box(1.0))) return 1.0;
  double good = 0.0, bad = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (good + bad);
    (all_usable(drive, box(middle)) ? good : bad) = middle;
  }
  return good;
}

}  // namespace

bool usable(const RodDrive& drive, const Eigen::Vector2d& q, RodPosture& posture) noexcept {
  if (!drive.at(q, posture)) return false;
  for (int i = 0; i < 2; ++i) {
    const RodMotor& motor = drive.motor(i);
    if (!(posture.motors[i] >= motor.lower && posture.motors[i] <= motor.upper)) return false;
    if (!(posture.crank_sine[i] >= kLeastCrankSine)) return false;
  }
  return posture.foot_share >= kLeastFootShare;
}

std::string not_used_for(const RodDrive& drive, const Eigen::Vector2d& q) {
  RodPosture p;
  const std::string where = formatted(" at %.3g and %.3g rad", q[0], q[1]);
  if (!drive.at(q, p)) return "a rod does not close" + where;
  for (int i = 0; i < 2; ++i) {
    const RodMotor& motor = drive.motor(i);
    if (!(p.motors[i] >= motor.lower && p.motors[i] <= motor.upper))
      return formatted("motor %s would be at %.3g rad, of a range of %.3g to %.3g,", motor.name.c_str(), p.motors[i], motor.lower,
                       motor.upper) + where;
    if (!(p.crank_sine[i] >= kLeastCrankSine))
      return formatted("crank and rod of motor %s are nearly in line (sine %.2f, at least %.2f),", motor.name.c_str(), p.crank_sine[i],
                       kLeastCrankSine) + where;
  }
  if (!(p.foot_share >= kLeastFootShare))
    return formatted("both rods pull the same way, so that one motion of the joints has no motor (levers %.2f, at least %.2f),",
                     p.foot_share, kLeastFootShare) + where;
  return "";
}

Eigen::Vector2d middle_of(const JointBox& limits) noexcept {
  return Eigen::Vector2d::Zero().cwiseMax(limits.lower).cwiseMin(limits.upper);
}

std::optional<JointBox> usable_box(const RodDrive& drive, const JointBox& limits) noexcept {
  const Eigen::Vector2d middle = middle_of(limits);
  RodPosture posture;
  if (!usable(drive, middle, posture)) return std::nullopt;
  const double share = largest(drive, [&](double s) {
    return JointBox{middle + s * (limits.lower - middle), middle + s * (limits.upper - middle)};
  });
  if (share == 1.0) return limits;
  JointBox box{middle + share * (limits.lower - middle), middle + share * (limits.upper - middle)};
  for (int joint = 0; joint < 2; ++joint) {
    for (const auto end : {&JointBox::lower, &JointBox::upper}) {
      const JointBox from = box;
      const auto moved = [&](double s) {
        JointBox out = from;
        (out.*end)[joint] += s * ((limits.*end)[joint] - (from.*end)[joint]);
        return out;
      };
      box = moved(largest(drive, moved));
    }
  }
  return box;
}

DriveMargins margins_in(const RodDrive& drive, const JointBox& box) noexcept {
  DriveMargins margins;
  margins.lower.setConstant(std::numeric_limits<double>::infinity());
  margins.upper = -margins.lower;
  RodPosture p;
  (void)everywhere(box, [&](const Eigen::Vector2d& q) {
    if (!drive.at(q, p)) return true;
    margins.crank_sine = std::min(margins.crank_sine, p.crank_sine.minCoeff());
    margins.foot_share = std::min(margins.foot_share, p.foot_share);
    margins.lower = margins.lower.cwiseMin(p.motors);
    margins.upper = margins.upper.cwiseMax(p.motors);
    return true;
  });
  return margins;
}

Eigen::Vector2d speed_box(const RodDrive& drive, const JointBox& box, const Eigen::Vector2d& wanted) noexcept {
  double share = 1.0;
  RodPosture p;
  (void)everywhere(box, [&](const Eigen::Vector2d& q) {
    if (!drive.at(q, p)) return true;
    const Eigen::Vector2d asked = p.jacobian.cwiseAbs() * wanted;
    for (int i = 0; i < 2; ++i) share = std::min(share, drive.motor(i).speed / asked[i]);
    return true;
  });
  return share * wanted;
}

Eigen::Vector2d torque_alone(const RodDrive& drive, const RodPosture& posture) noexcept {
  const Eigen::Matrix2d to_motors = posture.jacobian.transpose().inverse().cwiseAbs();
  const Eigen::Vector2d limit = drive.torque_limits();
  return {(limit.array() / to_motors.col(0).array()).minCoeff(), (limit.array() / to_motors.col(1).array()).minCoeff()};
}

Eigen::Vector2d torque_box(const RodDrive& drive, const RodPosture& posture) noexcept {
  const Eigen::Vector2d alone = torque_alone(drive, posture);
  const Eigen::Vector2d asked = posture.jacobian.transpose().inverse().cwiseAbs() * alone;
  return alone * (drive.torque_limits().array() / asked.array()).minCoeff();
}

}  // namespace twinbus::robot
