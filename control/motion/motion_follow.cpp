#include "control/motion/motion_follow.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/math/index.h"
#include "robot/motion/motion_spline.h"

namespace twinbus::inline control {

namespace {
constexpr double kBrakeTime = 0.3;    // [s] from full rate to rest
constexpr double kRestartTime = 0.5;  // [s] from rest to full rate
constexpr double kClearFor = 0.5;     // [s] the guard must be content before the motion goes on
constexpr double kMostHeld = 1.5;     // [s] that a guard holds a joint, then the motion ends
constexpr double kMostStarved = 1.0;  // [s] without the next frames, then the motion ends
constexpr double kEnd = 0.0002;       // [s] before its end a motion is over
constexpr double kSlack = 1.05;       // on velocity limits, for rounding
constexpr double kBeyond =
    0.02;  // of a control point beyond a limit: the curve itself stays inside [rad or m]
constexpr float kShortestPeriod = 0.005F;  // between frames [s]
constexpr int kFirstFrames = 12;           // that have come before a motion begins
}  // namespace

MotionFollow::MotionFollow(const Model& model) : model_(&model), frames_(kFrames) {}

bool MotionFollow::fits(const MotionPiece& piece) const noexcept {
  const int n = model_->bus_count();
  const std::int64_t all = n >= 63 ? ~std::int64_t{0} : bit(n) - 1;
  return piece.joint_count == n && (piece.joint_mask & ~all) == 0 && piece.count >= 1 &&
         piece.count <= kFramesPerPiece && piece.period >= kShortestPeriod && piece.frames >= 2 &&
         piece.first >= 0 && piece.first <= piece.frames - piece.count;
}

void MotionFollow::begin(const MotionPiece& piece) noexcept {
  drop();
  id_ = piece.motion_id;
  mask_ = piece.joint_mask;
  count_ = piece.frames;
  period_ = static_cast<double>(piece.period);
  depth_ = static_cast<double>(piece.depth);
  for (Frame& frame : frames_) frame.number = -1;
  stage_ = Stage::kComes;
}

void MotionFollow::add(const MotionPiece& piece) noexcept {
  if (piece.motion_id == 0 || spent_.contains(piece.motion_id)) return;
  const bool mine = stage_ != Stage::kNone && piece.motion_id == id_;
  if (!mine && active()) {
    refusal_ = "a motion is being played: ./twinbus mode balance ends it, then ask again";
    return spent_.spend(piece.motion_id);
  }
  if (!fits(piece)) {
    refusal_ = "the motion is not for this robot: joints or frames make no sense; it is not played";
    spent_.spend(piece.motion_id);
    if (mine) active() ? cancel() : drop();
    return;
  }
  if (!mine) begin(piece);
  const int oldest = static_cast<int>(time_ / period_) - 2;
  for (int i = 0; i < piece.count; ++i) {
    const int number = piece.first + i;
    if (number < oldest || number >= oldest + kFrames - 4) continue;
    Frame& frame = slot(number);
    frame.number = number;
    frame.q = piece.q[at(i)];
    frame.com = piece.com[at(i)];
    frame.tilt = piece.tilt[at(i)];
  }
  // Frame by frame, each after the one before: what a joint cannot do spoils the motion.
  for (; have_ < count_ && slot(have_).number == have_; ++have_) {
    const Frame& frame = slot(have_);
    const Frame& before = slot(std::max(0, have_ - 1));
    for (int k = 0; k < model_->bus_count(); ++k) {
      if (((mask_ >> k) & 1) == 0) continue;
      const Joint& joint = model_->joints[at(model_->bus_joints[at(k)])];
      const auto q = static_cast<double>(frame.q[at(k)]);
      const double speed = std::abs(q - static_cast<double>(before.q[at(k)])) / period_;
      const bool inside = joint.kind == JointKind::kContinuous ||
                          (q >= joint.lower - kBeyond && q <= joint.upper + kBeyond);
      const double most = joint.velocity > 0.0 ? kSlack * joint.velocity : 1e9;
      if (inside && speed <= most) continue;
      refusal_ = inside ? "a joint of the motion is faster than its limit: ./twinbus motion FILE "
                          "--check names it; the motion ends"
                        : "a joint of the motion leaves its limits: ./twinbus motion FILE --check "
                          "names it; the motion ends";
      spent_.spend(id_);
      active() ? cancel() : drop();
      return;
    }
  }
  if (stage_ == Stage::kComes && have_ >= std::min(count_, kFirstFrames)) {
    const SplinePlace place = spline_place(0.0, count_, period_);
    first_.fill(0.0);
    for (std::size_t i = 0; i < 4; ++i) {
      for (int k = 0; k < model_->bus_count(); ++k)
        first_[at(k)] += place.position[i] * static_cast<double>(slot(place.frame[i]).q[at(k)]);
    }
    stage_ = Stage::kWaits;
  }
}

void MotionFollow::refuse() noexcept {
  spent_.spend(id_);
  drop();
}

void MotionFollow::drop() noexcept {
  if (active()) spent_.spend(id_);
  stage_ = Stage::kNone;
  count_ = have_ = 0;
  time_ = rate_ = clear_for_ = starved_for_ = held_for_ = 0.0;
  ending_ = over_ = false;
  body_ = {};
}

void MotionFollow::forget() noexcept {
  drop();
  spent_ = {};
}

void MotionFollow::approach(double duration) noexcept {
  stage_ = Stage::kApproaches;
  time_ = rate_ = starved_for_ = held_for_ = 0.0;
  clear_for_ = kClearFor;
  over_ = false;
  fade_.rest(0.0);
  fade_.aim(1.0, duration);
}

const char* MotionFollow::take_refusal() noexcept { return std::exchange(refusal_, nullptr); }

void MotionFollow::sample(Posture& posture, double rate, double rate_change) noexcept {
  const SplinePlace place = spline_place(time_, count_, period_);
  std::array<const Frame*, 4> frame;
  for (std::size_t i = 0; i < 4; ++i) frame[i] = &slot(place.frame[i]);
  for (int k = 0; k < model_->bus_count() && stage_ == Stage::kPlays; ++k) {
    if (((mask_ >> k) & 1) == 0) continue;
    double q = 0.0, qd = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      q += place.position[i] * static_cast<double>(frame[i]->q[at(k)]);
      qd += place.velocity[i] * static_cast<double>(frame[i]->q[at(k)]);
    }
    posture.set(k, q, rate * qd);
  }
  body_ = {};
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d com(static_cast<double>(frame[i]->com[0]),
                              static_cast<double>(frame[i]->com[1]),
                              static_cast<double>(frame[i]->com[2]));
    const Eigen::Vector2d tilt(static_cast<double>(frame[i]->tilt[0]),
                               static_cast<double>(frame[i]->tilt[1]));
    body_.com += place.position[i] * com;
    body_.com_velocity += rate * place.velocity[i] * com;
    body_.com_acceleration +=
        (rate * rate * place.acceleration[i] + rate_change * place.velocity[i]) * com;
    body_.tilt += place.position[i] * tilt;
    body_.tilt_rate += rate * place.velocity[i] * tilt;
  }
}

