// From a gamepad or a keyboard to what goes out on the bus, by tables that are also the cheat
// sheet.
//
// Pure: neither SDL nor bus nor clock.  Sticks act only while the dead-man button is held and only
// after they have been centred; a stop is latched here until it is cleared; everything is zero the
// moment the button is let go, the pad is unplugged or the keyboard is left alone.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline control {

// Bits of Gamepad::buttons; SDL's controller buttons in SDL's order.
enum PadButton : std::int32_t {
  kPadA = 1 << 0,
  kPadB = 1 << 1,
  kPadX = 1 << 2,
  kPadY = 1 << 3,
  kPadBack = 1 << 4,
  kPadStart = 1 << 6,
  kPadLeftShoulder = 1 << 9,
  kPadRightShoulder = 1 << 10,
  kPadUp = 1 << 11,
  kPadDown = 1 << 12,
  kPadLeft = 1 << 13,
  kPadRight = 1 << 14,
};

// A pad as the driver sees it: left x, left y, right x, right y, left and right trigger; right and
// down positive.
struct PadInput {
  bool connected = false;
  std::int32_t buttons = 0;
  std::array<std::int16_t, 6> axes{};
  std::array<char, 32> name{};
};

// Keys that are not a byte.
enum Key : int { kKeyUp = 256, kKeyDown, kKeyLeft, kKeyRight };

// How far a hand is to move (forward, left, up [m]) and to turn about these three axes [rad].
struct HandMove {
  std::array<double, 3> by{}, turn{};
};

enum class TeleopAction {
  kNone,
  kDeadman,  // held, not pressed
  kStop,
  kClear,
  kBalance,
  kSway,
  kSquat,
  kHold,
  kWalk,
  kCentre,  // keyboard: all set points to zero
  kOtherHand,
  kLeftHand,
  kRightHand,
  kNextJoint,
  kPreviousJoint,
  kQuit,
};

class Teleop {
 public:
  // sender_id: random, drawn at start.  keyboard: keys set the axes, and there is no button to
  // hold.
  Teleop(std::int64_t sender_id, bool keyboard);

  void on_pad(const PadInput& input) noexcept;         // once per cycle
  void on_key(int key, std::int64_t now_ns) noexcept;  // a byte or a Key; unknown keys do nothing
  void let_go() noexcept;                              // terminal lost, leaving: zeros from now on
  // The active source, for addressing; a stop cleared by somebody else unlatches ours.
  void on_source(std::int64_t run_id, bool stopped) noexcept;
  void on_no_source() noexcept { run_id_ = 0; }  // none is heard

  // The next message to send; counts the sequence up.
  Gamepad message(std::int64_t utime, std::int64_t now_ns) noexcept;
  // Of the chosen hand, since the last call.
  HandMove take_hand_move() noexcept;
  // Of the chosen joint, since the last call: so long at the speed of a joint that is jogged, either way [s].
  double take_joint_move() noexcept;
  ArmSide hand() const noexcept { return hand_; }
  // Those that kOtherHand, kLeftHand and kRightHand step through, at most eight; the first is the one to move.  Without: left and right.
  void set_hands(std::span<const ArmSide> hands) noexcept;
  // The next thing asked for besides the axes; kNone when there is nothing more.
  TeleopAction take_action() noexcept;

  bool holding() const noexcept { return armed_; }
  bool stop_latched() const noexcept { return stop_latched_; }

 private:
  void act(TeleopAction action) noexcept;
  void move_arm(const PadInput& input) noexcept;
  bool arm_key(int key) noexcept;
  void release() noexcept;
  bool take_hold() noexcept;

  Gamepad gamepad_;
  bool keyboard_;
  bool armed_ = false;          // the dead-man button is held and the sticks have been centred
  bool seen_released_ = false;  // since the last release(): a button held all along does not arm
  bool centre_first_ = false;   // the mode has just been changed: sticks that were pushed for the old one count once centred
  bool stop_latched_ = false;
  bool stop_seen_ = false;  // the source has shown our stop
  std::int32_t last_buttons_ = 0;
  std::int64_t last_key_ns_ = 0;
  std::int64_t run_id_ = 0;
  ArmSide hand_ = ArmSide::kLeft;
  std::array<ArmSide, 8> hands_{ArmSide::kLeft, ArmSide::kRight};
  std::size_t hand_count_ = 2;
  HandMove hand_move_;
  double joint_move_ = 0.0;  // [s]
  std::array<TeleopAction, 16> actions_{};
  int action_count_ = 0;
};

// Dead zone taken off, the rest stretched to -1..1.
float stick_value(std::int16_t raw, double sign) noexcept;
float trigger_value(std::int16_t raw) noexcept;  // 0..1

// The mode request behind an action, all but its addressing; false for actions that are none.
[[nodiscard]] bool to_mode_request(TeleopAction action, ModeRequest& request) noexcept;

// The tables as text for a terminal.
std::string cheat_sheet(bool keyboard);

}  // namespace twinbus::control
