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
BY_CONTROLLER, COMMAND_TIMEOUT, FALLEN = 6, 7, 10  # stop_t.reason


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
        self.before = []  # with --robot it says first what it is bound to
        while 'ready' not in (line := self.process.stdout.readline()):
            self.before.append(line)
            if not line:
                raise RuntimeError('policy does not start: ' + ''.join(self.before) + self.process.communicate(timeout=20)[0])

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


def ends_in_order(folder, checks):
    """SIGTERM is a balanced stop, then the end; with the robot named beforehand, too."""
    policy = Policy(folder / 'stand.onnx', '--robot', 'hrp1s')
    with Stack('stand_python', '--stack', 'client', '--no-viewer', '--no-record'):
        bus = Bus()
        checks.that(bus.wait_for('COMMAND', timeout=20)[1] is not None, 'SIGTERM: it commands')
        begin = time.monotonic()
        policy.process.terminate()
        stopping = bus.wait_for('COMMAND', lambda c: c.flags & 1, timeout=5, start=0)[1]
        checks.that(stopping is not None, 'SIGTERM: it says that it is stopping')
        held = bus.wait_for('STATE', lambda s: s.stop_kind == 2, timeout=10, start=0)[1]
        checks.that(held is not None, 'SIGTERM: the robot is held')
        said = policy.process.communicate(timeout=20)[0]
        checks.at_most(time.monotonic() - begin, 8.0, f'SIGTERM: it has ended [s]: {said}')
        checks.that(policy.process.returncode == 0, f'SIGTERM: exit status {policy.process.returncode}: {said}')
        bus.close()


def stops(folder, name, model, said, reason, checks, kill=False):
    policy = Policy(model)
    bus = Bus()  # before the stack: it may be stopped before that is said to run
    try:
        with Stack('stand_python', '--stack', 'client', '--no-viewer', '--no-record'):
            if kill:
                bus.wait_for('CONTROLLER_STATUS', timeout=20)
                policy.process.kill()
            state = bus.wait_for('STATE', lambda s: s.stop_kind >= 2, timeout=20, start=0)[1]
            checks.that(state is not None, f'{name}: the robot is stopped')
            status = bus.wait_for('SOURCE_STATUS', lambda s: s.stop_kind >= 2, timeout=5, start=0)[1]
            checks.that(status is not None and status.stop_reason == reason, f'{name}: reason {status and status.stop_reason}, {reason} asked')
            time.sleep(1.0)
            states = [s for _, s in bus.messages('STATE')][-1:]
            checks.at_most(tilt_of(states[0]), 5.0, f'{name}: tilt afterwards [degrees]')
            told = [text_of(e) for _, e in bus.messages('EVENT')]
            checks.that(kill or any(said in line for line in told), f'{name}: EVENT says why: {told}')
    finally:
        bus.close()
        output = policy.end()
    if not kill:
        checks.that(said in output and policy.process.returncode == 1, f'{name}: it says why and exits with 1: {output}')


def tilt_of(state):
    """Of the IMU [degrees]."""
    _, x, y, _ = state.attitude
    return math.degrees(math.acos(max(-1.0, min(1.0, 1.0 - 2.0 * (x * x + y * y)))))


FAULTS = {'late': (BY_CONTROLLER, 'wants a new action every 20 ms'), 'nan': (BY_CONTROLLER, 'is not a finite number'),
          'die': (COMMAND_TIMEOUT, 'no command'), 'hang': (BY_CONTROLLER, 'wants a new action every 20 ms'),
          'throw': (BY_CONTROLLER, 'out of memory')}


