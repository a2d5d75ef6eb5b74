#!/usr/bin/env python3
"""Policies that others trained, on robots as `./twinbus check --propose` writes them, unedited: starts, walks, and the estimate of the base.

    bench_policy.py starts [--count 30] [--beside N]     real time, --wait 0, beside N compilers that never end: falls within 4 s, per velocity
    bench_policy.py walks [--seconds 60] [--seeds 3] [--engine mujoco] [--set contact=soft]   lock-step, noise, ESTIMATE and no TRUTH, a guard that judges every tick: falls, its stops, mean velocities, error of the estimate
    bench_policy.py switches [--count 20]                real time: from our engine to mujoco and back while it walks (stack client_mujoco)
    bench_policy.py estimate [--seconds 20] [--seeds 3]  the same at rest, walking, pushed and on tiles of 30 mm, and hrp1s under our controller,
                                                         with foot forces and without: ESTIMATE beside TRUTH, forward at most 0.05 m/s
                                                         rms on flat ground, 0.1 elsewhere
    bench_policy.py outside LIST [--seconds 10]          policies of others, a line each, MODEL ROBOT SPEC [VX VY WZ] (ROBOT: a folder, a URDF or
                                                         an MJCF that is proposed; SPEC: a file or -, then the model says it; default
                                                         0.5 0 0): each stays upright, or is refused, with its reason

Walks are judged beside the same policy in MuJoCo itself (this Python's mujoco; else said and left out): go1 within 5 % or 0.03, g1
within 10 % or 0.1 (m/s, rad/s); with --engine mujoco the component that was asked for within 3 %, MuJoCo at the same step (go1's model has
4 ms, and turns 2 % slower with it than with 2 ms, 3 % slower than with 1 ms).  Exit status 1 when a run fell, was
stopped, or something falls short.

--mjcf: the robot comes from the MJCF model in which its policy was trained, which knows rotors, friction and soles, instead of the URDF.

Needs $TWINBUS_DATA (policies/g1_policy.onnx, policies/go1_policy.onnx, robots/g1, robots/go1) and a Python with onnxruntime: this one, or
$TWINBUS_POLICY_PYTHON.  Starts and stacks share the bus of the machine: under test/tools/private_bus.sh."""
import argparse
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

import programs

programs.help_is(__doc__)
ROOT = pathlib.Path(__file__).resolve().parents[2]
other = os.environ.get('TWINBUS_POLICY_PYTHON')
if other and not os.environ.get('TWINBUS_POLICY_RUNS'):
    os.execve(other, [other, *sys.argv], dict(os.environ, TWINBUS_POLICY_RUNS='1'))
sys.path[:0] = [str(ROOT / 'python'), str(ROOT / 'test/process')]
SKIPPED = 77
try:
    import numpy as np
    import onnxruntime  # noqa: F401
    from twinbus.policy import find, network, robot, trial
    from twinbus.policy.errors import PolicyError
    from twinbus.policy.rotation import rotation_of
except ImportError as error:
    print(f'skipped: {error.name} is missing; set TWINBUS_POLICY_PYTHON')
    sys.exit(SKIPPED)
import harness  # noqa: E402
from peers import mujoco_policy  # noqa: E402

DATA = pathlib.Path(os.environ.get('TWINBUS_DATA', ''))
ROBOTS = {'g1': ('robots/g1/g1_29dof_rev_1_0.urdf', 'policies/g1_policy.onnx', 'g1_playground.spec.yaml',
                'policies/xmls/g1/scene_mjx_feetonly_flat_terrain.xml'),
          'go1': ('robots/go1/go1.urdf', 'policies/go1_policy.onnx', 'go1_playground.spec.yaml',
                 'policies/xmls/go1/scene_mjx_feetonly_flat_terrain.xml')}
COMMANDS = {'g1': [(0.0, 0.0, 0.0), (0.5, 0.0, 0.0), (1.0, 0.0, 0.0)],
            'go1': [(0.0, 0.0, 0.0), (0.5, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)]}
PUSHED = 'duration: 600\npush_round: {at: 3, every: 2, count: 8, phase: 0.6, forward: 0.3, back: 0.3, sideways: 0.2}\n'
TILES = 'duration: 600\nterrain: {tile: 0.3, height: 0.03, slope_deg: 0, from: 0.6, length: 6, width: 2.4}\n'


