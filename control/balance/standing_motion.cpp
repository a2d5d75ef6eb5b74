#include "control/balance/standing_motion.h"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>

namespace twinbus {

namespace {
constexpr double kLeastDeterminant =
    1e-5;  // of a leg's Jacobian, [m^3]: below, it is as good as straight
}

StandingMotion::StandingMotion(const Model& model)
    : model_(&model), mass_(model.total_mass()), leg_mask_(model.joints.size(), false) {
  for (int foot = 0; foot < 2; ++foot) {
    const auto f = static_cast<std::size_t>(foot);
    leg_[f] = leg_chain(model, foot);
    if (leg_[f].count != 6) {
      throw std::runtime_error("robot " + model.name + ": the " + (foot == 0 ? "left" : "right") +
                               " sole does not hang on the base by six joints; balance needs that");
    }
    for (int joint : leg_[f].joint) leg_mask_[static_cast<std::size_t>(joint)] = true;
  }
}

bool StandingMotion::update(const Kinematics& kinematics) noexcept {
  std::array<Matrix6, 2> inverse;
  std::array<Matrix36, 2> by_sole;
  const Eigen::Vector3d& base = kinematics.link_in_world(0).translation();
  for (std::size_t f = 0; f < 2; ++f) {
    const Sole& sole = model_->soles[f];
    const Eigen::Vector3d point = kinematics.link_in_world(sole.link) * sole.frame.translation();
    Matrix6 jacobian;
    Matrix36 com_columns;
    double mass = 0.0;  // of the leg from this joint on
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (int k = 5; k >= 0; --k) {
      const int joint = leg_[f].joint[static_cast<std::size_t>(k)];
      const int link = joint + 1;
      const double m = model_->links[static_cast<std::size_t>(link)].mass;
      mass += m;
      moment += m * kinematics.com_of_link(link);
      const Eigen::Vector3d& axis = kinematics.axis_in_world(joint);
      const Eigen::Vector3d& origin = kinematics.link_in_world(link).translation();
      jacobian.col(k) << axis.cross(point - origin), axis;
      com_columns.col(k) = axis.cross(moment - mass * origin) / mass_;
    }
    const Eigen::PartialPivLU<Matrix6> lu(jacobian);
    if (!(std::abs(lu.determinant()) > kLeastDeterminant)) return false;
    inverse[f] = lu.inverse();
    by_sole[f].noalias() = com_columns * inverse[f];
    sole_[f] = point - base;
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
    const Eigen::Matrix<double, 6, 1> legs = -(inverse_[f] * twist[f]);
    for (std::size_t k = 0; k < 6; ++k) qdd[leg_[f].joint[k]] = legs[static_cast<Eigen::Index>(k)];
  }
  return base;
}

}  // namespace twinbus
