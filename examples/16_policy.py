#!/usr/bin/env python3
"""16 A policy: a learned controller (ONNX) inside a program of your own, with what it was trained on read from beside it.

./twinbus policy MODEL.onnx is the same with every option; here its parts are one by one. Needs numpy, PyYAML and onnxruntime.
Start it first, then: ./twinbus up stand_python --stack client
"""
import argparse
import pathlib

import twinbus
from twinbus.policy.controller import Controller
from twinbus.policy.find import find
from twinbus.policy.network import Network
from twinbus.policy.robot import Robot
from twinbus.policy.runner import Options, Runner, Stopped


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('model', type=pathlib.Path, help='ONNX file')
    parser.add_argument('--spec', default='', help='SPEC.yaml, deploy.yaml or env.yaml; default: what lies beside the model, or its metadata')
    parser.add_argument('--vx', type=float, default=0.0, help='[m/s], while nobody walks it by WALK or GAMEPAD')
    parser.add_argument('--for', dest='duration', type=float, default=float('inf'), help="seconds of the robot's time")
    arguments = parser.parse_args()
    network = Network(arguments.model)

    def bind(robot: Robot) -> Controller:  # called once, in a thread, when the source has told of its robot
        spec = find(network, robot, arguments.spec)
        print(f'policy: {spec.source} moves {len(spec.joints)} of {len(robot.names())} joints, first {spec.names()[0]}', flush=True)
        return Controller(spec, robot, network)

    with twinbus.Bus() as bus:
        runner = Runner(bus, bind, Options(command=(arguments.vx, 0.0, 0.0), duration=arguments.duration))
        print('policy: ready', flush=True)
        try:
            runner.run()
        except Stopped as reason:
            raise ValueError(f'the policy stopped the robot: {reason}') from None
    print(f'policy: {runner.actions} actions in {runner.elapsed:.1f} s')


if __name__ == '__main__':
    twinbus.run(main)
