#!/usr/bin/env python3
"""Programs for a Unitree robot, on the vendor's own Python SDK (package unitree-sdk2py-dimos): what face_test.py lets drive.

    unitree_peer.py frames KIND COUNT INTERFACE DOMAIN   checks every state of unitree_probe and answers with a command
    unitree_peer.py drive KIND INTERFACE SECONDS         waits for the robot, holds what it finds, moves motor 3 by 0.1 rad
    unitree_peer.py WRONG KIND INTERFACE SECONDS         the same, but crc, nan, mode_machine, motor_mode, fast, other (a second
                                                         program that wants motor 3 elsewhere)
    unitree_peer.py released INTERFACE                   asks the motion service

KIND is unitree_hg or unitree_go.
"""
import importlib
import math
import sys
import time

import numpy as np
from unitree_sdk2py.core.channel import ChannelFactoryInitialize, ChannelPublisher, ChannelSubscriber
from unitree_sdk2py.idl import default
from unitree_sdk2py.utils.crc import CRC

AMPLITUDE = 0.1  # [rad]
MOVED = 3        # motor
MOTORS = {"unitree_hg": 35, "unitree_go": 20}
DRIVEN = {"unitree_hg": 29, "unitree_go": 12}


def types_of(kind):
    return importlib.import_module(f"unitree_sdk2py.idl.{kind}.msg.dds_")


def mixed(k, item):
    h = (k * 2654435761 + item * 2246822519 + 374761393) & 0xFFFFFFFF
    h ^= h >> 15
    h = (h * 2246822519) & 0xFFFFFFFF
    return h ^ (h >> 13)


def number(k, item):
    return (mixed(k, item) & 0xFFFF) / 64.0 - 512.0


def new_command(kind):
    frame = getattr(default, f"{kind}_msg_dds__LowCmd_")()
    if kind == "unitree_go":
        frame.head, frame.level_flag, frame.gpio = [0xFE, 0xEF], 0xFF, 0
        for motor in frame.motor_cmd:
            motor.mode = 0
    return frame


def command_of(k, kind):
    frame = new_command(kind)
    if kind == "unitree_hg":
        frame.mode_pr, frame.mode_machine = mixed(k, 900) & 1, mixed(k, 901) & 0xFF
    for m in range(MOTORS[kind]):
        i, motor = 10 * m, frame.motor_cmd[m]
        motor.mode = int(mixed(k, i) & 7 != 0)
        if motor.mode:
            motor.q, motor.dq, motor.tau = number(k, i + 1), number(k, i + 2), number(k, i + 3)
            motor.kp, motor.kd = number(k, i + 4) + 512.0, number(k, i + 5) + 512.0
        else:
            motor.q = motor.dq = motor.tau = motor.kp = motor.kd = 0.0
    return frame


def state_of(k, kind):
    frame, hg = getattr(default, f"{kind}_msg_dds__LowState_")(), kind == "unitree_hg"
    frame.tick = k
    if hg:
        frame.mode_pr, frame.mode_machine = 0, mixed(k, 901) & 0xFF
    else:
        frame.head, frame.level_flag = [0xFE, 0xEF], 0xFF
        frame.foot_force = frame.foot_force_est = [mixed(k, 920 + f) & 0x3FF for f in range(4)]
        frame.power_v, frame.power_a = number(k, 930), number(k, 931)
    imu = frame.imu_state
    imu.quaternion, imu.rpy, imu.temperature = [1.0, 0.0, 0.0, 0.0], [0.0] * 3, 0
    imu.gyroscope = [number(k, 910 + a) for a in range(3)]
    imu.accelerometer = [number(k, 913 + a) for a in range(3)]
    for m in range(MOTORS[kind]):
        i, motor = 10 * m, frame.motor_state[m]
        motor.mode = int(mixed(k, i) & 7 != 0)
        motor.q, motor.dq, motor.tau_est = number(k, i + 1), number(k, i + 2), number(k, i + 3)
        warm = mixed(k, i + 4) & 0x7F
        if hg:
            motor.temperature, motor.vol = [warm, warm], number(k, i + 5)
        else:
            motor.q_raw, motor.dq_raw, motor.temperature = motor.q, motor.dq, warm
    frame.wireless_remote = [mixed(k, 950 + b) & 0xFF for b in range(40)]
    return frame


def flat(value):
    """Fields in their order, arrays and structures opened."""
    if hasattr(value, "__dataclass_fields__"):
        return [x for name in value.__dataclass_fields__ for x in flat(getattr(value, name))]
    if isinstance(value, (list, tuple, bytes, np.ndarray)):
        return [x for one in value for x in flat(one)]
    return [value]


