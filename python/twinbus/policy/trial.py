"""A policy in a simulator of its own: a stack in lock-step on a bus of its own, and what TRUTH says of it.  No robot moves."""
from __future__ import annotations

import concurrent.futures
import json
import math
import os
import pathlib
import random
import subprocess
import tempfile
import time
from dataclasses import dataclass, field, replace
from typing import Callable

import numpy as np
from numpy.typing import NDArray

from .. import home, messages
from ..bus import Bus
from .controller import Controller
from .errors import PolicyError
from .network import Network
from .robot import Robot
from .runner import Options, Runner, Stopped
from .spec import Spec

Array = NDArray[np.float64]
SETTLED = 2.0     # of the beginning does not count [s]
NEAR = 0.05       # of the policy's posture: a start in it needs no fade [rad]
SILENCE = 60.0    # without STATE, after which the stack is given up [s]
TRACKED = 0.7     # of what a robot that only stands in the mean of a motion is from it: one that follows is nearer
STEADY = 0.1      # rms from a motion that is always near enough [rad]
STILL = 10.0      # in which the policy did not get on, as after a stop by somebody else [s]


@dataclass
class Outcome:
    """Of one trial.  Means after the first two seconds, in the heading frame of the base."""
    command: tuple[float, float, float]
    seed: int
    seconds: float = 0.0          # of the robot's time that it lasted
    velocity: Array = field(default_factory=lambda: np.zeros(3))  # vx, vy [m/s], wz [rad/s]
    largest_tilt: float = 0.0     # [rad]
    fell: bool = False
    stopped: str = ''             # why, when the robot was stopped
    apart: float = 0.0            # of a tracking policy: rms of its joints from the motion, once that has begun [rad]
    ended: bool = False           # and whether that came to its last frame
    judged: int = 0               # ticks that the guard looked at; 0: it was not waited for
    held: int = 0                 # of them with joints that it held
    guard_stops: int = 0          # stops that it asked for, each as long as it went on asking


class _Watch:
    """Sums up TRUTH."""

    def __init__(self) -> None:
        self.begin: float | None = None
        self.sum, self.count = np.zeros(3), 0
        self.tilt, self.fell, self.fell_at = 0.0, False, math.inf

    def see(self, truth: messages.sim_truth_t) -> None:
        self.begin = truth.sim_time if self.begin is None else self.begin
        w, x, y, z = truth.base_attitude
        self.tilt = max(self.tilt, math.acos(max(-1.0, min(1.0, 1.0 - 2.0 * (x * x + y * y)))))
        if (truth.fell or self.tilt > 1.0) and not self.fell:
            self.fell, self.fell_at = True, truth.sim_time - self.begin
        if self.fell or truth.sim_time - self.begin < SETTLED:
            return
        yaw = math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
        vx, vy = truth.base_velocity[0], truth.base_velocity[1]
        self.sum += [math.cos(yaw) * vx + math.sin(yaw) * vy, -math.sin(yaw) * vx + math.cos(yaw) * vy, truth.base_angular_velocity[2]]
        self.count += 1


class _Judged:
    """Sums up GUARD."""

    def __init__(self) -> None:
        self.ticks, self.held, self.stops, self._asks = 0, 0, 0, False

    def see(self, report: messages.guard_report_t) -> None:
        self.ticks += 1
        self.held += report.hold_mask != 0
        self.stops += bool(report.stop_asked) and not self._asks
        self._asks = bool(report.stop_asked)


class Beside:
    """Sums up how far the joints are from the motion that a controller follows, from its second frame on."""

    def __init__(self) -> None:
        self.sum, self.count, self.ended = 0.0, 0, False

    def see(self, controller: Controller, q: Array) -> None:
        """q: [joints on the bus], after each action."""
        follower = controller.follower
        if follower is None or not follower.begun:
            return
        own = q[controller.observation.index]
        self.sum += float(np.mean((own - follower.joints()[:len(own)])**2))
        self.count += 1
        self.ended = self.ended or follower.ended

    @property
    def apart(self) -> float:
        """Rms [rad]; no number before the motion has begun."""
        return math.sqrt(self.sum / self.count) if self.count else math.nan


