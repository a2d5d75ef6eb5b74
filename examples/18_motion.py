#!/usr/bin/env python3
"""18 A motion: a wave of the right arm with a bend of the knees, written as a file, checked, and played by the standing robot.

    ./twinbus up                      # in another terminal
    python3 examples/18_motion.py

`./twinbus motion FILE` names what is wrong with a motion (tick, joint, value, limit); with --play a robot that walks stops first,
plays, and stands as before. Recorded and retargeted motions (CSV, NPZ) are played the same way: doc/motion.md.
"""
import argparse
import csv
import math
import subprocess
import tempfile

RATE = 50  # frames a second
STAND = {'RARM_SHOULDER_P': 0.3113, 'RARM_SHOULDER_R': -0.1595, 'RARM_ELBOW': -0.6363,
         'LLEG_HIP_P': -0.571, 'LLEG_KNEE': 1.2644, 'LLEG_ANKLE_P': -0.6925,
         'RLEG_HIP_P': -0.571, 'RLEG_KNEE': 1.2644, 'RLEG_ANKLE_P': -0.6925}  # half_sitting of hrp1s [rad]


def ease(x: float) -> float:
    """0 to 1 without a corner."""
    x = min(1.0, max(0.0, x))
    return x * x * (3.0 - 2.0 * x)


def posture(time: float, seconds: float) -> dict[str, float]:
    """Angles of the joints at a time [rad]."""
    raised = ease(time / 1.5) * ease((seconds - time) / 1.5)
    bend = 0.3 * raised
    q = dict(STAND)
    q['RARM_SHOULDER_R'] -= 1.2 * raised
    q['RARM_ELBOW'] -= raised * (0.9 + 0.4 * math.sin(2.0 * math.pi * time))
    for side in 'LR':  # the soles stay flat, the trunk over them
        q[f'{side}LEG_HIP_P'] -= 0.46 * bend
        q[f'{side}LEG_KNEE'] += bend
        q[f'{side}LEG_ANKLE_P'] -= 0.54 * bend
    return q


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--for', dest='seconds', type=float, default=6.0, help='seconds')
    parser.add_argument('--twinbus', default='./twinbus', help='the program')
    parser.add_argument('--check', action='store_true', help='only check it')
    arguments = parser.parse_args()
    with tempfile.NamedTemporaryFile('w', suffix='.csv', newline='') as file:
        table = csv.writer(file)
        table.writerow(['time', *STAND])
        for frame in range(int(arguments.seconds * RATE) + 1):
            time = frame / RATE
            table.writerow([time, *posture(time, arguments.seconds).values()])
        file.flush()
        raise SystemExit(subprocess.call([arguments.twinbus, 'motion', file.name, '--check' if arguments.check else '--play']))


if __name__ == '__main__':
    main()