def frames(kind, count):
    crc, types = CRC(), types_of(kind)
    publisher = ChannelPublisher("rt/lowcmd", types.LowCmd_)
    publisher.Init()
    subscriber = ChannelSubscriber("rt/lowstate", types.LowState_)
    subscriber.Init()
    wrong, last = 0, 0
    while last < count:
        frame = subscriber.Read(60.0)
        if frame is None:
            break
        k = frame.tick
        if k != last:
            expected = state_of(k, kind)
            expected.crc = crc.Crc(expected)
            if k != last + 1 or frame.crc != crc.Crc(frame) or flat(frame) != flat(expected):
                wrong += 1
                if wrong < 4:
                    print(f"frame {k} after {last}: crc {frame.crc:08x}, of these fields {crc.Crc(frame):08x}, expected {expected.crc:08x}; "
                          f"{[(i, a, b) for i, (a, b) in enumerate(zip(flat(frame), flat(expected))) if a != b][:5]}", flush=True)
            last = k
            answer = command_of(k, kind)
            answer.crc = crc.Crc(answer)
        publisher.Write(answer)
    # The last answer may have been lost with the reader: once more.
    time.sleep(0.3)
    publisher.Write(answer)
    time.sleep(0.3)
    print(f"{last} frames, {wrong} wrong there", flush=True)
    return 0 if last == count and wrong == 0 else 1


def drive(what, kind, seconds):
    crc, types = CRC(), types_of(kind)
    newest = []
    subscriber = ChannelSubscriber("rt/lowstate", types.LowState_)
    subscriber.Init(newest.append, 10)
    publisher = ChannelPublisher("rt/lowcmd", types.LowCmd_)
    publisher.Init()
    end = time.monotonic() + 20
    while not newest:
        if time.monotonic() > end:
            print("no rt/lowstate", flush=True)
            return 1
        time.sleep(0.01)
    state = newest[-1]
    posture = [state.motor_state[m].q for m in range(DRIVEN[kind])]
    frame = new_command(kind)
    if kind == "unitree_hg":
        frame.mode_pr, frame.mode_machine = 0, state.mode_machine
    for m in range(DRIVEN[kind]):
        motor = frame.motor_cmd[m]
        motor.mode, motor.q, motor.dq, motor.tau, motor.kp, motor.kd = 1, posture[m], 0.0, 0.0, 60.0, 2.0
    if what == "other":
        frame.motor_cmd[MOVED].q = posture[MOVED] + 0.7
    if what == "mode_machine":
        frame.mode_machine = (frame.mode_machine + 1) & 0xFF
    if what == "motor_mode":
        frame.motor_cmd[MOVED].mode = 7
    if what in ("crc", "nan", "mode_machine", "motor_mode"):
        frame.motor_cmd[MOVED].q = posture[MOVED] + 0.7  # nobody may go there
    period = 0.0005 if what == "fast" else 0.002
    print("drives", flush=True)
    start = due = time.monotonic()
    bad, sent = 0, 0
    while due - start < seconds:
        if what in ("drive", "fast"):
            frame.motor_cmd[MOVED].q = posture[MOVED] + AMPLITUDE * math.sin(2.0 * math.pi * (due - start))
        if what == "nan":
            frame.motor_cmd[5].tau = math.nan
        frame.crc = crc.Crc(frame)
        if what == "crc":
            frame.crc ^= 1
        if sent % 500 == 0 and newest:
            bad += newest[-1].crc != crc.Crc(newest[-1])
        publisher.Write(frame)
        sent += 1
        due += period
        time.sleep(max(0.0, due - time.monotonic()))
        del newest[:-1]
    print(f"wrote {sent} in {time.monotonic() - start:.1f} s, {bad} states with a wrong crc", flush=True)
    return 1 if bad else 0


def released():
    from unitree_sdk2py.comm.motion_switcher.motion_switcher_client import MotionSwitcherClient
    client = MotionSwitcherClient()
    client.SetTimeout(5.0)
    client.Init()
    print(client.CheckMode(), client.ReleaseMode(), flush=True)
    return 0 if client.CheckMode()[1] == {"form": "0", "name": ""} else 1


def main():
    what = sys.argv[1]
    if what == "frames":
        ChannelFactoryInitialize(int(sys.argv[5]), sys.argv[4])
        return frames(sys.argv[2], int(sys.argv[3]))
    if what == "released":
        ChannelFactoryInitialize(0, sys.argv[2])
        return released()
    ChannelFactoryInitialize(0, sys.argv[3])
    return drive(what, sys.argv[2], float(sys.argv[4]))


if __name__ == "__main__":
    sys.exit(main())
