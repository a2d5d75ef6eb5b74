#!/usr/bin/env python3
"""A learned policy on the bus: it holds hrp1s, obeys walk and a stop, begins anew after clear; NaN, a late inference and its death stop
the robot with the true reason.  The networks are made here (test/python/tiny_onnx.py).

Needs numpy, PyYAML and onnxruntime: $TWINBUS_POLICY_PYTHON names a Python that has them, else python3."""
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import harness
from harness import BIN, ROOT, Bus, Checks, Stack, bus_joints, cli, text_of

sys.path.insert(0, str(ROOT / 'test/python'))
import tiny_onnx  # noqa: E402

PYTHON = os.environ.get('TWINBUS_POLICY_PYTHON', 'python3')
JOINTS = 29
BY_CONTROLLER, COMMAND_TIMEOUT = 6, 7  # stop_t.reason


def specification():
    """hrp1s stands in half_sitting: an action of zero."""
    import xml.etree.ElementTree as xml
    folder = ROOT / 'config/robots/hrp1s'
    pose = next(state for state in xml.parse(folder / 'hrp1s.srdf').iter('group_state') if state.get('name') == 'half_sitting')
    angles = {joint.get('name'): float(joint.get('value').split()[0]) for joint in pose.iter('joint')}
    rows = []
    for joint in bus_joints('hrp1s'):
        name = joint.get('name')
        kp, kd = (600, 6) if 'WRIST' in name else (3000, 60) if 'ARM' in name else (15000, 300)
        rows.append(f'  - {{name: {name}, default: {angles.get(name, 0.0)}, scale: 0.01, kp: {kp}, kd: {kd}}}')
    return '\n'.join(['spec: 1', 'name: stand', 'period: 0.02', 'joints:', *rows, 'observations:', '  - {term: base_angular_velocity}',
                      '  - {term: projected_gravity}', '  - {term: velocity_command}', '  - {term: joint_position}', ''])


