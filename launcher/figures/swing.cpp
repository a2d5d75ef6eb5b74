#include "launcher/figures/swing.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/dynamics/inverse_dynamics.h"
#include "common/math/index.h"
#include "sim/contact/ground_contacts.h"
#include "sim/world/static_equilibrium.h"

namespace twinbus::inline launcher {

namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kSmall = 1e-5;     // [m] and [rad], and a second of each
constexpr double kStandsOut = 5.0;  // a difference of extremes, of what is left at the end
constexpr std::size_t kFewest = 5;  // extremes

// Everything that acts on the robot, as one function of where it is and how it moves.
class StandingForces {
 public:
  StandingForces(const Model& model, const WorldConfig& world, const Standing& standing)
      : model_(model),
        world_(world),
        standing_(standing),
        kinematics_(model),
        dynamics_(model),
        tau_(model.joint_count()) {
    kinematics_.update(standing.configuration);
    for (std::size_t side = 0; side < 2; ++side) {
      const Sole& sole = model.soles[side];
      if (sole.link < 0) continue;
      for (int c = 0; c < kSoleCorners; ++c) anchor_[side][at(c)] = corner(sole, c);
      params_[side] =
          as_asked(world, rubber(sole.stiffness / kSoleCorners * world.stiffness_scale,
                                 sole.damping / kSoleCorners * world.damping_scale, 0.0));
    }
  }

  int size() const { return 6 + model_.joint_count(); }

  // What is missing to the accelerations, [base force, base torque, joints].
  VectorXd missing(const VectorXd& x, const VectorXd& v, const VectorXd& a) {
    Configuration c = standing_.configuration;
    c.base.translation() += x.head<3>();
    const Vector3d turn = x.segment<3>(3);
    if (turn.norm() > 0.0)
      c.base.linear() =
          Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix() * c.base.linear();
    c.q += x.tail(model_.joint_count());
    c.base_velocity = v.head<3>();
    c.base_angular_velocity = v.segment<3>(3);
    c.qd = v.tail(model_.joint_count());
    kinematics_.update(c);
    external_.clear();
    for (std::size_t side = 0; side < 2; ++side) {
      const Sole& sole = model_.soles[side];
      if (sole.link < 0) continue;
      for (int k = 0; k < kSoleCorners; ++k) push_corner(side, k);
    }
    VectorXd result(size());
    result.head<6>() = dynamics_.solve(kinematics_, c, a.tail(model_.joint_count()), a.head<3>(),
                                       a.segment<3>(3), external_, tau_);
    for (int j = 0; j < model_.joint_count(); ++j) {
      const Joint& joint = model_.joints[at(j)];
      const double servo = -world_.servo_kp_scale * joint.kp * x[6 + j] -
                           world_.servo_kd_scale * joint.kd * v[6 + j];
      result[6 + j] =
          tau_[j] + world_.friction_scale * joint.damping * v[6 + j] - standing_.tau[j] - servo;
    }
    return result;
  }

  // Of a force on a point, in the same coordinates.
  VectorXd work_of(const SteadyPush& push) {
    kinematics_.update(standing_.configuration);
    MatrixXd jacobian(6, size());
    kinematics_.point_jacobian(push.link, kinematics_.link_in_world(push.link) * push.point,
                               jacobian);
    return jacobian.topRows<3>().transpose() * push.force;
  }

 private:
  Vector3d corner(const Sole& sole, int k) const {
    return kinematics_.link_in_world(sole.link) * (sole.frame * sole_corner(sole, k));
  }

  void push_corner(std::size_t side, int k) {
    const Sole& sole = model_.soles[side];
    const ContactParams& p = params_[side];
    const Vector3d point = corner(sole, k);
    const Vector3d gone = point - anchor_[side][at(k)];
    const Vector3d velocity = kinematics_.point_velocity(sole.link, point);
    const double load = standing_.corner_force[side][at(k)];
    const double damping = damping_at(p, load / p.stiffness);
    Vector3d force = -p.tangent_stiffness * gone - p.tangent_damping * velocity;
    force.z() = load - p.stiffness * gone.z() - damping * velocity.z();
    external_.push_back({.link = sole.link, .point = point, .force = force});
  }

