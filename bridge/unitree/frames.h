// Unitree's low-level frames as they lie in memory: LowCmd and LowState of the humanoids ("hg": G1, H1-2) and of the others
// ("go": Go2, B2, H1).
//
// Natural alignment of C; the checksum runs over these bytes, padding included, so padding is zero.  Field names are those of
// the DDS types (bridge/unitree/idl), which twinbus_unitree_dds holds against these structs.  SI units; motors in the order of
// motor_table.h.

#pragma once

#include <array>
#include <cstdint>

namespace twinbus::inline bridge {

inline constexpr int kHgMotors = 35;
inline constexpr int kGoMotors = 20;
inline constexpr int kRemoteBytes = 40;

struct HgMotorCmd {
  std::uint8_t mode;  // 1 on, 0 off
  float q, dq, tau, kp, kd;
  std::uint32_t reserve;
};

struct HgLowCmd {
  std::uint8_t mode_pr;       // 0: ankles and waist as pitch and roll, 1: as motors A and B
  std::uint8_t mode_machine;  // repeats that of the state
  std::array<HgMotorCmd, kHgMotors> motor_cmd;
  std::array<std::uint32_t, 4> reserve;
  std::uint32_t crc;
};

template <class Temperature>
struct ImuState {
  std::array<float, 4> quaternion;  // w x y z
  std::array<float, 3> gyroscope, accelerometer, rpy;
  Temperature temperature;  // [Celsius]
};

struct HgMotorState {
  std::uint8_t mode;
  float q, dq, ddq, tau_est;
  std::array<std::int16_t, 2> temperature;  // [Celsius]
  float vol;                                // [V]
  std::array<std::uint32_t, 2> sensor;
  std::uint32_t motorstate;
  std::array<std::uint32_t, 4> reserve;
};

struct HgLowState {
  std::array<std::uint32_t, 2> version;
  std::uint8_t mode_pr, mode_machine;
  std::uint32_t tick;  // [ms]
  ImuState<std::int16_t> imu_state;
  std::array<HgMotorState, kHgMotors> motor_state;
  std::array<std::uint8_t, kRemoteBytes> wireless_remote;
  std::array<std::uint32_t, 4> reserve;
  std::uint32_t crc;
};

struct GoMotorCmd {
  std::uint8_t mode;  // 1 (or 10) on, 0 off
  float q, dq, tau, kp, kd;
  std::array<std::uint32_t, 3> reserve;
};

struct GoBmsCmd {
  std::uint8_t off;
  std::array<std::uint8_t, 3> reserve;
};

struct GoLowCmd {
  std::array<std::uint8_t, 2> head;  // 0xFE 0xEF
  std::uint8_t level_flag;           // 0xFF: low level
  std::uint8_t frame_reserve;
  std::array<std::uint32_t, 2> sn, version;
  std::uint16_t bandwidth;
  std::array<GoMotorCmd, kGoMotors> motor_cmd;
  GoBmsCmd bms_cmd;
  std::array<std::uint8_t, kRemoteBytes> wireless_remote;
  std::array<std::uint8_t, 12> led;
  std::array<std::uint8_t, 2> fan;
  std::uint8_t gpio;
  std::uint32_t reserve;
  std::uint32_t crc;
};

struct GoMotorState {
  std::uint8_t mode;
  float q, dq, ddq, tau_est, q_raw, dq_raw, ddq_raw;
  std::uint8_t temperature;  // [Celsius]
  std::uint32_t lost;
  std::array<std::uint32_t, 2> reserve;
};

struct GoBmsState {
  std::uint8_t version_high, version_low, status, soc;  // soc: charge [percent]
  std::int32_t current;                                 // [mA]
  std::uint16_t cycle;
  std::array<std::uint8_t, 2> bq_ntc, mcu_ntc;
  std::array<std::uint16_t, 15> cell_vol;  // [mV]
};

struct GoLowState {
  std::array<std::uint8_t, 2> head;
  std::uint8_t level_flag;
  std::uint8_t frame_reserve;
  std::array<std::uint32_t, 2> sn, version;
  std::uint16_t bandwidth;
  ImuState<std::uint8_t> imu_state;
  std::array<GoMotorState, kGoMotors> motor_state;
  GoBmsState bms_state;
  std::array<std::int16_t, 4> foot_force, foot_force_est;  // front right, front left, rear right, rear left
  std::uint32_t tick;                                      // [ms]
  std::array<std::uint8_t, kRemoteBytes> wireless_remote;
  std::uint8_t bit_flag;
  float adc_reel;
  std::uint8_t temperature_ntc1, temperature_ntc2;  // [Celsius]
  float power_v, power_a;                           // [V], [A]
  std::array<std::uint16_t, 4> fan_frequency;
  std::uint32_t reserve;
  std::uint32_t crc;
};

static_assert(sizeof(HgLowCmd) == 1004);
static_assert(sizeof(HgLowState) == 2092);
static_assert(sizeof(GoLowCmd) == 812);
static_assert(sizeof(GoLowState) == 1180);

inline constexpr int kLargestFrame = sizeof(HgLowState);

}  // namespace twinbus::bridge
