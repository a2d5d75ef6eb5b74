#include "control/teleop/teleop.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "common/text/formatted.h"
#include "lcmtypes/msg/motion_defaults.h"

namespace twinbus::inline control {

namespace {

constexpr double kStickDeadZone = 0.12;  // of full travel: worn sticks rest up to 0.1 off centre
constexpr double kTriggerDeadZone = 0.05;
constexpr double kKeyboardIdle = 30.0;  // no key for so long: nobody is there [s]

struct AxisRow {
  std::size_t axis;
  double sign;
  float Gamepad::*field;
  const char* control;
  const char* effect;
};
constexpr std::array<AxisRow, 4> kAxes{{
    {1, -1.0, &Gamepad::left_y, "left stick forward / back",
     "lean forward / back; in mode walk: walk"},
    {0, -1.0, &Gamepad::left_x, "left stick left / right",
     "lean left / right; in mode walk: step aside"},
    {3, -1.0, &Gamepad::right_y, "right stick down", "crouch"},
    {2, -1.0, &Gamepad::right_x, "right stick left / right", "turn, in mode walk"},
}};

// While this one is held too, the sticks move a hand or a joint and leave the body alone.
constexpr std::int32_t kHandButton = kPadRightShoulder;
constexpr double kHandSpeed = 0.10, kTurnSpeed = 0.4;      // at full stick [m/s], [rad/s]
constexpr double kHandKeyStep = 0.02, kTurnKeyStep = 0.05;  // [m], [rad]
constexpr double kJointKeyStep = 0.1;                       // at the speed of a joint [s]
constexpr double kPadCycle = 0.01;                          // from one on_pad to the next [s]
constexpr float kPulled = 0.5F;                             // a trigger
constexpr std::size_t kLeftTrigger = 4, kRightTrigger = 5;  // axes
struct HandAxisRow {
  std::size_t axis;  // of the pad
  double sign;
  std::size_t direction;  // forward, left, up; or about these
};
constexpr std::array<HandAxisRow, 3> kHandAxes{{{1, -1.0, 0}, {0, -1.0, 1}, {3, -1.0, 2}}};
// A stick to the right rolls to the right, forward tips forward, the other to the left turns left.
constexpr std::array<HandAxisRow, 3> kTurnAxes{{{0, 1.0, 0}, {1, -1.0, 1}, {2, -1.0, 2}}};
constexpr HandAxisRow kJointAxis{3, -1.0, 0};

constexpr std::int32_t kDeadmanButton = kPadLeftShoulder;

struct ButtonRow {
  std::int32_t buttons;  // all of them
  TeleopAction action;
  bool needs_deadman;
  const char* control;
  const char* effect;
};
constexpr std::array<ButtonRow, 10> kButtons{{
    {kPadB, TeleopAction::kStop, false, "B", "STOP, at any time"},
    {kPadBack | kPadStart, TeleopAction::kClear, false, "back + start", "clear the stop"},
    {kDeadmanButton, TeleopAction::kDeadman, false, "left bumper (LB), held",
     "dead-man: everything below works only while it is held"},
    {kPadA, TeleopAction::kBalance, true, "A", "balance, standing still"},
    {kPadUp, TeleopAction::kWalk, true, "cross up",
     "walk: the sticks then walk and turn; A stands again"},
    {kPadX, TeleopAction::kSway, true, "X", "sway from side to side"},
    {kPadY, TeleopAction::kSquat, true, "Y", "squat up and down"},
    {kPadDown, TeleopAction::kHold, true, "cross down", "hold the posture"},
    {kPadLeft, TeleopAction::kLeftHand, true, "cross left", "the left hand is the one to move, or the arm before this one"},
    {kPadRight, TeleopAction::kRightHand, true, "cross right", "the right hand is the one to move, or the arm after this one"},
}};

struct KeyRow {
  int key;
  int other_key;  // does the same, 0 none
  float Gamepad::*field;
  float step;
  TeleopAction action;
  const char* control;
  const char* effect;
};
constexpr float kStep = 0.1f;
constexpr std::array<KeyRow, 20> kKeys{{
    {' ', 0, nullptr, 0, TeleopAction::kStop, "space", "STOP, at any time"},
    {'c', 0, nullptr, 0, TeleopAction::kClear, "c", "clear the stop"},
    {'w', kKeyUp, &Gamepad::left_y, kStep, TeleopAction::kNone, "w, arrow up",
     "lean forward, a step more; in mode walk: walk"},
    {'s', kKeyDown, &Gamepad::left_y, -kStep, TeleopAction::kNone, "s, arrow down", "lean back"},
    {'a', kKeyLeft, &Gamepad::left_x, kStep, TeleopAction::kNone, "a, arrow left", "lean left"},
    {'d', kKeyRight, &Gamepad::left_x, -kStep, TeleopAction::kNone, "d, arrow right", "lean right"},
    {'i', 0, &Gamepad::right_y, kStep, TeleopAction::kNone, "i", "rise again"},
    {'k', 0, &Gamepad::right_y, -kStep, TeleopAction::kNone, "k", "crouch, a step more"},
    {'j', 0, &Gamepad::right_x, kStep, TeleopAction::kNone, "j", "turn left, in mode walk"},
    {'l', 0, &Gamepad::right_x, -kStep, TeleopAction::kNone, "l", "turn right, in mode walk"},
    {'x', '0', nullptr, 0, TeleopAction::kCentre, "x, 0", "centre: all of the above back to zero"},
    {'1', 0, nullptr, 0, TeleopAction::kBalance, "1", "balance, standing still"},
    {'2', 0, nullptr, 0, TeleopAction::kSway, "2", "sway from side to side"},
    {'3', 0, nullptr, 0, TeleopAction::kSquat, "3", "squat up and down"},
    {'4', 0, nullptr, 0, TeleopAction::kHold, "4", "hold the posture"},
    {'5', 0, nullptr, 0, TeleopAction::kWalk, "5",
     "walk: w s a d then walk, j l turn; 1 stands again"},
    {'h', 0, nullptr, 0, TeleopAction::kOtherHand, "h", "the next hand is the one to move"},
    {']', 0, nullptr, 0, TeleopAction::kNextJoint, "]", "the next joint is the one to move"},
    {'[', 0, nullptr, 0, TeleopAction::kPreviousJoint, "[", "the joint before it"},
    {'q', 3, nullptr, 0, TeleopAction::kQuit, "q, Ctrl-C", "let go and quit"},
}};

// Capitals move or turn the chosen hand by a step; the planner finds a way around everything.
struct HandKeyRow {
  int key;
  std::size_t direction;  // forward, left, up; 3 to 5: about these
  double sign;
};
constexpr std::array<HandKeyRow, 12> kHandKeys{
    {{'W', 0, 1.0}, {'S', 0, -1.0}, {'A', 1, 1.0}, {'D', 1, -1.0}, {'I', 2, 1.0}, {'K', 2, -1.0},
     {'O', 3, 1.0}, {'U', 3, -1.0}, {'T', 4, 1.0}, {'G', 4, -1.0}, {'J', 5, 1.0}, {'L', 5, -1.0}}};
// Of the chosen joint.
struct JointKeyRow {
  int key;
  double sign;
};
constexpr std::array<JointKeyRow, 4> kJointKeys{{{'=', 1.0}, {'+', 1.0}, {'-', -1.0}, {'_', -1.0}}};

constexpr int kMinRaw = -32767;  // SDL's range is one longer on the negative side
constexpr double kFullRaw = 32767.0;

double unit(std::int16_t raw) { return std::max<int>(raw, kMinRaw) / kFullRaw; }

// In another mode the same axes mean something else: a lean must not become a walk.
bool changes_mode(TeleopAction action) {
  ModeRequest request;
  return to_mode_request(action, request);
}

// The right bumper and trigger.
bool chooses_joint(const PadInput& input) {
  return (input.buttons & kHandButton) != 0 && trigger_value(input.axes[kRightTrigger]) > kPulled;
}

TeleopAction joint_action(TeleopAction action) {
  return action == TeleopAction::kLeftHand    ? TeleopAction::kPreviousJoint
         : action == TeleopAction::kRightHand ? TeleopAction::kNextJoint
                                              : action;
}

bool centred(const PadInput& input) {
  return std::all_of(kAxes.begin(), kAxes.end(), [&](const AxisRow& row) {
    return std::abs(unit(input.axes[row.axis])) <= kStickDeadZone;
  });
}

void zero_axes(Gamepad& gamepad) {
  for (const AxisRow& row : kAxes) gamepad.*row.field = 0.0f;
  gamepad.left_trigger = 0.0f;
  gamepad.right_trigger = 0.0f;
}

void append_row(std::string& text, const char* control, const char* effect) {
  text += formatted("  %-28s %s\n", control, effect);
}

}  // namespace

float stick_value(std::int16_t raw, double sign) noexcept {
  const double value = unit(raw);
  const double beyond = std::abs(value) - kStickDeadZone;
  if (!(beyond > 0.0)) return 0.0f;
  return static_cast<float>(std::copysign(beyond / (1.0 - kStickDeadZone), sign * value));
}

float trigger_value(std::int16_t raw) noexcept {
  const double beyond = unit(raw) - kTriggerDeadZone;
  return beyond > 0.0 ? static_cast<float>(beyond / (1.0 - kTriggerDeadZone)) : 0.0f;
}

Teleop::Teleop(std::int64_t sender_id, bool keyboard) : keyboard_(keyboard) {
  gamepad_.sender_id = sender_id;
  gamepad_.keyboard = keyboard;
  gamepad_.connected = keyboard;
  if (keyboard) std::snprintf(gamepad_.name.data(), gamepad_.name.size(), "keyboard");
}

void Teleop::release() noexcept {
  armed_ = false;
  seen_released_ = false;
  centre_first_ = false;
  gamepad_.deadman = false;
  hand_move_ = {};
  joint_move_ = 0.0;
  zero_axes(gamepad_);
}

void Teleop::let_go() noexcept {
  release();
  gamepad_.connected = false;
  gamepad_.buttons = 0;
  last_buttons_ = 0;
}

void Teleop::on_source(std::int64_t run_id, bool stopped) noexcept {
  run_id_ = run_id;
  if (stop_latched_ && stop_seen_ && !stopped) stop_latched_ = false;
  stop_seen_ = stop_latched_ && stopped;
}

void Teleop::on_pad(const PadInput& input) noexcept {
  if (!input.connected) return let_go();
  gamepad_.connected = true;
  gamepad_.name = input.name;
  gamepad_.buttons = input.buttons;

  // The dead-man first: a button pressed in the moment of letting go does nothing.
  const bool deadman = (input.buttons & kDeadmanButton) != 0;
  if (!deadman) release();
  for (const ButtonRow& row : kButtons) {
    const bool pressed = (input.buttons & row.buttons) == row.buttons;
    const bool before = (last_buttons_ & row.buttons) == row.buttons;
    if (row.action == TeleopAction::kDeadman) continue;
    if (!pressed || before || (row.needs_deadman && !armed_)) continue;
    act(chooses_joint(input) ? joint_action(row.action) : row.action);
  }
  last_buttons_ = input.buttons;
  if (!deadman) {
    seen_released_ = true;  // whatever a stop or a clear has just forgotten
    return;
  }

  if (!armed_ && seen_released_ && !stop_latched_ && centred(input)) {
    armed_ = true;
    gamepad_.run_id = run_id_;
  }
  gamepad_.deadman = armed_;
  zero_axes(gamepad_);
  if (!armed_) return;
  centre_first_ = centre_first_ && !centred(input);
  if (centre_first_) return;
  if ((input.buttons & kHandButton) != 0) return move_arm(input);
  for (const AxisRow& row : kAxes) {
    gamepad_.*row.field = stick_value(input.axes[row.axis], row.sign);
  }
  gamepad_.left_trigger = trigger_value(input.axes[4]);
  gamepad_.right_trigger = trigger_value(input.axes[5]);
}

// The right trigger: a joint, the left one: the hand turns, neither: it moves.
void Teleop::move_arm(const PadInput& input) noexcept {
  const auto stick = [&](const HandAxisRow& row) {
    return kPadCycle * static_cast<double>(stick_value(input.axes[row.axis], row.sign));
  };
  if (chooses_joint(input)) {
    joint_move_ += stick(kJointAxis);
  } else if (trigger_value(input.axes[kLeftTrigger]) > kPulled) {
    for (const HandAxisRow& row : kTurnAxes) hand_move_.turn[row.direction] += kTurnSpeed * stick(row);
  } else {
    for (const HandAxisRow& row : kHandAxes) hand_move_.by[row.direction] += kHandSpeed * stick(row);
  }
}

bool Teleop::arm_key(int key) noexcept {
  for (const HandKeyRow& row : kHandKeys) {
    if (row.key != key) continue;
    if (!take_hold()) return true;
    if (row.direction < 3) {
      hand_move_.by[row.direction] += row.sign * kHandKeyStep;
    } else {
      hand_move_.turn[row.direction - 3] += row.sign * kTurnKeyStep;
    }
    return true;
  }
  for (const JointKeyRow& row : kJointKeys) {
    if (row.key != key) continue;
    if (take_hold()) joint_move_ += row.sign * kJointKeyStep;
    return true;
  }
  return false;
}

void Teleop::on_key(int key, std::int64_t now_ns) noexcept {
  if (key <= 0) return;
  if (arm_key(key)) {
    last_key_ns_ = now_ns;
    return;
  }
  const auto row = std::find_if(kKeys.begin(), kKeys.end(), [&](const KeyRow& candidate) {
    return candidate.key == key || candidate.other_key == key;
  });
  if (row == kKeys.end()) return;
  last_key_ns_ = now_ns;
  if (row->action != TeleopAction::kNone) return act(row->action);
  if (!take_hold()) return;
  // Whole steps, so that as many steps back give exactly zero.
  float& value = gamepad_.*row->field;
  value = std::clamp(std::round((value + row->step) / kStep) * kStep, -1.0f, 1.0f);
}

// Of a keyboard, which has no button to hold: any key that moves something does.
bool Teleop::take_hold() noexcept {
  if (stop_latched_) return false;
  if (!armed_) gamepad_.run_id = run_id_;
  armed_ = true;
  gamepad_.deadman = true;
  return true;
}

HandMove Teleop::take_hand_move() noexcept { return std::exchange(hand_move_, {}); }

void Teleop::set_hands(std::span<const ArmSide> hands) noexcept {
  if (hands.empty()) return;
  hand_count_ = std::min(hands.size(), hands_.size());
  std::copy_n(hands.begin(), hand_count_, hands_.begin());
  hand_ = hands_.front();
}

double Teleop::take_joint_move() noexcept { return std::exchange(joint_move_, 0.0); }

void Teleop::act(TeleopAction action) noexcept {
  if (action == TeleopAction::kStop) {
    release();
    stop_latched_ = true;
    stop_seen_ = false;
  }
  if (action == TeleopAction::kClear) {
    stop_latched_ = false;
    release();
  }
  if (action == TeleopAction::kCentre || changes_mode(action)) {
    zero_axes(gamepad_);
    hand_move_ = {};
    joint_move_ = 0.0;
  }
  if (changes_mode(action)) centre_first_ = true;
  const auto here = static_cast<std::size_t>(std::find(hands_.begin(), hands_.begin() + hand_count_, hand_) - hands_.begin());
  if (action == TeleopAction::kOtherHand) hand_ = hands_[(here + 1) % hand_count_];
  if (action == TeleopAction::kLeftHand && here > 0) hand_ = hands_[here - 1];
  if (action == TeleopAction::kRightHand && here + 1 < hand_count_) hand_ = hands_[here + 1];
  if (action == TeleopAction::kQuit) let_go();
  // A stop is never lost to a full list: it takes the last place.
  if (action_count_ == static_cast<int>(actions_.size())) {
    if (action != TeleopAction::kStop) return;
    --action_count_;
  }
  actions_[static_cast<std::size_t>(action_count_++)] = action;
}

TeleopAction Teleop::take_action() noexcept {
  if (action_count_ == 0) return TeleopAction::kNone;
  const TeleopAction first = actions_.front();
  std::copy(actions_.begin() + 1, actions_.begin() + action_count_, actions_.begin());
  --action_count_;
  return first;
}

Gamepad Teleop::message(std::int64_t utime, std::int64_t now_ns) noexcept {
  if (keyboard_ && armed_ && 1e-9 * static_cast<double>(now_ns - last_key_ns_) > kKeyboardIdle) {
    release();
  }
  if (!armed_) gamepad_.run_id = run_id_;
  gamepad_.stop = stop_latched_;
  gamepad_.utime = utime;
  ++gamepad_.sequence;
  return gamepad_;
}

bool to_mode_request(TeleopAction action, ModeRequest& request) noexcept {
  request.mode = Mode::kBalance;
  request.motion = Motion::kNone;
  switch (action) {
    case TeleopAction::kBalance:
      return true;
    case TeleopAction::kSway:
    case TeleopAction::kSquat:
      request.motion = action == TeleopAction::kSway ? Motion::kSway : Motion::kSquat;
      request.amplitude = defaults_of(request.motion).amplitude;
      request.frequency = defaults_of(request.motion).frequency;
      return true;
    case TeleopAction::kWalk:
      request.mode = Mode::kWalk;
      return true;
    case TeleopAction::kHold:
      request.mode = Mode::kHold;
      return true;
    default:
      return false;
  }
}

std::string cheat_sheet(bool keyboard) {
  std::string text;
  if (keyboard) {
    text +=
        "keyboard: each key moves a set point by a tenth; there is no dead-man key: the set points "
        "stay until x, space,\n"
        "another mode (1 to 5), or 30 s without a key\n";
    for (const KeyRow& row : kKeys) append_row(text, row.control, row.effect);
    append_row(text, "W S A D, with shift",
               "hand 20 mm forward, back, left, right, around everything");
    append_row(text, "I K, with shift", "hand 20 mm up, down; x stops it");
    append_row(text, "U O, T G, J L, with shift",
               "hand rolls left, right; tips forward, back; turns left, right by 3 degrees; it keeps its turn from then on");
    append_row(text, "+ -", "the chosen joint one way, the other, at a quarter of its speed while the key is held");
    append_row(text, "no key for 30 s", "counts as letting go, as does closing the terminal");
    return text;
  }
  text += "gamepad (names as on an Xbox pad)\n";
  for (const ButtonRow& row : kButtons) append_row(text, row.control, row.effect);
  for (const AxisRow& row : kAxes) append_row(text, row.control, row.effect);
  append_row(text, "right bumper (RB), held too",
             "sticks move the hand: left stick along the ground,");
  append_row(text, "", "right stick up / down; the planner finds the way");
  append_row(text, "RB and LT", "sticks turn the hand: left stick rolls and tips it,");
  append_row(text, "", "right stick turns it left / right; it keeps its turn from then on");
  append_row(text, "RB and RT", "right stick up / down moves the chosen joint, cross left / right");
  append_row(text, "", "chooses the one before or the next");
  text += "  take hold with centred sticks; letting go of LB or unplugging sends zeros; after a change of mode the sticks\n"
          "  count again once they were centred\n";
  return text;
}

}  // namespace twinbus::control
