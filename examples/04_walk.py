#!/usr/bin/env python3
"""04 Walk: asks for mode walk, then for a velocity, again and again while it is wanted; a controller that hears no more stops the walk.

    ./twinbus up               (in another terminal)
    python3 examples/04_walk.py 0.2 0 0 --for 4
"""
import argparse
import time
from typing import Any

import twinbus

WALK, BALANCE = 5, 4


def enter(bus: twinbus.Bus, mode: int) -> Any:
    request = twinbus.mode_request_t()
    request.mode = mode
    for _ in range(5):
        bus.ask('MODE_REQUEST', request, bus.wait('STATE'))
        try:
            return bus.wait('CONTROLLER_STATUS', lambda status: status.mode == mode, 3.0)
        except TimeoutError:
            continue
    raise TimeoutError(f'the controller does not enter mode {mode}: see EVENT (./twinbus status)')


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('velocity', nargs=3, type=float, metavar='V', help='VX VY WZ: forward, left [m/s], turn left [rad/s]')
    parser.add_argument('--for', dest='duration', type=float, default=4.0, help='seconds to walk')
    arguments = parser.parse_args()
    bus = twinbus.Bus()
    bus.listen('STATE', 'CONTROLLER_STATUS')
    start = enter(bus, WALK).base_position
    command = twinbus.walk_command_t()
    command.vx, command.vy, command.wz = arguments.velocity
    command.timeout = 0.3  # [s] for which it counts when no other comes
    end = time.monotonic() + arguments.duration
    while time.monotonic() < end:
        bus.ask('WALK', command, bus.wait('STATE'))  # the newest run_id: the source may have changed
        time.sleep(0.05)
        bus.receive(0)
    enter(bus, BALANCE)  # it takes the last step first
    last = bus.wait('CONTROLLER_STATUS').base_position
    print(f'walked {last[0] - start[0]:+.2f} m along x, {last[1] - start[1]:+.2f} m along y')


if __name__ == '__main__':
    twinbus.run(main)
