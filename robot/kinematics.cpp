#include "robot/kinematics.h"

#include "robot/index.h"
#include "robot/pose_math.h"

namespace twinbus {

Configuration::Configuration(const Model& model)
    : q(Eigen::VectorXd::Zero(model.joint_count())),
      qd(Eigen::VectorXd::Zero(model.joint_count())) {}

void set_joints(const Model& model, const RobotState& state,
                Configuration& configuration) noexcept {
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
    configuration.q[model.bus_joints[k]] = state.q[k];
    configuration.qd[model.bus_joints[k]] = static_cast<double>(state.qd[k]);
  }
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[at(j)];
    if (joint.mimic < 0) continue;
    configuration.q[j] = joint.mimic_multiplier * configuration.q[joint.mimic] + joint.mimic_offset;
    configuration.qd[j] = joint.mimic_multiplier * configuration.qd[joint.mimic];
  }
}

Kinematics::Kinematics(const Model& model)
    : model_(&model),
      pose_(model.links.size(), Eigen::Isometry3d::Identity()),
      omega_(model.links.size(), Eigen::Vector3d::Zero()),
      velocity_(model.links.size(), Eigen::Vector3d::Zero()),
      axis_(model.joints.size(), Eigen::Vector3d::Zero()),
      com_of_link_(model.links.size(), Eigen::Vector3d::Zero()),
      subtree_mass_(model.links.size(), 0.0),
      subtree_moment_(model.links.size(), Eigen::Vector3d::Zero()),
      mass_(model.total_mass()) {
  for (std::size_t i = 0; i < model.links.size(); ++i) subtree_mass_[i] = model.links[i].mass;
  for (std::size_t i = model.links.size() - 1; i > 0; --i) {
    subtree_mass_[at(model.links[i].parent)] += subtree_mass_[i];
  }
  update(Configuration(model));
}

void Kinematics::update(const Configuration& configuration) noexcept {
  pose_[0] = configuration.base;
  omega_[0] = configuration.base_angular_velocity;
  velocity_[0] = configuration.base_velocity;
  for (std::size_t j = 0; j < model_->joints.size(); ++j) {
    const Joint& joint = model_->joints[j];
    const auto parent = at(joint.parent);
    const std::size_t child = j + 1;
    const double q = configuration.q[static_cast<Eigen::Index>(j)];
    const double qd = configuration.qd[static_cast<Eigen::Index>(j)];

    const Eigen::Matrix3d& r_parent = pose_[parent].linear();
    Eigen::Matrix3d rotation;
    rotation.noalias() = r_parent * joint.placement.linear();
    axis_[j].noalias() = rotation * joint.axis;
    Eigen::Vector3d arm;  // from the parent's origin to the child's, world
    arm.noalias() = r_parent * joint.placement.translation();
    omega_[child] = omega_[parent];
    if (joint.kind == JointKind::kPrismatic) {
      arm += q * axis_[j];
      pose_[child].linear() = rotation;
      velocity_[child] = velocity_[parent] + omega_[parent].cross(arm) + qd * axis_[j];
    } else {
      pose_[child].linear().noalias() = rotation * rotation_about(joint.axis, q);
      velocity_[child] = velocity_[parent] + omega_[parent].cross(arm);
      omega_[child] += qd * axis_[j];
    }
    pose_[child].translation() = pose_[parent].translation() + arm;
  }
  update_com();
}

// Subtrees first, because every Jacobian column of the centre of mass is about one; then the
// momentum.
void Kinematics::update_com() noexcept {
  const std::vector<Link>& links = model_->links;
  for (std::size_t i = 0; i < links.size(); ++i) {
    com_of_link_[i] = pose_[i].translation();
    com_of_link_[i].noalias() += pose_[i].linear() * links[i].com;
    subtree_moment_[i] = links[i].mass * com_of_link_[i];
  }
  for (std::size_t i = links.size() - 1; i > 0; --i) {
    subtree_moment_[at(links[i].parent)] += subtree_moment_[i];
  }
  const double inverse_mass = mass_ > 0.0 ? 1.0 / mass_ : 0.0;
  com_ = inverse_mass * subtree_moment_[0];

  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  // about com_
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Eigen::Vector3d offset = com_of_link_[i] - pose_[i].translation();
    const Eigen::Vector3d p = links[i].mass * (velocity_[i] + omega_[i].cross(offset));
    const Eigen::Matrix3d& r = pose_[i].linear();
    momentum += p;
    angular += (com_of_link_[i] - com_).cross(p);
    angular.noalias() += r * (links[i].inertia * (r.transpose() * omega_[i]));
  }
  com_velocity_ = inverse_mass * momentum;
  angular_momentum_ = angular;
}

Eigen::Vector3d Kinematics::point_velocity(int link, const Eigen::Vector3d& point) const noexcept {
  return velocity_[at(link)] + omega_[at(link)].cross(point - pose_[at(link)].translation());
}

void Kinematics::point_jacobian(int link, const Eigen::Vector3d& point,
                                Eigen::MatrixXd& jacobian) const noexcept {
  jacobian.setZero();
  jacobian.block<3, 3>(0, 0).setIdentity();
  jacobian.block<3, 3>(0, 3) = -skew(point - pose_[0].translation());
  jacobian.block<3, 3>(3, 3).setIdentity();
  for (int i = link; i > 0; i = model_->links[at(i)].parent) {
    const auto j = at(i - 1);
    const Eigen::Index column = 6 + i - 1;
    if (model_->joints[j].kind == JointKind::kPrismatic) {
      jacobian.block<3, 1>(0, column) = axis_[j];
    } else {
      jacobian.block<3, 1>(0, column) = axis_[j].cross(point - pose_[at(i)].translation());
      jacobian.block<3, 1>(3, column) = axis_[j];
    }
  }
}

void Kinematics::com_jacobian(Eigen::MatrixXd& jacobian) const noexcept {
  const double inverse_mass = mass_ > 0.0 ? 1.0 / mass_ : 0.0;
  jacobian.block<3, 3>(0, 0).setIdentity();
  jacobian.block<3, 3>(0, 3) = -skew(com_ - pose_[0].translation());
  for (std::size_t j = 0; j < model_->joints.size(); ++j) {
    const std::size_t child = j + 1;
    const double share = inverse_mass * subtree_mass_[child];
    const auto column = static_cast<Eigen::Index>(6 + j);
    if (model_->joints[j].kind == JointKind::kPrismatic) {
      jacobian.block<3, 1>(0, column) = share * axis_[j];
    } else {
      jacobian.block<3, 1>(0, column) = axis_[j].cross(inverse_mass * subtree_moment_[child] -
                                                       share * pose_[child].translation());
    }
  }
}

}  // namespace twinbus
