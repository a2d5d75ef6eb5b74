#include "bridge/unitree/low_frames.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "bridge/unitree/crc.h"

namespace twinbus::inline bridge {

namespace {

constexpr std::uint8_t kOn = 1;
constexpr std::uint8_t kGoOn = 10;  // that of older programs for "go" robots
constexpr std::array<std::uint8_t, 2> kGoHead = {0xFE, 0xEF};
constexpr std::uint8_t kLowLevel = 0xFF;

// Padding too, since the checksum runs over it.
template <class Frame>
void clear(Frame& frame) noexcept {
  static_assert(std::is_trivially_copyable_v<Frame>);
  std::memset(static_cast<void*>(&frame), 0, sizeof frame);
}

template <class Frame>
void seal(Frame& frame, std::span<std::byte> out) noexcept {
  std::memcpy(out.data(), &frame, sizeof frame);
  frame.crc = crc_of_words(out.first(sizeof frame - sizeof frame.crc));
  std::memcpy(out.data() + sizeof frame - sizeof frame.crc, &frame.crc, sizeof frame.crc);
}

// The frame, if size and checksum are right.
template <class Frame>
FrameFault open(std::span<const std::byte> bytes, Frame& frame) noexcept {
  static_assert(std::is_trivially_copyable_v<Frame>);
  if (bytes.size() != sizeof frame) return FrameFault::kSize;
  std::memcpy(static_cast<void*>(&frame), bytes.data(), sizeof frame);
  return crc_of_words(bytes.first(sizeof frame - sizeof frame.crc)) == frame.crc ? FrameFault::kNone : FrameFault::kCrc;
}

template <class Motors>
void put_wishes(const LowCommand& command, Motors& motors) noexcept {
  for (std::size_t m = 0; m < motors.size(); ++m) {
    const MotorWish& wish = command.motor[m];
    auto& motor = motors[m];
    motor.mode = wish.on ? kOn : std::uint8_t{0};
    motor.q = wish.q;
    motor.dq = wish.dq;
    motor.tau = wish.tau;
    motor.kp = wish.kp;
    motor.kd = wish.kd;
  }
}

template <class Motors>
FrameVerdict take_wishes(const Motors& motors, UnitreeFamily family, LowCommand& command) noexcept {
  for (std::size_t m = 0; m < motors.size(); ++m) {
    const auto& motor = motors[m];
    const int number = static_cast<int>(m);
    const bool on = motor.mode == kOn || (family == UnitreeFamily::kGo && motor.mode == kGoOn);
    if (!on && motor.mode != 0) return {FrameFault::kMotorMode, number, motor.mode};
    if (!on) {
      command.motor[m] = {};
      continue;
    }
    for (const float number_of_it : {motor.q, motor.dq, motor.tau, motor.kp, motor.kd}) {
      if (!std::isfinite(number_of_it)) return {FrameFault::kNotFinite, number, 0};
    }
    if (!(motor.kp >= 0.0F && motor.kd >= 0.0F)) return {FrameFault::kGain, number, 0};
    command.motor[m] = {.on = true, .q = motor.q, .dq = motor.dq, .tau = motor.tau, .kp = motor.kp, .kd = motor.kd};
  }
  return {};
}

template <class Integer>
Integer whole(float value) noexcept {
  constexpr auto low = static_cast<float>(std::numeric_limits<Integer>::min());
  constexpr auto high = static_cast<float>(std::numeric_limits<Integer>::max());
  if (!std::isfinite(value)) return 0;
  return static_cast<Integer>(std::lround(std::clamp(value, low, high)));
}

// Roll, pitch and yaw of a unit quaternion w x y z [rad].
std::array<float, 3> roll_pitch_yaw(const std::array<float, 4>& q) noexcept {
  const auto [w, x, y, z] = q;
  const float sine = std::clamp(2.0F * (w * y - z * x), -1.0F, 1.0F);
  return {std::atan2(2.0F * (w * x + y * z), 1.0F - 2.0F * (x * x + y * y)), std::asin(sine),
          std::atan2(2.0F * (w * z + x * y), 1.0F - 2.0F * (y * y + z * z))};
}

template <class Imu>
void put_imu(const LowReading& reading, Imu& imu) noexcept {
  imu.quaternion = reading.quaternion;
  imu.gyroscope = reading.gyro;
  imu.accelerometer = reading.accel;
  imu.rpy = roll_pitch_yaw(reading.quaternion);
}

template <class Imu>
bool take_imu(const Imu& imu, LowReading& reading) noexcept {
  for (const float x : imu.quaternion) {
    if (!std::isfinite(x)) return false;
  }
  for (const float x : imu.gyroscope) {
    if (!std::isfinite(x)) return false;
  }
  for (const float x : imu.accelerometer) {
    if (!std::isfinite(x)) return false;
  }
  reading.quaternion = imu.quaternion;
  reading.gyro = imu.gyroscope;
  reading.accel = imu.accelerometer;
  return true;
}

template <class Motors>
FrameVerdict take_motors(const Motors& motors, LowReading& reading) noexcept {
  for (std::size_t m = 0; m < motors.size(); ++m) {
    const auto& motor = motors[m];
    for (const float number : {motor.q, motor.dq, motor.tau_est}) {
      if (!std::isfinite(number)) return {FrameFault::kNotFinite, static_cast<int>(m), 0};
    }
    reading.motor[m].on = motor.mode != 0;
    reading.motor[m].q = motor.q;
    reading.motor[m].dq = motor.dq;
    reading.motor[m].tau = motor.tau_est;
  }
  return {};
}

FrameVerdict take(const HgLowCmd& frame, LowCommand& command) noexcept {
  command.mode_pr = frame.mode_pr;
  command.mode_machine = frame.mode_machine;
  return take_wishes(frame.motor_cmd, UnitreeFamily::kHg, command);
}

FrameVerdict take(const GoLowCmd& frame, LowCommand& command) noexcept {
  if (frame.level_flag != kLowLevel) return {FrameFault::kLevel, -1, frame.level_flag};
  return take_wishes(frame.motor_cmd, UnitreeFamily::kGo, command);
}

FrameVerdict take(const HgLowState& frame, LowReading& reading) noexcept {
  if (!take_imu(frame.imu_state, reading)) return {FrameFault::kNotFinite, -1, 0};
  reading.mode_pr = frame.mode_pr;
  reading.mode_machine = frame.mode_machine;
  reading.tick = frame.tick;
  reading.remote = frame.wireless_remote;
  for (std::size_t m = 0; m < frame.motor_state.size(); ++m) {
    const HgMotorState& motor = frame.motor_state[m];
    reading.motor[m].celsius = static_cast<float>(std::max(motor.temperature[0], motor.temperature[1]));
    reading.motor[m].volts = std::isfinite(motor.vol) ? motor.vol : 0.0F;
  }
  return take_motors(frame.motor_state, reading);
}

FrameVerdict take(const GoLowState& frame, LowReading& reading) noexcept {
  if (!take_imu(frame.imu_state, reading)) return {FrameFault::kNotFinite, -1, 0};
  reading.tick = frame.tick;
  reading.remote = frame.wireless_remote;
  for (std::size_t f = 0; f < 4; ++f) reading.foot_force[f] = frame.foot_force[f];
  for (std::size_t m = 0; m < frame.motor_state.size(); ++m) reading.motor[m].celsius = frame.motor_state[m].temperature;
  reading.volts = std::isfinite(frame.power_v) ? frame.power_v : 0.0F;
  reading.amperes = std::isfinite(frame.power_a) ? frame.power_a : 0.0F;
  return take_motors(frame.motor_state, reading);
}

template <class Frame, class Result>
FrameVerdict open_and_take(std::span<const std::byte> bytes, Result& result) noexcept {
  Frame frame;
  if (const FrameFault fault = open(bytes, frame); fault != FrameFault::kNone) return {fault, -1, 0};
  Result taken;
  const FrameVerdict verdict = take(frame, taken);
  if (verdict.fault == FrameFault::kNone) result = taken;
  return verdict;
}

// put: what the motors of that frame have besides.
template <class Frame, class Put>
void put_reading(const LowReading& reading, Frame& frame, const Put& put) noexcept {
  frame.tick = reading.tick;
  put_imu(reading, frame.imu_state);
  for (std::size_t m = 0; m < frame.motor_state.size(); ++m) {
    const MotorReading& one = reading.motor[m];
    auto& motor = frame.motor_state[m];
    motor.mode = one.on ? kOn : std::uint8_t{0};
    motor.q = one.q;
    motor.dq = one.dq;
    motor.tau_est = one.tau;
    put(one, motor);
  }
  frame.wireless_remote = reading.remote;
}

void seal_hg(const LowReading& reading, std::span<std::byte> out) noexcept {
  HgLowState frame;
  clear(frame);
  frame.mode_pr = reading.mode_pr;
  frame.mode_machine = reading.mode_machine;
  put_reading(reading, frame, [](const MotorReading& one, HgMotorState& motor) {
    motor.temperature.fill(whole<std::int16_t>(one.celsius));
    motor.vol = one.volts;
  });
  seal(frame, out);
}

void seal_go(const LowReading& reading, std::span<std::byte> out) noexcept {
  GoLowState frame;
  clear(frame);
  frame.head = kGoHead;
  frame.level_flag = kLowLevel;
  put_reading(reading, frame, [](const MotorReading& one, GoMotorState& motor) {
    motor.q_raw = one.q;
    motor.dq_raw = one.dq;
    motor.temperature = whole<std::uint8_t>(one.celsius);
  });
  for (std::size_t f = 0; f < 4; ++f) frame.foot_force[f] = frame.foot_force_est[f] = whole<std::int16_t>(reading.foot_force[f]);
  frame.power_v = reading.volts;
  frame.power_a = reading.amperes;
  seal(frame, out);
}

}  // namespace

void encode(const LowCommand& command, UnitreeFamily family, std::span<std::byte> out) noexcept {
  if (family == UnitreeFamily::kHg) {
    HgLowCmd frame;
    clear(frame);
    frame.mode_pr = command.mode_pr;
    frame.mode_machine = command.mode_machine;
    put_wishes(command, frame.motor_cmd);
    seal(frame, out);
  } else {
    GoLowCmd frame;
    clear(frame);
    frame.head = kGoHead;
    frame.level_flag = kLowLevel;
    put_wishes(command, frame.motor_cmd);
    seal(frame, out);
  }
}

void encode(const LowReading& reading, UnitreeFamily family, std::span<std::byte> out) noexcept {
  if (family == UnitreeFamily::kHg) {
    seal_hg(reading, out);
  } else {
    seal_go(reading, out);
  }
}

FrameVerdict decode(std::span<const std::byte> frame, UnitreeFamily family, LowCommand& command) noexcept {
  return family == UnitreeFamily::kHg ? open_and_take<HgLowCmd>(frame, command) : open_and_take<GoLowCmd>(frame, command);
}

FrameVerdict decode(std::span<const std::byte> frame, UnitreeFamily family, LowReading& reading) noexcept {
  return family == UnitreeFamily::kHg ? open_and_take<HgLowState>(frame, reading) : open_and_take<GoLowState>(frame, reading);
}

}  // namespace twinbus::bridge
