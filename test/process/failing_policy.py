#!/usr/bin/env python3
"""A policy that fails after so many actions: its inference takes 30 ms, or never ends, gives NaN, throws, or the program dies (SIGKILL).

    failing_policy.py MODEL.onnx --fault late|hang|nan|throw|die --after ACTIONS [--spec FILE] [--vx V]

Prints "ready" when it listens, and "failing" when it does."""
import argparse
import os
import pathlib
import signal
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'python'))
import numpy  # noqa: E402
import twinbus  # noqa: E402
from twinbus.policy.command_line import go_ahead  # noqa: E402
from twinbus.policy.controller import Controller  # noqa: E402
from twinbus.policy.find import find  # noqa: E402
from twinbus.policy.network import Network  # noqa: E402
from twinbus.policy.runner import Options, Runner, Stopped  # noqa: E402


class Failing:
    """A network whose answers go wrong."""

    def __init__(self, network, fault, after):
        self._network, self._fault, self._left = network, fault, after
        self.observation_size, self.action_size = network.observation_size, network.action_size

    def reset(self):
        self._network.reset()

    def run(self, observation):
        action = self._network.run(observation)
        self._left -= 1
        if self._left > 0:
            return action
        if self._left == 0:
            print('failing', flush=True)
        if self._fault == 'die':
            os.kill(os.getpid(), signal.SIGKILL)
        if self._fault == 'throw':
            raise twinbus.policy.errors.PolicyError('the inference failed: out of memory')
        if self._fault in ('late', 'hang'):
            time.sleep(0.03 if self._fault == 'late' else 60.0)
        return numpy.full_like(action, numpy.nan) if self._fault == 'nan' else action


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('model', type=pathlib.Path)
    parser.add_argument('--fault', choices=('late', 'hang', 'nan', 'throw', 'die', 'none'), required=True)
    parser.add_argument('--after', type=int, required=True)
    parser.add_argument('--spec', default='')
    parser.add_argument('--vx', type=float, default=0.0)
    arguments = parser.parse_args()
    network = Network(arguments.model)
    failing = Failing(network, arguments.fault, arguments.after)
    with twinbus.Bus() as bus:
        runner = Runner(bus, lambda robot: Controller(find(network, robot, arguments.spec), robot, failing),
                        Options(command=(arguments.vx, 0.0, 0.0), fifo=go_ahead()))
        print('ready', flush=True)
        try:
            runner.run()
        except Stopped as reason:
            sys.exit(f'policy: stopped the robot: {reason}')


if __name__ == '__main__':
    main()
