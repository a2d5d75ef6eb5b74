// What the modes ask of the legs, and of what moves them.

#include "control/loop/modes.h"

#include "common/math/index.h"

namespace twinbus::inline control {

void Modes::walk_steps(const StepList& list) noexcept {
  if (point_feet_ != nullptr) {
    sentence_ = "footsteps are for soles; point feet are told a velocity";
    return;
  }
  if (walk() == nullptr || after_rest_ || stopping_) {
    sentence_ = "footsteps are walked in mode walk; the robot stays where it is";
    return;
  }
  if (const char* why = walk_->follow(list)) sentence_ = why;
}

void Modes::add_path(const ArmPathPiece& piece) noexcept {
  const char* why = held_by_gate_ || stopping_ ? "the robot is stopped: clear the stop first; the arm path is not followed"
                    : bracing_                 ? "the robot falls; the arm path is not followed"
                    : motion_.active()         ? "the robot plays a motion; the arm path is not followed"
                    : mode_ == Mode::kIdle || mode_ == Mode::kNone
                        ? "the joints are let go: ./twinbus mode balance (or hold) first; the arm path is not followed"
                        : nullptr;
  if (why != nullptr) return arm_.refuse(piece, why);
  arm_.add(piece);
}

void Modes::set_legs(SetPoint& set_point) const noexcept {
  const Behavior& active = *active_;
  const int n = model_.bus_count();
  for (int k = 0; k < n; ++k) {
    const auto i = at(k);
    const int j = model_.bus_joints[i];
    if (((legs_ >> k) & 1) == 0) {
      active.offset(j, set_point.q[i], set_point.qd[i]);
      continue;
    }
    set_point.q[i] = active.q()[j];
    set_point.qd[i] = active.qd()[j];
    set_point.kp[i] = active.kp()[j];
    set_point.kd[i] = active.kd()[j];
  }
}

void Modes::move_legs(const Moment& now, double dt) noexcept {
  if (active_ == nullptr) return static_torque_.solve(now.estimator, q_given_, tau_);
  const char* stopped = active_->why_stopped();
  if (active_ == balance_.get() && motion_.moves_body()) follow_body();
  active_->update(now.estimator, q_given_, dt);
  if (stopped == nullptr && active_->why_stopped() != nullptr) sentence_ = active_->why_stopped();
  if (active_->finite()) return;
  motion_.drop();
  if (active_ != standing_) {
    sentence_ = "the walking controller met a number that is not one; the robot stands";
    enter(Mode::kBalance, now);
    return move_legs(now, dt);
  }
  sentence_ = "the balance controller met a number that is not one; it starts again";
  active_->forget();
  active_->start(now.estimator);
  active_->update(now.estimator, q_given_, dt);
}

}  // namespace twinbus::control
