#include "robot/kinematics/closed_form.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "common/math/pose_math.h"

namespace twinbus::inline robot {

namespace {

constexpr double kTurn = 2.0 * 3.14159265358979323846;
constexpr double kMeet = 1e-7;  // axes nearer than this meet [m]

using Vector = Eigen::Vector3d;

// Rotates u about the axis into v, or as near as it gets.
double turn_between(const Vector& axis, const Vector& u, const Vector& v) noexcept {
  const Vector across = u - axis.dot(u) * axis;
  return std::atan2(axis.dot(across.cross(v)), across.dot(v));
}

// Angles with e^(a x) e^(b y) u = v, |u| = |v|, two of them; what is missing to a solution [of the
// squared length] comes back, and then both are as near as it gets.
double two_turns(const Vector& a, const Vector& b, const Vector& u, const Vector& v, double (&x)[2],
                 double (&y)[2]) noexcept {
  const Vector normal = a.cross(b);
  const double d = a.dot(b), bu = b.dot(u), av = a.dot(v), scale = 1.0 / normal.squaredNorm();
  const double alpha = (av - d * bu) * scale, beta = (bu - d * av) * scale;
  const double square =
      (u.squaredNorm() - alpha * alpha - beta * beta - 2.0 * alpha * beta * d) * scale;
  const double gamma = std::sqrt(std::max(0.0, square));
  for (int i = 0; i < 2; ++i) {
    const Vector middle = alpha * a + beta * b + (i == 0 ? gamma : -gamma) * normal;
    y[i] = turn_between(b, u, middle);
    x[i] = turn_between(a, middle, v);
  }
  return std::max(0.0, -square);
}

bool meet(const Vector& p, const Vector& a, const Vector& q, const Vector& b,
          Vector& where) noexcept {
  const Vector normal = a.cross(b);
  const double square = normal.squaredNorm();
  if (!(square > 1e-6)) return false;
  if (std::abs(normal.dot(q - p)) > kMeet * std::sqrt(square)) return false;
  where = p + ((q - p).cross(b).dot(normal) / square) * a;
  return true;
}

}  // namespace

struct ClosedForm::Branch {
  Angles q;
  double beyond = 0.0;
};

ClosedForm::ClosedForm(const Model& model, const std::vector<int>& path,
                       const Eigen::Isometry3d& frame)
    : zero_inverse_(Eigen::Isometry3d::Identity()),
      shoulder_(Vector::Zero()),
      wrist_(Vector::Zero()) {
  if (path.size() < static_cast<std::size_t>(kSolved) ||
      path.size() > static_cast<std::size_t>(kMaxChain)) {
    return;
  }
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (const int j : path) {
    const Joint& joint = model.joints[at(j)];
    if (joint.mimic >= 0) return;
    pose = pose * joint.placement;
    axes_.push_back({pose.linear() * joint.axis, pose.translation(),
                     joint.kind == JointKind::kPrismatic, static_cast<int>(axes_.size())});
  }
  zero_inverse_ = (pose * frame).inverse();
  if (find_window()) return;
  // The inverse of the product runs from the tip, with every turn the other way.
  std::reverse(axes_.begin(), axes_.end());
  for (Axis& axis : axes_) axis.direction = -axis.direction;
  reversed_ = true;
  find_window();
}

bool ClosedForm::find_window() noexcept {
  for (std::size_t s = 0; s + kSolved <= axes_.size(); ++s) {
    const Axis* a = &axes_[s];
    const bool turns = std::none_of(a, a + kSolved, [](const Axis& axis) { return axis.slides; });
    if (!turns || !meet(a[0].point, a[0].direction, a[1].point, a[1].direction, shoulder_) ||
        !meet(a[4].point, a[4].direction, a[5].point, a[5].direction, wrist_) ||
        !(a[1].direction.cross(a[2].direction).norm() > 1e-3) ||
        !(a[2].direction.cross(shoulder_ - a[2].point).norm() < kMeet) ||
        !(a[3].direction.cross(shoulder_ - a[3].point).norm() > 1e-3) ||
        !(a[3].direction.cross(wrist_ - a[3].point).norm() > 1e-3)) {
      continue;
    }
    first_ = static_cast<int>(s);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      if (i < s || i >= s + kSolved) locked_.push_back(axes_[i].joint);
    }
    return true;
  }
  return false;
}

// The angle as a full turn more or less puts it within limits and near the start; what is left over
// is counted.
double ClosedForm::angle_at(std::size_t i, double angle, const Angles& start, const Angles& low,
                            const Angles& high, Branch& branch) const noexcept {
  const auto joint = static_cast<std::size_t>(axes_[i].joint);
  double q = start[joint] + std::remainder(angle - start[joint], kTurn);
  if (q > high[joint]) {
    if (q - kTurn >= low[joint] || low[joint] - (q - kTurn) < q - high[joint]) q -= kTurn;
  } else if (q < low[joint]) {
    if (q + kTurn <= high[joint] || q + kTurn - high[joint] < low[joint] - q) q += kTurn;
  }
  branch.q[joint] = q;
  branch.beyond += std::max({0.0, q - high[joint], low[joint] - q});
  return q;
}

