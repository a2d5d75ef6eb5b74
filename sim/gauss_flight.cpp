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
constexpr int kTurnSweeps = 8;        // they cost no dynamics
// Beyond such a change of speed postures are not yet known.
constexpr double kFar = 0.1;  // [rad/s]

struct Gauss {
  Eigen::Vector4d c;
  Eigen::Matrix4d within;        // a_ij
  Eigen::Matrix4d twice;         // its square: from accelerations to positions
  Eigen::RowVector4d whole;      // b_j
  Eigen::RowVector4d whole_way;  // b_j (1 - c_j)
  Eigen::Matrix4d ahead;         // from accelerations of a step to those of the next

  Gauss() {
    const double near = std::sqrt(3.0 / 7 - 2.0 / 7 * std::sqrt(1.2)),
                 far = std::sqrt(3.0 / 7 + 2.0 / 7 * std::sqrt(1.2));
    c = 0.5 + 0.5 * Eigen::Array4d(-far, -near, near, far);
    Eigen::Matrix4d powers, integrals, next;  // of c
    for (int k = 0; k < 4; ++k) {
      powers.col(k) = c.array().pow(k);
      integrals.col(k) = c.array().pow(k + 1) / (k + 1);
      next.col(k) = (1.0 + c.array()).pow(k);
    }
    const Eigen::Matrix4d weights = powers.inverse();
    within = integrals * weights;
    twice = within * within;
    whole = Eigen::RowVector4d(1.0, 1.0 / 2, 1.0 / 3, 1.0 / 4) * weights;
    whole_way = whole * within;
    ahead = next * weights;
  }
};

const Gauss& gauss() {
  static const Gauss method;
  return method;
}

// Of a turn Q with angular velocity w in its own axes:  Q' = 1/2 Q (w, 0), as x y z w.
Eigen::Vector4d turning(const Eigen::Vector4d& turn, const Eigen::Vector3d& w) noexcept {
  return 0.5 * (Eigen::Quaterniond(turn) * Eigen::Quaterniond(0.0, w.x(), w.y(), w.z())).coeffs();
}

Eigen::Matrix3d axes_of(const Eigen::Array4d& turn) noexcept {
  return Eigen::Quaterniond(Eigen::Vector4d(turn.matrix().normalized())).toRotationMatrix();
}

// to = start + rate times + weights slopes, of each column of four.
TWINBUS_AVX2_CLONES
void integrate(const Eigen::Matrix4d& within, const double* slopes, const Eigen::Vector4d& times,
               const double* rate, const double* start, Eigen::Index columns, double* to) noexcept {
  const Vec4 weights[4] = {load4(within.col(0).data()), load4(within.col(1).data()),
                           load4(within.col(2).data()), load4(within.col(3).data())};
  const Vec4 t = load4(times.data());
  for (Eigen::Index c = 0; c < columns; ++c, slopes += 4, to += 4) {
    store4(to, start[c] + t * rate[c] + weights[0] * slopes[0] + weights[1] * slopes[1] +
                   weights[2] * slopes[2] + weights[3] * slopes[3]);
  }
}

constexpr int kSpin = 3, kJoints = FourPostures::kFirstJoint;  // first columns

}  // namespace

GaussFlight::GaussFlight(const Model& model, bool fixed_base, double mass_scale)
    : floating_(!fixed_base),
      joints_(model.joint_count()),
      four_(model, fixed_base, mass_scale),
      before_(model) {
  for (Points* points : {&acceleration_, &next_}) {
    points->setZero(FourPostures::kCount, kJoints + joints_);
  }
  for (Eigen::ArrayXd* start : {&start_q_, &start_qd_}) start->setZero(joints_);
  (void)gauss();
}

void GaussFlight::aim(const std::vector<JointLaw>& joints, double h) noexcept {
  const Eigen::Matrix4d within = h * gauss().within, twice = h * h * gauss().twice;
  const Eigen::Vector4d none = Eigen::Vector4d::Zero(), times = h * gauss().c;
  auto q = four_.q(), qd = four_.qd();
  const double *slopes = acceleration_.data() + FourPostures::kCount * kJoints,
               *rates = start_qd_.data();
  integrate(within, slopes, none, rates, rates, joints_, qd.data());
  integrate(twice, slopes, times, rates, start_q_.data(), joints_, q.data());
  if (floating_) {
    integrate(within, acceleration_.col(kSpin).data(), none, start_spin_.data(), start_spin_.data(),
              3, four_.spin().data());
  }
  if (!driven_) return;
  auto torque = four_.torque();
  for (int j = 0; j < static_cast<int>(joints_); ++j) {
    const JointLaw& law = joints[at(four_.joint_of(j))];
    for (Eigen::Index p = 0; p < FourPostures::kCount; ++p) {
      torque(p, j) = law.torque_at(q(p, j), qd(p, j));
    }
  }
}

