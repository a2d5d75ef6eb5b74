#include "sim/articulated/aba4.h"

#include <cmath>

#include "common/math/index.h"
#include "sim/articulated/articulated_kernels.h"

namespace twinbus::inline sim {

namespace {

Three<double> three(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Symmetric3<double> symmetric(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)};
}

// How masses lie about a point: all of it, mass times where they are, sum of mass times r r'.
struct Masses {
  double all = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
};

Masses masses_of(const Link& link, double scale) {
  const double m = scale * link.mass;
  const Eigen::Matrix3d inertia = scale * link.inertia;
  return {m, m * link.com,
          0.5 * inertia.trace() * Eigen::Matrix3d::Identity() - inertia +
              m * link.com * link.com.transpose()};
}

// What lies on an axis through the point, or can be moved to it, is no longer link's but of what the joint
// is on: there the axis begins at p.
void hand_on(const Joint& joint, Masses& link, Masses& on) {
  const Eigen::Vector3d a = joint.axis, p = joint.placement.translation(),
                        out = joint.placement.linear() * a;
  const double m = link.all, along = a.dot(link.moment), far = a.dot(link.spread * a);
  on.all += m;
  on.moment += m * p + along * out;
  on.spread += m * p * p.transpose() + along * (p * out.transpose() + out * p.transpose()) +
               far * out * out.transpose();
  link.all = 0.0;
  link.moment -= along * a;
  link.spread -= far * a * a.transpose();
}

void keep(const Masses& masses, RigidLink& of) {
  const Eigen::Matrix3d& spread = masses.spread;
  of.mass = masses.all;
  of.moment = three(masses.moment);
  of.inertia = symmetric(spread.trace() * Eigen::Matrix3d::Identity() - spread);
  of.spread = symmetric(spread);
}

// How a link hangs on its parent.
RigidLink rigid(const Model& model, std::size_t i) {
  RigidLink of{};
  of.axis = 3;
  of.leaf = true;
  if (i == 0) return of;
  const Joint& joint = model.joints[i - 1];
  const Eigen::Matrix3d placed = joint.placement.linear();
  of.offset = three(joint.placement.translation());
  of.apart = joint.placement.translation() != Eigen::Vector3d::Zero();
  of.rotor = joint.rotor_inertia;
  of.parent = at(joint.parent);
  of.placed = {three(placed.col(0)), three(placed.col(1)), three(placed.col(2))};
  of.direction = three(joint.axis);
  of.slides = joint.kind == JointKind::kPrismatic;
  const bool straight = !of.slides && placed == Eigen::Matrix3d::Identity();
  for (int k = 0; k < 3; ++k) {
    if (straight && joint.axis == Eigen::Vector3d::Unit(k)) of.axis = k;
  }
  return of;
}

}  // namespace

FourPostures::FourPostures(const Model& model, bool fixed_base, double mass_scale) {
  const std::size_t count = model.links.size();
  std::vector<Masses> masses;
  for (std::size_t i = 0; i < count; ++i) {
    body_.rigid.push_back(rigid(model, i));
    masses.push_back(masses_of(model.links[i], mass_scale));
  }
  for (std::size_t i = count - 1; i > 0; --i) {
    RigidLink &link = body_.rigid[i], &on = body_.rigid[link.parent];
    link.first = on.leaf;
    on.leaf = false;
    if (link.axis < 3) hand_on(model.joints[i - 1], masses[i], masses[link.parent]);
  }
  for (std::size_t i = 0; i < count; ++i) keep(masses[i], body_.rigid[i]);
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

double FourPostures::improve(const Accelerations& guess, Accelerations& to) noexcept {
  if (!TWINBUS_KERNEL(find_near_sines(body_))) {
    find_sines(body_.angle, body_.sine, body_.cosine);
  }
  return std::sqrt(TWINBUS_KERNEL(improve(body_, guess.data(), to.data())) / kCount);
}

}  // namespace twinbus::sim
