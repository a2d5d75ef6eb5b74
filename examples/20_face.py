#!/usr/bin/env python3
"""20 A face: a program for a Unitree G1 on DDS, as it would run beside the robot; it cannot see that twinbus answers.

    ./twinbus up stand --robot my_g1 --face unitree_hg      in another terminal: the robot's face (doc/face.md)
    python3 examples/20_face.py --interface lo              needs the vendor's package: pip install unitree-sdk2py-dimos

It takes hold of the posture that it finds and bends the left elbow by 0.3 rad and back."""
import argparse
import math
import time

from unitree_sdk2py.core.channel import ChannelFactoryInitialize, ChannelPublisher, ChannelSubscriber
from unitree_sdk2py.idl.default import unitree_hg_msg_dds__LowCmd_
from unitree_sdk2py.idl.unitree_hg.msg.dds_ import LowCmd_, LowState_
from unitree_sdk2py.utils.crc import CRC

MOTORS, ELBOW = 29, 18
LEGS_AND_WAIST = 15           # the first motors, which carry the robot
PERIOD = 0.002                # [s]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else '')
    parser.add_argument('--interface', default='lo')
    parser.add_argument('--for', dest='duration', type=float, default=6.0, help='[s]')
    arguments = parser.parse_args()
    ChannelFactoryInitialize(0, arguments.interface)
    states: ChannelSubscriber = ChannelSubscriber('rt/lowstate', LowState_)
    states.Init()
    commands: ChannelPublisher = ChannelPublisher('rt/lowcmd', LowCmd_)
    commands.Init()
    state = states.Read(10.0)
    if state is None:
        raise SystemExit('20_face.py: no rt/lowstate within 10 s: ./twinbus up stand --robot my_g1 --face unitree_hg')
    found = [state.motor_state[motor].q for motor in range(MOTORS)]
    command, crc = unitree_hg_msg_dds__LowCmd_(), CRC()
    command.mode_machine = state.mode_machine
    bent, begin = 0.0, time.monotonic()
    while (t := time.monotonic() - begin) < arguments.duration:
        for motor in range(MOTORS):
            one = command.motor_cmd[motor]
            one.mode, one.q, one.dq, one.tau = 1, found[motor], 0.0, 0.0
            one.kp, one.kd = (300.0, 6.0) if motor < LEGS_AND_WAIST else (60.0, 2.0)
        command.motor_cmd[ELBOW].q += 0.15 * (1.0 - math.cos(2.0 * math.pi * t / arguments.duration))
        command.crc = crc.Crc(command)
        commands.Write(command)
        newest = states.Read(0.01)
        if newest is not None:
            state = newest
        bent = max(bent, state.motor_state[ELBOW].q - found[ELBOW])
        time.sleep(PERIOD)
    print(f'the elbow bent by {bent:.2f} rad and is {state.motor_state[ELBOW].q - found[ELBOW]:+.2f} rad from where it was')


if __name__ == '__main__':
    main()
