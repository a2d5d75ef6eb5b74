// The arms that the gamepad process moves: a hand by goals for the planner, a joint by poses.  For gamepad_main.cpp only.

#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "common/process/process.h"
#include "common/text/formatted.h"
#include "common/text/printable.h"
#include "control/gamepad_requests_main.h"
#include "control/teleop/hand_target.h"
#include "control/teleop/joint_target.h"
#include "control/teleop/teleop.h"
#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "lcmtypes/msg/plan_refusal.h"
#include "robot/collision/thing_name.h"
#include "robot/description/model.h"
#include "robot/estimation/estimator.h"

namespace twinbus::inline control {

// The hand and the joint that are moved: where they are, whether another operator drives, what is asked for, and why it is
// not done.
class GamepadArm {
 public:
  GamepadArm(const Model& model, std::int64_t id) : model_(model), estimator_(model), id_(id), joint_(model) {
    for (const Hand* hand : hands_of(model)) sides_.push_back(side_of(*hand));
    if (!sides_.empty()) target_.choose(sides_.front());
  }
  // That an operator may choose, in their order.
  const std::vector<ArmSide>& sides() const { return sides_; }

  void listen(Bus& bus) {
    bus.listen<&HandTarget::on_path>(channel::kArmPath, target_);
    bus.listen<&GamepadArm::hear_status>(channel::kControllerStatus, *this);
    bus.listen<&GamepadArm::hear_gamepad>(channel::kGamepad, *this);
    bus.listen<&GamepadArm::hear_event>(channel::kEvent, *this);
    bus.listen<&GamepadArm::hear_guard>(channel::kGuard, *this);
  }
  // Once per cycle, with the newest state.
  void update(const RobotState& state, bool fresh, Teleop& teleop) {
    heard_ = fresh;
    known_ = fresh && state.model_hash == model_.hash && state.joint_count == model_.bus_count();
    const HandMove by = teleop.take_hand_move();
    const double joint_by = teleop.take_joint_move();
    const Hand* hand = hand_of(model_, number_of(teleop.hand()));
    if (hand != nullptr) target_.choose(side_of(*hand));
    const bool holds = teleop.holding() && known_ && state.stop_kind == StopKind::kNone;
    if (!holds) {
      if (held_) stop();
      held_ = drives_ = false;
      return;
    }
    estimator_.update(state);
    if (!held_) drives_ = other_ns_ == 0 || seconds_since(other_ns_) > kOtherHolds;
    held_ = true;
    if (!drives_) return;
    if (joint_by != 0.0) {
      asked_ns_ = monotonic_ns();
      joint_shown_ = true;
      joint_.move(joint_by, state, mode_);
    }
    if (hand == nullptr) return;
    if (by.by != HandMove{}.by || by.turn != HandMove{}.turn) {
      asked_ns_ = monotonic_ns();
      joint_shown_ = false;
    }
    const Eigen::Isometry3d at = estimator_.ground_in_world().inverse() *
                                 estimator_.kinematics().link_in_world(hand->link) * hand->frame;
    target_.move(Eigen::Vector3d(by.by.data()), Eigen::Vector3d(by.turn.data()), at);
  }
  void stop() {
    target_.stop();
    joint_.stop();
  }
  // What was asked for besides the axes.  Another mode ends a jog, and says itself what becomes of the joint.
  void on_action(TeleopAction action) {
    if (action == TeleopAction::kCentre) stop();
    if (action == TeleopAction::kNextJoint) choose_joint(1);
    if (action == TeleopAction::kPreviousJoint) choose_joint(-1);
    if (ModeRequest mode; to_mode_request(action, mode)) {
      target_.stop();
      joint_.drop();
    }
  }
  // Of the joint, behind a mode that the operator asks for.
  void ask_for_pose(std::int64_t now_ns, const RobotState& state, Requests& requests) {
    if (!known_ || state.stop_kind != StopKind::kNone || requests.says_mode()) return;
    if (ModeRequest pose; joint_.next(now_ns, state, mode_, pose)) requests.start_pose(pose, state.run_id);
  }
  // Why what was asked for is not done, once; empty when there is nothing new.
  std::string take_sentence() {
    const bool refused = target_.phase() == HandTarget::Phase::kRefused;
    if (refused && !refused_) sentence_ = "the hand stays: " + why_no_way();
    refused_ = refused;
    const bool held = joint_.is_held() && asked();
    const bool told = told_ns_ != 0 && seconds_since(told_ns_) < kAnswers;
    if (held && !joint_held_ && !told) sentence_ = "the joint is held" + nearest();
    joint_held_ = held;
    return std::exchange(sentence_, {});
  }
  bool walks() const { return mode_ == Mode::kWalk; }
  void send(Bus& bus, const RobotState& state, std::int64_t utime, std::int64_t now) {
    ArmGoal goal;
    if (!target_.next(now, state.run_id, random_id(), goal)) return;
    goal.sender_id = id_;
    goal.utime = utime;
    static_cast<void>(bus.send(channel::kArmGoal, goal));  // counted by the bus
  }
  std::string words(const RobotState& state) const {
    if (known_ && joint_shown_) return joint_.words(state);
    const std::string side = spoken();
    const Eigen::Vector3d& at = target_.wanted();
    switch (target_.phase()) {
      case HandTarget::Phase::kAsked:
      case HandTarget::Phase::kGoing:
        return formatted("%s to %.2f %.2f %.2f", side.c_str(), at.x(), at.y(), at.z());
      case HandTarget::Phase::kRefused:
        return side + ": " + (target_.unanswered() ? "no planner answers" : "no way there");
      case HandTarget::Phase::kIdle:
        break;
    }
    if (!heard_) return "";
    return known_ ? side : "hands of another robot: --robot says which";
  }

