#!/usr/bin/env python3
"""06 Stop and clear: stops the robot (hold), waits until STATE says so, and lets it go on.

A stop works with the controller dead, anybody may ask for it, and it stays until somebody echoes its nonce. It is software: it
complements the emergency stop of a robot and never replaces it.

    ./twinbus up               (in another terminal)
    python3 examples/06_stop_and_clear.py
"""
import argparse
import time

import twinbus

CLEAR, BALANCED, HOLD, OFF = 0, 1, 2, 3


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--for', dest='duration', type=float, default=1.0, help='seconds to stay stopped')
    arguments = parser.parse_args()
    bus = twinbus.Bus()
    bus.listen('STATE')
    state = bus.wait('STATE')
    stop = twinbus.stop_t()
    stop.kind, stop.reason = HOLD, 1
    for _ in range(3):  # any datagram may be lost; a stop said twice is stopped once
        bus.ask('STOP', stop, state)
    stopped = bus.wait('STATE', lambda state: state.stop_kind >= HOLD)
    print(f'stopped at tick {stopped.tick}, nonce {stopped.stop_nonce}', flush=True)
    time.sleep(arguments.duration)
    bus.receive(0)
    for _ in range(20):
        clear = twinbus.stop_t()
        clear.kind, clear.stop_nonce = CLEAR, bus.wait('STATE').stop_nonce  # the one in force now
        bus.ask('STOP', clear, state)
        try:
            goes_on = bus.wait('STATE', lambda state: state.stop_kind == 0, 0.2)
            print(f'goes on at tick {goes_on.tick}')
            return
        except TimeoutError:
            continue
    raise TimeoutError('it stays stopped: whatever stopped it still asks for it (./twinbus status)')


if __name__ == '__main__':
    twinbus.run(main)
