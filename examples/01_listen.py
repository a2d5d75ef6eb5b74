#!/usr/bin/env python3
"""01 Listen: prints time, load of the feet and a joint of whatever robot is active, ten times a second.

    ./twinbus up               (in another terminal)
    python3 examples/01_listen.py
"""
import argparse
import math
import time

import twinbus

SOURCES = {1: 'simulator', 2: 'bridge', 3: 'replay'}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--for', dest='duration', type=float, default=math.inf, help='seconds to run')
    arguments = parser.parse_args()
    bus = twinbus.Bus()
    bus.listen('STATE')
    end = time.monotonic() + arguments.duration
    while time.monotonic() < end:
        # All that came since the last time; the newest counts.
        state = twinbus.newest_state(bus.receive(1.0))
        if state is None:
            print('no robot is heard', flush=True)
            continue
        load = sum(state.wrench[foot][2] for foot in (0, 1))  # of both soles [N]
        print(f'{1e-9 * state.time_ns:8.3f} s  {SOURCES[state.source]}, tick {state.tick}, term {state.term}, '
              f'{state.joint_count} joints, q[3] {state.q[3]:+.4f} rad, feet {load:.0f} N', flush=True)
        time.sleep(0.1)


if __name__ == '__main__':
    twinbus.run(main)
