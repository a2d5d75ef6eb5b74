#include "sim/gauss_flight.h"

#include <Eigen/LU>
#include <cmath>

#include "robot/index.h"
#include "robot/vec4.h"

namespace twinbus {

namespace {

// Of the speed that iterations would still change, beside 1 and the fastest [1/s].
constexpr double kSettled = 1e-9;
constexpr int kMostIterations = 16;
constexpr int kMostHalvings = 4;
constexpr double kGentleGauss = 0.2;  // gentle()'s limit, for iterations that settle quickly
constexpr int kTurnSweeps = 2, kLastTurnSweeps = 8;  // they cost no dynamics

struct Gauss {
  Eigen::Matrix4d within;    // a_ij
  Eigen::RowVector4d whole;  // b_j
  Eigen::Matrix4d ahead;     // from accelerations of a step to those of the next

  Gauss() {
    const double near = std::sqrt(3.0 / 7 - 2.0 / 7 * std::sqrt(1.2)),
                 far = std::sqrt(3.0 / 7 + 2.0 / 7 * std::sqrt(1.2));
    const Eigen::Array4d c = 0.5 + 0.5 * Eigen::Array4d(-far, -near, near, far);
    Eigen::Matrix4d powers, integrals, next;  // of c
    for (int k = 0; k < 4; ++k) {
      powers.col(k) = c.pow(k);
      integrals.col(k) = c.pow(k + 1) / (k + 1);
      next.col(k) = (1.0 + c).pow(k);
    }
    const Eigen::Matrix4d weights = powers.inverse();
    within = integrals * weights;
    whole = Eigen::RowVector4d(1.0, 1.0 / 2, 1.0 / 3, 1.0 / 4) * weights;
    ahead = next * weights;
  }
};

const Gauss& gauss() {
  static const Gauss method;
  return method;
}

// Of a turn Q with angular velocity w in its own axes:  Q' = 1/2 Q (w, 0), as x y z w.
Eigen::Vector4d turning(const Eigen::Vector4d& turn, double wx, double wy, double wz) noexcept {
  return 0.5 * (Eigen::Quaterniond(turn) * Eigen::Quaterniond(0.0, wx, wy, wz)).coeffs();
}

Eigen::Matrix3d axes_of(const Eigen::Array4d& turn) noexcept {
  return Eigen::Quaterniond(Eigen::Vector4d(turn.matrix().normalized())).toRotationMatrix();
}

// to = start + within * slopes, of each column of four.
TWINBUS_AVX2_CLONES
void integrate(const Eigen::Matrix4d& within, const double* slopes, const double* start,
               Eigen::Index columns, double* to) noexcept {
  const Vec4 weights[4] = {load4(within.col(0).data()), load4(within.col(1).data()),
                           load4(within.col(2).data()), load4(within.col(3).data())};
  for (Eigen::Index c = 0; c < columns; ++c, slopes += 4, to += 4) {
    store4(to, start[c] + weights[0] * slopes[0] + weights[1] * slopes[1] +
                   weights[2] * slopes[2] + weights[3] * slopes[3]);
  }
}

}  // namespace

GaussFlight::GaussFlight(const Model& model, bool fixed_base, double mass_scale)
    : floating_(!fixed_base),
      joints_(model.joint_count()),
      four_(model, fixed_base, mass_scale),
      before_(model) {
  for (Points* points : {&acceleration_, &next_, &rates_}) {
    points->setZero(FourPostures::kCount, 6 + joints_);
  }
  start_rates_.setZero(6 + joints_);
  (void)gauss();
}

void GaussFlight::follow(double h, const Configuration& start) noexcept {
  const Eigen::Matrix4d within = h * gauss().within;
  integrate(within, acceleration_.data(), start_rates_.data(), start_rates_.size(), rates_.data());
  four_.qd() = rates_.rightCols(joints_);
  integrate(within, four_.qd().data(), start.q.data(), joints_, four_.q().data());
}

void GaussFlight::turn(double h, int sweeps) noexcept {
  const Eigen::Matrix4d within = h * gauss().within;
  for (int i = 0; i < sweeps; ++i) {
    Turns change;
    for (Eigen::Index p = 0; p < FourPostures::kCount; ++p) {
      change.row(p) =
          turning(turns_.row(p).matrix(), rates_(p, 0), rates_(p, 1), rates_(p, 2)).transpose();
    }
    turns_.matrix().noalias() = within.lazyProduct(change.matrix());
    turns_.rowwise() += start_turn_.transpose();
  }
}

bool GaussFlight::evaluate(const std::vector<JointLaw>& joints) noexcept {
  auto torque = four_.torque();
  const auto q = four_.q(), qd = four_.qd();
  for (int j = 0; j < static_cast<int>(joints_); ++j) {
    for (Eigen::Index p = 0; p < FourPostures::kCount; ++p) {
      torque(p, j) = joints[at(j)].torque_at(q(p, j), qd(p, j));
    }
  }
  Eigen::Matrix3d axes[FourPostures::kCount];
  for (int p = 0; floating_ && p < FourPostures::kCount; ++p) {
    axes[p] = axes_of(turns_.row(p).transpose());
    const Eigen::Vector3d w = rates_.row(p).head<3>().matrix(), v = rates_.row(p).segment<3>(3);
    four_.set_base(p, axes[p], axes[p] * w, axes[p] * v);
  }
  if (!four_.accelerate()) return false;
  for (int p = 0; p < FourPostures::kCount; ++p) {
    if (floating_) {
      const Screw a = four_.base_acceleration(p);
      next_.row(p).head<3>() = (axes[p].transpose() * angular(a)).array();
      next_.row(p).segment<3>(3) = (axes[p].transpose() * linear(a)).array();
    }
    for (int j = 0; j < static_cast<int>(joints_); ++j) next_(p, 6 + j) = four_.qdd(p, j);
  }
  return true;
}

GaussFlight::Outcome GaussFlight::settle(const std::vector<JointLaw>& joints, double h,
                                         const Configuration& start) noexcept {
  if (known_) {
    next_.matrix().noalias() = gauss().ahead.lazyProduct(acceleration_.matrix());
    acceleration_.swap(next_);
  } else {
    acceleration_.setZero();
  }
  turns_.rowwise() = start_turn_.transpose();
  const double enough = kSettled * h * (1.0 + start_rates_.abs().maxCoeff());
  double before = 1.0;  // how much the iteration before changed
  for (int i = 0; i < kMostIterations; ++i) {
    follow(h, start);
    if (floating_) turn(h, kTurnSweeps);
    if (!rates_.allFinite() || !evaluate(joints)) return Outcome::kWild;
    if (i == 0 && !gentle(joints, h, kGentleGauss, [this](int j) { return four_.inverse_inertia(j); })) {
      return Outcome::kNotForThis;
    }
    const double change = h * (next_ - acceleration_).abs().maxCoeff();
    acceleration_.swap(next_);
    // Each changes about as much less than the one before.
    if (i > 0 && change < before && change * change <= enough * before) return Outcome::kTaken;
    before = change;
  }
  return Outcome::kWild;
}

bool GaussFlight::finish(const std::vector<JointLaw>& joints, double h, Configuration& c) noexcept {
  follow(h, c);
  const Eigen::RowVector4d whole = h * gauss().whole;
  const Eigen::ArrayXd& v0 = start_rates_;
  for (int j = 0; j < static_cast<int>(joints_); ++j) {
    const double q = c.q[j] + whole.dot(rates_.col(6 + j).matrix());
    if (!joints[at(j)].within_stops(q)) return false;
    next_(0, 6 + j) = q;
  }
  c.q = next_.row(0).tail(joints_).matrix();
  c.qd = v0.tail(joints_).matrix();
  c.qd.noalias() += whole.lazyProduct(acceleration_.rightCols(joints_).matrix()).transpose();
  if (!floating_) return true;
  turn(h, kLastTurnSweeps);
  Eigen::Vector4d attitude = start_turn_.matrix();
  for (Eigen::Index p = 0; p < FourPostures::kCount; ++p) {
    attitude += whole[p] *
                turning(turns_.row(p).matrix(), rates_(p, 0), rates_(p, 1), rates_(p, 2));
    const Eigen::Vector3d v = rates_.row(p).segment<3>(3).matrix();
    c.base.translation() += whole[p] * (axes_of(turns_.row(p).transpose()) * v);
  }
  const Eigen::Matrix<double, 6, 1> root =
      v0.head<6>().matrix() + whole.lazyProduct(acceleration_.leftCols<6>().matrix()).transpose();
  c.base.linear() = axes_of(attitude.array());
  c.base_angular_velocity = c.base.linear() * root.head<3>();
  c.base_velocity = c.base.linear() * root.tail<3>();
  return true;
}

void GaussFlight::begin(const Configuration& configuration) noexcept {
  const Eigen::Matrix3d axes = configuration.base.linear();
  start_turn_ = Eigen::Quaterniond(axes).coeffs();
  start_rates_.tail(joints_) = configuration.qd;
  if (floating_) {
    start_rates_.head<3>() = axes.transpose() * configuration.base_angular_velocity;
    start_rates_.segment<3>(3) = axes.transpose() * configuration.base_velocity;
    return;
  }
  for (int p = 0; p < FourPostures::kCount; ++p) {
    four_.set_base(p, axes, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  }
}

// halvings: how often h may still be halved.
GaussFlight::Outcome GaussFlight::advance(const std::vector<JointLaw>& joints, double h,
                                          int halvings, Configuration& configuration) noexcept {
  begin(configuration);
  Outcome outcome = settle(joints, h, configuration);
  if (outcome == Outcome::kTaken) {
    known_ = true;
    return finish(joints, h, configuration) ? outcome : Outcome::kNotForThis;
  }
  known_ = false;
  if (outcome == Outcome::kNotForThis || halvings == 0) return outcome;
  for (int half = 0; half < 2; ++half) {
    outcome = advance(joints, 0.5 * h, halvings - 1, configuration);
    if (outcome != Outcome::kTaken) return outcome;
  }
  known_ = false;  // what is known is of half a step
  return outcome;
}

bool GaussFlight::step(ArticulatedBody& body, const std::vector<JointLaw>& joints, double h,
                       Configuration& configuration) noexcept {
  before_ = configuration;
  if (advance(joints, h, kMostHalvings, configuration) != Outcome::kTaken) {
    known_ = false;
    configuration = before_;
    return false;
  }
  body.place(configuration);
  return true;
}

}  // namespace twinbus
