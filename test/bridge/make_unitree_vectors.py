#!/usr/bin/env python3
"""Prints the checksums in unitree_frames_test.cpp, as the vendor's Python SDK computes them (pip install unitree-sdk2py-dimos).

    make_unitree_vectors.py

Motor m has mode 1, q m / 8 - 1, dq m / 4, tau -m / 2, and in a command kp m + 1, kd m / 16; the rest is said below.
"""
from unitree_sdk2py.idl import default
from unitree_sdk2py.utils.crc import CRC


def motors(frame, count, command):
    for m, motor in enumerate((frame.motor_cmd if command else frame.motor_state)[:count]):
        motor.mode, motor.q, motor.dq = 1, m / 8 - 1, m / 4
        if command:
            motor.tau, motor.kp, motor.kd = -m / 2, m + 1.0, m / 16
        else:
            motor.tau_est = -m / 2


def state(frame):
    frame.tick, frame.wireless_remote = 123456, list(range(40))
    frame.imu_state.quaternion, frame.imu_state.gyroscope = [1.0, 0.0, 0.0, 0.0], [1.0, 2.0, 3.0]
    frame.imu_state.accelerometer, frame.imu_state.rpy, frame.imu_state.temperature = [0.5, -0.5, 9.75], [0.0, 0.0, 0.0], 0


def main():
    hg_command = default.unitree_hg_msg_dds__LowCmd_()
    hg_command.mode_pr, hg_command.mode_machine = 0, 5
    motors(hg_command, 35, True)
    hg_state = default.unitree_hg_msg_dds__LowState_()
    hg_state.mode_pr, hg_state.mode_machine = 0, 5
    motors(hg_state, 35, False)
    state(hg_state)
    for motor in hg_state.motor_state:
        motor.temperature, motor.vol = [41, 41], 50.5
    go_command = default.unitree_go_msg_dds__LowCmd_()
    go_command.head, go_command.level_flag, go_command.gpio = [0xFE, 0xEF], 0xFF, 0
    motors(go_command, 20, True)
    go_state = default.unitree_go_msg_dds__LowState_()
    go_state.head, go_state.level_flag = [0xFE, 0xEF], 0xFF
    motors(go_state, 20, False)
    state(go_state)
    for motor in go_state.motor_state:
        motor.q_raw, motor.dq_raw, motor.temperature = motor.q, motor.dq, 41
    go_state.foot_force = go_state.foot_force_est = [10, 20, 30, 40]
    go_state.power_v, go_state.power_a = 29.5, 0.0
    for name, frame in (("kHgCommand", hg_command), ("kHgState", hg_state), ("kGoCommand", go_command), ("kGoState", go_state)):
        print(f"constexpr std::uint32_t {name} = 0x{CRC().Crc(frame):08X};")


if __name__ == "__main__":
    main()