PERIOD = 0.002  # of the bus, and so the longest step that engine mujoco takes [s]
# Beside MuJoCo: share of its velocity, and what is near enough in any case [m/s, rad/s]; share in its own engine.
BESIDE, IN_MUJOCO = {'g1': (0.10, 0.1), 'go1': (0.05, 0.03)}, 0.03


# As scene walk_noisy has it; each seed draws anew.
NOISE = {'encoder': 1e-5, 'velocity': 0.01, 'attitude': 0.002, 'gyro': 0.01}


class Policy:
    """A policy with its proposed robot."""

    def __init__(self, name, folder, mjcf, trained):
        urdf, model, spec, mjcf_file = ROBOTS[name]
        self.name, self.folder, self.model, self.spec_file = name, folder / name, DATA / model, ROOT / 'test/python/policies' / spec
        status, out, err = harness.cli('check', DATA / (mjcf_file if mjcf else urdf), '--propose', self.folder,
                                        *(['--spec', self.spec_file] if trained else []), timeout=600)
        assert self.folder.is_dir(), f'{status}: {out[-400:]}{err[-400:]}'
        self.robot = robot.from_folder(str(self.folder))
        self.network = network.Network(self.model)
        if mjcf:  # in its model the damping of the joints is what the specification has as kd of the servos: it counts once
            urdf = next(self.folder.glob('*.urdf'))
            urdf.write_text(re.sub(r'<dynamics damping="[^"]*"', '<dynamics damping="0"', urdf.read_text()))
        self.spec = find.find(self.network, self.robot, str(self.spec_file))


class Error:
    """Of the velocity in ESTIMATE beside that of TRUTH, base axes, after two seconds."""

    def __init__(self):
        self.squares, self.count, self.largest, self.begin, self.from_truth = np.zeros(3), 0, 0.0, None, False
        self._truths = {}

    def look(self, runner, truth):
        self.begin = truth.sim_time if self.begin is None else self.begin
        self.from_truth = self.from_truth or runner._said_truth
        estimate = runner._estimate
        self._truths[truth.tick] = rotation_of(np.array(truth.base_attitude)).T @ np.array(truth.base_velocity)
        while len(self._truths) > 8:
            self._truths.pop(next(iter(self._truths)))
        if estimate is None or estimate.tick not in self._truths or truth.sim_time - self.begin < 2.0:
            return
        error = np.array(estimate.velocity_in_base) - self._truths.pop(estimate.tick)
        self.squares += error * error
        self.count += 1
        self.largest = max(self.largest, float(np.linalg.norm(error)))

    def rms(self):
        return np.sqrt(self.squares / max(1, self.count))


# Of the estimate forward, rms: on flat ground, pushed or on tiles [m/s].
FLAT, ELSEWHERE = 0.05, 0.1
AS_IT_IS, WITHOUT = 'as it measures', 'without foot forces'


def is_estimated(what, robot, log, most):
    """Whether the log's velocity is estimated well enough forward, with what its feet measure and without."""
    good = True
    for words in ((), ('--no-forces',)):
        done = subprocess.run([harness.BIN / 'estimate_bench', robot, log, '--from', '2', '--most', str(most), *words], capture_output=True, text=True, check=False)
        found = re.findall(r'^(accelerometer and feet|ESTIMATE) +rms ([0-9.]+)', done.stdout, re.M)
        walked = re.search(r'([0-9.-]+) m/s forward', done.stdout)
        print(f'{what}, {WITHOUT if words else AS_IT_IS}: walks {walked[1] if walked else "?"} m/s; off by '
              + ', '.join(f'{name} {value}' for name, value in found) + f' m/s forward rms, at most {most:g} asked{"" if done.returncode == 0 else ": FALLS SHORT " + done.stderr.strip()}', flush=True)
        good = good and done.returncode == 0
    return good


def ours_estimated(folder):
    """How often the estimate of hrp1s, which our controller moves, falls short."""
    short = 0
    for course, more, most in (('flat', '', FLAT), ('pushed', PUSHED, ELSEWHERE), ('tiles', TILES, ELSEWHERE)):
        for vx in (0.0, 0.5, 1.0) if course == 'flat' else (0.5,):
            scene, log = folder / f'hrp1s_{course}_{vx:g}.yaml', folder / 'hrp1s.log'
            walks = f'  - {{at: 0.5, mode: walk}}\nwalks:\n  - {{at: 1, for: 20, vx: {vx:g}}}\n' if vx else ''
            noise = ''.join(f'  sensor.noise.{key}: {value}\n' for key, value in NOISE.items())
            rest = more.partition('\n')[2]
            scene.write_text(f'about: The estimate of the base.\nduration: 14\n{rest}settings:\n{noise}modes:\n  - {{at: 0, mode: balance}}\n{walks}')
            status, out, err = harness.cli('run', scene, '--robot', 'hrp1s', '--log', log, timeout=600)
            if not log.exists() or 'fell' in out:
                print(f'hrp1s {course} {vx:g}: {status}: {out[-300:]}{err[-300:]}', flush=True)
                short += 1
                continue
            short += not is_estimated(f'hrp1s {course} {vx:g}', 'hrp1s', log, most)
            log.unlink()
    return short


