#include "robot/forward_dynamics.h"

#include <cassert>

#include "robot/index.h"
#include "robot/pose_math.h"

namespace twinbus {

namespace {

SpatialMatrix matrix_of(const RigidInertia& body) noexcept {
  const Eigen::Matrix3d moment = skew(body.moment);
  SpatialMatrix m;
  m.topLeftCorner<3, 3>() = body.inertia;
  m.topRightCorner<3, 3>() = moment;
  m.bottomLeftCorner<3, 3>() = -moment;
  m.bottomRightCorner<3, 3>() = body.mass * Eigen::Matrix3d::Identity();
  return m;
}

}  // namespace

ForwardDynamics::ForwardDynamics(const Model& model)
    : model_(&model),
      parts_(model.links.size()),
      origin_(Eigen::Vector3d::Zero()),
      base_acceleration_(Eigen::Vector3d::Zero()),
      base_spin_(Eigen::Vector3d::Zero()) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    parts_[i].motion.setZero();
    parts_[i].drift.setZero();
    parts_[i].u_column.setZero();
    parts_[i].parent = model.links[i].parent;
  }
}

void ForwardDynamics::solve(const Kinematics& kinematics, const Configuration& configuration,
                            const Eigen::VectorXd& tau, const std::vector<ExternalWrench>& external,
                            Eigen::VectorXd& qdd) noexcept {
  const int n = model_->joint_count();
  origin_ = kinematics.link_in_world(0).translation();
  for (int i = 0; i <= n; ++i) {
    Part& part = parts_[at(i)];
    const Eigen::Vector3d& omega = kinematics.angular_velocity(i);
    part.velocity << omega, kinematics.origin_velocity(i) +
                                omega.cross(origin_ - kinematics.link_in_world(i).translation());
    const RigidInertia body = rigid_inertia(*model_, kinematics, i);
    part.inertia = matrix_of(body);
    part.bias = cross_force(part.velocity, body.times(part.velocity));
    if (i == 0) continue;
    part.motion = joint_motion(*model_, kinematics, i - 1);
    part.drift = cross_motion(part.velocity, configuration.qd[i - 1] * part.motion);
  }
  for (const ExternalWrench& wrench : external) {
    if (wrench.link < 0 || wrench.link > n) continue;
    Part& part = parts_[at(wrench.link)];
    part.bias.head<3>() -= wrench.torque + (wrench.point - origin_).cross(wrench.force);
    part.bias.tail<3>() -= wrench.force;
  }

  for (int i = n; i > 0; --i) {
    Part& part = parts_[at(i)];
    Part& parent = parts_[at(part.parent)];
    part.u_column.noalias() = part.inertia * part.motion;
    part.d_inverse =
        1.0 / (part.motion.dot(part.u_column) + model_->joints[at(i - 1)].rotor_inertia);
    part.u = tau[i - 1] - part.motion.dot(part.bias);
    const Spatial scaled = part.d_inverse * part.u_column;
    part.inertia.noalias() -= scaled * part.u_column.transpose();
    parent.inertia += part.inertia;
    Spatial bias = part.bias + part.u * scaled;
    bias.noalias() += part.inertia * part.drift;
    parent.bias += bias;
  }

  // Gravity is an acceleration of the world upwards.
  Part& base = parts_[0];
  base.acceleration << Eigen::Vector3d::Zero(), kGravity * Eigen::Vector3d::UnitZ();
  if (model_->floating_base) {
    base_.compute(base.inertia);
    base.acceleration = base_.solve(-base.bias);
  }
  for (int i = 1; i <= n; ++i) {
    Part& part = parts_[at(i)];
    part.acceleration = parts_[at(part.parent)].acceleration + part.drift;
    qdd[i - 1] = part.d_inverse * (part.u - part.u_column.dot(part.acceleration));
    part.acceleration += qdd[i - 1] * part.motion;
  }
  base_spin_ = base.acceleration.head<3>();
  base_acceleration_ = base.acceleration.tail<3>() - kGravity * Eigen::Vector3d::UnitZ();
  base_acceleration_ += configuration.base_angular_velocity.cross(configuration.base_velocity);
  if (!model_->floating_base) base_acceleration_.setZero();
}

void ForwardDynamics::contact_mobility(const ContactPoint* contacts, int count,
                                       Eigen::MatrixXd& mobility) noexcept {
  assert(count <= kMaxContacts);
  const int n = model_->joint_count();
  for (int b = 0; b < count; ++b) {
    for (int axis = 0; axis < 3; ++axis) {
      for (Part& part : parts_) part.u = 0.0;
      // The push travels to the base, and moves every joint on its way.
      const Eigen::Vector3d force = Eigen::Vector3d::Unit(axis);
      Spatial bias;
      bias << (origin_ - contacts[b].point).cross(force), -force;
      for (int i = contacts[b].link; i > 0; i = parts_[at(i)].parent) {
        Part& part = parts_[at(i)];
        part.u = -part.motion.dot(bias);
        bias += (part.u * part.d_inverse) * part.u_column;
      }
      parts_[0].acceleration.setZero();
      if (model_->floating_base) parts_[0].acceleration = base_.solve(-bias);
      for (int i = 1; i <= n; ++i) {
        Part& part = parts_[at(i)];
        const Spatial& above = parts_[at(part.parent)].acceleration;
        part.acceleration =
            above + part.d_inverse * (part.u - part.u_column.dot(above)) * part.motion;
      }
      for (int a = 0; a < count; ++a) {
        const Spatial& acceleration = parts_[at(contacts[a].link)].acceleration;
        const Eigen::Vector3d arm = contacts[a].point - origin_;
        mobility.block<3, 1>(3 * a, 3 * b + axis) =
            Eigen::Vector3d(acceleration.tail<3>()) +
            Eigen::Vector3d(acceleration.head<3>()).cross(arm);
      }
    }
  }
}

}  // namespace twinbus
