#include "robot/kinematics/inverse_kinematics.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "common/math/index.h"
#include "common/math/pose_math.h"

namespace twinbus::inline robot {

namespace {

constexpr double kFirstDamping = 1e-3;
constexpr double kLeastDamping = 1e-8;
constexpr double kMostDamping = 1e4;
constexpr int kMostSlow = 4;      // steps that hardly help, before another posture is tried
constexpr int kSamples = 150;     // of joints that the closed form leaves over
constexpr int kTriesInVain = 4;   // for the nearest posture, once it is known that none reaches
constexpr double kWithin = 1e-7;  // beyond limits, and still one step away from them [rad]

std::vector<int> path_between(const Model& model, int base_link, int link) {
  std::vector<int> path;
  for (int i = link; i != base_link; i = model.links[at(i)].parent) {
    if (i <= 0) {
      throw std::runtime_error("inverse kinematics: link " + model.links.at(at(link)).name +
                               " does not hang on link " + model.links.at(at(base_link)).name);
    }
    path.push_back(i - 1);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

Eigen::Isometry3d moved(const Joint& joint, double q) noexcept {
  Eigen::Isometry3d pose = joint.placement;
  if (joint.kind == JointKind::kPrismatic) {
    pose.translation() += q * (joint.placement.linear() * joint.axis);
  } else {
    pose.linear() = joint.placement.linear() * rotation_about(joint.axis, q);
  }
  return pose;
}

}  // namespace

InverseKinematics::InverseKinematics(const Model& model, int base_link, int link,
                                     const Eigen::Isometry3d& frame)
    : model_(&model),
      path_(path_between(model, base_link, link)),
      frame_(frame),
      closed_(model, path_, frame),
      trial_(model.joint_count()),
      now_(model.joint_count()),
      best_(model.joint_count()) {
  for (const int joint : path_) {
    if (model.joints[at(joint)].mimic < 0) joints_.push_back(joint);
  }
  if (joints_.size() > static_cast<std::size_t>(kMaxChain)) {
    throw std::runtime_error("inverse kinematics: more than " + std::to_string(kMaxChain) +
                             " joints between links " + model.links[at(base_link)].name + " and " +
                             model.links[at(link)].name);
  }
  held_.fill(std::numeric_limits<double>::quiet_NaN());
  // Steps of powers of 1 / g, g^(n+1) = g + 1, fill the box of all postures most evenly.
  double g = 1.5;
  for (int round = 0; round < 50; ++round) {
    g = std::pow(1.0 + g, 1.0 / (1.0 + static_cast<double>(joints_.size())));
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    seed_step_[i] = std::pow(1.0 / g, static_cast<double>(i + 1));
  }
  jacobian_.setZero(6, static_cast<Eigen::Index>(joints_.size()));
}

void InverseKinematics::hold(int joint, double place) noexcept {
  const auto found = std::find(joints_.begin(), joints_.end(), joint);
  if (found != joints_.end()) held_[static_cast<std::size_t>(found - joints_.begin())] = place;
}

double InverseKinematics::low(std::size_t i, const IkOptions& options) const noexcept {
  if (std::isfinite(held_[i])) return held_[i];
  const Joint& joint = model_->joints[at(joints_[i])];
  return std::min(joint.lower + options.limit_margin, 0.5 * (joint.lower + joint.upper));
}

double InverseKinematics::high(std::size_t i, const IkOptions& options) const noexcept {
  if (std::isfinite(held_[i])) return held_[i];
  const Joint& joint = model_->joints[at(joints_[i])];
  return std::max(joint.upper - options.limit_margin, 0.5 * (joint.lower + joint.upper));
}

Eigen::Isometry3d InverseKinematics::pose(const Eigen::VectorXd& q) const noexcept {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (const int j : path_) pose = pose * moved(model_->joints[at(j)], q[j]);
  return pose * frame_;
}

Eigen::Isometry3d InverseKinematics::pose_and_axes(const Eigen::VectorXd& q) noexcept {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::size_t i = 0;
  for (const int j : path_) {
    const Joint& joint = model_->joints[at(j)];
    pose = pose * moved(joint, q[j]);
    if (joint.mimic >= 0) continue;
    axis_[i] = pose.linear() * joint.axis;
    origin_[i] = pose.translation();
    ++i;
  }
  return pose * frame_;
}

// (J^T J + damping I) dq = J^T error over the joints that are free: not pushing against a limit.
InverseKinematics::Step InverseKinematics::step(const Eigen::Matrix<double, 6, 1>& error,
                                                double damping, const IkOptions& options,
                                                const Eigen::VectorXd& q) noexcept {
  const auto n = static_cast<Eigen::Index>(joints_.size());
  std::array<bool, kMaxChain> fixed{};
  Step dq = Step::Zero(n);
  for (int round = 0; round <= kMaxChain; ++round) {
    Normal normal = jacobian_.transpose() * jacobian_;
    Step right = jacobian_.transpose() * error;
    for (Eigen::Index i = 0; i < n; ++i) {
      normal(i, i) += damping;
      if (!fixed[static_cast<std::size_t>(i)]) continue;
      normal.row(i).setZero();
      normal.col(i).setZero();
      normal(i, i) = 1.0;
      right[i] = 0.0;
    }
    dq = normal.llt().solve(right);
    bool all_inside = true;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const double value = q[joints_[i]];
      const double change = dq[static_cast<Eigen::Index>(i)];
      const bool outwards =
          (value <= low(i, options) && change < 0.0) || (value >= high(i, options) && change > 0.0);
      if (!fixed[i] && outwards) {
        fixed[i] = true;
        all_inside = false;
      }
    }
    if (all_inside) break;
  }
  return dq;
}

// From now_ downhill; the result is in now_.
IkResult InverseKinematics::descend(const Eigen::Isometry3d& target, const IkOptions& options,
                                    bool may_give_up) noexcept {
  const auto n = static_cast<Eigen::Index>(joints_.size());
  trial_ = now_;
  const auto error_of = [&](const Eigen::Isometry3d& pose) {
    Eigen::Matrix<double, 6, 1> error;
    error << target.translation() - pose.translation(),
        options.rotation_weight * rotation_vector(target.linear() * pose.linear().transpose());
    return error;
  };
  Eigen::Isometry3d pose = pose_and_axes(now_);
  Eigen::Matrix<double, 6, 1> error = error_of(pose);
  double damping = kFirstDamping;
  int slow = 0;  // steps in a row that hardly helped: a local minimum, often at limits
  IkResult result;
  const auto good = [&] {
    result.position_error = error.head<3>().norm();
    result.rotation_error =
        options.rotation_weight > 0.0 ? error.tail<3>().norm() / options.rotation_weight : 0.0;
    result.reached = result.position_error <= options.position_tolerance &&
                     result.rotation_error <= options.rotation_tolerance;
    return result.reached;
  };

  while (!good() && result.iterations < options.iterations && damping < kMostDamping) {
    if (may_give_up && slow >= kMostSlow) break;
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Joint& joint = model_->joints[at(joints_[k])];
      if (joint.kind == JointKind::kPrismatic) {
        jacobian_.block<3, 1>(0, i) = axis_[k];
        jacobian_.block<3, 1>(3, i).setZero();
      } else {
        jacobian_.block<3, 1>(0, i) = axis_[k].cross(pose.translation() - origin_[k]);
        jacobian_.block<3, 1>(3, i) = options.rotation_weight * axis_[k];
      }
    }
    // Levenberg and Marquardt: damp more until the step makes the error smaller.
    bool better = false;
    for (; !better && result.iterations < options.iterations && damping < kMostDamping;
         ++result.iterations) {
      const Step dq = step(error, damping, options, now_);
      for (std::size_t i = 0; i < joints_.size(); ++i) {
        trial_[joints_[i]] = std::clamp(now_[joints_[i]] + dq[static_cast<Eigen::Index>(i)],
                                        low(i, options), high(i, options));
      }
      const Eigen::Isometry3d next = pose_and_axes(trial_);
      const Eigen::Matrix<double, 6, 1> next_error = error_of(next);
      const double ratio = next_error.squaredNorm() / error.squaredNorm();
      better = ratio < 1.0;
      if (better) {
        slow = ratio > 0.7 ? slow + 1 : 0;
        now_ = trial_;
        pose = next;
        error = next_error;
        damping = std::max(0.1 * damping, kLeastDamping);
      } else {
        damping *= 4.0;
      }
    }
  }
  return result;
}

bool InverseKinematics::closed_form(const Eigen::Isometry3d& target, const IkOptions& options,
                                    bool& sure) noexcept {
  if (!closed_.usable() || !(options.rotation_weight > 0.0)) return false;
  ClosedForm::Angles start{}, from{}, lows{}, highs{};
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    lows[i] = low(i, options);
    highs[i] = high(i, options);
    start[i] = std::clamp(now_[joints_[i]], lows[i], highs[i]);
  }
  ClosedForm::Candidate best;
  const std::vector<int>& locked = closed_.locked();
  const int samples = locked.empty() ? 1 : kSamples;
  for (int k = 0; k < samples && !(best.beyond <= kWithin); ++k) {
    from = start;
    for (std::size_t i = 0; k > 0 && i < locked.size(); ++i) {
      const auto joint = static_cast<std::size_t>(locked[i]);
      const double least = std::max(lows[joint], start[joint] - 3.2);
      const double most = std::min(highs[joint], start[joint] + 3.2);
      const double step = locked.size() == 1 ? 0.6180339887498949 : seed_step_[i];
      from[joint] = least + std::fmod(0.5 + k * step, 1.0) * (most - least);
    }
    closed_.solve(target, from, lows, highs, best);
  }
  if (!std::isfinite(best.beyond)) return false;
  sure = locked.empty() && best.beyond > kWithin;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    now_[joints_[i]] = std::clamp(best.q[i], lows[i], highs[i]);
  }
  return true;
}

