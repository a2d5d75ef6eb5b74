#include "robot/mass_matrix.h"

#include "robot/index.h"
#include "robot/pose_math.h"

namespace twinbus {

MassMatrix::MassMatrix(const Model& model)
    : model_(&model),
      h_(Eigen::MatrixXd::Zero(6 + model.joint_count(), 6 + model.joint_count())),
      composite_(model.links.size()),
      motion_(model.joints.size(), Spatial::Zero()),
      force_(model.joints.size(), Spatial::Zero()),
      com_(Eigen::Vector3d::Zero()) {}

void MassMatrix::update(const Kinematics& kinematics) noexcept {
  const int n = model_->joint_count();
  for (int i = 0; i <= n; ++i) composite_[at(i)] = rigid_inertia(*model_, kinematics, i);
  for (int j = 0; j < n; ++j) motion_[at(j)] = joint_motion(*model_, kinematics, j);
  // Joints of different branches do not meet: their entries stay zero.
  for (int j = n - 1; j >= 0; --j) {
    const Joint& joint = model_->joints[at(j)];
    composite_[at(joint.parent)].add(composite_[at(j + 1)]);
    const Spatial force = composite_[at(j + 1)].times(motion_[at(j)]);
    force_[at(j)] = force;
    h_(6 + j, 6 + j) = motion_[at(j)].dot(force) + joint.rotor_inertia;
    for (int link = joint.parent; link > 0; link = model_->links[at(link)].parent) {
      const double entry = motion_[at(link - 1)].dot(force);
      h_(6 + j, 6 + link - 1) = entry;
      h_(6 + link - 1, 6 + j) = entry;
    }
    h_.block<3, 1>(0, 6 + j) = force.tail<3>();
    h_.block<3, 1>(3, 6 + j) = force.head<3>();
    h_.block<1, 3>(6 + j, 0) = force.tail<3>().transpose();
    h_.block<1, 3>(6 + j, 3) = force.head<3>().transpose();
  }
  const RigidInertia& whole = composite_[0];
  const Eigen::Matrix3d moment = skew(whole.moment);
  h_.block<3, 3>(0, 0) = whole.mass * Eigen::Matrix3d::Identity();
  h_.block<3, 3>(0, 3) = -moment;
  h_.block<3, 3>(3, 0) = moment;
  h_.block<3, 3>(3, 3) = whole.inertia;
  if (whole.mass > 0.0) com_ = whole.moment / whole.mass;
}

void MassMatrix::centroidal_map(Eigen::MatrixXd& map) const noexcept {
  const RigidInertia& whole = composite_[0];
  map.block<3, 6>(0, 0) = h_.block<3, 6>(0, 0);
  map.block<3, 3>(3, 0).setZero();
  const Eigen::Matrix3d moment = skew(whole.moment);
  map.block<3, 3>(3, 3) = whole.inertia;
  map.block<3, 3>(3, 3).noalias() += skew(com_) * moment;
  for (int j = 0; j < model_->joint_count(); ++j) {
    const Spatial& force = force_[at(j)];
    const Eigen::Vector3d linear = force.tail<3>();
    map.block<3, 1>(0, 6 + j) = linear;
    map.block<3, 1>(3, 6 + j) = Eigen::Vector3d(force.head<3>()) - com_.cross(linear);
  }
}

}  // namespace twinbus
