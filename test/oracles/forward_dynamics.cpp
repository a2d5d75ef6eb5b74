#include "test/oracles/forward_dynamics.h"

#include <cassert>

#include "common/math/index.h"

namespace twinbus {

ForwardDynamics::ForwardDynamics(const Model& model)
    : model_(&model),
      parts_(model.links.size()),
      origin_(Eigen::Vector3d::Zero()),
      base_acceleration_(Eigen::Vector3d::Zero()),
      base_spin_(Eigen::Vector3d::Zero()) {
  for (std::size_t i = parts_.size() - 1; i > 0; --i) {
    Part& part = parts_[i];
    const Joint& joint = model.joints[i - 1];
    part.parent = joint.parent;
    part.rotor = joint.rotor_inertia;
    part.slides = joint.kind == JointKind::kPrismatic;
  }
}

// Where links would accelerate to with joints at constant speed and the base held up against
// gravity.
TWINBUS_AVX2_CLONES
void ForwardDynamics::outward_drift(const Kinematics& kinematics, const double* qd) noexcept {
  store(parts_[0].drift, Vec4{0.0, 0.0, kGravity, 0.0});
  store(parts_[0].spin, Vec4{});
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    Part& part = parts_[i];
    const LinkState& link = kinematics.state(static_cast<int>(i));
    const LinkState& parent = kinematics.state(part.parent);
    const Vec4 omega = load(parent.omega), spin = load(parts_[at(part.parent)].spin);
    const Vec4 arm =
        load4(link.pose.matrix().data() + 12) - load4(parent.pose.matrix().data() + 12);
    const Vec4 turn = cross4(omega, load(link.axis) * qd[i - 1]);
    const Vec4 drift =
        load(parts_[at(part.parent)].drift) + cross4(spin, arm) + cross4(omega, cross4(omega, arm));
    store(part.drift, part.slides ? drift + turn * 2.0 : drift);
    store(part.spin, part.slides ? spin : spin + turn);
  }
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Part& part = parts_[i];
    const LinkState& link = kinematics.state(static_cast<int>(i));
    const LinkMass& of = kinematics.mass_of(static_cast<int>(i));
    const Columns turned = turned_inertia(kinematics, static_cast<int>(i));
    const Vec4 com = load(link.com) - load4(kinematics.state(0).pose.matrix().data() + 12);
    const Vec4 c = load(link.com) - load4(link.pose.matrix().data() + 12);
    const Vec4 omega = load(link.omega), spin = load(part.spin);
    const Vec4 force =
        (load(part.drift) + cross4(spin, c) + cross4(omega, cross4(omega, c))) * of.mass;
    const Vec4 moment =
        turned.times(spin) + cross4(omega, turned.times(omega)) + cross4(com, force);
    store(part.bias, {moment, force});

    const RigidInertia body = moved_inertia(turned, com, of.mass);
    const Vec4 h = body.moment;
    store(part.aa[0], body.inertia.x);
    store(part.aa[1], body.inertia.y);
    store(part.aa[2], body.inertia.z);
    store(part.al[0], Vec4{0.0, h[2], -h[1], 0.0});
    store(part.al[1], Vec4{-h[2], 0.0, h[0], 0.0});
    store(part.al[2], Vec4{h[1], -h[0], 0.0, 0.0});
    store(part.la[0], Vec4{0.0, -h[2], h[1], 0.0});
    store(part.la[1], Vec4{h[2], 0.0, -h[0], 0.0});
    store(part.la[2], Vec4{-h[1], h[0], 0.0, 0.0});
    store(part.ll[0], Vec4{of.mass, 0.0, 0.0, 0.0});
    store(part.ll[1], Vec4{0.0, of.mass, 0.0, 0.0});
    store(part.ll[2], Vec4{0.0, 0.0, of.mass, 0.0});
    if (i > 0) store(part.motion, joint_motion(kinematics, static_cast<int>(i), part.slides));
  }
}

TWINBUS_AVX2_CLONES
void ForwardDynamics::inward(const double* tau) noexcept {
  for (std::size_t i = parts_.size() - 1; i > 0; --i) {
    Part& part = parts_[i];
    Part& parent = parts_[at(part.parent)];
    const double* a = part.motion.angular.value.data();
    const double* v = part.motion.linear.value.data();
    const Columns aa = {load(part.aa[0]), load(part.aa[1]), load(part.aa[2])};
    const Columns la = {load(part.la[0]), load(part.la[1]), load(part.la[2])};
    const Columns al = {load(part.al[0]), load(part.al[1]), load(part.al[2])};
    const Columns ll = {load(part.ll[0]), load(part.ll[1]), load(part.ll[2])};
    const Spatial column = {aa.times(a) + al.times(v), la.times(a) + ll.times(v)};
    const Spatial motion = load(part.motion);
    const Spatial bias = load(part.bias);
    part.d_inverse = 1.0 / (dot(motion, column) + part.rotor);
    part.u = tau[i - 1] - dot(motion, bias);
    store(part.column, column);
    const Spatial scaled = column * part.d_inverse;
    const double* ca = part.column.angular.value.data();
    const double* cl = part.column.linear.value.data();
    const auto fold = [](auto& to, const Columns& block, const Vec4& less, const double* by) {
      store(to[0], load(to[0]) + (block.x - less * by[0]));
      store(to[1], load(to[1]) + (block.y - less * by[1]));
      store(to[2], load(to[2]) + (block.z - less * by[2]));
    };
    fold(parent.aa, aa, scaled.angular, ca);
    fold(parent.la, la, scaled.linear, ca);
    fold(parent.al, al, scaled.angular, cl);
    fold(parent.ll, ll, scaled.linear, cl);
    store(parent.bias, load(parent.bias) + bias + scaled * part.u);
  }
}

