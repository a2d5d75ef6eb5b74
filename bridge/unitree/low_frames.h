// LowCmd and LowState of either family in one form, and the way to and from the bytes of a frame (frames.h).
//
// Whoever stands in for the robot decodes commands and encodes states; a driver of a real robot does the opposite.  What
// comes from outside is judged here whole: behind decode() every number is finite and every mode is one that is known.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "bridge/unitree/frames.h"

namespace twinbus::inline bridge {

enum class UnitreeFamily : std::int8_t { kHg, kGo };

struct MotorWish {
  bool on = false;
  float q = 0, dq = 0, tau = 0, kp = 0, kd = 0;  // [rad], [rad/s], [N m], [N m/rad], [N m s/rad]
};

struct LowCommand {
  std::uint8_t mode_pr = 0, mode_machine = 0;  // hg only
  std::array<MotorWish, kHgMotors> motor{};    // go: the first kGoMotors
};

struct MotorReading {
  bool on = false;
  float q = 0, dq = 0, tau = 0;  // [rad], [rad/s], [N m]
  float celsius = 0, volts = 0;  // 0: not known; go frames have no voltage of a motor
};

struct LowReading {
  std::uint8_t mode_pr = 0, mode_machine = 0;  // hg only
  std::uint32_t tick = 0;                      // [ms]
  std::array<float, 4> quaternion{1, 0, 0, 0};  // w x y z
  std::array<float, 3> gyro{}, accel{};         // [rad/s], specific force [m/s^2]
  std::array<MotorReading, kHgMotors> motor{};
  std::array<float, 4> foot_force{};  // go only: front right, front left, rear right, rear left [N]
  std::array<std::uint8_t, kRemoteBytes> remote{};
  float volts = 0, amperes = 0;  // go only: of the battery; 0: not known
};

// Why a frame is not obeyed.
enum class FrameFault : std::int8_t {
  kNone = 0,
  kSize,        // the bytes are no frame of this family
  kCrc,
  kNotFinite,   // q, dq, tau, kp or kd of a motor that is on
  kGain,        // kp or kd below zero
  kMotorMode,   // neither on nor off
  kLevel,       // go: level_flag does not say low level
};
struct FrameVerdict {
  FrameFault fault = FrameFault::kNone;
  int motor = -1;  // of the fault, -1: of none
  int value = 0;   // that was found there: a mode or flag
};

constexpr int motor_count(UnitreeFamily family) noexcept { return family == UnitreeFamily::kHg ? kHgMotors : kGoMotors; }
constexpr std::size_t command_bytes(UnitreeFamily family) noexcept {
  return family == UnitreeFamily::kHg ? sizeof(HgLowCmd) : sizeof(GoLowCmd);
}
constexpr std::size_t state_bytes(UnitreeFamily family) noexcept {
  return family == UnitreeFamily::kHg ? sizeof(HgLowState) : sizeof(GoLowState);
}

// frame: at least command_bytes() or state_bytes(); its checksum is written too.
void encode(const LowCommand& command, UnitreeFamily family, std::span<std::byte> frame) noexcept;
void encode(const LowReading& reading, UnitreeFamily family, std::span<std::byte> frame) noexcept;

// What is refused leaves the result as it was.
FrameVerdict decode(std::span<const std::byte> frame, UnitreeFamily family, LowCommand& command) noexcept;
FrameVerdict decode(std::span<const std::byte> frame, UnitreeFamily family, LowReading& reading) noexcept;

}  // namespace twinbus::bridge
