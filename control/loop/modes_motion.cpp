// What of Modes moves a robot that stands: poses, sway and squat, motions that are played.

#include "control/loop/modes.h"

#include <utility>

#include "common/math/index.h"

namespace twinbus::inline control {

namespace {
constexpr double kApproach = 1.5;    // [s] to the first frame of a motion, and back, at least
constexpr double kPatience = 3.0;    // [s] with a joint that the guard holds on that way
constexpr double kLevel = 0.005;     // a motion that is no deeper asks nothing of the knees [m]
}  // namespace

// Of a robot on its feet: the legs are told where to be, or nothing balances what the other joints do.
const char* Modes::why_no_pose(const ModeRequest& request, const Moment& now) noexcept {
  const bool balanced = (request.joint_mask & legs_) == 0 && (active_ != nullptr || may_balance(now));
  if (pose_ == nullptr || !stands(now) || balanced) return nullptr;
  return pose_->why_not(now.estimator, now.last != nullptr ? now.last->q : now.state.q, request.q, request.joint_mask);
}

// What was asked is told of, though something came before it began.
void Modes::forget_pose() noexcept {
  if (std::exchange(looks_ahead_, false)) sentence_ = "the pose is not begun: the robot was stopped meanwhile; ask again once it stands";
}

void Modes::look_ahead(const Moment& now) noexcept {
  if (!looks_ahead_) return;
  const PoseWay::Verdict verdict = way_.look();
  if (verdict == PoseWay::Verdict::kLooks) return;
  looks_ahead_ = false;
  if (verdict == PoseWay::Verdict::kTouches) {
    sentence_ = way_.why();
  } else {
    enter_pose(asked_pose_, now);
  }
}

void Modes::enter_pose(const ModeRequest& request, const Moment& now) noexcept {
  arm_.cancel();
  // Without legs in it, the legs balance what the others do, from hold too.
  const bool without_legs = (request.joint_mask & legs_) == 0;
  if (!without_legs || !(active_ != nullptr || may_balance(now))) {
    enter(Mode::kHold, now);
  } else if (active_ == nullptr) {
    enter(Mode::kBalance, now);
  }
  mode_ = Mode::kPose;
  posture_.move(request.q, request.joint_mask, static_cast<double>(request.duration));
}

void Modes::request_motion(const ModeRequest& request, const Moment& now) noexcept {
  const auto amplitude = static_cast<double>(request.amplitude);
  const auto frequency = static_cast<double>(request.frequency);
  // One that squats already was asked before, from where it stood.
  const bool from_standing = squat_ != nullptr && active_->motion() == Motion::kNone;
  if (request.motion == Motion::kSquat && from_standing) {
    const double depth = 2.0 * ComMotion::possible(amplitude, frequency);
    if (const char* why = squat_->why_not(now.estimator, depth)) {
      sentence_ = why;
      return;
    }
  }
  active_->request(request.motion, amplitude, frequency);
}

const char* Modes::why_no_motion(const Moment& now) noexcept {
  if (held_by_gate_ || stopping_) return "the robot is stopped: clear the stop first; the motion is not played";
  if (bracing_) return "the robot falls; the motion is not played";
  if (mode_ == Mode::kIdle || mode_ == Mode::kNone)
    return "the joints are let go: ./twinbus mode balance first; the motion is not played";
  if (standing_ == nullptr) return nullptr;
  const bool balances = active_ != nullptr || may_balance(now);
  if (!balances)
    return stands(now) ? "a motion begins on an upright robot with both soles on the ground; it is not played" : nullptr;
  if (squat_ == nullptr || motion_.depth() <= kLevel) return nullptr;
  return squat_->why_not(now.estimator, motion_.depth());
}

// One that is asked while the robot walks waits until it stands.
void Modes::begin_motion(const Moment& now) noexcept {
  if (walks()) {
    if (after_rest_) return;
    sentence_ = "the robot walks: it stops first, and plays the motion once it stands";
    return leave_walk({}, false, true);
  }
  if (const char* why = why_no_motion(now)) {
    sentence_ = why;
    return motion_.refuse();
  }
  arm_.cancel();
  forget_pose();
  if (active_ == nullptr && may_balance(now)) enter(Mode::kBalance, now);
  if (active_ != nullptr) {
    motion_.keep_off(legs_);
    active_->stop_motion(kStopTime);
    mode_ = Mode::kBalance;
  }
  stood_ = joints_of(posture_);
  way_.start(now.estimator.configuration(), stood_, motion_.first(), motion_.mask());
  motion_.set_stage(MotionFollow::Stage::kLooks);
}

void Modes::look_along(const Moment& now) noexcept {
  const PoseWay::Verdict verdict = way_.look();
  if (verdict == PoseWay::Verdict::kLooks) return;
  const bool back = motion_.stage() == MotionFollow::Stage::kLooksBack;
  const bool is_free = verdict == PoseWay::Verdict::kFree;
  if (back && is_free) return go_back();
  if (!back && is_free && !motion_.ending()) {
    posture_.move(motion_.first(), motion_.mask(), kApproach);
    waited_ = 0.0;
    return motion_.approach(kApproach);
  }
  if (!is_free) {
    sentence_ = back ? "the straight way from the end of the motion to where the robot stood is not free: it stays as the motion ended"
                     : "the straight way to the first frame of the motion is not free; it is not played";
  }
  end_motion(now);
}

void Modes::go_back() noexcept {
  posture_.move(stood_, motion_.mask(), kApproach);
  motion_.set_stage(MotionFollow::Stage::kReturns);
}

void Modes::end_motion(const Moment& now) noexcept {
  motion_.drop();
  const ModeRequest next = std::exchange(after_motion_, {});
  if (next.mode != Mode::kNone) obey(next, now);
}

void Modes::play(const Moment& now, std::int64_t mask, double dt) noexcept {
  if (const char* why = motion_.take_refusal()) sentence_ = why;
  switch (motion_.stage()) {
    case MotionFollow::Stage::kNone:
    case MotionFollow::Stage::kComes:
      break;
    case MotionFollow::Stage::kWaits:
      begin_motion(now);
      break;
    case MotionFollow::Stage::kLooks:
    case MotionFollow::Stage::kLooksBack:
      look_along(now);
      break;
    case MotionFollow::Stage::kApproaches:
      motion_.update(posture_, mask, dt);
      if (motion_.ending()) {
        go_back();
      } else if (!posture_.moving() && motion_.approached()) {
        const bool waits = posture_.waits(motion_.mask());
        if (waits && (waited_ += dt) < kPatience) break;
        if (waits || posture_.gave_up(motion_.mask())) {
          sentence_ = "the guard holds the robot on the way to the first frame of the motion; it is not played";
          go_back();
        } else {
          motion_.play();
        }
      }
      break;
    case MotionFollow::Stage::kPlays:
      motion_.update(posture_, mask, dt);
      braked_ = posture_;
      brake(braked_, kStopTime);
      if (!motion_.over()) break;
      way_.start(now.estimator.configuration(), joints_of(posture_), stood_, motion_.mask());
      motion_.set_stage(MotionFollow::Stage::kLooksBack);
      break;
    case MotionFollow::Stage::kReturns:
      if (!posture_.moving()) end_motion(now);  // what the guard holds goes on by itself
      break;
  }
}

PerJoint<double> Modes::joints_of(const Posture& posture) const noexcept {
  PerJoint<double> q{};
  for (int k = 0; k < model_.bus_count(); ++k) q[at(k)] = posture.q(k);
  return q;
}

// The posture as it comes to rest from here.
void Modes::brake(Posture& posture, double duration) const noexcept {
  PerJoint<double> qd{};
  for (int k = 0; k < model_.bus_count(); ++k) qd[at(k)] = posture.qd(k);
  posture.brake(joints_of(posture), qd, duration);
}

void Modes::stop_playing() noexcept {
  if (motion_.stage() == MotionFollow::Stage::kNone) return;
  if (motion_.active()) brake(posture_, kStopTime);
  motion_.refuse();
  after_motion_ = {};
}

// What is asked while a motion plays is obeyed when it has been ended and the robot is back where it stood.
bool Modes::put_off(const ModeRequest& request) noexcept {
  if (request.mode == Mode::kNone || request.mode == Mode::kIdle || request.mode == Mode::kStop) return false;
  if (motion_.active()) {
    after_motion_ = request;
    motion_.cancel();
    return true;
  }
  if (motion_.stage() == MotionFollow::Stage::kWaits) {
    motion_.refuse();
    sentence_ = "something else was asked before the motion began: it is not played";
  }
  return false;
}

// While standing.
void Modes::follow_body() noexcept {
  const MotionFollow::Body& body = motion_.body();
  balance_->follow(body.com, body.com_velocity, body.com_acceleration, body.tilt, body.tilt_rate);
}

}  // namespace twinbus::control
