#include "robot/dynamics/joint_inertia.h"

#include <algorithm>

#include "common/math/index.h"

namespace twinbus::inline robot {

JointInertia::JointInertia(const Model& model)
    : model_(&model),
      composites_(model.links.size(), RigidInertia{}),
      h_(at(kMaxJoints * kMaxJoints), 0.0),
      row_(model.joints.size(), -1),
      columns_(at(kFactor - kMaxJoints)),
      left_(columns_.size(), 0.0) {}

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
  entries_ = 0;
  for (int i = 0; i < count_; ++i) {
    const int joint = joints[at(i)];
    const Spatial motion = motion_of(kinematics, joint), momentum = composites_[at(joint + 1)].times(motion);
    h_[where(i, i)] = dot(motion, momentum) + model_->joints[at(joint)].rotor_inertia;
    rows_[at(i)].first = entries_;
    for (int link = model_->joints[at(joint)].parent; link > 0; link = model_->links[at(link)].parent) {
      const int row = row_[at(link - 1)];
      if (row < 0) continue;
      h_[where(i, row)] = h_[where(row, i)] = dot(motion_of(kinematics, link - 1), momentum);
      columns_[at(entries_)] = row;
      left_[at(entries_++)] = h_[where(i, row)];
    }
    rows_[at(i)].end = entries_;
  }
}

}  // namespace twinbus::robot
