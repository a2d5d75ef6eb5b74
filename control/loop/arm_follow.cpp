#include "control/loop/arm_follow.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/math/index.h"

namespace twinbus::inline control {

namespace {
constexpr double kBeginsNear = 0.05;  // [rad] between the arm and the first knot
constexpr double kBrakeTime = 0.15;   // [s] from full rate to rest
constexpr double kRestartTime = 0.4;  // [s] from rest to full rate
constexpr double kClearFor = 0.5;     // [s] the guard must be content before the arm goes on
constexpr int kMostBlocks = 3;        // then the path is given up
constexpr double kSlack = 1.05;       // on velocity limits, for rounding

}  // namespace

ArmFollow::ArmFollow(const Model& model)
    : model_(&model), bus_of_(model.joints.size(), -1), allowed_(model.joints.size(), true) {
  for (int k = 0; k < model.bus_count(); ++k) bus_of_[at(model.bus_joints[at(k)])] = k;
  for (int joint : model.leg_joints) allowed_[at(joint)] = false;
  for (Path* path : {&active_, &incoming_}) {
    path->time.resize(kMaxPieces * kKnotsPerPiece);
    path->q.resize(kMaxPieces * kKnotsPerPiece);
    path->qd.resize(kMaxPieces * kKnotsPerPiece);
  }
}

void ArmFollow::begin(Path& path, const ArmPathPiece& piece) noexcept {
  path.path_id = piece.path_id;
  path.goal_id = piece.goal_id;
  path.pieces = piece.pieces;
  path.joint_count = piece.joint_count;
  path.joint = piece.joint;
  path.have = 0;
  path.spoilt = !(piece.pieces >= 1 && piece.pieces <= kMaxPieces && piece.joint_count >= 1 &&
                  piece.joint_count <= kArmJoints);
  if (path.spoilt) return;
  for (int c = 0; c < path.joint_count; ++c) {
    const int joint = piece.joint[at(c)];
    const bool known = joint >= 0 && joint < model_->joint_count() && bus_of_[at(joint)] >= 0 &&
                       allowed_[at(joint)];
    path.spoilt = path.spoilt || !known;
    path.bus_joint[at(c)] = known ? bus_of_[at(joint)] : 0;
    for (int b = 0; b < c; ++b) path.spoilt = path.spoilt || piece.joint[at(b)] == joint;
  }
  if (path.spoilt) refusal_ = "the arm path names a joint that is not of an arm";
}

void ArmFollow::add(const ArmPathPiece& piece) noexcept {
  if (piece.status != decltype(piece.status){} || piece.pieces <= 0)
    return;                                    // the planner found no path
  if (spent_.contains(piece.path_id)) return;  // heard again
  if (incoming_.pieces == 0 || incoming_.path_id != piece.path_id) begin(incoming_, piece);
  Path& path = incoming_;
  if (path.spoilt) return;
  bool good = piece.pieces == path.pieces && piece.joint_count == path.joint_count &&
              piece.joint == path.joint && piece.piece >= 0 && piece.piece < path.pieces &&
              piece.knot_count >= 1 && piece.knot_count <= kKnotsPerPiece;
  for (int k = 0; good && k < piece.knot_count; ++k) {
    good = std::isfinite(piece.time[at(k)]) && piece.time[at(k)] >= 0.0;
    for (int c = 0; good && c < path.joint_count; ++c) {
      const Joint& joint = model_->joints[at(path.joint[at(c)])];
      const double q = piece.q[at(k)][at(c)];
      const double qd = static_cast<double>(piece.qd[at(k)][at(c)]);
      good = std::isfinite(q) && std::isfinite(qd) && std::abs(qd) <= kSlack * joint.velocity &&
             (joint.kind == JointKind::kContinuous ||
              (q >= joint.lower - 1e-6 && q <= joint.upper + 1e-6));
    }
  }
  if (!good) {
    path.spoilt = true;
    refusal_ = "a piece of the arm path makes no sense: sizes, times or limits";
    return;
  }
  const int row = piece.piece * kKnotsPerPiece;
  path.knots_of[at(piece.piece)] = piece.knot_count;
  for (int k = 0; k < piece.knot_count; ++k) {
    path.time[at(row + k)] = piece.time[at(k)];
    path.q[at(row + k)] = piece.q[at(k)];
    for (int c = 0; c < kArmJoints; ++c) {
      path.qd[at(row + k)][at(c)] = static_cast<double>(piece.qd[at(k)][at(c)]);
    }
  }
  path.have |= 1ULL << piece.piece;
  if (path.complete()) {
    spent_.spend(path.path_id);
    waiting_ = finish(path);
    if (!waiting_) path.spoilt = true;
    if (following_) ending_ = true;  // the old one first comes to rest
  }
}

bool ArmFollow::finish(Path& path) noexcept {
  int n = 0;
  for (int p = 0; p < path.pieces; ++p) {
    for (int k = 0; k < path.knots_of[at(p)]; ++k, ++n) {
      const auto from = at(p * kKnotsPerPiece + k);
      path.time[at(n)] = path.time[from];
      path.q[at(n)] = path.q[from];
      path.qd[at(n)] = path.qd[from];
      if (n > 0 && !(path.time[at(n)] > path.time[at(n - 1)])) {
        refusal_ = "the times of the arm path do not increase";
        return false;
      }
    }
  }
  path.knot_count = n;
  return n >= 1;
}

void ArmFollow::refuse(const ArmPathPiece& piece, const char* why) noexcept {
  if (spent_.contains(piece.path_id)) return;
  spent_.spend(piece.path_id);
  if (piece.pieces > 0) refusal_ = why;
}

void ArmFollow::cancel() noexcept {
  ending_ = true;
  waiting_ = false;
  if (incoming_.pieces != 0) spent_.spend(incoming_.path_id);
  incoming_.pieces = 0;
  if (!following_) state_ = ArmState::kNone;
}

void ArmFollow::drop() noexcept {
  cancel();
  following_ = ending_ = false;
  state_ = ArmState::kNone;
}

void ArmFollow::place(double time, double rate, Posture& posture) const noexcept {
  int segment = segment_;
  while (segment < active_.knot_count - 2 && time >= active_.time[at(segment + 1)]) ++segment;
  sample(segment, time, rate, posture);
}

void ArmFollow::sample(int segment, double time, double rate, Posture& posture) const noexcept {
  const Path& path = active_;
  const int last = path.knot_count - 1;
  for (int c = 0; c < path.joint_count; ++c) {
    double q = path.q[at(last)][at(c)];
    double qd = 0.0;
    if (last > 0 && time < path.time[at(last)]) {
      const auto a = at(segment);
      const auto b = at(segment + 1);
      const double h = path.time[b] - path.time[a];
      const double s = std::clamp((time - path.time[a]) / h, 0.0, 1.0);
      const double s2 = s * s;
      const double s3 = s2 * s;
      const double qa = path.q[a][at(c)], qb = path.q[b][at(c)];
      const double va = h * path.qd[a][at(c)], vb = h * path.qd[b][at(c)];
      q = (2.0 * s3 - 3.0 * s2 + 1.0) * qa + (s3 - 2.0 * s2 + s) * va +
          (-2.0 * s3 + 3.0 * s2) * qb + (s3 - s2) * vb;
      qd = ((6.0 * s2 - 6.0 * s) * (qa - qb) + (3.0 * s2 - 4.0 * s + 1.0) * va +
            (3.0 * s2 - 2.0 * s) * vb) /
           h;
    }
    posture.set(path.bus_joint[at(c)], q, rate * qd);
  }
}

void ArmFollow::update(Posture& posture, std::int64_t masked, double dt) noexcept {
  if (!following_ && waiting_) {
    waiting_ = false;
    bool near = true;
    for (int c = 0; c < incoming_.joint_count; ++c) {
      near = near &&
             std::abs(incoming_.q[0][at(c)] - posture.q(incoming_.bus_joint[at(c)])) <= kBeginsNear;
    }
    if (near) {
      std::swap(active_, incoming_);
      following_ = true;
      ending_ = false;
      time_ = active_.time[0];
      rate_ = 0.0;
      clear_for_ = kClearFor;
      blocked_ = segment_ = 0;
      state_ = ArmState::kFollowing;
      // What is left between the arm and the first knot fades along the way.
      for (int c = 0; c < active_.joint_count; ++c) {
        const double gap = posture.q(active_.bus_joint[at(c)]) - active_.q[0][at(c)];
        for (int k = 0; k + 1 < active_.knot_count; ++k) {
          const double left = 1.0 - static_cast<double>(k) / (active_.knot_count - 1);
          active_.q[at(k)][at(c)] += gap * left;
        }
      }
    } else {
      refusal_ = "the arm path does not begin where the arm is";
    }
    incoming_.pieces = 0;
  }
  if (!following_) return;

  std::int64_t mine = 0;
  for (int c = 0; c < active_.joint_count; ++c) mine |= std::int64_t{1} << active_.bus_joint[at(c)];
  const bool held = (masked & mine) != 0;
  if (held && clear_for_ >= kClearFor && ++blocked_ >= kMostBlocks) ending_ = true;
  clear_for_ = held ? 0.0 : clear_for_ + dt;
  const bool stop = ending_ || held || clear_for_ < kClearFor;
  state_ = (held || clear_for_ < kClearFor) ? ArmState::kStoppedByGuard : ArmState::kFollowing;
  rate_ = stop ? std::max(0.0, rate_ - dt / kBrakeTime) : std::min(1.0, rate_ + dt / kRestartTime);
  time_ += rate_ * dt;
  while (segment_ < active_.knot_count - 2 && time_ >= active_.time[at(segment_ + 1)]) ++segment_;
  sample(segment_, time_, rate_, posture);

  if (time_ >= active_.time[at(active_.knot_count - 1)]) {
    following_ = false;
    state_ = ArmState::kDone;
  } else if (ending_ && rate_ <= 0.0) {
    following_ = false;
    state_ = held || blocked_ >= kMostBlocks ? ArmState::kStoppedByGuard : ArmState::kNone;
  }
}

}  // namespace twinbus::control