def posture_of(spec: Spec, robot: Robot) -> str | None:
    """A pose of the SRDF in which the policy begins, or None."""
    for name, angles in robot.poses.items():
        if all(abs(angles.get(joint.name, 0.0) - joint.default) < NEAR for joint in spec.joints):
            return name
    return None


def run(network: Network, spec: Spec, robot: Robot, folder: str, command: tuple[float, float, float], seconds: float, seed: int = 1,
        engine: str = '', settings: tuple[str, ...] = (), wait: float | None = None, scene: str = 'stand_python',
        look: Callable[[Runner, messages.sim_truth_t], None] | None = None, guarded: bool = False) -> Outcome:
    """folder: of the robot, as behind --robot.  seconds: of the robot's time.  wait: as of the runner, None: 0 where a pose of the SRDF is
    the policy's posture.  scene: a name or a file.  look: called with every TRUTH.  guarded: the guard judges every tick; else those for
    which it has time, since a lock-step does not wait for it.

    PolicyError when the stack does not run."""
    pose = posture_of(spec, robot)
    wait = (0.3 if pose is None else 0.0) if wait is None else wait
    outcome, watch, beside, judged = Outcome(command, seed), _Watch(), Beside(), _Judged()
    url = f'udpm://239.255.76.67:{random.SystemRandom().randrange(20000, 60000)}?ttl=0'
    with tempfile.TemporaryDirectory() as work, Bus(url) as bus:
        runner = Runner(bus, lambda found: Controller(spec, found, network), Options(command, wait, None if wait > 0.0 else False, seconds, say=lambda _: None,
                        guarded=guarded), replace(robot))

        def see(truth: messages.sim_truth_t) -> None:
            watch.see(truth)
            if look is not None:
                look(runner, truth)
        runner.on_truth, runner.on_guard = see, judged.see
        def compare(state: messages.robot_state_t) -> None:
            if isinstance(runner.controller, Controller) and runner.actions:
                beside.see(runner.controller, np.array(state.q[:state.joint_count]))
        runner.on_state = compare if spec.follows else None
        words = [str(home.program()), 'up', scene, '--stack', 'client', '--robot', folder, '--lockstep', '--no-viewer', '--no-record',
                 '--for', f'{seconds + 0.1:g}', '--seed', str(seed), '--url', url]
        words += ['--start-pose', pose] if pose is not None else []
        words += ['--engine', engine] if engine else []
        for setting in settings:
            words += ['--set', setting]
        log = pathlib.Path(work) / 'up.txt'
        with log.open('w') as out:
            stack = subprocess.Popen(words, stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                     env=dict(os.environ, TWINBUS_RUNS=work))
        try:
            quiet, last, since = 0.0, -1.0, time.monotonic()
            while runner.elapsed < seconds and not watch.fell:
                quiet = 0.0 if runner.receive(0.5) else quiet + 0.5
                if quiet > SILENCE or stack.poll() is not None and quiet > 1.0:
                    if runner.ticks:
                        break
                    raise PolicyError('the trial does not run: ' + ' '.join(log.read_text().splitlines()[-3:])[:400])
                if runner.elapsed > last:
                    last, since = runner.elapsed, time.monotonic()
                elif runner.ticks and time.monotonic() - since > (allowed := STILL if last > 0.0 else SILENCE):  # a first one may wait for others
                    outcome.stopped = _who_stopped(log.read_text().splitlines()) or f'nothing went on for {allowed:g} s'
                    break
        except Stopped as stop:
            outcome.stopped = str(stop)
        finally:
            stack.terminate()
            try:
                stack.wait(20.0)
            except subprocess.TimeoutExpired:
                stack.kill()
    outcome.seconds, outcome.fell, outcome.largest_tilt = min(runner.elapsed, watch.fell_at), watch.fell, watch.tilt
    outcome.apart, outcome.ended = beside.apart, beside.ended
    outcome.judged, outcome.held, outcome.guard_stops = judged.ticks, judged.held, judged.stops
    outcome.velocity = watch.sum / max(1, watch.count)
    return outcome


