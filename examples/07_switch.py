#!/usr/bin/env python3
"""07 Switch: lets another source take over the robot, live; the controller is not told and misses no tick.

    ./twinbus up --stack both  (in another terminal)
    python3 examples/07_switch.py bridge
    python3 examples/07_switch.py sim
"""
import argparse

import twinbus

SOURCES = {'sim': 1, 'bridge': 2, 'replay': 3}
SWITCH, TRACK, SHADOW, NOW, WHEN_SAFE = 2, 3, 4, 1, 2
STANDBY = (4, 5)  # roles


def ask(bus: twinbus.Bus, action: int, target: twinbus.source_status_t, meant_for: twinbus.robot_state_t | twinbus.source_status_t) -> None:
    request = twinbus.source_request_t()
    request.action, request.policy, request.target_run_id = action, WHEN_SAFE, target.run_id
    bus.ask('SOURCE_REQUEST', request, meant_for)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('to', choices=SOURCES)
    arguments = parser.parse_args()
    bus = twinbus.Bus()
    bus.listen('STATE', 'SOURCE_STATUS')
    active = bus.wait('STATE')
    if active.source == SOURCES[arguments.to]:
        raise ValueError(f'{arguments.to} is active already')
    target = bus.wait('SOURCE_STATUS', lambda s: s.source == SOURCES[arguments.to])
    # First it follows: a simulator is set to the state of the robot, hardware copies the commands.
    ask(bus, TRACK if target.can_be_set else SHADOW, target, target)
    bus.wait('SOURCE_STATUS', lambda s: s.run_id == target.run_id and s.role in STANDBY)
    for _ in range(40):
        ask(bus, SWITCH, target, active)
        try:
            state = bus.wait('STATE', lambda s: s.run_id == target.run_id, 0.5)
            print(f'{arguments.to} is active: tick {state.tick}, term {state.term}')
            return
        except TimeoutError:
            continue
    raise TimeoutError('refused, or no answer: ./twinbus switch says why')


if __name__ == '__main__':
    twinbus.run(main)
