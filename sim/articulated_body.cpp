#include "sim/articulated_body.h"

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "robot/dynamics.h"
#include "robot/index.h"

namespace twinbus {

// The order of these files matters.
// clang-format off
namespace baseline {
#include "sim/spatial_functions.h"
#include "sim/articulated_placing.h"
#include "sim/articulated_sweeps.h"
}  // namespace baseline
#if defined(__x86_64__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2,fma")
namespace avx2 {
#include "sim/spatial_functions.h"
#include "sim/articulated_placing.h"
#include "sim/articulated_sweeps.h"
}  // namespace avx2
#pragma GCC target("avx512f,avx512vl,avx512dq,fma")
namespace avx512 {
#include "sim/spatial_functions.h"
#include "sim/articulated_placing.h"
#include "sim/articulated_sweeps.h"
}  // namespace avx512
#pragma GCC pop_options
#define TWINBUS_KERNEL(call) \
  (simd() == Simd::kAvx512 ? avx512::call : simd() == Simd::kAvx2 ? avx2::call : baseline::call)
#else
#define TWINBUS_KERNEL(call) (baseline::call)
#endif
// clang-format on

namespace {

void set_columns(const Eigen::Matrix3d& from, Vec4 (&to)[3]) {
  for (int k = 0; k < 3; ++k) to[k] = baseline::vec4(from.col(k));
}

}  // namespace

ArticulatedBody::ArticulatedBody(const Model& model, bool fixed_base, double mass_scale) {
  d_.floating = !fixed_base;
  d_.fixed.resize(model.links.size());
  d_.links.resize(model.links.size());
  d_.folded.resize(model.links.size());
  d_.qd.resize(model.joints.size());
  std::vector<int> depth(model.links.size(), 0);
  branch_.assign(model.links.size(), 0);
  for (std::size_t i = 0; i < d_.fixed.size(); ++i) {
    const Link& link = model.links[i];
    BodyData::Fixed& to = d_.fixed[i];
    to.mass = link.mass * mass_scale;
    to.com = baseline::vec4(link.com);
    const Eigen::Matrix3d inertia = link.inertia * mass_scale;
    set_columns(inertia, to.inertia);
    d_.mass += to.mass;
    const bool moves = i > 0 || d_.floating;
    if (moves && (!(link.mass > 0.0) || !(inertia.llt().info() == Eigen::Success))) {
      throw std::runtime_error(
          "link '" + link.name +
          "' cannot be simulated: its mass and inertia must be positive; give it an <inertial>");
    }
    if (i == 0) continue;
    const Joint& joint = model.joints[i - 1];
    to.parent = joint.parent;
    depth[i] = depth[static_cast<std::size_t>(joint.parent)] + 1;
    deepest_ = std::max(deepest_, depth[i]);
    if (!d_.floating)
      branch_[i] = joint.parent == 0 ? static_cast<int>(i) : branch_[at(joint.parent)];
    to.prismatic = joint.kind == JointKind::kPrismatic;
    to.offset = baseline::vec4(joint.placement.translation());
    to.axis = baseline::vec4(joint.axis);
    to.rotor = joint.rotor_inertia;
    const Eigen::Vector3d& a = joint.axis;
    Eigen::Matrix3d hat;
    hat << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    const Eigen::Matrix3d along = a * a.transpose();
    const Eigen::Matrix3d placed = joint.placement.linear();
    set_columns(to.prismatic ? placed : Eigen::Matrix3d(placed * along), to.still);
    set_columns(placed * (Eigen::Matrix3d::Identity() - along), to.swing);
    set_columns(placed * hat, to.turn);
  }
  for (std::size_t i = d_.fixed.size() - 1; i > 0; --i) {
    BodyData::Fixed& parent = d_.fixed[static_cast<std::size_t>(d_.fixed[i].parent)];
    d_.fixed[i].first = parent.leaf;
    parent.leaf = false;
  }
}

void ArticulatedBody::place(const Configuration& configuration) noexcept {
  TWINBUS_KERNEL(place(d_, configuration));
}

void ArticulatedBody::place(const Momentum& wanted, Configuration& configuration) noexcept {
  TWINBUS_KERNEL(correct(d_, wanted, configuration));
}

void ArticulatedBody::add_compliance(int link, const Eigen::Vector3d& r,
                                     const Eigen::Matrix3d& weight) noexcept {
  TWINBUS_KERNEL(fold_compliance(d_, link, r, weight));
}

bool ArticulatedBody::inward(const std::vector<JointRow>& rows, double h) noexcept {
  return TWINBUS_KERNEL(fold_inward(d_, rows, h));
}

void ArticulatedBody::outward() noexcept { TWINBUS_KERNEL(accelerate(d_)); }

void ArticulatedBody::add_wrench(int link, const Screw& wrench) noexcept {
  TWINBUS_KERNEL(fold_wrench(d_, link, wrench));
}

int ArticulatedBody::response(int link, ResponseRow* rows) const noexcept {
  return TWINBUS_KERNEL(respond(d_, link, rows));
}

Momentum ArticulatedBody::momentum() const noexcept {
  return baseline::momentum_of(d_, d_.momentum, d_.moment);
}

void ArticulatedBody::add_force(int link, const Eigen::Vector3d& r,
                                const Eigen::Vector3d& force) noexcept {
  Screw& bias = d_.links[static_cast<std::size_t>(link)].rigid_bias;
  baseline::operator-=(bias, baseline::force_at(baseline::vec4(r), baseline::vec4(force)));
}

// In root axes the derivative of the root's velocity is the acceleration itself: no extra w x v.
void ArticulatedBody::advance(double h, Configuration& to) const noexcept {
  for (std::size_t i = 1; i < d_.links.size(); ++i) {
    const auto joint = static_cast<Eigen::Index>(i) - 1;
    to.qd[joint] += h * d_.links[i].qdd;
    to.q[joint] += h * to.qd[joint];
  }
  if (!d_.floating) return;
  const Screw& a = d_.links[0].acceleration;
  const Eigen::Vector3d w = to.base_angular_velocity + h * angular(a);
  const Eigen::Vector3d v = to.base_velocity + h * linear(a);
  to.base.translation() += h * v;
  const double angle = h * w.norm();
  if (!(angle > 0.0)) {
    to.base_velocity = v;
    to.base_angular_velocity = w;
    return;
  }
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, w.normalized()).toRotationMatrix();
  const Eigen::Quaterniond attitude(Eigen::Matrix3d(turn * to.base.linear()));
  to.base.linear() = attitude.normalized().toRotationMatrix();
  to.base_velocity = turn * v;
  to.base_angular_velocity = w;
}

}  // namespace twinbus
