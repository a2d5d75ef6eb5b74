#!/usr/bin/env python3
"""09 Add a channel: publishes the mechanical power of the joints, 50 times a second, as a type of its own on a channel of its own.

Nothing in twinbus changes for that: a recorder takes whatever is on the bus, so POWER is in every log; lcm-spy and lcm-logplayer
know it like any other. The type is power_t.lcm, beside this file.

    ./twinbus up               (in another terminal)
    python3 examples/09_add_channel.py
"""
import argparse
import math
import pathlib
import time
from typing import Any

import twinbus

PERIOD = 0.02  # [s]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--for', dest='duration', type=float, default=math.inf, help='seconds to run')
    arguments = parser.parse_args()
    power_t: Any = twinbus.message_type(pathlib.Path(__file__).with_name('power_t.lcm').read_text())
    bus = twinbus.Bus()
    bus.listen('STATE')
    print('add_channel: ready', flush=True)
    end = time.monotonic() + arguments.duration
    while time.monotonic() < end:
        state = twinbus.newest_state(bus.receive(0.1))
        if state is None:
            continue
        powers = [state.tau[k] * state.qd[k] for k in range(state.joint_count)]
        message = power_t()
        message.tick, message.mechanical = state.tick, sum(powers)
        message.joint = max(range(len(powers)), key=lambda k: abs(powers[k]))
        message.largest = powers[message.joint]
        bus.send('POWER', message)
        time.sleep(PERIOD)


if __name__ == '__main__':
    twinbus.run(main)
