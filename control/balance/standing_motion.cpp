#include "control/balance/standing_motion.h"

#include <Eigen/LU>
#include <cmath>

#include "common/math/index.h"

namespace twinbus::inline control {

namespace {
constexpr double kPosture = 8.0;  // rate at which what a seventh joint leaves free comes back [1/s]
constexpr double kLeastDeterminant =
    1e-5;  // of a leg's Jacobian, [m^3]: below, it is as good as straight
}

StandingMotion::StandingMotion(const Model& model)
    : model_(&model),
      mass_(model.total_mass()),
      leg_{LegMotion(model, 0), LegMotion(model, 1)},
      home_(model, "half_sitting"),
      leg_mask_(model.joints.size(), false) {
  for (const LegMotion& leg : leg_) {
    for (const int joint : leg.chain()) leg_mask_[at(joint)] = true;
  }
}

bool StandingMotion::update(const Kinematics& kinematics) noexcept {
  std::array<Matrix6, 2> inverse;
  std::array<Matrix36, 2> by_sole;
  const Eigen::Vector3d& base = kinematics.link_in_world(0).translation();
  for (std::size_t f = 0; f < 2; ++f) {
    const Sole& sole = model_->soles[f];
    const Eigen::Isometry3d pose = kinematics.link_in_world(sole.link) * sole.frame;
    LegMotion& leg = leg_[f];
    leg.update(kinematics, pose);
    LegMotion::Matrix37 com_columns = LegMotion::Matrix37::Zero();
    double mass = 0.0;  // of the leg from this joint on
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (int k = leg.chain().count - 1; k >= 0; --k) {
      const int joint = leg.chain().joint[at(k)];
      const int link = joint + 1;
      const double m = model_->links[static_cast<std::size_t>(link)].mass;
      mass += m;
      moment += m * kinematics.com_of_link(link);
      const Eigen::Vector3d& axis = kinematics.axis_in_world(joint);
      const Eigen::Vector3d& origin = kinematics.link_in_world(link).translation();
      com_columns.col(k) = axis.cross(moment - mass * origin) / mass_;
    }
    const Eigen::PartialPivLU<Matrix6> lu(leg.jacobian());
    const double least = leg.chain().count == 7 ? kLeastDeterminant * kLeastDeterminant : kLeastDeterminant;
    if (!(std::abs(lu.determinant()) > least)) return false;
    inverse[f] = lu.inverse();
    by_sole[f].noalias() = leg.by_coordinates(com_columns) * inverse[f];
    sole_[f] = pose.translation() - base;
  }
  inverse_ = inverse;
  com_by_sole_ = by_sole;
  com_ = kinematics.com() - base;
  Eigen::Matrix3d by_base = Eigen::Matrix3d::Identity();
  for (std::size_t f = 0; f < 2; ++f) by_base -= by_sole[f].leftCols<3>();
  com_by_base_ = by_base.inverse();
  return true;
}

Eigen::Vector3d StandingMotion::solve(const Eigen::Vector3d& com_acceleration,
                                      const Eigen::Vector3d& turning,
                                      Eigen::VectorXd& qdd) const noexcept {
  Eigen::Vector3d rest = com_acceleration - turning.cross(com_);
  std::array<Eigen::Matrix<double, 6, 1>, 2> twist;
  for (std::size_t f = 0; f < 2; ++f) {
    twist[f] << turning.cross(sole_[f]), turning;
    rest.noalias() += com_by_sole_[f] * twist[f];
  }
  const Eigen::Vector3d base = com_by_base_ * rest;
  for (std::size_t f = 0; f < 2; ++f) {
    twist[f].head<3>() += base;
    const LegMotion::Vector6 x = -(inverse_[f] * twist[f]);
    for (int k = 0; k < leg_[f].chain().count; ++k) qdd[leg_[f].chain().joint[at(k)]] = leg_[f].rate(at(k), x);
  }
  return base;
}

void StandingMotion::keep_posture(const Configuration& now, Eigen::VectorXd& qdd) const noexcept {
  for (const LegMotion& leg : leg_) {
    if (leg.chain().count != 7) continue;
    LegMotion::Vector7 wanted;
    for (int k = 0; k < 7; ++k) {
      const int joint = leg.chain().joint[at(k)];
      wanted[k] = kPosture * kPosture * (home_.q[joint] - now.q[joint]) - 2.0 * kPosture * now.qd[joint];
    }
    wanted = leg.unseen(wanted);
    for (int k = 0; k < 7; ++k) qdd[leg.chain().joint[at(k)]] += wanted[k];
  }
}

}  // namespace twinbus::control