  const Model& model_;
  const WorldConfig& world_;
  const Standing& standing_;
  Kinematics kinematics_;
  InverseDynamics dynamics_;
  VectorXd tau_;
  std::array<std::array<Vector3d, kSoleCorners>, 2> anchor_;
  std::array<ContactParams, 2> params_;
  std::vector<ExternalWrench> external_;
};

}  // namespace

std::optional<Swing> swing_of(const Model& model, const WorldConfig& world, const VectorXd& q,
                              const SteadyPush& push, int joint) {
  const Sole& left = model.soles[0];
  const Sole& right = model.soles[1];
  const double of_corner = world.stiffness_scale / kSoleCorners;
  const Standing standing =
      stand(model, q, 1.0, {of_corner * left.stiffness, of_corner * right.stiffness},
            world.ground_height, false);
  if (!standing.balanced) return std::nullopt;
  StandingForces forces(model, world, standing);
  const int n = forces.size();
  const VectorXd zero = VectorXd::Zero(n);
  MatrixXd mass(n, n), damping(n, n), stiffness(n, n);
  for (int i = 0; i < n; ++i) {
    const VectorXd d = kSmall * VectorXd::Unit(n, i);
    const auto slope = [&](const VectorXd& plus, const VectorXd& minus) {
      return VectorXd((plus - minus) / (2.0 * kSmall));
    };
    stiffness.col(i) = slope(forces.missing(d, zero, zero), forces.missing(-d, zero, zero));
    damping.col(i) = slope(forces.missing(zero, d, zero), forces.missing(zero, -d, zero));
    mass.col(i) = slope(forces.missing(zero, zero, d), forces.missing(zero, zero, -d));
  }
  const Eigen::PartialPivLU<MatrixXd> inverse(mass);
  MatrixXd system = MatrixXd::Zero(2 * n, 2 * n);
  system.topRightCorner(n, n).setIdentity();
  system.bottomLeftCorner(n, n) = -inverse.solve(stiffness);
  system.bottomRightCorner(n, n) = -inverse.solve(damping);
  const Eigen::EigenSolver<MatrixXd> modes(system);
  if (modes.info() != Eigen::Success) return std::nullopt;
  VectorXd start = VectorXd::Zero(2 * n);
  start.head(n) = stiffness.fullPivLu().solve(forces.work_of(push));
  const Eigen::VectorXcd share =
      modes.eigenvectors().fullPivLu().solve(start.cast<std::complex<double>>());
  int most = -1;
  double seen = 0.0;
  for (int i = 0; i < 2 * n; ++i) {
    const std::complex<double> value = modes.eigenvalues()[i];
    const double size = std::abs(share[i] * modes.eigenvectors()(6 + joint, i));
    if (!(value.imag() > 0.0) || !(value.real() < 0.0) || !(size > seen)) continue;
    most = i;
    seen = size;
  }
  if (most < 0) return std::nullopt;
  const std::complex<double> value = modes.eigenvalues()[most];
  return Swing{2.0 * std::numbers::pi / value.imag(), -value.real()};
}

std::optional<Swing> swing_seen(const std::vector<double>& values, double step) {
  struct Extreme {
    double time, value;
  };
  std::vector<Extreme> extremes;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    const double before = values[i] - values[i - 1], after = values[i + 1] - values[i];
    if (!(before * after < 0.0)) continue;
    // The top of the parabola through the three.
    const double along = 0.5 * (before + after) / (before - after);
    extremes.push_back(
        {step * (static_cast<double>(i) + along), values[i] + 0.25 * along * (before + after)});
  }
  const auto tail = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 9 / 10);
  if (values.size() < 30) return std::nullopt;
  const auto [low, high] = std::minmax_element(tail, values.end());
  const double left = kStandsOut * (*high - *low);
  std::size_t count = 1;
  while (count < extremes.size() &&
         std::abs(extremes[count].value - extremes[count - 1].value) > left) {
    ++count;
  }
  if (count < kFewest || count > extremes.size()) return std::nullopt;
  // The first is not of the swing alone: what is faster has not died out.
  const std::size_t first = 1;
  const auto halves = static_cast<double>(count - 1 - first);
  const double half = (extremes[count - 1].time - extremes[first].time) / halves;
  const auto gap = [&](std::size_t i) {
    return std::abs(extremes[i].value - extremes[i - 1].value);
  };
  const double fell = std::log(gap(first + 1) / gap(count - 1));
  return Swing{2.0 * half, fell / (half * (halves - 1.0))};
}

}  // namespace twinbus::launcher
