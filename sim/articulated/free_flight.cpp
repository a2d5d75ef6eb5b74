#include "sim/articulated/free_flight.h"

#include <algorithm>

#include "common/math/index.h"

namespace twinbus::inline sim {

namespace {

// Fehlberg 1968 (NASA TR R-287), RK7(8).
constexpr double kA[13][12] = {
    {},
    {2.0 / 27},
    {1.0 / 36, 1.0 / 12},
    {1.0 / 24, 0, 1.0 / 8},
    {5.0 / 12, 0, -25.0 / 16, 25.0 / 16},
    {1.0 / 20, 0, 0, 1.0 / 4, 1.0 / 5},
    {-25.0 / 108, 0, 0, 125.0 / 108, -65.0 / 27, 125.0 / 54},
    {31.0 / 300, 0, 0, 0, 61.0 / 225, -2.0 / 9, 13.0 / 900},
    {2.0, 0, 0, -53.0 / 6, 704.0 / 45, -107.0 / 9, 67.0 / 90, 3.0},
    {-91.0 / 108, 0, 0, 23.0 / 108, -976.0 / 135, 311.0 / 54, -19.0 / 60, 17.0 / 6, -1.0 / 12},
    {2383.0 / 4100, 0, 0, -341.0 / 164, 4496.0 / 1025, -301.0 / 82, 2133.0 / 4100, 45.0 / 82,
     45.0 / 164, 18.0 / 41},
    {3.0 / 205, 0, 0, 0, 0, -6.0 / 41, -3.0 / 205, -3.0 / 41, 3.0 / 41, 6.0 / 41},
    {-1777.0 / 4100, 0, 0, -341.0 / 164, 4496.0 / 1025, -289.0 / 82, 2193.0 / 4100, 51.0 / 82,
     33.0 / 164, 12.0 / 41, 0, 1.0}};
constexpr double kB[13] = {0,        0,         0,         0, 0,          34.0 / 105, 9.0 / 35,
                           9.0 / 35, 9.0 / 280, 9.0 / 280, 0, 41.0 / 840, 41.0 / 840};

// gentle()'s limits: well inside the stable range.
constexpr double kGentle = 1.0;
constexpr double kGentleMultistep = 0.2;

}  // namespace

FlightMotion::FlightMotion(const Model& model, const WorldConfig& config)
    : method_(config.flight),
      fixed_base_(config.fixed_base),
      joints_(model.joint_count()),
      first_q_(fixed_base_ ? 0 : 7),
      first_qd_(fixed_base_ ? joints_ : joints_ + 13),
      rows_(model.joints.size()) {
  if (method_ == Flight::kGauss8)
    gauss_.emplace(model, fixed_base_, config.mass_scale, config.flight_error);
  const Eigen::Index size = first_qd_ + joints_;
  for (Eigen::VectorXd* v : {&y_, &sum_, &trial_}) v->setZero(size);
  for (Eigen::VectorXd& v : k_) v.setZero(size);
  for (Eigen::VectorXd& v : history_) v.setZero(size);
  scratch_.q.setZero(joints_);
  scratch_.qd.setZero(joints_);
}

void FlightMotion::read(const Configuration& c) noexcept {
  if (!fixed_base_) {
    const Eigen::Matrix3d R = c.base.linear();
    Eigen::Vector4d turn = Eigen::Quaterniond(R).coeffs();
    // The history knows one of the two signs.
    if (known_ > 0 && turn.dot(y_.segment<4>(3)) < 0.0) turn = -turn;
    y_.head<3>() = c.base.translation();
    y_.segment<4>(3) = turn;
    y_.segment<3>(first_qd_ - 6) = R.transpose() * c.base_angular_velocity;
    y_.segment<3>(first_qd_ - 3) = R.transpose() * c.base_velocity;
  }
  y_.segment(first_q_, joints_) = c.q;
  y_.tail(joints_) = c.qd;
}

void FlightMotion::write(const Eigen::VectorXd& y, Configuration& c) const noexcept {
  if (!fixed_base_) {
    const Eigen::Matrix3d R =
        Eigen::Quaterniond(Eigen::Vector4d(y.segment<4>(3).normalized())).toRotationMatrix();
    c.base.translation() = y.head<3>();
    c.base.linear() = R;
    c.base_angular_velocity = R * y.segment<3>(first_qd_ - 6);
    c.base_velocity = R * y.segment<3>(first_qd_ - 3);
  }
  c.q = y.segment(first_q_, joints_);
  c.qd = y.tail(joints_);
}

bool FlightMotion::evaluate(ArticulatedBody& body, const std::vector<JointLaw>& joints,
                            const Configuration& c, Eigen::VectorXd& dy) noexcept {
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    rows_[j] = {.force = joints[j].torque_at(c.q[index], c.qd[index]), .gain = 0.0};
  }
  if (!body.inward(rows_, 0.0)) return false;
  body.outward();
  if (!fixed_base_) {
    const Eigen::Matrix3d R = c.base.linear();
    const Screw a = body.acceleration(0);
    dy.head<3>() = c.base_velocity;
    const Eigen::Vector3d w = R.transpose() * c.base_angular_velocity;
    const Eigen::Quaterniond turn(Eigen::Vector4d(trial_.segment<4>(3)));
    dy.segment<4>(3) = 0.5 * (turn * Eigen::Quaterniond(0.0, w.x(), w.y(), w.z())).coeffs();
    dy.segment<3>(first_qd_ - 6) = R.transpose() * angular(a);
    dy.segment<3>(first_qd_ - 3) = R.transpose() * linear(a);
  }
  dy.segment(first_q_, joints_) = c.qd;
  for (Eigen::Index j = 0; j < joints_; ++j) {
    dy[first_qd_ + j] = body.qdd(static_cast<int>(j));
  }
  return true;
}

