// What the modes ask of the legs: of two with soles, or of four with point feet.

#include "control/loop/modes.h"

#include <stdexcept>

#include "common/math/index.h"
#include "robot/description/walking_config.h"

namespace twinbus {

void Modes::find_four_legs() {
  if (why_no_quadruped(model_) != nullptr) return;
  quadruped_ = std::make_unique<Quadruped>(model_);
  quadruped_->limit(walking_of(model_).fastest);
  for (int k = 0; k < model_.bus_count(); ++k) {
    if (quadruped_->is_leg(model_.bus_joints[at(k)])) legs_ |= std::int64_t{1} << k;
  }
}

void Modes::enter_trot(const Moment& now) noexcept {
  if (!on_four_ && !may_balance(now)) {
    sentence_ = "trotting begins on an upright robot with its feet on the ground; the mode stays as it is";
    return;
  }
  if (!on_four_) {
    changed_ = true;
    if (mode_ == Mode::kIdle || mode_ == Mode::kNone || now.last == nullptr) posture_.rest(now.state.q);
    begin_balance(now);
  }
  quadruped_->walk(true);
  leaving_ = false;
  mode_ = Mode::kWalk;
}

void Modes::walk_steps(const StepList& list) noexcept {
  if (quadruped_ != nullptr) {
    sentence_ = "footsteps are for two legs; four are told a velocity";
    return;
  }
  if (!walking_ || leaving_ || stopping_) {
    sentence_ = "footsteps are walked in mode walk; the robot stays where it is";
    return;
  }
  if (const char* why = walk_->follow(list)) sentence_ = why;
}

void Modes::add_path(const ArmPathPiece& piece) noexcept {
  const bool may_follow = !motion_.active() &&
      !(held_by_gate_ || stopping_ || bracing_ || mode_ == Mode::kIdle || mode_ == Mode::kNone);
  if (!may_follow) return arm_.refuse(piece);
  arm_.add(piece);
}

void Modes::set_legs(int k, SetPoint& set_point) const noexcept {
  const auto i = at(k);
  const int j = model_.bus_joints[i];
  const bool leg = ((legs_ >> k) & 1) != 0;
  if (leg) {
    set_point.q[i] = walking_ ? walk_->q()[j] : balancing_ ? balance_->q()[j] : quadruped_->q()[j];
    set_point.qd[i] = walking_ ? walk_->qd()[j] : balancing_ ? balance_->qd()[j] : quadruped_->qd()[j];
  }
  if (walking_) return;
  if (leg) {
    set_point.kp[i] = balancing_ ? balance_->kp(j) : quadruped_->kp()[j];
    set_point.kd[i] = balancing_ ? balance_->kd(j) : quadruped_->kd()[j];
  } else if (balancing_) {
    set_point.q[i] += balance_->offset(j);
    set_point.qd[i] += balance_->offset_rate(j);
  }
}

void Modes::move_legs(const Moment& now, double dt) noexcept {
  if (walking_) {
    const bool went_on = !walk_->stopped_by_ground();
    walk_->update(now.estimator, q_given_, dt);
    if (went_on && walk_->stopped_by_ground())
      sentence_ = "the ground is not flat, and feet without force sensors do not turn with it: the robot stops";
    if (walk_->finite()) return;
    sentence_ = "the walking controller met a number that is not one; the robot stands";
    enter(Mode::kBalance, now);
  }
  if (on_four_) {
    quadruped_->update(now.estimator, dt);
    if (quadruped_->finite()) return;
    sentence_ = "the controller of the four legs met a number that is not one; it starts again";
    quadruped_->start(now.estimator);
    quadruped_->update(now.estimator, dt);
  } else if (balancing_) {
    if (motion_.moves_body()) follow_body();
    balance_->update(now.estimator, dt);
    if (balance_->finite()) return;
    motion_.drop();
    sentence_ = "the balance controller met a number that is not one; it starts again";
    balance_->forget();
    balance_->start(now.estimator);
    balance_->update(now.estimator, dt);
  } else {
    static_torque_.solve(now.estimator, q_given_, tau_);
  }
}

}  // namespace twinbus