class Policy:
    """./twinbus policy with what it says."""

    def __init__(self, model, *words):
        self.process = subprocess.Popen([str(BIN / 'twinbus'), 'policy', str(model), *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        text=True, env=dict(os.environ, TWINBUS_POLICY_PYTHON=PYTHON))
        line = self.process.stdout.readline()
        if 'ready' not in line:
            raise RuntimeError('policy does not start: ' + line + self.process.communicate(timeout=20)[0])

    def end(self):
        if self.process.poll() is None:
            self.process.terminate()
        return self.process.communicate(timeout=20)[0]


def stands(folder, checks):
    policy = Policy(tiny_onnx.linear(folder / 'stand.onnx', 9 + JOINTS, JOINTS))
    try:
        with Stack('stand_python', '--stack', 'client', '--no-viewer', '--no-record'):
            bus = Bus()
            checks.that(bus.wait_for('CONTROLLER_STATUS', lambda s: s.mode == 5, timeout=20)[1] is not None, 'stands: mode walk is told')
            status, out, err = cli('walk', '0.1', '0', '0', '--for', '1')
            checks.that(status == 0, f'stands: walk is obeyed: {out}{err}')
            status, out, err = cli('stop', 'balanced')
            checks.that(status == 0, f'stands: stop balanced: {out}{err}')
            flagged = [c for _, c in bus.messages('COMMAND') if c.flags & 1]
            checks.that(len(flagged) > 5, f'stands: {len(flagged)} commands said "stopping"')
            # it falls silent at last, so the source holds; until then it is balanced
            held = bus.wait_for('STATE', lambda s: s.stop_kind == 2, timeout=10, start=0)[1]
            checks.that(held is not None, 'stands: a balanced stop ends in hold')
            status, out, err = cli('clear')
            checks.that(status == 0, f'stands: clear: {out}{err}')
            now = time.monotonic_ns()
            time.sleep(1.0)
            commands = sum(1 for _ in bus.messages('COMMAND', now))
            states = [s for _, s in bus.messages('STATE', now)]
            checks.at_least(commands / max(1, len(states)), 0.5, 'stands: commands per state after clear')
            checks.that(bool(states) and states[-1].stop_kind == 0, 'stands: not stopped after clear')
            bus.close()
    finally:
        said = policy.end()
    checks.that('29 of 29 joints of' in said, 'stands: what it is bound to is said: ' + said[:300])


def stops(folder, name, model, said, reason, checks, kill=False):
    policy = Policy(model)
    try:
        with Stack('stand_python', '--stack', 'client', '--no-viewer', '--no-record'):
            bus = Bus()
            if kill:
                bus.wait_for('CONTROLLER_STATUS', timeout=20)
                policy.process.kill()
            state = bus.wait_for('STATE', lambda s: s.stop_kind >= 2, timeout=20, start=0)[1]
            checks.that(state is not None, f'{name}: the robot is stopped')
            status = bus.wait_for('SOURCE_STATUS', lambda s: s.stop_kind >= 2, timeout=5, start=0)[1]
            checks.that(status is not None and status.stop_reason == reason, f'{name}: reason {status and status.stop_reason}, {reason} asked')
            time.sleep(1.0)
            states = [s for _, s in bus.messages('STATE')][-1:]
            w, x, y, z = states[0].attitude
            checks.at_most(math.degrees(math.acos(max(-1.0, 1.0 - 2.0 * (x * x + y * y)))), 5.0, f'{name}: tilt afterwards [degrees]')
            told = [text_of(e) for _, e in bus.messages('EVENT')]
            checks.that(kill or any(said in line for line in told), f'{name}: EVENT says why: {told}')
            bus.close()
    finally:
        output = policy.end()
    if not kill:
        checks.that(said in output and policy.process.returncode == 1, f'{name}: it says why and exits with 1: {output}')


def example(folder, checks):
    """examples/16_policy.py: the same in a program of one's own."""
    process = subprocess.Popen([PYTHON, str(ROOT / 'examples/16_policy.py'), str(folder / 'stand.onnx'), '--for', '1'], stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, text=True)
    try:
        process.stdout.readline()  # "ready"
        with Stack('stand_python', '--stack', 'client', '--no-viewer', '--no-record'):
            said = process.communicate(timeout=30)[0]
        checks.that(process.returncode == 0 and 'actions in 1.0 s' in said, f'example: {process.returncode}, {said}')
    finally:
        process.kill()


def main():
    harness.require('twinbus', 'twinbus_simulator')
    there = subprocess.run([PYTHON, '-c', 'import numpy, yaml, onnxruntime'], capture_output=True, text=True)
    if there.returncode != 0:
        line = subprocess.run([str(BIN / 'twinbus'), 'policy', 'none.onnx'], capture_output=True, text=True,
                              env=dict(os.environ, TWINBUS_POLICY_PYTHON=PYTHON)).stderr
        assert 'pip install onnxruntime' in line, line
        print('skipped: ' + there.stderr.strip().splitlines()[-1] + '; set TWINBUS_POLICY_PYTHON to a Python that has numpy, pyyaml, onnxruntime')
        sys.exit(harness.SKIPPED)
    checks = Checks()
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work)
        (folder / 'SPEC.yaml').write_text(specification())
        stands(folder, checks)
        example(folder, checks)
        reads = 9 + JOINTS
        stops(folder, 'nan', tiny_onnx.linear(folder / 'nan.onnx', reads, JOINTS, math.nan), 'is not a finite number', BY_CONTROLLER, checks)
        stops(folder, 'late', tiny_onnx.linear(folder / 'late.onnx', reads, JOINTS, slow=200), 'a new action every 20 ms', BY_CONTROLLER, checks)
        stops(folder, 'dead', folder / 'stand.onnx', '', COMMAND_TIMEOUT, checks, kill=True)
    checks.exit()


if __name__ == '__main__':
    main()