// dy at trial_.
bool FlightMotion::stage(ArticulatedBody& body, const std::vector<JointLaw>& joints,
                         int index) noexcept {
  if (!trial_.allFinite()) return false;
  write(trial_, scratch_);
  body.place(scratch_);
  return evaluate(body, joints, scratch_, k_[at(index)]);
}

bool FlightMotion::runge_kutta(ArticulatedBody& body, const std::vector<JointLaw>& joints,
                               double h) noexcept {
  sum_ = y_ + h / 6.0 * k_[0];
  const double share[3] = {0.5, 0.5, 1.0}, weight[3] = {1.0 / 3, 1.0 / 3, 1.0 / 6};
  for (int s = 0; s < 3; ++s) {
    trial_ = y_ + share[s] * h * k_[at(s)];
    if (!stage(body, joints, s + 1)) return false;
    sum_ += weight[s] * h * k_[at(s) + 1];
  }
  return true;
}

bool FlightMotion::fehlberg(ArticulatedBody& body, const std::vector<JointLaw>& joints,
                            double h) noexcept {
  for (int s = 1; s < kStages; ++s) {
    trial_ = y_;
    for (int k = 0; k < s; ++k) {
      if (kA[s][k] != 0.0) trial_ += h * kA[s][k] * k_[at(k)];
    }
    if (!stage(body, joints, s)) return false;
  }
  sum_ = y_;
  for (int s = 0; s < kStages; ++s) {
    if (kB[s] != 0.0) sum_ += h * kB[s] * k_[at(s)];
  }
  return true;
}

bool FlightMotion::step(ArticulatedBody& body, const std::vector<JointLaw>& joints, double h,
                        Configuration& configuration) noexcept {
  for (const JointLaw& joint : joints) {
    if (!joint.smooth()) return false;
  }
  if (gauss_) return gauss_->step(body, joints, h, configuration);
  read(configuration);
  trial_ = y_;
  const double limit = method_ == Flight::kAb4 ? kGentleMultistep : kGentle;
  if (!evaluate(body, joints, configuration, k_[0]) ||
      !gentle(joints, h, limit, [&](int j) { return body.inverse_inertia(j); })) {
    known_ = 0;
    return false;
  }
  bool done = false;
  if (method_ == Flight::kRkf78) {
    done = fehlberg(body, joints, h);
  } else {
    newest_ = (newest_ + 1) % 4;
    history_[at(newest_)] = k_[0];
    known_ = std::min(known_ + 1, 4);
    if (method_ == Flight::kAb4 && known_ == 4) {
      const auto past = [&](int n) -> const Eigen::VectorXd& {
        return history_[at((newest_ + 4 - n) % 4)];
      };
      sum_ = y_ + h / 24.0 * (55.0 * past(0) - 59.0 * past(1) + 37.0 * past(2) - 9.0 * past(3));
      done = true;
    } else {
      done = runge_kutta(body, joints, h);
    }
  }
  done = done && sum_.allFinite();
  for (std::size_t j = 0; done && j < joints.size(); ++j) {
    done = joints[j].within_stops(sum_[first_q_ + static_cast<Eigen::Index>(j)]);
  }
  if (!done) {
    known_ = 0;
    body.place(configuration);
    return false;
  }
  if (!fixed_base_) sum_.segment<4>(3).normalize();
  y_.swap(sum_);
  write(y_, configuration);
  body.place(configuration);
  return true;
}

}  // namespace twinbus::sim