def _who_stopped(lines: list[str]) -> str:
    """What the stack said of a stop, and what the guard saw before it; empty: there was none."""
    stop = next((number for number, line in enumerate(lines) if ": stop '" in line), None)
    if stop is None:
        return ''
    seen = [line.removeprefix('up: guard: ') for line in lines[:stop] if 'guard holds joints' in line] if 'guard' in lines[stop] else []
    return lines[stop].removeprefix('up: ') + (f' ({seen[-1]})' if seen else '')


@dataclass
class Case:
    """What run() takes."""
    network: Network
    spec: Spec
    robot: Robot
    folder: str
    command: tuple[float, float, float]
    seconds: float
    seed: int = 1
    engine: str = ''


def run_all(cases: list[Case], jobs: int) -> list[Outcome]:
    """Each with a stack of its own, jobs at once; in the order of the cases."""
    def one(case: Case) -> Outcome:
        network = Network(case.network.path, case.network.input, case.network.output)  # a recurrent one has a memory of its own
        return run(network, case.spec, case.robot, case.folder, case.command, case.seconds, case.seed, case.engine)
    with concurrent.futures.ThreadPoolExecutor(max(1, jobs)) as pool:
        return list(pool.map(one, cases))


def error_of(outcome: Outcome) -> float:
    """What it walks beside what it was asked [m/s and rad/s together]."""
    return float(np.linalg.norm(outcome.velocity - np.array(outcome.command)))


def is_good(outcome: Outcome) -> bool:
    """It neither fell nor was stopped, and walks roughly as it was asked."""
    return not outcome.fell and not outcome.stopped and error_of(outcome) < max(0.35, 0.6 * float(np.linalg.norm(outcome.command)))


def tracks(outcome: Outcome, spread: float, whole: bool) -> tuple[bool, str]:
    """Whether it played its motion, and the sentence.  spread: of the motion; whole: it had the time for all of it."""
    most = max(STEADY, TRACKED * spread)
    if outcome.fell or outcome.stopped or whole and not outcome.ended:
        return False, 'it does not come to the end of its motion'
    if math.isnan(outcome.apart):
        return False, 'the motion did not begin: its first frame is held for a second, --seconds wants more'
    if outcome.apart > most:
        return False, (f'its joints are {outcome.apart:.3f} rad rms from the motion, over {most:.3f}: a robot that only stands there is {spread:.3f} '
                       'from it, so this does not follow')
    return True, f'it plays its motion in the simulator{"" if outcome.ended else ", not to its end (--seconds)"}'


def in_words(outcome: Outcome) -> str:
    asked, walked = ('%.2f %.2f %.2f' % tuple(numbers) for numbers in (outcome.command, outcome.velocity))
    end = f'fell after {outcome.seconds:.1f} s' if outcome.fell else f'stopped: {outcome.stopped}' if outcome.stopped else \
        f'{outcome.seconds:.1f} s, tilt {math.degrees(outcome.largest_tilt):.1f} degrees'
    guard = f'; guard: {outcome.guard_stops} stops, joints held in {outcome.held} of {outcome.judged} ticks' if outcome.judged else ''
    return f'asked {asked}, walked {walked}: {end}{guard}'


def as_json(outcome: Outcome) -> str:
    """One line."""
    return json.dumps({'command': outcome.command, 'seed': outcome.seed, 'seconds': round(outcome.seconds, 3),
                       'velocity': [round(float(v), 4) for v in outcome.velocity], 'largest_tilt_deg': round(math.degrees(outcome.largest_tilt), 2),
                       'fell': outcome.fell, 'stopped': outcome.stopped})