def walk(policy, command, seconds, seed, scene='stand_python', engine='', settings=(), guarded=False):
    error = Error()
    settings = (*settings, f'sensor.seed={seed}', *(f'sensor.noise.{key}={value:g}' for key, value in NOISE.items()))
    outcome = trial.run(policy.network, policy.spec, policy.robot, str(policy.folder), command, seconds, seed, engine, settings, scene=scene, look=error.look,
                        guarded=guarded)
    assert not error.from_truth, 'the velocity of the base was that of TRUTH'
    rms = error.rms()
    print(f'{policy.name:4} {trial.in_words(outcome)}; estimate off by {rms[0]:.3f} {rms[1]:.3f} {rms[2]:.3f} m/s rms, {error.largest:.2f} at most '
          f'({error.count} ticks), seed {seed}', flush=True)
    return outcome, rms


def falls_short(policy, command, mean, engine, seconds):
    """Says how far the walk is from the policy's own in MuJoCo; whether it is too far."""
    def itself(step):
        return mujoco_policy.velocity_of(policy.network, policy.spec, policy.robot, DATA / ROBOTS[policy.name][3], command, seconds, step)
    theirs = itself(PERIOD if engine == 'mujoco' else None)
    if theirs is None:
        print(f'{policy.name}: not judged beside MuJoCo: this Python has none (pip install mujoco)', flush=True)
        return False
    velocity, fell = theirs
    share, least = BESIDE[policy.name]
    most = [IN_MUJOCO * abs(v) if engine == 'mujoco' and asked else max(share * abs(v), least) for v, asked in zip(velocity, command)]
    off = [ours - v for ours, v in zip(mean, velocity)]
    if engine == 'mujoco':
        own, _ = itself(None)
        print(f"{policy.name}: at its model's own step MuJoCo walks {own[0]:.3f} {own[1]:.3f} {own[2]:.3f}", flush=True)
    far = any(not abs(o) <= m for o, m in zip(off, most))
    print(f'{policy.name} {command[0]:g} {command[1]:g} {command[2]:g}: MuJoCo itself {velocity[0]:.3f} {velocity[1]:.3f} {velocity[2]:.3f}'
          f'{" and fell" if fell else ""}; off by {off[0]:+.3f} {off[1]:+.3f} {off[2]:+.3f}, at most {most[0]:.3f} {most[1]:.3f} {most[2]:.3f}'
          f'{" asked: FALLS SHORT" if far else ""}', flush=True)
    return far


def table(policy, cases, seconds, seeds, scene='stand_python', about='', engine='', settings=(), guarded=False, most=None, beside=False):
    """How many runs fell or were stopped; beside: or were far from the policy's walk in MuJoCo; most: or estimated the velocity forward worse than this [m/s], rms."""
    falls = 0
    for command in cases:
        rows = [walk(policy, command, seconds, seed, scene, engine, settings, guarded) for seed in range(1, seeds + 1)]
        fell = sum(outcome.fell or bool(outcome.stopped) for outcome, _ in rows)
        stops = [outcome.guard_stops for outcome, _ in rows]
        guard = f" guard: {' '.join(map(str, stops))} stops, {' '.join(str(outcome.held) for outcome, _ in rows)} ticks held |" if guarded else ''
        mean = np.mean([outcome.velocity for outcome, _ in rows], axis=0)
        rms = np.sqrt(np.mean([error * error for _, error in rows], axis=0))
        print(f'| {policy.name} | {about} | {command[0]:g} {command[1]:g} {command[2]:g} | {fell} of {len(rows)} fell | {mean[0]:.3f} {mean[1]:.3f} '
              f'{mean[2]:.3f} | {rms[0]:.3f} {rms[1]:.3f} {rms[2]:.3f} |{guard}', flush=True)
        falls += max(fell, sum(map(bool, stops)))
        if most is not None and not rms[0] <= most:
            print(f'{policy.name} {about}: the estimate is off by {rms[0]:.3f} m/s forward, at most {most:g} asked: FALLS SHORT', flush=True)
            falls += 1
        if beside:
            falls += falls_short(policy, command, mean, engine, seconds)
    return falls


