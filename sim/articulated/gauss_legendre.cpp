#include "sim/articulated/gauss_legendre.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "common/simd/vec4.h"

namespace twinbus::inline sim {

namespace {

// Of the speed that iterations would still change, beside 1 and the fastest [1/s].
constexpr double kSettled = 3e-10;
// Of the error that a part of a step may have.
constexpr double kSettledShare = 0.5;
constexpr int kMostIterations = 16;
constexpr int kMostParts = 500;             // tried in a step
constexpr double kMostHalved = 1.0 / 16.0;  // of a step that has no error to keep to
constexpr double kAlmost = 1e-9;
// The error of a step's speeds, from the last two of the four polynomials that its accelerations are:
// found by comparing with steps a sixth as long, for 21 motions of 5 robots.  Of 1200 parts three
// quarters are less wrong, 6 % more than twice as wrong.
constexpr double kOfPolynomials = 2e-3;
constexpr double kFirstReach = 0.1;  // [s]
constexpr int kJudged = 1;           // the iteration after which a part that is too long shows it
constexpr double kCautious = 0.8, kTooWrong = 4.0, kMostShrunk = 0.2, kMostGrown = 2.0;
constexpr double kOfWild = 0.5;       // at most, of a part that was
constexpr double kGentleGauss = 0.2;  // gentle()'s limit, for iterations that settle quickly
constexpr int kTurnSweeps = 8;        // they cost no dynamics
// Beyond such a change postures are not yet known.
constexpr double kFar = 0.2;  // [rad]

struct Gauss {
  Eigen::Vector4d c;
  Eigen::Matrix4d within;         // a_ij
  Eigen::Matrix4d twice;          // its square: from accelerations to positions
  Eigen::RowVector4d whole;       // b_j
  Eigen::RowVector4d whole_way;   // b_j (1 - c_j)
  Eigen::Matrix4d powers;         // from accelerations to the coefficients of 1, t, t^2, t^3
  Eigen::Vector4d second, third;  // to those of Legendre's polynomials of degree 2 and 3 over it

