#!/usr/bin/env python3
"""A logger plug-in: adds a quantity of one's own to every log, here the mechanical power of the joints, 50 times a second.

A recorder takes whatever is on the bus, so a plug-in is a program that listens, computes and publishes a type of its own
(power_t.lcm) on a channel of its own (POWER).  lcm-spy and lcm-logplayer know it like any other.
"""
import argparse
import os
import subprocess
import sys
import tempfile
import time

import twinbus

PERIOD = 0.02  # [s]


def own_type():
    """The Python class of power_t, made by lcm-gen."""
    folder = tempfile.mkdtemp(prefix='log_power')
    source = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'power_t.lcm')
    subprocess.run(['lcm-gen', '-p', '--ppath', folder, source], check=True, stdout=subprocess.DEVNULL)
    sys.path.insert(0, folder)
    import example
    return example.power_t


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--for', dest='duration', type=float, default=float('inf'), help='seconds to run')
    parser.add_argument('--url', help='LCM network (default: $LCM_DEFAULT_URL)')
    parser.add_argument('--prefix', default='', help='before every channel name')
    arguments = parser.parse_args()
    power_t = own_type()
    bus = twinbus.Bus(arguments.url, arguments.prefix)
    bus.listen('STATE')
    print('log_power.py: ready', flush=True)
    end = time.monotonic() + arguments.duration
    while time.monotonic() < end:
        state = twinbus.newest_state(bus.receive(0.1))
        if state is None:
            continue
        powers = [state.tau[k] * state.qd[k] for k in range(state.joint_count)]
        message = power_t()
        message.tick = state.tick
        message.mechanical = sum(powers)
        message.joint = max(range(len(powers)), key=lambda k: abs(powers[k]))
        message.largest = powers[message.joint]
        bus.send('POWER', message)
        time.sleep(PERIOD)


if __name__ == '__main__':
    try:
        main()
    except KeyboardInterrupt:
        pass
    except (OSError, ValueError, subprocess.CalledProcessError) as error:
        raise SystemExit(f'log_power.py: {error}')