IkResult InverseKinematics::solve(const Eigen::Isometry3d& target, const IkOptions& options,
                                  Eigen::VectorXd& q) noexcept {
  IkResult result;
  if (!target.matrix().allFinite() || !q.allFinite()) return result;
  double least = std::numeric_limits<double>::infinity();
  bool sure = false;  // that nothing reaches it
  now_ = q;
  const bool closed = options.restarts > 0 && closed_form(target, options, sure);
  const int first = closed ? -1 : 0;
  const int last = sure ? std::min(options.restarts, kTriesInVain) : options.restarts;
  for (int attempt = first; attempt <= last && !result.reached; ++attempt) {
    if (attempt >= 0) now_ = q;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      double& value = now_[joints_[i]];
      if (attempt > 0 && std::isfinite(high(i, options) - low(i, options))) {
        const double place = std::fmod(0.5 + attempt * seed_step_[i], 1.0);
        value = low(i, options) + place * (high(i, options) - low(i, options));
      }
      value = std::clamp(value, low(i, options), high(i, options));
    }
    IkResult next = descend(target, options, attempt < last);
    next.iterations += result.iterations;
    const double error = next.position_error + options.rotation_weight * next.rotation_error;
    if (error < least) {
      least = error;
      best_ = now_;
      result = next;
    }
    result.iterations = next.iterations;
  }
  for (const int joint : joints_) q[joint] = best_[joint];
  return result;
}

}  // namespace twinbus::robot
