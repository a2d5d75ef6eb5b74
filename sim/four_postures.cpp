#include "sim/four_postures.h"

#include "robot/index.h"
#include "sim/articulated_kernels.h"

namespace twinbus {

namespace {

void set(Three<Vec4>& lanes, int lane, const Eigen::Vector3d& to) noexcept {
  lanes.x[lane] = to.x();
  lanes.y[lane] = to.y();
  lanes.z[lane] = to.z();
}

}  // namespace

FourPostures::FourPostures(const Model& model, bool fixed_base, double mass_scale) {
  root_.floating = !fixed_base;
  links_.parent.assign(model.links.size(), -1);
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    links_.parent[j + 1] = model.joints[j].parent;
  }
  lanes_.ranks = copies_side_by_side(links_.parent, kCount);
  fill(lanes_, model, mass_scale, links_);
}

void FourPostures::set_base(int posture, const Eigen::Matrix3d& axes,
                            const Eigen::Vector3d& angular_velocity,
                            const Eigen::Vector3d& velocity) noexcept {
  LinkLanes<Vec4>& root = lanes_.links[0];
  set(root.rotation.x, posture, axes.col(0));
  set(root.rotation.y, posture, axes.col(1));
  set(root.rotation.z, posture, axes.col(2));
  if (!root_.floating) return;
  set(root.velocity.w, posture, angular_velocity);
  set(root.velocity.v, posture, velocity);
}

bool FourPostures::accelerate() noexcept {
  find_sines(lanes_.angle, lanes_.sine, lanes_.cosine);
  TWINBUS_KERNEL(place_links(lanes_));
  if (!TWINBUS_KERNEL(fold_inward(lanes_, root_, 0.0))) return false;
  TWINBUS_KERNEL(accelerate(lanes_, root_));
  return true;
}

Screw FourPostures::base_acceleration(int posture) const noexcept {
  const Six<Vec4>& a = lanes_.links[0].acceleration;
  return {Vec4{a.w.x[posture], a.w.y[posture], a.w.z[posture], 0.0},
          Vec4{a.v.x[posture], a.v.y[posture], a.v.z[posture], 0.0}};
}

}  // namespace twinbus