 private:
  static constexpr double kOtherHolds = 0.2;  // [s] since the other was heard holding on

  static constexpr double kAnswers = 2.0;     // [s] after a wish, what others tell is of it

  ArmSide side_of(const Hand& hand) const { return static_cast<ArmSide>(number_of(model_, hand) + 1); }
  // Of the hand that is moved.
  std::string spoken() const {
    const Hand* hand = hand_of(model_, number_of(target_.side()));
    if (hand == nullptr) return "no hand";
    return target_.side() == ArmSide::kLeft || target_.side() == ArmSide::kRight ? hand->name + " hand" : "arm " + hand->name;
  }
  void choose_joint(int step) {
    joint_.choose(step);
    joint_shown_ = true;
  }
  bool asked() const { return asked_ns_ != 0 && seconds_since(asked_ns_) < kAnswers; }
  std::string why_no_way() const {
    if (target_.unanswered()) return "no planner answers";
    const std::array<int, 2> pair = target_.touching();
    return plan_refusal(target_.refusal(), thing_name(model_, {}, pair[0]).data(), thing_name(model_, {}, pair[1]).data(),
                        target_.miss(), target_.oriented());
  }
  // What the controller, planner or guard tells while something is asked for.
  void hear_event(const Event& event) {
    // The planner's event says what is wrong with a goal that makes no sense; all else it answers on ARM_PATH.
    const bool bad_goal = event.kind == ProcessKind::kPlanner && target_.refusal() == ArmPathStatus::kBadGoal;
    const bool answers = event.kind == ProcessKind::kController || event.kind == ProcessKind::kGuard || bad_goal;
    if (!asked() || !answers) return;
    told_ns_ = monotonic_ns();
    sentence_ = printable({event.text.data(), strnlen(event.text.data(), event.text.size())});
  }
  void hear_guard(const GuardReport& report) { guard_ = report; }
  // What it is nearest to, where it is near anything.
  std::string nearest() const {
    if (guard_.pairs_near <= 0) return "";
    return std::string(": ") + thing_name(model_, {}, guard_.link_a[0]).data() +
           formatted(" is %.0f mm from ", 1e3 * static_cast<double>(guard_.distance[0])) +
           thing_name(model_, {}, guard_.link_b[0]).data();
  }
  void hear_status(const ControllerStatus& status) {
    target_.on_status(status);
    mode_ = status.mode;
  }
  void hear_gamepad(const Gamepad& pad) {
    if (pad.sender_id != id_ && pad.deadman) other_ns_ = monotonic_ns();
  }

  const Model& model_;
  Estimator estimator_;
  std::int64_t id_;
  std::vector<ArmSide> sides_;
  HandTarget target_;
  JointTarget joint_;
  std::string sentence_;
  std::int64_t asked_ns_ = 0, told_ns_ = 0;  // something; what others tell
  bool joint_shown_ = false, refused_ = false, joint_held_ = false;
  GuardReport guard_;
  bool heard_ = false, known_ = false, held_ = false, drives_ = false;
  std::int64_t other_ns_ = 0;
  Mode mode_ = Mode::kNone;
};

}  // namespace twinbus::control
