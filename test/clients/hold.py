#!/usr/bin/env python3
"""A whole controller: holds the posture it finds, with the torque that held it.

Knows STATE and COMMAND and nothing else, so it never notices whether a simulator or a robot is behind them, nor when
one takes the place of the other.
"""
import argparse
import time

import twinbus

# Gains of hrp1s: first joint, last joint, kp [N m/rad], kd [N m s/rad].  For another robot: --gains.
HRP1S = '0-5:15000:300,6-9:3000:60,10-12:600:6,13-18:15000:300,19-22:3000:60,23-25:600:6,26-28:15000:300'


def parse_gains(text):
    kp, kd = [0.0] * twinbus.JOINTS, [0.0] * twinbus.JOINTS
    for entry in text.split(','):
        joints, stiffness, damping = entry.split(':')
        first, _, last = joints.partition('-')
        for joint in range(int(first), int(last or first) + 1):
            kp[joint], kd[joint] = float(stiffness), float(damping)
    return kp, kd


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--gains', type=parse_gains, default=parse_gains(HRP1S),
                        help='FIRST-LAST:KP:KD,... by joint index (default: hrp1s)')
    parser.add_argument('--for', dest='duration', type=float, default=float('inf'), help='seconds to run')
    parser.add_argument('--url', help='LCM network (default: $LCM_DEFAULT_URL)')
    parser.add_argument('--prefix', default='', help='before every channel name')
    arguments = parser.parse_args()
    kp, kd = arguments.gains

    bus = twinbus.Bus(arguments.url, arguments.prefix)
    bus.listen('STATE')
    me = twinbus.new_id()
    posture = torque = None
    answered = 0
    end = time.monotonic() + arguments.duration
    print('hold.py: ready', flush=True)
    while time.monotonic() < end:
        state = twinbus.newest_state(bus.receive(0.1))
        if state is None:
            continue
        if posture is None:
            posture, torque = state.q, state.tau
            print(f'hold.py: holding {state.joint_count} joints', flush=True)
        bus.send('COMMAND', twinbus.command_for(state, me, posture, tau=torque, kp=kp, kd=kd))
        answered += 1
    print(f'hold.py: {answered} states answered')


if __name__ == '__main__':
    try:
        main()
    except KeyboardInterrupt:
        pass
    except (OSError, ValueError) as error:
        raise SystemExit(f'hold.py: {error}')
