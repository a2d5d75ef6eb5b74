#include "robot/dynamics.h"

#include "robot/index.h"

namespace twinbus {

InverseDynamics::InverseDynamics(const Model& model)
    : model_(&model),
      acceleration_(model.links.size(), Eigen::Vector3d::Zero()),
      angular_acceleration_(model.links.size(), Eigen::Vector3d::Zero()),
      force_(model.links.size(), Eigen::Vector3d::Zero()),
      torque_(model.links.size(), Eigen::Vector3d::Zero()) {}

// Everything in world axes; moments of a link about its origin.  Gravity enters as an acceleration
// of the base upwards.
Eigen::Matrix<double, 6, 1> InverseDynamics::solve(
    const Kinematics& kinematics, const Configuration& configuration, const Eigen::VectorXd& qdd,
    const Eigen::Vector3d& base_acceleration, const Eigen::Vector3d& base_angular_acceleration,
    const std::vector<ExternalWrench>& external, Eigen::VectorXd& tau) noexcept {
  acceleration_[0] = base_acceleration + kGravity * Eigen::Vector3d::UnitZ();
  angular_acceleration_[0] = base_angular_acceleration;
  for (int j = 0; j < model_->joint_count(); ++j) {
    const Joint& joint = model_->joints[at(j)];
    const auto parent = at(joint.parent);
    const auto child = at(j + 1);
    const Eigen::Vector3d& axis = kinematics.axis_in_world(j);
    const Eigen::Vector3d& omega = kinematics.angular_velocity(joint.parent);
    const Eigen::Vector3d arm = kinematics.link_in_world(j + 1).translation() -
                                kinematics.link_in_world(joint.parent).translation();
    const Eigen::Vector3d turn = configuration.qd[j] * omega.cross(axis);
    acceleration_[child] = acceleration_[parent] + angular_acceleration_[parent].cross(arm) +
                           omega.cross(omega.cross(arm));
    angular_acceleration_[child] = angular_acceleration_[parent];
    if (joint.kind == JointKind::kPrismatic) {
      acceleration_[child] += 2.0 * turn + qdd[j] * axis;
    } else {
      angular_acceleration_[child] += turn + qdd[j] * axis;
    }
  }

  for (int i = 0; i < model_->link_count(); ++i) {
    const Link& link = model_->links[at(i)];
    const Eigen::Matrix3d& r = kinematics.link_in_world(i).linear();
    const Eigen::Vector3d& omega = kinematics.angular_velocity(i);
    const Eigen::Vector3d& alpha = angular_acceleration_[at(i)];
    const Eigen::Vector3d c = kinematics.com_of_link(i) - kinematics.link_in_world(i).translation();
    // In link axes: N = I alpha + omega x I omega.
    const Eigen::Vector3d omega_link = r.transpose() * omega;
    const Eigen::Vector3d alpha_link = r.transpose() * alpha;
    Eigen::Vector3d moment = link.inertia * alpha_link;
    moment += omega_link.cross(link.inertia * omega_link);
    force_[at(i)] =
        link.mass * (acceleration_[at(i)] + alpha.cross(c) + omega.cross(omega.cross(c)));
    torque_[at(i)] = c.cross(force_[at(i)]);
    torque_[at(i)].noalias() += r * moment;
  }
  for (const ExternalWrench& wrench : external) {
    if (wrench.link < 0 || wrench.link >= model_->link_count()) continue;
    const Eigen::Vector3d arm = wrench.point - kinematics.link_in_world(wrench.link).translation();
    force_[at(wrench.link)] -= wrench.force;
    torque_[at(wrench.link)] -= wrench.torque + arm.cross(wrench.force);
  }

  for (int j = model_->joint_count() - 1; j >= 0; --j) {
    const Joint& joint = model_->joints[at(j)];
    const auto parent = at(joint.parent);
    const auto child = at(j + 1);
    const Eigen::Vector3d& axis = kinematics.axis_in_world(j);
    tau[j] = axis.dot(joint.kind == JointKind::kPrismatic ? force_[child] : torque_[child]) +
             joint.rotor_inertia * qdd[j];
    const Eigen::Vector3d arm = kinematics.link_in_world(j + 1).translation() -
                                kinematics.link_in_world(joint.parent).translation();
    force_[parent] += force_[child];
    torque_[parent] += torque_[child] + arm.cross(force_[child]);
  }
  Eigen::Matrix<double, 6, 1> base;
  base << force_[0], torque_[0];
  return base;
}

Eigen::Vector3d InverseDynamics::point_acceleration(const Kinematics& kinematics, int link,
                                                    const Eigen::Vector3d& point) const noexcept {
  const Eigen::Vector3d arm = point - kinematics.link_in_world(link).translation();
  const Eigen::Vector3d& omega = kinematics.angular_velocity(link);
  return acceleration_[at(link)] - kGravity * Eigen::Vector3d::UnitZ() +
         angular_acceleration_[at(link)].cross(arm) + omega.cross(omega.cross(arm));
}

}  // namespace twinbus
