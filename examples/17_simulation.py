#!/usr/bin/env python3
"""17 Simulation: the robot in this process, no bus: numpy commands the joints, and the robot bows and comes up again.

    pip install ./python       (or, with the compiled part built in this tree, nothing)
    python3 examples/17_simulation.py
"""
import argparse
import time

import numpy as np

import twinbus

BOW = {'RLEG_HIP_P': -0.15, 'LLEG_HIP_P': -0.15, 'RLEG_KNEE': 0.3, 'LLEG_KNEE': 0.3, 'RLEG_ANKLE_P': -0.15, 'LLEG_ANKLE_P': -0.15}  # [rad]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('--for', dest='duration', type=float, default=10.0, help='simulated seconds')
    parser.add_argument('--scene', default='stand')
    arguments = parser.parse_args()
    simulation = twinbus.Simulation(arguments.scene, control=None)
    state, command, robot = simulation.state, simulation.command, simulation.robot
    posture, bow = np.array(state.q), np.zeros(len(robot.joints))
    for name, angle in BOW.items():
        bow[robot.joints.index(name)] = angle
    heights, begin = [], time.monotonic()
    while simulation.time < arguments.duration and not simulation.truth.fell:
        phase = np.pi * simulation.time
        command.q[:] = posture + bow * 0.5 * (1.0 - np.cos(phase))
        command.qd[:] = bow * 0.5 * np.pi * np.sin(phase)
        simulation.step()
        heights.append(float(simulation.truth.com[2]))
    took = time.monotonic() - begin
    print(f'centre of mass {1e3 * (max(heights) - min(heights)):.0f} mm up and down, joints at most '
          f'{1e3 * np.abs(command.q - state.q).max():.1f} mrad from their command')
    print(f'{robot.name}: {simulation.time:.1f} seconds {"to a fall" if simulation.truth.fell else "without a fall"}, '
          f'{simulation.time / took:.1f} times real time')


if __name__ == '__main__':
    twinbus.run(main)
