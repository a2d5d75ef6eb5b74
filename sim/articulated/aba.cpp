#include "sim/articulated/aba.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "sim/articulated/articulated_kernels.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

// One call for both widths.
#define TWINBUS_SWEEP(name, ...)                                  \
  (wide_ ? TWINBUS_KERNEL(name(four_ __VA_OPT__(, ) __VA_ARGS__)) \
         : TWINBUS_KERNEL(name(one_ __VA_OPT__(, ) __VA_ARGS__)))

namespace {

// A rank costs in four lanes what it costs in one, but for what is gathered from parents.
constexpr double kWorthFour = 1.5;

template <class L>
void set_rows(BodyLanes<L>& d, const std::vector<JointRow>& rows) noexcept {
  for (std::size_t j = 0; j < d.of_joint.size(); ++j) {
    d.force[d.of_joint[j]] = rows[j].force;
    d.gain[d.of_joint[j]] = rows[j].gain;
  }
}

}  // namespace

ArticulatedBody::ArticulatedBody(const Model& model, bool fixed_base, double mass_scale) {
  check_links(model, fixed_base);
  state_.floating = !fixed_base;
  const std::size_t count = model.links.size();
  std::vector<int> depth(count, 0);
  branch_.assign(count, 0);
  links_.parent.assign(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    state_.mass += model.links[i].mass * mass_scale;
    if (i == 0) continue;
    const int parent = model.joints[i - 1].parent;
    links_.parent[i] = parent;
    depth[i] = depth[at(parent)] + 1;
    deepest_ = std::max(deepest_, depth[i]);
    if (!state_.floating) branch_[i] = parent == 0 ? static_cast<int>(i) : branch_[at(parent)];
  }
  four_.ranks = side_by_side(links_.parent, 4);
  wide_ = kWorthFour * static_cast<double>(four_.ranks.size()) < static_cast<double>(count);
  if (wide_) {
    fill(four_, model, mass_scale, links_);
  } else {
    four_.ranks.clear();
    one_.ranks = side_by_side(links_.parent, 1);
    fill(one_, model, mass_scale, links_);
  }
}

void ArticulatedBody::place(const Configuration& configuration) noexcept {
  TWINBUS_SWEEP(place, state_, configuration);
}

void ArticulatedBody::place(const Momentum& wanted, Configuration& configuration) noexcept {
  TWINBUS_SWEEP(correct, state_, wanted, configuration);
}

void ArticulatedBody::let_go() noexcept { TWINBUS_SWEEP(weigh_links); }

bool ArticulatedBody::inward(const std::vector<JointRow>& rows, double h) noexcept {
  wide_ ? set_rows(four_, rows) : set_rows(one_, rows);
  return TWINBUS_SWEEP(fold_inward, state_, h);
}

void ArticulatedBody::outward() noexcept { TWINBUS_SWEEP(accelerate, state_); }

void ArticulatedBody::add_wrench(int link, const Screw& wrench) noexcept {
  TWINBUS_KERNEL(fold_wrench(links_, state_, link, wrench));
}

int ArticulatedBody::response(int link, ResponseRow* rows) const noexcept {
  return TWINBUS_KERNEL(respond(links_, state_, link, rows));
}

Momentum ArticulatedBody::momentum() const noexcept {
  return wide_ ? baseline::momentum_in(state_, four_.momentum, four_.moment)
               : baseline::momentum_in(state_, one_.momentum, one_.moment);
}

BodyEnergy ArticulatedBody::energy(Eigen::Vector3d* world, Eigen::Vector3d* own) const noexcept {
  return TWINBUS_SWEEP(energy_in, state_, world, own);
}

double ArticulatedBody::fastest(double reach) const noexcept {
  const std::vector<double>& rates = wide_ ? four_.rate : one_.rate;
  const auto count = static_cast<Eigen::Index>(rates.size());
  const double sum = Eigen::Map<const Eigen::ArrayXd>(rates.data(), count).abs().sum();
  const Screw base = links_.screw(0, TWINBUS_LANE_FIELD(velocity));
  // A joint's axis is within reach too; a prismatic one moves what it carries at its own speed.
  return linear(base).norm() + angular(base).norm() * reach + std::max(1.0, 2.0 * reach) * sum;
}