  Gauss() {
    const double near = std::sqrt(3.0 / 7 - 2.0 / 7 * std::sqrt(1.2)),
                 far = std::sqrt(3.0 / 7 + 2.0 / 7 * std::sqrt(1.2));
    c = 0.5 + 0.5 * Eigen::Array4d(-far, -near, near, far);
    Eigen::Matrix4d of_c, integrals;
    for (int k = 0; k < 4; ++k) {
      of_c.col(k) = c.array().pow(k);
      integrals.col(k) = c.array().pow(k + 1) / (k + 1);
    }
    const Eigen::Matrix4d weights = of_c.inverse();
    powers = weights;
    second = (weights.row(2) + 1.5 * weights.row(3)).transpose() / 6.0;
    third = weights.row(3).transpose() / 20.0;
    within = integrals * weights;
    twice = within * within;
    whole = Eigen::RowVector4d(1.0, 1.0 / 2, 1.0 / 3, 1.0 / 4) * weights;
    whole_way = whole * within;
  }
};

const Gauss& gauss() {
  static const Gauss method;
  return method;
}

Eigen::Matrix3d axes_of(const Eigen::Array4d& turn) noexcept {
  return Eigen::Quaterniond(Eigen::Vector4d(turn.matrix().normalized())).toRotationMatrix();
}

TWINBUS_INLINE Vec4 column_of(const Eigen::Matrix4d& weights, int k) noexcept {
  return load4(weights.data() + 4 * k);
}

// to = start + weights from, of each column of four; start: 0 if null.
TWINBUS_AVX2_CLONES
void integrate(const Eigen::Matrix4d& weights, const double* from, const double* start,
               Eigen::Index columns, double* to) noexcept {
  const Vec4 a = column_of(weights, 0), b = column_of(weights, 1), c = column_of(weights, 2),
             d = column_of(weights, 3);
  for (Eigen::Index k = 0; k < columns; ++k, from += 4, to += 4) {
    const Vec4 more = a * from[0] + b * from[1] + c * from[2] + d * from[3];
    store4(to, start != nullptr ? start[k] + more : more);
  }
}

// The same twice at once, from accelerations to rates and to angles.
TWINBUS_AVX2_CLONES
void integrate_twice(const Eigen::Matrix4d& within, const Eigen::Matrix4d& twice,
                     const Eigen::Vector4d& times, const double* from, const double* rate,
                     const double* angle, Eigen::Index columns, double* rates,
                     double* angles) noexcept {
  const Vec4 t = load4(times.data());
  for (Eigen::Index k = 0; k < columns; ++k, from += 4, rates += 4, angles += 4) {
    const double a = from[0], b = from[1], c = from[2], d = from[3];
    store4(rates, rate[k] + (column_of(within, 0) * a + column_of(within, 1) * b +
                             column_of(within, 2) * c + column_of(within, 3) * d));
    store4(angles, angle[k] + t * rate[k] +
                       (column_of(twice, 0) * a + column_of(twice, 1) * b +
                        column_of(twice, 2) * c + column_of(twice, 3) * d));
  }
}

TWINBUS_INLINE double sum(const Vec4& v) noexcept { return (v[0] + v[1]) + (v[2] + v[3]); }

// The largest of weights times column, either sign, of columns of four.
TWINBUS_AVX2_CLONES
double most_of(const Eigen::Vector4d& weights, const double* from, Eigen::Index columns) noexcept {
  const Vec4 w = load4(weights.data());
  double most = 0.0;
  for (Eigen::Index k = 0; k < columns; ++k, from += 4) {
    most = std::max(most, std::abs(sum(w * load4(from))));
  }
  return most;
}

// Of turns T with angular velocities w in their own axes, four of each, x y z s and x y z:
//     T' = 1/2 T (w, 0)
TWINBUS_AVX2_CLONES
void turning(const double* turns, const double* w, double* to) noexcept {
  const Vec4 x = load4(turns), y = load4(turns + 4), z = load4(turns + 8), s = load4(turns + 12);
  const Vec4 a = 0.5 * load4(w), b = 0.5 * load4(w + 4), c = 0.5 * load4(w + 8);
  store4(to, s * a + y * c - z * b);
  store4(to + 4, s * b + z * a - x * c);
  store4(to + 8, s * c + x * b - y * a);
  store4(to + 12, -x * a - y * b - z * c);
}

constexpr int kSpin = 3, kJoints = FourPostures::kFirstJoint;  // first columns

}  // namespace

GaussFlight::GaussFlight(const Model& model, bool fixed_base, double mass_scale, double most_error)
    : floating_(!fixed_base),
      joints_(model.joint_count()),
      most_error_(most_error),
      four_(model, fixed_base, mass_scale) {
  for (Points* points : {&acceleration_, &next_, &last_}) {
    points->setZero(FourPostures::kCount, kJoints + joints_);
  }
  for (Eigen::ArrayXd* start : {&start_.q, &start_.qd}) start->setZero(joints_);
  (void)gauss();
}

void GaussFlight::aim(const std::vector<JointLaw>& joints, double h) noexcept {
  const Eigen::Matrix4d within = h * gauss().within, twice = h * h * gauss().twice;
  const Eigen::Vector4d times = h * gauss().c;
  auto q = four_.q(), qd = four_.qd();
  integrate_twice(within, twice, times, acceleration_.col(kJoints).data(), start_.qd.data(),
                  start_.q.data(), joints_, qd.data(), q.data());
  if (floating_) {
    integrate(within, acceleration_.col(kSpin).data(), start_.spin.data(), 3, four_.spin().data());
  }
  if (!driven_) return;
  auto torque = four_.torque();
  for (int j = 0; j < static_cast<int>(joints_); ++j) {
    for (Eigen::Index p = 0; p < FourPostures::kCount; ++p) {
      torque(p, j) = joints[at(j)].torque_at(q(p, j), qd(p, j));
    }
  }
}

// From the step before, of length last_step_, which ended where this one begins.
void GaussFlight::guess(double h) noexcept {
  if (!(last_step_ > 0.0)) {
    acceleration_.setZero();
    return;
  }
  const Eigen::Array4d t = 1.0 + h / last_step_ * gauss().c.array();
  Eigen::Matrix4d powers;
  powers << Eigen::Array4d::Ones(), t, t * t, t * t * t;
  const Eigen::Matrix4d ahead = powers * gauss().powers;
  integrate(ahead, last_.data(), nullptr, last_.cols(), acceleration_.data());
}

GaussFlight::Outcome GaussFlight::settle(const std::vector<JointLaw>& joints, double h) noexcept {
  guess(h);
  error_ = 0.0;
  const double fastest = start_.qd.abs().maxCoeff() + start_.spin.abs().maxCoeff();
  const double enough = std::max(kSettled * h * (1.0 + fastest), kSettledShare * most_error_);
  double before = 1.0;  // how much the iteration before changed
  bool far = true;
  for (int i = 0; i < kMostIterations; ++i) {
    aim(joints, h);
    if (far && !four_.weigh()) return Outcome::kWild;
    const double change = h * four_.improve(acceleration_, next_);
    if (i == 0 &&
        !gentle(joints, h, kGentleGauss, [this](int j) { return four_.inverse_inertia(j); })) {
      return Outcome::kNotForThis;
    }
    if (!(change < HUGE_VAL)) return Outcome::kWild;
    acceleration_.swap(next_);
    far = far && h * change > kFar;
    // Each changes about as much less than the one before.
    const bool settled = i > 0 && change < before && change * change <= enough * before;
    if (most_error_ > 0.0 && (settled || i == kJudged)) {
      error_ = error(h);
      if (error_ > kTooWrong * most_error_) return Outcome::kWild;
    }
    if (settled) return Outcome::kTaken;
    before = change;
  }
  return Outcome::kWild;
}

double GaussFlight::longer(double error) const noexcept {
  return std::clamp(kCautious * std::pow(error / most_error_, -1.0 / 8.0), kMostShrunk, kMostGrown);
}

// Found by what it is of: how fast the motion swings and how far it turns meanwhile.
double GaussFlight::error(double h) const noexcept {
  const double* from = acceleration_.col(kSpin).data();
  const Eigen::Index columns = acceleration_.cols() - kSpin;
  return kOfPolynomials * h * most_of(gauss().third, from, columns) * h * h *
         most_of(gauss().second, from, columns);
}

void GaussFlight::finish_base(double h) noexcept {
  const Gauss& method = gauss();
  const Eigen::Matrix4d within = h * method.within;
  auto spin = four_.spin();
  integrate(within, acceleration_.col(kSpin).data(), start_.spin.data(), 3, spin.data());
  Turns turns, change;
  turns.rowwise() = start_.turn.transpose();
  for (int i = 0; i <= kTurnSweeps; ++i) {
    turning(turns.data(), spin.data(), change.data());
    if (i == kTurnSweeps) break;
    integrate(within, change.data(), start_.turn.data(), 4, turns.data());
  }
  const Eigen::Vector3d fall = {0.0, 0.0, -kGravity * h};
  start_.place += h * (start_.velocity + 0.5 * fall);
  start_.velocity += fall;
  for (Eigen::Index p = 0; p < FourPostures::kCount; ++p) {
    const Eigen::Vector3d felt =
        axes_of(turns.row(p).transpose()) * acceleration_.row(p).head<3>().matrix().transpose();
    start_.place += h * h * method.whole_way[p] * felt;
    start_.velocity += h * method.whole[p] * felt;
  }
  start_.spin +=
      h * (method.whole * acceleration_.middleCols<3>(kSpin).matrix()).transpose().array();
  start_.turn += h * (method.whole * change.matrix()).transpose().array();
}

bool GaussFlight::finish(const std::vector<JointLaw>& joints, double h) noexcept {
  for (int j = 0; j < static_cast<int>(joints_); ++j) {
    const auto a = acceleration_.col(kJoints + j).matrix();
    start_.q[j] += h * (start_.qd[j] + h * gauss().whole_way.dot(a));
    start_.qd[j] += h * gauss().whole.dot(a);
    if (!joints[at(j)].within_stops(start_.q[j])) return false;
  }
  if (floating_) finish_base(h);
  last_.swap(acceleration_);
  last_step_ = h;
  return true;
}

void GaussFlight::begin(const std::vector<JointLaw>& joints, const Configuration& c) noexcept {
  const Eigen::Matrix3d axes = c.base.linear();
  start_.turn = Eigen::Quaterniond(axes).coeffs();
  start_.place = c.base.translation();
  start_.velocity = c.base_velocity;
  start_.q = c.q;
  start_.qd = c.qd;
  if (floating_) {
    start_.spin = axes.transpose() * c.base_angular_velocity;
  } else {
    four_.hold(axes);
  }
  driven_ = false;
  for (const JointLaw& law : joints) {
    driven_ =
        driven_ || law.stiffness() != 0.0 || law.damping() != 0.0 || law.torque_at(0.0, 0.0) != 0.0;
  }
  if (!driven_) four_.torque().setZero();
}

void GaussFlight::end(Configuration& c) const noexcept {
  c.q = start_.q;
  c.qd = start_.qd;
  if (!floating_) return;
  c.base.translation() = start_.place;
  c.base.linear() = axes_of(start_.turn);
  c.base_velocity = start_.velocity;
  c.base_angular_velocity = c.base.linear() * start_.spin.matrix();
}

// In parts of at most reach_: less after one that was too wild or too wrong, more after good ones.
bool GaussFlight::step(ArticulatedBody& body, const std::vector<JointLaw>& joints, double h,
                       Configuration& configuration) noexcept {
  begin(joints, configuration);
  const bool by_error = most_error_ > 0.0;
  if (!by_error || !(last_step_ > 0.0)) reach_ = by_error ? kFirstReach : h;
  double left = h;
  for (int tried = 0; left > 0.0; ++tried) {
    const double parts = std::max(1.0, std::ceil(left / reach_ - kAlmost)), part = left / parts;
    const Outcome outcome = tried == kMostParts ? Outcome::kNotForThis : settle(joints, part);
    if (outcome == Outcome::kNotForThis) break;
    if (outcome == Outcome::kTaken) {
      if (!finish(joints, part)) break;
      left = parts > 1.0 ? left - part : 0.0;
    } else if (!by_error && part < 1.5 * kMostHalved * h) {
      break;
    }
    const double room = error_ > 0.0 ? longer(error_) : 1.0;
    reach_ = (outcome == Outcome::kTaken ? room : std::min(room, kOfWild)) * part;
  }
  if (left > 0.0) {
    interrupt();
    return false;
  }
  end(configuration);
  body.place(configuration);
  return true;
}

}  // namespace twinbus::sim