def start(policy, vx):
    """One start in real time; what it did: '' or how it ended."""
    pose = trial.posture_of(policy.spec, policy.robot)
    words = [str(harness.BIN / 'twinbus'), 'policy', str(policy.model), '--spec', str(policy.spec_file), '--command', str(vx), '0', '0', '--wait', '0']
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               env=dict(os.environ, TWINBUS_POLICY_PYTHON=sys.executable))
    bus = harness.Bus()
    try:
        while 'ready' not in (line := process.stdout.readline()):
            assert line, process.communicate()[0]
        with harness.Stack('stand_python', '--stack', 'client', '--robot', policy.folder, '--no-viewer', '--no-record',
                           *(['--start-pose', pose] if pose else [])):
            time.sleep(4.0)
            states = [state for _, state in bus.messages('STATE')]
    finally:
        bus.close()
        process.kill()
        process.communicate()
    tilts = [math.degrees(2.0 * math.asin(min(1.0, math.hypot(state.attitude[1], state.attitude[2])))) for state in states]
    if max(tilts) > 40.0:
        return f'fell after {0.002 * next(k for k, tilt in enumerate(tilts) if tilt > 40.0):.1f} s'
    return '' if states[-1].stop_kind == 0 else f'stopped, kind {states[-1].stop_kind}'


class Compilers:
    """So many that compile the same again and again, while inside."""

    HEADERS = ('algorithm', 'filesystem', 'functional', 'map', 'random', 'regex', 'string', 'thread')

    def __init__(self, count):
        self.count, self.running = count, []

    def __enter__(self):
        source = ''.join(f'#include <{name}>\\n' for name in self.HEADERS)
        line = f"while printf '{source}std::regex one(\"a+b\");' | c++ -std=c++20 -O2 -x c++ -c -o /dev/null -; do :; done"
        self.running = [subprocess.Popen(['sh', '-c', line], start_new_session=True) for _ in range(self.count)]

    def __exit__(self, *unused):
        for process in self.running:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()


def outside(file, seconds, folder):
    """How many of the policies of this list neither stay upright nor are refused."""
    failed, lines = 0, [line.split() for line in pathlib.Path(file).read_text().splitlines() if line.strip() and not line.startswith('#')]
    for number, (model, of_robot, spec_file, *command) in enumerate(lines):
        command = tuple(map(float, command)) or (0.5, 0.0, 0.0)
        try:
            place = pathlib.Path(of_robot)
            if place.is_file():
                place = folder / f'robot{number}'
                status, out, err = harness.cli('check', of_robot, '--propose', place, timeout=600)
                if not place.is_dir():
                    raise PolicyError(f'check ended with {status}: {err[-300:]}')
            whole, known = network.Network(pathlib.Path(model)), robot.from_folder(str(place))
            found = find.find(whole, known, '' if spec_file == '-' else spec_file)
            outcome = trial.run(whole, found, known, str(place), command, seconds)
            good, said = not outcome.fell and not outcome.stopped, trial.in_words(outcome)
        except PolicyError as refusal:
            good, said = True, f'refused: {refusal}'
        failed += not good
        print(f'{pathlib.Path(model).name} on {pathlib.Path(of_robot).name}: {said}{"" if good else ": FAILED"}', flush=True)
    print(f'{len(lines) - failed} of {len(lines)} policies stay upright or are refused', flush=True)
    return failed + (not lines)


def starts(policy, count):
    failed = 0
    for command in COMMANDS[policy.name]:
        ends = [end for end in (start(policy, command[0]) for _ in range(count)) if end]
        failed += len(ends)
        print(f'{policy.name} {command[0]:g} m/s: {len(ends)} of {count} starts failed {ends}', flush=True)
    return failed


