#include "robot/dynamics/joint_inertia.h"

#include <algorithm>

#include "common/math/index.h"

namespace twinbus {

JointInertia::JointInertia(const Model& model)
    : model_(&model),
      composites_(model.links.size(), RigidInertia{}),
      h_(at(kMaxJoints * kMaxJoints), 0.0),
      l_(h_),
      row_(model.joints.size(), -1) {}

TWINBUS_INLINE Spatial JointInertia::motion_of(const Kinematics& kinematics, int joint) const noexcept {
  return joint_motion(kinematics, joint + 1, model_->joints[at(joint)].kind == JointKind::kPrismatic);
}

TWINBUS_AVX2_CLONES
void JointInertia::update(const Kinematics& kinematics, std::span<const int> joints) noexcept {
  count_ = std::min(static_cast<int>(joints.size()), kMaxJoints);
  std::fill(row_.begin(), row_.end(), -1);
  for (int i = 0; i < count_; ++i) row_[at(joints[at(i)])] = i;
  for (std::size_t link = 1; link < composites_.size(); ++link)
    composites_[link] = rigid_inertia(kinematics, static_cast<int>(link));
  for (std::size_t link = composites_.size() - 1; link > 0; --link) {
    RigidInertia& above = composites_[at(model_->links[link].parent)];
    const RigidInertia& own = composites_[link];
    above.mass += own.mass;
    above.moment += own.moment;
    above.inertia = {above.inertia.x + own.inertia.x, above.inertia.y + own.inertia.y, above.inertia.z + own.inertia.z};
  }
  for (int i = 0; i < count_; ++i) {
    const int joint = joints[at(i)];
    const Spatial motion = motion_of(kinematics, joint), momentum = composites_[at(joint + 1)].times(motion);
    h_[where(i, i)] = dot(motion, momentum) + model_->joints[at(joint)].rotor_inertia;
    above_[at(i)] = -1;
    for (int link = model_->joints[at(joint)].parent; link > 0; link = model_->links[at(link)].parent) {
      const int row = row_[at(link - 1)];
      if (row < 0) continue;
      if (above_[at(i)] < 0) above_[at(i)] = row;
      h_[where(i, row)] = h_[where(row, i)] = dot(motion_of(kinematics, link - 1), momentum);
    }
  }
}

void JointInertia::times(const double* x, double* y) const noexcept {
  for (int i = 0; i < count_; ++i) {
    y[i] = h_[where(i, i)] * x[i];
    for (int j = above_[at(i)]; j >= 0; j = above_[at(j)]) {
      y[i] += h_[where(i, j)] * x[j];
      y[j] += h_[where(i, j)] * x[i];
    }
  }
}

void JointInertia::factor(const double* added) noexcept {
  for (int i = 0; i < count_; ++i) {
    l_[where(i, i)] = h_[where(i, i)] + added[i];
    for (int j = above_[at(i)]; j >= 0; j = above_[at(j)]) l_[where(i, j)] = h_[where(i, j)];
  }
  for (int k = count_ - 1; k >= 0; --k) {
    for (int i = above_[at(k)]; i >= 0; i = above_[at(i)]) {
      const double share = l_[where(k, i)] / l_[where(k, k)];
      for (int j = i; j >= 0; j = above_[at(j)]) l_[where(i, j)] -= share * l_[where(k, j)];
      l_[where(k, i)] = share;
    }
  }
}

void JointInertia::solve(double* x) const noexcept {
  for (int i = count_ - 1; i >= 0; --i) {
    for (int j = above_[at(i)]; j >= 0; j = above_[at(j)]) x[j] -= l_[where(i, j)] * x[i];
  }
  for (int i = 0; i < count_; ++i) {
    x[i] /= l_[where(i, i)];
    for (int j = above_[at(i)]; j >= 0; j = above_[at(j)]) x[i] -= l_[where(i, j)] * x[j];
  }
}

}  // namespace twinbus
