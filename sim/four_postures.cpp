#include "sim/four_postures.h"

#include "robot/index.h"
#include "sim/articulated_kernels.h"

namespace twinbus {

namespace {

Three<Vec4> in_lanes(const Eigen::Vector3d& v) noexcept {
  return {Vec4{} + v.x(), Vec4{} + v.y(), Vec4{} + v.z()};
}

RigidLink rigid(const Model& model, std::size_t i, double mass_scale) {
  const Link& link = model.links[i];
  const double m = mass_scale * link.mass;
  const Eigen::Vector3d c = link.com;
  const Eigen::Matrix3d inertia =
      mass_scale * link.inertia +
      m * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
  RigidLink of{.mass = m,
               .moment = {m * c.x(), m * c.y(), m * c.z()},
               .inertia = {inertia(0, 0), inertia(0, 1), inertia(0, 2), inertia(1, 1),
                           inertia(1, 2), inertia(2, 2)},
               .offset = {0.0, 0.0, 0.0},
               .axis = 3};
  if (i == 0) return of;
  const Joint& joint = model.joints[i - 1];
  const Eigen::Vector3d offset = joint.placement.translation();
  of.offset = {offset.x(), offset.y(), offset.z()};
  for (int k = 0; k < 3; ++k) {
    const bool straight = joint.placement.linear() == Eigen::Matrix3d::Identity();
    if (straight && joint.axis == Eigen::Vector3d::Unit(k)) of.axis = k;
  }
  return of;
}

}  // namespace

FourPostures::FourPostures(const Model& model, bool fixed_base, double mass_scale) {
  root_.floating = !fixed_base;
  numbers_.parent.assign(model.links.size(), -1);
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    numbers_.parent[j + 1] = model.joints[j].parent;
    slides_ = slides_ || model.joints[j].kind == JointKind::kPrismatic;
  }
  lanes_.ranks = copies_side_by_side(numbers_.parent, kCount);
  fill(lanes_, model, mass_scale, numbers_);
  for (const Rank& rank : lanes_.ranks) {
    rigid_.push_back(rigid(model, at(rank.link[0]), mass_scale));
  }
  links_.resize(model.links.size());
  spin().setZero();
}

void FourPostures::hold(const Eigen::Matrix3d& axes) noexcept {
  lanes_.links[0].rotation = {in_lanes(axes.col(0)), in_lanes(axes.col(1)), in_lanes(axes.col(2))};
  held_ = axes.transpose() * Eigen::Vector3d(0.0, 0.0, kGravity);
}

bool FourPostures::accelerate(Accelerations& to) noexcept {
  find_sines(lanes_.angle, lanes_.sine, lanes_.cosine);
  if (root_.floating) lanes_.links[0].velocity.w = links_[0].value.w;
  TWINBUS_KERNEL(place_links(lanes_));
  if (!TWINBUS_KERNEL(fold_inward(lanes_, root_, 0.0))) return false;
  TWINBUS_KERNEL(accelerate(lanes_, root_));
  if (root_.floating) {
    const Six<Vec4>& a = lanes_.links[0].acceleration;
    const Vec4 felt[6] = {a.v.x, a.v.y, a.v.z + kGravity, a.w.x, a.w.y, a.w.z};
    for (int k = 0; k < 6; ++k) store4(to.col(k).data(), felt[k]);
  } else {
    to.leftCols<6>().setZero();
    for (int k = 0; k < 3; ++k) to.col(k) = held_[k];
  }
  for (std::size_t r = 1; r < lanes_.links.size(); ++r) {
    store4(to.data() + (kFirstJoint - 1 + r) * kCount, lanes_.links[r].qdd);
  }
  return true;
}

void FourPostures::improve(Accelerations& guess) noexcept {
  if (slides_) {
    (void)accelerate(guess);
    return;
  }
  find_sines(lanes_.angle, lanes_.sine, lanes_.cosine);
  TWINBUS_KERNEL(improve(lanes_, root_, rigid_, links_, guess.data()));
}

}  // namespace twinbus