def fails_in_mid_step(robot, model, spec, vx, fault, after, name, checks):
    """The robot stands afterwards, or has been let go and is damped; the first reason is the true one, and EVENT says it."""
    reason, said = FAULTS[fault]
    words = [PYTHON, str(ROOT / 'test/process/failing_policy.py'), str(model), '--fault', fault, '--after', str(after), '--vx', str(vx)]
    policy = subprocess.Popen(words + (['--spec', str(spec)] if spec else []), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    attempt = checks.tentative()
    end, bus = 'none', Bus()
    try:
        policy.stdout.readline()
        with Stack('stand_python', '--stack', 'client', '--robot', robot, '--no-viewer', '--no-record'):
            stopped = bus.wait_for('SOURCE_STATUS', lambda s: s.stop_kind >= 2, timeout=20 + 0.02 * after, start=0)[1]
            time.sleep(5.0)
            states = [s for _, s in bus.messages('STATE')][-500:]
            told = [text_of(e) for _, e in bus.messages('EVENT')]
            commanded = [s.stop_reason for _, s in bus.messages('SOURCE_STATUS') if s.stop_kind >= 1]
            largest = max(tilt_of(state) for state in states)
            turning = max(float(abs(rate)) for state in states for rate in state.qd[:state.joint_count])
            end = 'stands' if largest < 20.0 and states[-1].stop_kind == 2 else 'damped' if states[-1].stop_kind == 3 else 'stiff'
            attempt.that(end in ('stands', 'damped'), f'{name}: it {end}, tilt {largest:.1f} degrees')
            attempt.at_most(turning, 1.0, f'{name}: fastest joint in the last second [rad/s]')
            fell_first = stopped is not None and stopped.stop_reason == FALLEN
            true = any(kind == reason for kind in commanded[:1]) or fell_first and fault == 'die'
            attempt.that(true and any(said in line for line in told), f'{name}: reasons {commanded[:3]}, {reason} asked; EVENT: {told[-6:]}')
    finally:
        bus.close()
        policy.kill()
        output = policy.communicate(timeout=20)[0]
    if fault != 'die':
        attempt.that(said in output, f'{name}: it says why: {output[-300:]}')
    checks.adopt(attempt)
    return end if attempt.failed == 0 else 'failed'


def mid_step(folder, checks):
    """A policy that walks where the data of others are there (TWINBUS_DATA), else one that stands; TWINBUS_FULL: twenty of them."""
    data = pathlib.Path(os.environ.get('TWINBUS_DATA', ''))
    robot, model, spec, speeds = 'hrp1s', folder / 'stand.onnx', '', (0.0,)
    if (data / 'policies/g1_policy.onnx').is_file():
        robot, model, speeds = folder / 'g1', data / 'policies/g1_policy.onnx', (0.0, 0.5)
        spec = ROOT / 'test/python/policies/g1_playground.spec.yaml'
        status, out, err = cli('check', data / 'robots/g1/g1_29dof_rev_1_0.urdf', '--propose', robot, timeout=300)
        checks.that(status == 0, f'mid-step: proposal: {out[-300:]}{err[-300:]}')
    faults, ends = list(FAULTS), {}
    count = int(os.environ.get('TWINBUS_POLICY_FAULTS', 20 if harness.FULL else 3))
    for number in range(count):
        fault, vx = faults[number % 3 if not harness.FULL else number % len(faults)], speeds[number // 3 % len(speeds)]
        end = fails_in_mid_step(str(robot), model, spec, vx, fault, 110 + 7 * number, f'{fault} at {vx} m/s, {number}', checks)
        ends.setdefault((fault, vx), []).append(end)
        print(f'mid-step {number + 1}: {fault}, {vx} m/s: {end}', flush=True)
    good = sum(end != 'failed' for several in ends.values() for end in several)
    print(f'in mid-step: {good} of {count}; ' + '; '.join(f'{fault} at {vx}: {", ".join(several)}' for (fault, vx), several in ends.items()))


def starts(checks):
    """G1 on the robot as proposed begins to walk at once, at three velocities (test/bench/bench_policy.py)."""
    done = subprocess.run([PYTHON, str(ROOT / 'test/bench/bench_policy.py'), 'starts', '--robots', 'g1', '--count', '30' if harness.FULL else '1'],
                          capture_output=True, text=True, env=dict(os.environ, TWINBUS_POLICY_PYTHON=PYTHON, TWINBUS_POLICY_RUNS='1'))
    print(done.stdout, end='')
    checks.that(done.returncode in (0, harness.SKIPPED), f'starts: {done.stdout[-600:]}{done.stderr[-600:]}')


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


def plays(folder, checks):
    """A tracking policy beside the one that walks: ./twinbus mode play changes to it, and anything else back."""
    text = specification()
    (folder / 'track.spec.yaml').write_text(text[:text.index('observations:')] + 'observations:\n  - {term: motion_joints}\n'
                                            '  - {term: motion_orientation}\nmotion: {anchor: CHEST}\n')
    tables = {'joint_pos': [[0.001 * k] * JOINTS for k in range(100)], 'joint_vel': [[0.05] * JOINTS] * 100, 'ref_quat_xyzw': [[0.0, 0.0, 0.0, 1.0]] * 100}
    track = tiny_onnx.linear(folder / 'track.onnx', 2 * JOINTS + 6, JOINTS, bias=0.5, tables=tables)
    policy = Policy(tiny_onnx.linear(folder / 'stand.onnx', 9 + JOINTS, JOINTS), '--play', str(track))
    try:
        with Stack('stand_python', '--stack', 'client', '--no-viewer', '--no-record'):
            bus = Bus()
            checks.that(bus.wait_for('CONTROLLER_STATUS', lambda s: s.mode == 5, timeout=20)[1] is not None, 'plays: it walks first')
            status, out, err = cli('mode', 'play')
            checks.that(status == 0 and 'plays a motion' in out, f'plays: {status} {out}{err}')
            ended = bus.wait_for('CONTROLLER_STATUS', lambda s: s.mode == 4 and s.motion == 0, timeout=10)[1]  # 1 s and 2 s of the motion
            checks.that(ended is not None, 'plays: the motion ends by itself')
            cli('mode', 'play')
            status, out, err = cli('walk', '0.1', '0', '0', '--for', '0.5')
            checks.that(status == 0, f'plays: walk ends it: {out}{err}')
            states = [s for _, s in bus.messages('STATE')]
            checks.that(bool(states) and states[-1].stop_kind == 0, 'plays: not stopped')
            moved = {round(c.q[0], 4) for _, c in bus.messages('COMMAND')}
            checks.that(len(moved) >= 2, f'plays: both policies command: {sorted(moved)[:5]}')
    finally:
        said = policy.end()
    checks.that('follows' in ''.join(policy.before) + said, f'plays: says what it follows: {said}')


def main():
    harness.require('twinbus', 'twinbus_simulator', 'twinbus_guard')
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
        ends_in_order(folder, checks)
        example(folder, checks)
        plays(folder, checks)
        reads = 9 + JOINTS
        stops(folder, 'nan', tiny_onnx.linear(folder / 'nan.onnx', reads, JOINTS, math.nan), 'is not a finite number', BY_CONTROLLER, checks)
        stops(folder, 'late', tiny_onnx.linear(folder / 'late.onnx', reads, JOINTS, slow=200), 'a new action every 20 ms', BY_CONTROLLER, checks)
        stops(folder, 'dead', folder / 'stand.onnx', '', COMMAND_TIMEOUT, checks, kill=True)
        mid_step(folder, checks)
        starts(checks)
    checks.exit()


if __name__ == '__main__':
    main()
