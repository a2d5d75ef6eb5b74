#!/usr/bin/env python3
"""03 Squat: asks the controller to balance and to move the body up and down (or from side to side: --sway), then to stand.

    ./twinbus up               (in another terminal)
    python3 examples/03_squat.py
"""
import argparse
import time
from typing import Any

import twinbus

BALANCE, NONE, SWAY, SQUAT = 4, 0, 1, 2  # mode and motions of mode_request_t


def ask(bus: twinbus.Bus, state: twinbus.robot_state_t, motion: int) -> Any:
    """Asks until the controller says that this request is in force: any datagram may be lost."""
    request = twinbus.mode_request_t()
    request.mode, request.motion, request.amplitude, request.frequency = BALANCE, motion, 0.03, 0.25  # [m, Hz]
    for _ in range(20):
        bus.ask('MODE_REQUEST', request, state)
        try:
            return bus.wait('CONTROLLER_STATUS', lambda status: status.mode_sequence == request.sequence, 0.25)
        except TimeoutError:
            continue
    raise TimeoutError('the controller does not answer (./twinbus status)')


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--sway', action='store_true', help='from side to side instead')
    parser.add_argument('--for', dest='duration', type=float, default=8.0, help='seconds to move')
    arguments = parser.parse_args()
    bus = twinbus.Bus()
    bus.listen('STATE', 'CONTROLLER_STATUS')
    state = bus.wait('STATE')
    ask(bus, state, SWAY if arguments.sway else SQUAT)
    heights, sides, end = [], [], time.monotonic() + arguments.duration
    while time.monotonic() < end:
        status = bus.wait('CONTROLLER_STATUS')
        heights.append(status.com[2])
        sides.append(status.com[1])
    print(f'the centre of mass moved {1e3 * (max(heights) - min(heights)):.0f} mm up and down, '
          f'{1e3 * (max(sides) - min(sides)):.0f} mm from side to side')
    ask(bus, bus.wait('STATE'), NONE)


if __name__ == '__main__':
    twinbus.run(main)
