#include "test/oracles/mass_matrix.h"

#include "common/math/index.h"
#include "common/math/pose_math.h"

namespace twinbus {

MassMatrix::MassMatrix(const Model& model)
    : h_(Eigen::MatrixXd::Zero(6 + model.joint_count(), 6 + model.joint_count())),
      parts_(model.links.size()) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    parts_[i].mass = model.links[i].mass;
    if (i == 0) continue;
    parts_[i].parent = model.joints[i - 1].parent;
    parts_[i].rotor = model.joints[i - 1].rotor_inertia;
    parts_[i].slides = model.joints[i - 1].kind == JointKind::kPrismatic;
  }
  for (std::size_t i = parts_.size() - 1; i > 0; --i) {
    parts_[at(parts_[i].parent)].mass += parts_[i].mass;
  }
}

TWINBUS_AVX2_CLONES
void MassMatrix::update(const Kinematics& kinematics) noexcept {
  const int n = static_cast<int>(parts_.size()) - 1;
  for (int i = 0; i <= n; ++i) {
    Composite& part = parts_[at(i)];
    const RigidInertia body = rigid_inertia(kinematics, i);
    store(part.inertia[0], body.inertia.x);
    store(part.inertia[1], body.inertia.y);
    store(part.inertia[2], body.inertia.z);
    store(part.moment, body.moment);
    if (i > 0) store(part.motion, joint_motion(kinematics, i, part.slides));
  }
  // Joints of different branches do not meet: their entries stay zero.
  const Eigen::Index rows = h_.rows();
  double* h = h_.data();
  for (int i = n; i > 0; --i) {
    Composite& part = parts_[at(i)];
    Composite& parent = parts_[at(part.parent)];
    const RigidInertia body = {
        {load(part.inertia[0]), load(part.inertia[1]), load(part.inertia[2])},
        load(part.moment),
        part.mass};
    store(parent.inertia[0], load(parent.inertia[0]) + body.inertia.x);
    store(parent.inertia[1], load(parent.inertia[1]) + body.inertia.y);
    store(parent.inertia[2], load(parent.inertia[2]) + body.inertia.z);
    store(parent.moment, load(parent.moment) + body.moment);
    const Spatial motion = load(part.motion);
    const Spatial force = body.times(motion);
    store(part.force, force);

    const Eigen::Index me = 5 + i;
    double* column = h + me * rows;
    double* row = h + me;
    std::memcpy(column, &force.linear, 3 * sizeof(double));
    std::memcpy(column + 3, &force.angular, 3 * sizeof(double));
    for (Eigen::Index k = 0; k < 6; ++k) row[k * rows] = column[k];
    column[me] = dot(motion, force) + part.rotor;
    for (int up = part.parent; up > 0; up = parts_[at(up)].parent) {
      const double entry = dot(load(parts_[at(up)].motion), force);
      column[5 + up] = entry;
      row[(5 + up) * rows] = entry;
    }
  }
  const Composite& whole = parts_[0];
  const Eigen::Matrix3d moment = skew(whole.moment.value);
  h_.block<3, 3>(0, 0) = whole.mass * Eigen::Matrix3d::Identity();
  h_.block<3, 3>(0, 3) = -moment;
  h_.block<3, 3>(3, 0) = moment;
  for (int c = 0; c < 3; ++c) h_.block<3, 1>(3, 3 + c) = whole.inertia[c].value;
}

void MassMatrix::centroidal_map(Eigen::MatrixXd& map) const noexcept {
  const Composite& whole = parts_[0];
  const Eigen::Vector3d com = whole.mass > 0.0 ? Eigen::Vector3d(whole.moment.value / whole.mass)
                                               : Eigen::Vector3d(Eigen::Vector3d::Zero());
  map.block<3, 6>(0, 0) = h_.block<3, 6>(0, 0);
  map.block<3, 3>(3, 0).setZero();
  map.block<3, 3>(3, 3) = h_.block<3, 3>(3, 3);
  map.block<3, 3>(3, 3).noalias() += skew(com) * skew(whole.moment.value);
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(5 + i);
    const StoredSpatial& force = parts_[i].force;
    map.block<3, 1>(0, column) = force.linear.value;
    map.block<3, 1>(3, column) = force.angular.value - com.cross(force.linear.value);
  }
}

}  // namespace twinbus
