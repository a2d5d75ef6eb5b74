#include "test/oracles/prioritized_ik.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/index.h"
#include "common/math/pose_math.h"

namespace twinbus {

namespace {

constexpr double kDependent = 1e-6;  // a row that higher ones leave less than this of is dropped
constexpr double kLeastStep = 1e-6;
constexpr double kSameError = 0.1;  // of the tolerance: errors that differ by less are the same
constexpr int kMends = 2;           // steps after each step, for what it did to higher levels
constexpr int kMostRounds = 12;     // of joints found to go beyond limits

int row_count(const IkTask& task, int joints) noexcept {
  switch (task.kind) {
    case IkTaskKind::kPose:
      return 6;
    case IkTaskKind::kPosture:
      return joints;
    default:
      return 3;
  }
}

// Negative: a is better; positive: worse; 0: the same.
int compare(const PrioritizedIkResult& a, const PrioritizedIkResult& b, double tolerance) noexcept {
  for (std::size_t k = 0; k < a.error.size(); ++k) {
    if (a.error[k] <= tolerance && b.error[k] <= tolerance) continue;
    if (a.error[k] < b.error[k] - kSameError * tolerance) return -1;
    if (!(a.error[k] <= b.error[k] + kSameError * tolerance)) return 1;
  }
  return 0;
}

}  // namespace

PrioritizedIk::PrioritizedIk(const Model& model)
    : model_(&model),
      kinematics_(model),
      base_free_(model.floating_base),
      held_(model.joints.size(), 0),
      fixed_(6 + model.joints.size(), 0),
      jacobian_(6, 6 + model.joint_count()),
      com_jacobian_(3, 6 + model.joint_count()),
      row_(6 + model.joint_count()),
      task_(6 + model.joint_count(), static_cast<int>(kMaxRows)),
      projected_(6 + model.joint_count(), static_cast<int>(kMaxRows)),
      basis_(6 + model.joint_count(), static_cast<int>(kMaxRows)),
      error_(static_cast<int>(kMaxRows)),
      step_(6 + model.joint_count()),
      trial_(model) {}

void PrioritizedIk::hold(int joint, bool held) noexcept { held_[at(joint)] = held ? 1 : 0; }

double PrioritizedIk::low(int joint, const PrioritizedIkOptions& options) const noexcept {
  const Joint& of = model_->joints[at(joint)];
  return std::min(of.lower + options.limit_margin, 0.5 * (of.lower + of.upper));
}

double PrioritizedIk::high(int joint, const PrioritizedIkOptions& options) const noexcept {
  const Joint& of = model_->joints[at(joint)];
  return std::max(of.upper - options.limit_margin, 0.5 * (of.lower + of.upper));
}

bool PrioritizedIk::sound(std::span<const IkTask> tasks) const noexcept {
  int rows = 0;
  for (const IkTask& task : tasks) {
    const bool of_link = task.kind != IkTaskKind::kCom && task.kind != IkTaskKind::kPosture;
    if (task.level < 0 || task.level >= kMaxLevels || !task.target.matrix().allFinite() ||
        !task.frame.matrix().allFinite() || !task.axes.allFinite() || !std::isfinite(task.weight) ||
        (of_link && (task.link < 0 || task.link >= model_->link_count())) ||
        (task.kind == IkTaskKind::kPosture &&
         (task.posture == nullptr || task.posture->size() != model_->joint_count() ||
          !task.posture->allFinite()))) {
      return false;
    }
    rows += row_count(task, model_->joint_count());
  }
  return rows <= kMaxRows;
}

// A joint that follows another moves with it.
void PrioritizedIk::add_row(double error, double weight) noexcept {
  for (int j = model_->joint_count() - 1; j >= 0; --j) {
    const Joint& joint = model_->joints[at(j)];
    if (joint.mimic < 0) continue;
    row_[6 + joint.mimic] += joint.mimic_multiplier * row_[6 + j];
    row_[6 + j] = 0.0;
  }
  task_.col(rows_) = weight * row_;
  error_[rows_++] = weight * error;
}

void PrioritizedIk::add_rows(const IkTask& task, const PrioritizedIkOptions& options,
                             const Configuration& configuration) noexcept {
  if (task.kind == IkTaskKind::kPosture) {
    for (int j = 0; j < model_->joint_count(); ++j) {
      if (model_->joints[at(j)].mimic >= 0) continue;
      row_.setZero();
      row_[6 + j] = 1.0;
      add_row((*task.posture)[j] - configuration.q[j], task.weight);
    }
    return;
  }
  if (task.kind == IkTaskKind::kCom) {
    kinematics_.com_jacobian(com_jacobian_);
    for (int k = 0; k < 3; ++k) {
      row_ = com_jacobian_.row(k).transpose();
      add_row(task.target.translation()[k] - kinematics_.com()[k], task.weight * task.axes[k]);
    }
    return;
  }
  const Eigen::Isometry3d& link = kinematics_.link_in_world(task.link);
  const Eigen::Vector3d point = link * task.frame.translation();
  kinematics_.point_jacobian(task.link, point, jacobian_);
  for (int k = 0; k < 3 && task.kind != IkTaskKind::kRotation; ++k) {
    row_ = jacobian_.row(k).transpose();
    add_row(task.target.translation()[k] - point[k], task.weight * task.axes[k]);
  }
  if (task.kind == IkTaskKind::kPosition) return;
  const Eigen::Matrix3d now = link.linear() * task.frame.linear();
  const Eigen::Vector3d turn = rotation_vector(task.target.linear() * now.transpose());
  for (int k = 0; k < 3; ++k) {
    row_ = jacobian_.row(3 + k).transpose();
    add_row(turn[k], task.weight * options.rotation_weight);
  }
}

void PrioritizedIk::linearise(std::span<const IkTask> tasks, const PrioritizedIkOptions& options,
                              const Configuration& configuration) noexcept {
  kinematics_.update(configuration);
  rows_ = 0;
  for (int level = 0; level < kMaxLevels; ++level) {
    Level& now = levels_[at(level)];
    now = {rows_, 0, true};
    for (const IkTask& task : tasks) {
      if (task.level != level) continue;
      add_rows(task, options, configuration);
      now.posture = now.posture && task.kind == IkTaskKind::kPosture;
    }
    now.count = rows_ - now.first;
  }
}

void PrioritizedIk::solve_levels(const PrioritizedIkOptions& options, int end_level) noexcept {
  step_.setZero();
  int rank = 0;
  for (int l = 0; l < end_level; ++l) {
    const Level& level = levels_[at(l)];
    if (level.count == 0) continue;
    const int first = rank, end = level.first + level.count;
    double largest = 0.0;
    for (int r = level.first; r < end; ++r) {
      projected_.col(r) = task_.col(r);
      for (std::size_t k = 0; k < fixed_.size(); ++k) {
        if (fixed_[k] != 0) projected_(static_cast<Eigen::Index>(k), r) = 0.0;
      }
      largest = std::max(largest, projected_.col(r).norm());
      for (int pass = 0; pass < 2; ++pass) {  // twice is enough to be orthogonal to rounding
        for (int b = 0; b < first; ++b) {
          projected_.col(r) -= basis_.col(b).dot(projected_.col(r)) * basis_.col(b);
        }
      }
    }
    // Gram and Schmidt, longest row first.
    for (int k = 0; k < level.count; ++k) {
      int longest = level.first;
      double length = -1.0;
      for (int r = level.first; r < end; ++r) {
        const double norm = projected_.col(r).norm();
        if (norm > length) {
          length = norm;
          longest = r;
        }
      }
      if (!(length > kDependent * (largest + 1e-9))) break;
      basis_.col(rank) = projected_.col(longest) / length;
      for (int pass = 0; pass < 2; ++pass) {
        for (int b = 0; b < rank; ++b) {
          basis_.col(rank) -= basis_.col(b).dot(basis_.col(rank)) * basis_.col(b);
        }
        basis_.col(rank).normalize();
      }
      for (int r = level.first; r < end; ++r) {
        projected_.col(r) -= basis_.col(rank).dot(projected_.col(r)) * basis_.col(rank);
      }
      ++rank;
    }
    const int size = rank - first;
    if (size == 0) continue;
    // (M' M + damping) z = M' (e - J dq),  M = J B.
    normal_.setZero(size, size);
    right_.setZero(size);
    double square = 0.0;
    Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxRows, 1> m(size);
    for (int r = level.first; r < end; ++r) {
      const double missing = error_[r] - task_.col(r).dot(step_);
      square += missing * missing;
      for (int b = 0; b < size; ++b) m[b] = basis_.col(first + b).dot(task_.col(r));
      normal_.selfadjointView<Eigen::Lower>().rankUpdate(m);
      right_ += missing * m;
    }
    const double damping = options.damping * options.damping * std::min(square, 1.0) + 1e-12;
    for (int b = 0; b < size; ++b) normal_(b, b) += damping;
    Eigen::LLT<Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>>, Eigen::Lower>
        factor(normal_);
    factor.solveInPlace(right_);
    for (int b = 0; b < size; ++b) step_ += right_[b] * basis_.col(first + b);
  }
}

bool PrioritizedIk::hold_at_limits(const PrioritizedIkOptions& options,
                                   const Configuration& configuration) noexcept {
  bool found = false;
  for (int j = 0; j < model_->joint_count(); ++j) {
    if (fixed_[at(6 + j)] != 0) continue;
    const double q = configuration.q[j], change = step_[6 + j];
    const bool outwards = (q <= low(j, options) + 1e-12 && change < 0.0) ||
                          (q >= high(j, options) - 1e-12 && change > 0.0);
    if (!outwards) continue;
    fixed_[at(6 + j)] = 1;
    found = true;
  }
  return found;
}

void PrioritizedIk::move(double share, const PrioritizedIkOptions& options,
                         Configuration& configuration) const noexcept {
  configuration.base.translation() += share * step_.head<3>();
  configuration.base.linear() =
      rotation_of(share * step_.segment<3>(3)) * configuration.base.linear();
  for (int j = 0; j < model_->joint_count(); ++j) {
    if (held_[at(j)] != 0 || model_->joints[at(j)].mimic >= 0) continue;
    configuration.q[j] =
        std::clamp(configuration.q[j] + share * step_[6 + j], low(j, options), high(j, options));
  }
  for (int j = 0; j < model_->joint_count(); ++j) {
    const Joint& joint = model_->joints[at(j)];
    if (joint.mimic < 0) continue;
    configuration.q[j] = joint.mimic_multiplier * configuration.q[joint.mimic] + joint.mimic_offset;
  }
}

int PrioritizedIk::first_posture() const noexcept {
  for (int k = 0; k < kMaxLevels; ++k) {
    if (levels_[at(k)].count > 0 && levels_[at(k)].posture) return k;
  }
  return kMaxLevels;
}

PrioritizedIkResult PrioritizedIk::result(const PrioritizedIkOptions& options) const noexcept {
  PrioritizedIkResult result;
  result.reached = true;
  for (int k = 0; k < kMaxLevels; ++k) {
    const Level& level = levels_[at(k)];
    if (level.count == 0) continue;
    result.error[at(k)] = error_.segment(level.first, level.count).norm();
    if (level.posture || result.error[at(k)] <= options.tolerance) continue;
    if (result.reached) result.first_missed = k;
    result.reached = false;
  }
  return result;
}

PrioritizedIkResult PrioritizedIk::solve(std::span<const IkTask> tasks,
                                         const PrioritizedIkOptions& options,
                                         Configuration& configuration) noexcept {
  PrioritizedIkResult now;
  if (!sound(tasks) || !configuration.q.allFinite() || !configuration.base.matrix().allFinite()) {
    now.error.fill(std::numeric_limits<double>::infinity());
    now.first_missed = 0;
    return now;
  }
  step_.setZero();
  move(0.0, options, configuration);  // into the limits
  linearise(tasks, options, configuration);
  now = result(options);
  double trust = options.largest_step;
  int iterations = 0;
  for (; iterations < options.iterations && trust >= kLeastStep; ++iterations) {
    trial_ = configuration;
    if (iterations > 0) linearise(tasks, options, trial_);
    const double size = step(tasks, options, kMaxLevels, trust, trial_);
    // The level that is missed goes on once; what is above it gets back to where it was.
    const int missed = now.first_missed < 0 ? first_posture() : now.first_missed;
    for (int k = 0; k < kMends; ++k) {
      step(tasks, options, k == 0 ? std::min(missed + 1, kMaxLevels) : missed,
           std::min(trust, size), trial_);
    }
    const PrioritizedIkResult next = result(options);
    const int change = compare(next, now, options.tolerance);
    if (change > 0) {
      trust = 0.25 * std::min(trust, size);
      continue;
    }
    trust = std::min(options.largest_step, 2.0 * trust);
    configuration = trial_;
    now = next;
    if (change == 0) break;
  }
  now.iterations = iterations;
  return now;
}

double PrioritizedIk::step(std::span<const IkTask> tasks, const PrioritizedIkOptions& options,
                           int end, double trust, Configuration& configuration) noexcept {
  for (std::size_t k = 0; k < 6; ++k) fixed_[k] = base_free_ ? 0 : 1;
  for (std::size_t j = 0; j < held_.size(); ++j) {
    fixed_[6 + j] = held_[j] != 0 || model_->joints[j].mimic >= 0 ? 1 : 0;
  }
  solve_levels(options, end);
  for (int round = 0; round < kMostRounds && hold_at_limits(options, configuration); ++round) {
    solve_levels(options, end);
  }
  const double size = step_.cwiseAbs().maxCoeff();
  if (!(size > 0.0)) return 0.0;
  move(std::min(1.0, trust / size), options, configuration);
  linearise(tasks, options, configuration);
  return std::min(trust, size);
}

}  // namespace twinbus
