#!/usr/bin/env python3
"""05 Reach: asks the planner to bring a hand to a point; it plans around body and obstacles, and the controller follows the path.

    ./twinbus up               (in another terminal)
    python3 examples/05_reach.py left 0.35 0.25 0.75
"""
import argparse

import twinbus

POSITION, DONE, STOPPED = 2, 2, 3
STATUS = {1: 'unreachable', 2: 'the start is in collision', 3: 'the goal is in collision', 4: 'no way found in time', 6: 'bad goal'}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('hand', choices=['left', 'right'])
    parser.add_argument('position', nargs=3, type=float, metavar='X',
                        help='X Y Z of the hand [m]; origin midway between the soles, x forward, z up')
    arguments = parser.parse_args()
    bus = twinbus.Bus()
    bus.listen('STATE', 'ARM_PATH', 'CONTROLLER_STATUS')
    goal = twinbus.arm_goal_t()
    goal.goal_id = twinbus.new_id()  # the path that answers it names it
    goal.side = 1 if arguments.hand == 'left' else 2
    goal.kind, goal.position[:], goal.speed = POSITION, arguments.position, 0.4
    goal.orientation[:] = [1.0, 0.0, 0.0, 0.0]
    path = None
    for _ in range(20):  # any datagram may be lost; the same goal_id is planned once
        bus.ask('ARM_GOAL', goal, bus.wait('STATE'))
        try:
            path = bus.wait('ARM_PATH', lambda piece: piece.goal_id == goal.goal_id, 0.5)
            break
        except TimeoutError:
            continue
    if path is None:
        raise TimeoutError('no planner answers (./twinbus status)')
    if path.status != 0:
        raise ValueError(f'no path: {STATUS.get(path.status, path.status)}; missed by {path.miss:.3f} m')
    bus.wait('CONTROLLER_STATUS', lambda status: status.arm_path_id == path.path_id)
    end = bus.wait('CONTROLLER_STATUS', lambda status: status.arm_state in (DONE, STOPPED), 30.0)
    print('the hand is there' if end.arm_state == DONE else 'the guard stopped the arm')


if __name__ == '__main__':
    twinbus.run(main)
