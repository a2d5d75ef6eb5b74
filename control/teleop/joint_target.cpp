#include "control/teleop/joint_target.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/text/formatted.h"

namespace twinbus::inline control {

namespace {
constexpr double kSpeedShare = 0.25, kFastest = 0.5, kFastestSlide = 0.1;  // of the velocity limit; [rad/s], [m/s]
constexpr double kAhead = 0.5;                                             // [s]
constexpr double kPeakOfMinJerk = 1.875;                                   // largest speed over mean speed, of a pose
constexpr double kShortest = 0.2;                                          // [s]
constexpr double kAway = 0.2, kRests = 0.02;  // of what it goes in kAhead; of its speed
constexpr double kNear = 1e-4;                     // a wish no further than this asks for nothing [rad or m]
constexpr std::int64_t kAgainNs = 100'000'000;     // from one pose to the next
constexpr std::int64_t kFreshNs = 1'000'000'000;   // then a wish begins anew where the joint is

// Why a joint is not jogged in this mode, which a pose would end; null where it is.
const char* why_not(Mode mode) {
  return mode == Mode::kWalk   ? "stands first: it walks"
         : mode == Mode::kIdle ? "is let go: ask for hold first"
         : mode == Mode::kStop ? "waits: the robot is stopped"
                               : nullptr;
}
}  // namespace

JointTarget::JointTarget(const Model& model) : model_(&model) {
  for (const Hand* hand : hands_of(model)) {
    if (hand->joints.empty()) continue;
    const int k = model.bus_index[static_cast<std::size_t>(hand->joints.front())];
    if (k < 0) continue;
    chosen_ = k;
    break;
  }
}

const Joint& JointTarget::joint() const noexcept {
  return model_->joints[static_cast<std::size_t>(model_->bus_joints[static_cast<std::size_t>(chosen_)])];
}

double JointTarget::speed() const noexcept {
  if (model_->bus_count() == 0) return 0.0;
  const double most = joint().kind == JointKind::kPrismatic ? kFastestSlide : kFastest;
  return joint().velocity > 0.0 ? std::min(kSpeedShare * joint().velocity, most) : most;
}

void JointTarget::choose(int step) noexcept {
  const int count = model_->bus_count();
  if (count == 0) return;
  stop();
  halt_ = false;  // another joint: the old one goes to where it was sent, which is near
  chosen_ = (chosen_ + step % count + count) % count;
  refusal_ = nullptr;
}

void JointTarget::move(double seconds, const RobotState& state, Mode mode) noexcept {
  if (!std::isfinite(seconds) || seconds == 0.0 || chosen_ >= state.joint_count) return;
  refusal_ = why_not(mode);
  if (refusal_ != nullptr) return;
  const double q = state.q[static_cast<std::size_t>(chosen_)];
  if (!std::isfinite(q)) return;
  if (!begun_ || now_ns_ - moved_ns_ > kFreshNs) wanted_ = asked_ = q;
  begun_ = true;
  halt_ = false;
  moved_ns_ = now_ns_;
  const double ahead = kAhead * speed();
  if ((wanted_ - q) * seconds < 0.0) wanted_ = q;  // back again, from where it is: something may hold it far behind
  wanted_ = std::clamp(wanted_ + seconds * speed(), q - ahead, q + ahead);
  const double inside = joint().kind == JointKind::kContinuous ? wanted_ : std::clamp(wanted_, joint().lower, joint().upper);
  if (inside != wanted_) refusal_ = inside < wanted_ ? "is at its upper limit" : "is at its lower limit";
  wanted_ = inside;
}

void JointTarget::watch(const RobotState& state) noexcept {
  const auto k = static_cast<std::size_t>(chosen_);
  const bool away = begun_ && std::abs(asked_ - state.q[k]) > kAway * kAhead * speed();
  const bool rests = std::abs(static_cast<double>(state.qd[k])) < kRests * speed();
  still_ns_ = !(away && rests) ? 0 : still_ns_ != 0 ? still_ns_ : now_ns_;
}

void JointTarget::stop() noexcept {
  halt_ = begun_;
  begun_ = false;
}

bool JointTarget::next(std::int64_t now_ns, const RobotState& state, Mode mode, ModeRequest& request) noexcept {
  now_ns_ = now_ns;
  if (why_not(mode) != nullptr) drop();
  watch(state);
  const auto k = static_cast<std::size_t>(chosen_);
  const bool halt = std::exchange(halt_, false) && now_ns - asked_ns_ < kFreshNs;
  if (halt) {
    wanted_ = state.q[k];
    if (joint().kind != JointKind::kContinuous) wanted_ = std::clamp(wanted_, joint().lower, joint().upper);
  } else if (!begun_ || now_ns - asked_ns_ < kAgainNs || !(std::abs(wanted_ - asked_) > kNear)) {
    return false;
  }
  asked_ = wanted_;
  asked_ns_ = now_ns;
  request = {};
  request.mode = Mode::kPose;
  request.q[k] = wanted_;
  request.joint_mask = std::int64_t{1} << chosen_;
  const double way = std::abs(wanted_ - state.q[k]);
  request.duration = static_cast<float>(halt ? kShortest : std::max(kShortest, kPeakOfMinJerk * way / speed()));
  return true;
}

std::string JointTarget::words(const RobotState& state) const {
  if (model_->bus_count() == 0) return "";
  const double q = state.q[static_cast<std::size_t>(chosen_)];
  std::string text = joint().name + formatted(" %.3f %s", q, joint().kind == JointKind::kPrismatic ? "m" : "rad");
  if (refusal_ != nullptr) {
    text += std::string(" ") + refusal_;
  } else if (is_held()) {
    text += " is held";
  }
  return text;
}

}  // namespace twinbus::control