GaussFlight::Outcome GaussFlight::settle(const std::vector<JointLaw>& joints, double h) noexcept {
  if (known_) {
    next_.matrix().noalias() = gauss().ahead.lazyProduct(acceleration_.matrix());
    acceleration_.swap(next_);
  } else {
    acceleration_.setZero();
  }
  const double fastest = start_qd_.abs().maxCoeff() + start_spin_.abs().maxCoeff();
  const double enough = kSettled * h * (1.0 + fastest);
  double before = 1.0;  // how much the iteration before changed
  bool far = true;
  for (int i = 0; i < kMostIterations; ++i) {
    aim(joints, h);
    if (!four_.qd().allFinite()) return Outcome::kWild;
    if (far) {
      if (!four_.accelerate(next_)) return Outcome::kWild;
    } else {
      next_ = acceleration_;
      four_.improve(next_);
    }
    if (i == 0 &&
        !gentle(joints, h, kGentleGauss, [this](int j) { return four_.inverse_inertia(j); })) {
      return Outcome::kNotForThis;
    }
    const double change = h * (next_ - acceleration_).abs().maxCoeff();
    acceleration_.swap(next_);
    far = far && change > kFar;
    // Each changes about as much less than the one before.
    if (i > 0 && change < before && change * change <= enough * before) return Outcome::kTaken;
    before = change;
  }
  return Outcome::kWild;
}

void GaussFlight::finish_base(double h, Configuration& c) noexcept {
  const Gauss& method = gauss();
  Turns turns, change;
  turns.rowwise() = start_turn_.transpose();
  for (int i = 0; i <= kTurnSweeps; ++i) {
    for (Eigen::Index p = 0; p < FourPostures::kCount; ++p) {
      const Eigen::Vector3d spin = four_.spin().row(p).matrix();
      change.row(p) = turning(turns.row(p).matrix(), spin).transpose();
    }
    if (i == kTurnSweeps) break;
    turns.matrix().noalias() = h * method.within.lazyProduct(change.matrix());
    turns.rowwise() += start_turn_.transpose();
  }
  const Eigen::Vector3d before = c.base_velocity, fall = {0.0, 0.0, -kGravity * h};
  c.base.translation() += h * (before + 0.5 * fall);
  c.base_velocity += fall;
  for (Eigen::Index p = 0; p < FourPostures::kCount; ++p) {
    const Eigen::Vector3d felt =
        axes_of(turns.row(p).transpose()) * acceleration_.row(p).head<3>().matrix().transpose();
    c.base.translation() += h * h * method.whole_way[p] * felt;
    c.base_velocity += h * method.whole[p] * felt;
  }
  const Eigen::Array3d spin =
      start_spin_ +
      h * (method.whole * acceleration_.middleCols<3>(kSpin).matrix()).transpose().array();
  const Eigen::Vector4d turn =
      start_turn_.matrix() + h * (method.whole * change.matrix()).transpose();
  c.base.linear() = axes_of(turn.array());
  c.base_angular_velocity = c.base.linear() * spin.matrix();
}

bool GaussFlight::finish(const std::vector<JointLaw>& joints, double h, Configuration& c) noexcept {
  aim(joints, h);
  for (int j = 0; j < static_cast<int>(joints_); ++j) {
    const int joint = four_.joint_of(j);
    const auto a = acceleration_.col(kJoints + j).matrix();
    c.q[joint] += h * (c.qd[joint] + h * gauss().whole_way.dot(a));
    c.qd[joint] += h * gauss().whole.dot(a);
    if (!joints[at(joint)].within_stops(c.q[joint])) return false;
  }
  if (floating_) finish_base(h, c);
  return true;
}

void GaussFlight::begin(const std::vector<JointLaw>& joints,
                        const Configuration& configuration) noexcept {
  const Eigen::Matrix3d axes = configuration.base.linear();
  start_turn_ = Eigen::Quaterniond(axes).coeffs();
  if (floating_) {
    start_spin_ = axes.transpose() * configuration.base_angular_velocity;
  } else {
    four_.hold(axes);
  }
  driven_ = false;
  for (int j = 0; j < static_cast<int>(joints_); ++j) {
    const int joint = four_.joint_of(j);
    const JointLaw& law = joints[at(joint)];
    start_q_[j] = configuration.q[joint];
    start_qd_[j] = configuration.qd[joint];
    driven_ =
        driven_ || law.stiffness() != 0.0 || law.damping() != 0.0 || law.torque_at(0.0, 0.0) != 0.0;
  }
  if (!driven_) four_.torque().setZero();
}

// halvings: how often h may still be halved.
GaussFlight::Outcome GaussFlight::advance(const std::vector<JointLaw>& joints, double h,
                                          int halvings, Configuration& configuration) noexcept {
  begin(joints, configuration);
  Outcome outcome = settle(joints, h);
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