TWINBUS_AVX2_CLONES
void ForwardDynamics::outward(double* qdd) noexcept {
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    Part& part = parts_[i];
    const Spatial above = load(parts_[at(part.parent)].acceleration);
    const double rate = part.d_inverse * (part.u - dot(load(part.column), above));
    if (qdd != nullptr) qdd[i - 1] = rate;
    store(part.acceleration, above + load(part.motion) * rate);
  }
}

void ForwardDynamics::base_solve(const StoredSpatial& bias) noexcept {
  Eigen::Matrix<double, 6, 1> x;
  x << bias.angular.value, bias.linear.value;
  x = base_.solve(-x);
  parts_[0].acceleration.angular.value = x.head<3>();
  parts_[0].acceleration.linear.value = x.tail<3>();
}

void ForwardDynamics::solve(const Kinematics& kinematics, const Configuration& configuration,
                            const Eigen::VectorXd& tau, const std::vector<ExternalWrench>& external,
                            Eigen::VectorXd& qdd) noexcept {
  origin_ = kinematics.link_in_world(0).translation();
  outward_drift(kinematics, configuration.qd.data());
  for (const ExternalWrench& wrench : external) {
    if (wrench.link < 0 || wrench.link >= static_cast<int>(parts_.size())) continue;
    StoredSpatial& bias = parts_[at(wrench.link)].bias;
    bias.angular.value -= wrench.torque + (wrench.point - origin_).cross(wrench.force);
    bias.linear.value -= wrench.force;
  }
  inward(tau.data());
  Part& base = parts_[0];
  base.acceleration = {};
  if (model_->floating_base) {
    Eigen::Matrix<double, 6, 6> inertia;
    for (int c = 0; c < 3; ++c) {
      inertia.block<3, 1>(0, c) = base.aa[c].value;
      inertia.block<3, 1>(3, c) = base.la[c].value;
      inertia.block<3, 1>(0, 3 + c) = base.al[c].value;
      inertia.block<3, 1>(3, 3 + c) = base.ll[c].value;
    }
    base_.compute(inertia);
    base_solve(base.bias);
  }
  outward(qdd.data());
  base_spin_ = base.acceleration.angular.value;
  base_acceleration_ = base.acceleration.linear.value;
}

void ForwardDynamics::contact_mobility(const ContactPoint* contacts, int count,
                                       Eigen::MatrixXd& mobility) noexcept {
  assert(count <= kMaxContacts);
  for (int b = 0; b < count; ++b) {
    for (int axis = 0; axis < 3; ++axis) {
      for (Part& part : parts_) part.u = 0.0;
      // The push travels to the base, and moves every joint on its way.
      const Eigen::Vector3d force = Eigen::Vector3d::Unit(axis);
      StoredSpatial bias;
      bias.angular.value = (origin_ - contacts[b].point).cross(force);
      bias.linear.value = -force;
      for (int i = contacts[b].link; i > 0; i = parts_[at(i)].parent) {
        Part& part = parts_[at(i)];
        part.u = -part.motion.angular.value.dot(bias.angular.value) -
                 part.motion.linear.value.dot(bias.linear.value);
        bias.angular.value += (part.u * part.d_inverse) * part.column.angular.value;
        bias.linear.value += (part.u * part.d_inverse) * part.column.linear.value;
      }
      parts_[0].acceleration = {};
      if (model_->floating_base) base_solve(bias);
      outward(nullptr);
      for (int a = 0; a < count; ++a) {
        const StoredSpatial& acceleration = parts_[at(contacts[a].link)].acceleration;
        const Eigen::Vector3d arm = contacts[a].point - origin_;
        mobility.block<3, 1>(3 * a, 3 * b + axis) =
            acceleration.linear.value + acceleration.angular.value.cross(arm);
      }
    }
  }
}

bool ForwardDynamics::contact_inertia(const ContactPoint* contacts, int count, double damping,
                                      Eigen::MatrixXd& inertia) noexcept {
  contact_mobility(contacts, count, inertia);
  for (int i = 0; i < 3 * count; ++i) inertia(i, i) += damping;
  contact_factor_.compute(inertia);
  if (contact_factor_.info() != Eigen::Success) return false;
  inertia.setIdentity();
  contact_factor_.solveInPlace(inertia);
  return inertia.allFinite();
}

}  // namespace twinbus
