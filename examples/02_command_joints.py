#!/usr/bin/env python3
"""02 Command joints: a whole controller. It holds the posture it finds; --joint K --by RAD moves one joint by so much and back.

It knows STATE and COMMAND and nothing else, so it does not notice whether a simulator or a robot is behind them, nor when one takes
the place of the other. Start it first, then: ./twinbus up stand_python --stack client
"""
import argparse
import math
import time

import twinbus

# Gains of hrp1s: first joint, last joint, kp [N m/rad], kd [N m s/rad].
GAINS = [(0, 5, 15000, 300), (6, 9, 3000, 60), (10, 12, 600, 6), (13, 18, 15000, 300), (19, 22, 3000, 60),
         (23, 25, 600, 6), (26, 28, 15000, 300)]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--joint', type=int, help='joint index, in the order of the URDF')
    parser.add_argument('--by', type=float, default=0.2, help='[rad], with --joint')
    parser.add_argument('--for', dest='duration', type=float, default=math.inf, help='seconds to run')
    arguments = parser.parse_args()
    kp, kd = [0.0] * twinbus.JOINTS, [0.0] * twinbus.JOINTS
    for first, last, stiffness, damping in GAINS:
        for joint in range(first, last + 1):
            kp[joint], kd[joint] = stiffness, damping

    bus, me, stopped = twinbus.Bus(), twinbus.new_id(), 0
    bus.listen('STATE', 'SOURCE_STATUS')
    obedience = twinbus.Obedience(me)
    found = None
    end = time.monotonic() + arguments.duration
    print('command_joints: ready', flush=True)
    while time.monotonic() < end:
        messages = bus.receive(0.1)
        if problem := obedience.problem(messages):
            print(f'command_joints: {problem}', flush=True)
        state = twinbus.newest_state(messages)
        if state is None:
            continue
        if found is None:
            found, q, stopped = state, list(state.q), state.time_ns
            print(f'command_joints: holding {state.joint_count} joints', flush=True)
        if state.stop_kind != 1:
            q, stopped = list(found.q), state.time_ns
            if arguments.joint is not None:  # up and down every 4 s, by the robot's own time
                t = 1e-9 * (state.time_ns - found.time_ns)
                q[arguments.joint] += arguments.by * 0.5 * (1.0 - math.cos(0.5 * math.pi * t))
        command = twinbus.command_for(state, me, q, tau=found.tau, kp=kp, kd=kd)
        command.flags = int(0 < state.time_ns - stopped < 5e8)  # a balanced stop: it rests by itself, then is held
        bus.send('COMMAND', command)


if __name__ == '__main__':
    twinbus.run(main)
