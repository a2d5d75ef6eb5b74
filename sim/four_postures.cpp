#include "sim/four_postures.h"

#include "robot/index.h"
#include "sim/articulated_kernels.h"

namespace twinbus {

namespace {

Three<double> three(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Symmetric3<double> symmetric(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

// What a link weighs and how its joint holds it.
RigidLink rigid(const Model& model, std::size_t i, double mass_scale) {
  const Link& link = model.links[i];
  const double m = mass_scale * link.mass;
  const Eigen::Vector3d c = link.com;
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d inertia =
      mass_scale * link.inertia + m * (c.squaredNorm() * one - c * c.transpose());
  RigidLink of{};
  of.mass = m;
  of.moment = three(m * c);
  of.inertia = symmetric(inertia);
  of.spread = symmetric(0.5 * inertia.trace() * one - inertia);
  of.axis = 3;
  of.leaf = true;
  if (i == 0) return of;
  const Joint& joint = model.joints[i - 1];
  const Eigen::Matrix3d placed = joint.placement.linear();
  of.offset = three(joint.placement.translation());
  of.rotor = joint.rotor_inertia;
  of.parent = at(joint.parent);
  of.placed = {three(placed.col(0)), three(placed.col(1)), three(placed.col(2))};
  of.direction = three(joint.axis);
  of.slides = joint.kind == JointKind::kPrismatic;
  for (int k = 0; k < 3; ++k) {
    if (!of.slides && placed == one && joint.axis == Eigen::Vector3d::Unit(k)) of.axis = k;
  }
  return of;
}

}  // namespace

FourPostures::FourPostures(const Model& model, bool fixed_base, double mass_scale) {
  const std::size_t count = model.links.size();
  for (std::size_t i = 0; i < count; ++i) body_.rigid.push_back(rigid(model, i, mass_scale));
  for (std::size_t i = count - 1; i > 0; --i) {
    RigidLink& on = body_.rigid[body_.rigid[i].parent];
    body_.rigid[i].first = on.leaf;
    on.leaf = false;
  }
  body_.links.resize(count);
  body_.folded.resize(count);
  body_.root.floating = !fixed_base;
  for (auto* numbers : {&body_.angle, &body_.rate, &body_.force, &body_.sine, &body_.cosine,
                        &body_.known_angle, &body_.known_sine, &body_.known_cosine}) {
    numbers->assign(count * kCount, 0.0);
  }
  spin().setZero();
}

void FourPostures::hold(const Eigen::Matrix3d& axes) noexcept {
  const Eigen::Vector3d up = axes.row(2).transpose() * kGravity;
  body_.held = {Vec4{} + up.x(), Vec4{} + up.y(), Vec4{} + up.z()};
}

bool FourPostures::weigh() noexcept {
  find_sines(body_.angle, body_.sine, body_.cosine);
  body_.known_angle = body_.angle;
  body_.known_sine = body_.sine;
  body_.known_cosine = body_.cosine;
  return TWINBUS_KERNEL(factor(body_));
}

void FourPostures::improve(const Accelerations& guess, Accelerations& to) noexcept {
  if (!TWINBUS_KERNEL(find_near_sines(body_))) {
    find_sines(body_.angle, body_.sine, body_.cosine);
  }
  TWINBUS_KERNEL(improve(body_, guess.data(), to.data()));
}

}  // namespace twinbus