void PointForces::add(const Eigen::Vector3d& r, const Eigen::Vector3d& f,
                      const Eigen::Matrix3d& weight) noexcept {
  // J(r)' weight J(r) = [ r^ W r^' , r^ W ; .. , W ], of what is symmetric the lower half.  In single numbers: what was
  // written in ones and is read in twos waits for the memory.
  const double x = r.x(), y = r.y(), z = r.z();
  torque.x() += y * f.z() - z * f.y();
  torque.y() += z * f.x() - x * f.z();
  torque.z() += x * f.y() - y * f.x();
  for (int k = 0; k < 3; ++k) force[k] += f[k];
  double turned[3][3];  // [column][row]
  for (int k = 0; k < 3; ++k) {
    const double a = weight(0, k), b = weight(1, k), c = weight(2, k);
    turned[k][0] = y * c - z * b;
    turned[k][1] = z * a - x * c;
    turned[k][2] = x * b - y * a;
    for (int row = k; row < 3; ++row) vv(row, k) += weight(row, k);
    for (int row = 0; row < 3; ++row) wv(row, k) += turned[k][row];
  }
  ww(0, 0) += y * turned[2][0] - z * turned[1][0];
  ww(1, 0) += z * turned[0][0] - x * turned[2][0];
  ww(2, 0) += x * turned[1][0] - y * turned[0][0];
  ww(1, 1) += z * turned[0][1] - x * turned[2][1];
  ww(2, 1) += x * turned[1][1] - y * turned[0][1];
  ww(2, 2) += x * turned[1][2] - y * turned[0][2];
}

void ArticulatedBody::add_force(int link, const Eigen::Vector3d& r,
                                const Eigen::Vector3d& force) noexcept {
  add_wrench_to_bias(link, r.cross(force), force);
}

void ArticulatedBody::add_wrench_to_bias(int link, const Eigen::Vector3d& torque,
                                         const Eigen::Vector3d& force) noexcept {
  double* bias = links_.of(link, TWINBUS_LANE_FIELD(bias));
  for (int k = 0; k < 3; ++k) {
    bias[static_cast<std::size_t>(k) * links_.stride] -= torque[k];
    bias[static_cast<std::size_t>(k + 3) * links_.stride] -= force[k];
  }
}

namespace {

// Of those of the lanes of a rank, a lane's own.
template <class L>
double* stiffness_of(BodyLanes<L>& d, std::size_t number) {
  const std::size_t lanes = sizeof(L) / sizeof(double),
                    size = sizeof(LinkLanes<L>) / sizeof(double);
  const std::size_t rank = number / size;
  if (!d.ranks[rank].touched) {
    double* to = reinterpret_cast<double*>(&d.stiff[rank].value);
    std::fill_n(to, sizeof(Inertia<L>) / sizeof(double), 0.0);
  }
  d.ranks[rank].touched = true;
  return reinterpret_cast<double*>(&d.stiff[rank].value) + number % size % lanes;
}

}  // namespace

void ArticulatedBody::add_forces(int link, const PointForces& forces) noexcept {
  add_wrench_to_bias(link, forces.torque, forces.force);
  const std::size_t number = links_.where[at(link)];
  double* to = wide_ ? stiffness_of(four_, number) : stiffness_of(one_, number);
  const auto add = [&](double x) {
    *to += x;
    to += links_.stride;
  };
  for (int k = 0; k < 3; ++k) {
    for (int row = k; row < 3; ++row) add(forces.ww(row, k));
  }
  for (int k = 0; k < 9; ++k) add(forces.wv.data()[k]);
  for (int k = 0; k < 3; ++k) {
    for (int row = k; row < 3; ++row) add(forces.vv(row, k));
  }
}

// In root axes the derivative of the root's velocity is the acceleration itself: no extra w x v.
void ArticulatedBody::advance(double h, Configuration& to) const noexcept {
  for (std::size_t i = 1; i < links_.where.size(); ++i) {
    const auto joint = static_cast<Eigen::Index>(i) - 1;
    to.qd[joint] += h * qdd(static_cast<int>(joint));
    to.q[joint] += h * to.qd[joint];
  }
  if (!state_.floating) return;
  const Screw a = acceleration(0);
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

}  // namespace twinbus::sim