void MotionFollow::update(Posture& posture, std::int64_t masked, double dt) noexcept {
  if (stage_ == Stage::kApproaches) {
    fade_.advance(dt);
    sample(posture, 0.0, 0.0);
    body_.com_velocity = fade_.velocity() * body_.com;
    body_.com_acceleration = fade_.acceleration() * body_.com;
    body_.com *= fade_.position();
    body_.tilt_rate = fade_.velocity() * body_.tilt;
    body_.tilt *= fade_.position();
    return;
  }
  const bool whole = have_ == count_;
  const double end = std::max(0.0, period_ * (whole ? count_ - 1 : have_ - 4));
  const bool held = (masked & mask_) != 0;
  clear_for_ = held ? 0.0 : clear_for_ + dt;
  const bool stop = ending_ || clear_for_ < kClearFor;
  const double before = rate_;
  rate_ = stop ? std::max(0.0, rate_ - dt / kBrakeTime) : std::min(1.0, rate_ + dt / kRestartTime);
  rate_ = std::min(rate_, std::sqrt(2.0 * std::max(0.0, end - time_) / kBrakeTime));
  time_ = std::min(end > time_ ? end : time_, time_ + rate_ * dt);
  sample(posture, rate_, dt > 0.0 ? (rate_ - before) / dt : 0.0);
  held_for_ = held ? held_for_ + dt : 0.0;
  starved_for_ = !whole && rate_ < 0.05 && !stop ? starved_for_ + dt : 0.0;
  if (held_for_ > kMostHeld && !ending_) {
    refusal_ =
        "the guard holds a joint of the motion: it would touch something there; the motion ends";
    ending_ = true;
  }
  if (starved_for_ > kMostStarved && !ending_) {
    refusal_ =
        "the next frames of the motion do not come: whoever sends it is gone; the motion ends";
    ending_ = true;
  }
  over_ = (whole && end - time_ < kEnd) || (ending_ && rate_ <= 0.0);
}

}  // namespace twinbus::control