def switches(policy, count, name, vx=0.5):
    """While it walks, a switch a second between our engine and MuJoCo; how many failed."""
    pose = trial.posture_of(policy.spec, policy.robot)
    words = [str(harness.BIN / 'twinbus'), 'policy', str(policy.model), '--spec', str(policy.spec_file), '--command', str(vx), '0', '0']
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               env=dict(os.environ, TWINBUS_POLICY_PYTHON=sys.executable))
    bus, done, runs = harness.Bus(), 0, set()
    try:
        while 'ready' not in (line := process.stdout.readline()):
            assert line, process.communicate()[0]
        with harness.Stack('stand_python', '--stack', name, '--robot', policy.folder, '--no-viewer', '--no-record',
                           *(['--start-pose', pose] if pose else [])) as stack:
            time.sleep(3.0)
            for number in range(count):
                status, out, err = harness.cli('switch', 'sim', '--policy', 'now', timeout=40)
                time.sleep(1.0)
                states = [state for _, state in bus.messages('STATE')]
                runs.update(state.run_id for state in states)
                most = max((2.0 * math.asin(min(1.0, math.hypot(state.attitude[1], state.attitude[2]))) for state in states), default=9.0)
                if status != 0 or not states or states[-1].stop_kind != 0 or most > math.radians(40.0):
                    print(f'{policy.name}: switch {number}: exit status {status}, {(out + err).strip()}, tilt {math.degrees(most):.0f} degrees, '
                          f'stop {states[-1].stop_kind if states else "unknown"}', *stack.lines[-4:], sep='\n', flush=True)
                    break
                bus.forget()
                done += 1
    finally:
        bus.close()
        process.kill()
        process.communicate()
    print(f'{policy.name} {vx:g} m/s: {done} of {count} switches between two engines while it walks, {len(runs)} sources heard', flush=True)
    return count - done


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('what', choices=('starts', 'walks', 'switches', 'estimate', 'outside'))
    parser.add_argument('list', nargs='?', help='of outside')
    parser.add_argument('--beside', type=int, default=0, help='compilers beside starts')
    parser.add_argument('--count', type=int, help='of starts, 30, or switches, 20')
    parser.add_argument('--seconds', type=float)
    parser.add_argument('--seeds', type=int, default=3)
    parser.add_argument('--stack', default='client_mujoco', help='of switches: a name or a file')
    parser.add_argument('--engine', default='', help="of walks and estimate; default the scene's")
    parser.add_argument('--robots', nargs='+', choices=ROBOTS, default=list(ROBOTS))
    parser.add_argument('--set', action='append', default=[], help='of walks and estimate: a setting of the simulator')
    parser.add_argument('--mjcf', action='store_true')
    parser.add_argument('--trained', action='store_true', help='rotors and friction of joints that the URDF does not say are of the specification')
    words = parser.parse_args()
    if (words.what == 'outside') != (words.list is not None):
        parser.error('outside takes a LIST, and nothing else does')
    missing = [] if words.list else [name for name in words.robots for path in ROBOTS[name][:2] if not (DATA / path).is_file()]
    if missing or not str(DATA):
        print(f'skipped: $TWINBUS_DATA has not what {", ".join(sorted(set(missing)))} needs')
        sys.exit(SKIPPED)
    falls = 0
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work)
        (folder / 'pushed.yaml').write_text('about: Pushed all round.\n' + PUSHED)
        (folder / 'tiles.yaml').write_text('about: Tiles.\n' + TILES)
        if words.list:
            falls += outside(words.list, words.seconds or 10.0, folder)
        for name in () if words.list else words.robots:
            policy = Policy(name, folder, words.mjcf, words.trained)
            if words.what == 'starts':
                with Compilers(words.beside):
                    falls += starts(policy, words.count or 30)
            elif words.what == 'switches':
                falls += switches(policy, words.count or 20, words.stack)
            elif words.what == 'walks':
                falls += table(policy, COMMANDS[name], words.seconds or 60.0, words.seeds, about='flat', engine=words.engine, settings=words.set,
                               guarded=True, beside=True)
            else:
                seconds, engine = words.seconds or 20.0, words.engine
                for feet, settings in ((AS_IT_IS, words.set), (WITHOUT, [*words.set, 'sensor.foot_forces=0'])):
                    falls += table(policy, COMMANDS[name], seconds, words.seeds, about=f'flat, {feet}', engine=engine, settings=settings, most=FLAT)
                    for course, longest in (('pushed', seconds), ('tiles', min(seconds, 12.0))):
                        falls += table(policy, [(0.5, 0.0, 0.0)], longest, words.seeds, str(folder / f'{course}.yaml'), f'{course}, {feet}', engine, settings,
                                       most=ELSEWHERE)
        if words.what == 'estimate':
            falls += ours_estimated(folder)
    sys.exit(1 if falls else 0)


if __name__ == '__main__':
    main()
