#!/usr/bin/env python3
"""05 Reach: asks the planner to bring a hand to a point; it plans around body and obstacles, and the controller follows the path.

    ./twinbus up               (in another terminal)
    python3 examples/05_reach.py left 0.35 0.25 0.75
    python3 examples/05_reach.py north 0.1 0.6 0.7 --robot FOLDER     (of a robot whose arms have other names; needs pip install ./python)
"""
import argparse

import twinbus


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('hand', help='left, right, or the name of an arm in robot.yaml')
    parser.add_argument('position', nargs=3, type=float, metavar='X',
                        help='X Y Z of the hand [m]; origin midway between the soles, x forward, z up')
    parser.add_argument('--robot', default='', help='its folder, or its name in config/robots')
    arguments = parser.parse_args()
    robot = twinbus.Robot(arguments.robot).info if arguments.robot else None
    twinbus.Arm(twinbus.Bus(), arguments.hand, robot).reach(arguments.position)
    print('the hand is there')


if __name__ == '__main__':
    twinbus.run(main)