void ClosedForm::solve(const Eigen::Isometry3d& target, const Angles& start, const Angles& low,
                       const Angles& high, Candidate& best) const noexcept {
  const auto s = static_cast<std::size_t>(first_);
  const auto motion = [&](std::size_t i, double q) {
    const Axis& axis = axes_[i];
    Eigen::Isometry3d m = Eigen::Isometry3d::Identity();
    if (axis.slides) {
      m.translation() = q * axis.direction;
    } else {
      m.linear() = rotation_about(axis.direction, q);
      m.translation() = axis.point - m.linear() * axis.point;
    }
    return m;
  };
  // product: what the six have to do.
  Eigen::Isometry3d product = target * zero_inverse_;
  if (reversed_) product = product.inverse();
  for (std::size_t i = 0; i < s; ++i) {
    product = motion(i, -start[static_cast<std::size_t>(axes_[i].joint)]) * product;
  }
  for (std::size_t i = axes_.size(); i > s + kSolved; --i) {
    product = product * motion(i - 1, -start[static_cast<std::size_t>(axes_[i - 1].joint)]);
  }
  const Axis* a = &axes_[s];
  const Eigen::Matrix3d& turned = product.linear();
  const Vector seen = turned.transpose() * (shoulder_ - product.translation()) - wrist_;

  // Elbow: |e^(-x4 q4) shoulder - wrist| = |seen|.
  const Vector& w = a[3].direction;
  const Vector upper = shoulder_ - a[3].point, fore = wrist_ - a[3].point;
  const double along = w.dot(upper - fore);
  const Vector across_upper = upper - w.dot(upper) * w, across_fore = fore - w.dot(fore) * w;
  const double lengths = across_upper.norm() * across_fore.norm();
  const double cosine = (across_upper.squaredNorm() + across_fore.squaredNorm() -
                         (seen.squaredNorm() - along * along)) /
                        (2.0 * lengths);
  if (!std::isfinite(cosine)) return;
  const double middle = turn_between(w, upper, fore);
  const double bend = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double lack = std::max(0.0, std::abs(cosine) - 1.0);
  // Angles are exact to rounding where the arm is bent, to its root where it is straight.
  constexpr double kAngleRounding = 1e-9;
  Branch elbow;
  for (int e = 0; e < 2; ++e) {
    elbow.q = start;
    elbow.beyond = lack < kAngleRounding ? 0.0 : lack;
    const double q3 = angle_at(s + 3, -(middle + (e == 0 ? bend : -bend)), start, low, high, elbow);
    if (!(elbow.beyond <= best.beyond + kAngleRounding)) continue;
    const Eigen::Matrix3d back3 = rotation_about(w, -q3);
    // Wrist: e^(-x6 q6) e^(-x5 q5) (shoulder seen past the elbow) = seen.
    const Vector past = a[3].point + back3 * upper - wrist_;
    double q5[2], q4[2];
    const double short4 = two_turns(a[5].direction, a[4].direction, past, seen, q5, q4);
    for (int v = 0; v < 2; ++v) {
      Branch wrist = elbow;
      wrist.beyond += short4 < kAngleRounding ? 0.0 : short4;
      angle_at(s + 4, -q4[v], start, low, high, wrist);
      angle_at(s + 5, -q5[v], start, low, high, wrist);
      if (!(wrist.beyond <= best.beyond + kAngleRounding)) continue;
      // Shoulder: what turning is left.
      const Eigen::Matrix3d rest = turned * (rotation_about(a[5].direction, q5[v]) *
                                             (rotation_about(a[4].direction, q4[v]) * back3));
      double q0[2], q1[2];
      const double short0 =
          two_turns(a[0].direction, a[1].direction, a[2].direction, rest * a[2].direction, q0, q1);
      for (int h = 0; h < 2; ++h) {
        Branch all = wrist;
        all.beyond += short0 < kAngleRounding ? 0.0 : short0;
        angle_at(s, q0[h], start, low, high, all);
        angle_at(s + 1, q1[h], start, low, high, all);
        if (!(all.beyond <= best.beyond + kAngleRounding)) continue;
        const Vector probe = rotation_about(a[1].direction, -q1[h]) *
                             (rotation_about(a[0].direction, -q0[h]) * (rest * a[1].direction));
        angle_at(s + 2, turn_between(a[2].direction, a[1].direction, probe), start, low, high, all);
        double distance = 0.0;
        for (std::size_t i = 0; i < axes_.size(); ++i) distance += std::abs(all.q[i] - start[i]);
        const bool same = all.beyond <= best.beyond + kAngleRounding;
        if (all.beyond < best.beyond - kAngleRounding || (same && distance < best.distance)) {
          best = {all.q, all.beyond, distance};
        }
      }
    }
  }
}

}  // namespace twinbus::robot
