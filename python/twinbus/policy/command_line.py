"""./twinbus policy MODEL.onnx: runs a learned policy on the bus, proposes its specification, checks it, or maps its answer."""
from __future__ import annotations

import argparse
import gc
import math
import os
import pathlib
import signal
import sys

from ..bus import Bus
from ..home import as_typed
from . import answer_map, check, find, robot, spec, suspects, trial
from . import propose as begin
from .acting import Acting
from .controller import Controller
from .errors import PolicyError, Refused
from .follower import STANDS
from .network import Network
from .repertoire import Repertoire, pair_up
from .runner import Options, Runner, Stopped

COMMANDED = ('velocity_command', 'command_linear_velocity', 'command_angular_velocity')
PRIORITY = 45  # FIFO: below that of the source and of the guard

def go_ahead() -> bool:
    """FIFO priority, as the loop of our own controller has it, where this account may; short pauses of the garbage collector."""
    gc.collect()
    gc.freeze()  # what is there by now is not looked through again
    if os.environ.get('TWINBUS_FIFO') == '0':
        return False
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(PRIORITY))
    except OSError:
        return False
    return True


def run(words: argparse.Namespace) -> int:
    network = Network(words.model)
    beside = Network(pathlib.Path(words.play)) if words.play else None

    def bind_one(one: Network, named: str, found: robot.Robot) -> Controller:
        specification = specified(one, found, named, words.motion)
        controller = Controller(specification, found, one if network_fits(specification, one)
                                else Network(one.path, specification.input, specification.output))
        print(f'policy: {specification.source}: {len(specification.joints)} of {len(found.names())} joints of {found.name}, '
              f'{len(specification.observations)} observations, {1.0 / specification.period:.0f} actions a second', flush=True)
        for sentence in specification.assumed:
            print(f'policy: assumed: {sentence}', flush=True)
        if controller.follower is not None:
            motion = controller.follower.motion
            print(f'policy: follows {motion.source}: {len(motion)} frames, {len(motion) * specification.period:.1f} s', flush=True)
        return controller

    def bind(found: robot.Robot) -> Acting:
        first = bind_one(network, words.spec, found)
        second = None if beside is None else bind_one(beside, words.play_spec, found)
        look_at_motion(words.motion, first.spec, first.spec if second is None else second.spec)
        return first if second is None else Repertoire(first, second)
    early, late = find.without_robot(network, words.spec), find.without_robot(beside, words.play_spec) if beside is not None else None
    if early is not None and beside is None:
        look_at_motion(words.motion, early)
    elif early is not None and late is not None:
        look_at_motion(words.motion, early, late)
        pair_up(early, late)
    known = robot.from_folder(words.robot) if words.robot else None
    fifo = not words.no_fifo and go_ahead()
    wait = words.wait if words.wait is not None else 0.0 if words.no_fade else 0.3
    with Bus(words.url, words.prefix) as bus:
        # A policy that moves at once is not faded in: half obeyed it falls.
        fade = False if words.no_fade or wait == 0.0 else True if words.fade else None
        runner = Runner(bus, bind, Options(tuple(words.command), wait, fade, words.duration, fifo), known)
        signal.signal(signal.SIGTERM, signal.default_int_handler)  # as Ctrl-C: an orderly end
        print('policy: ready', flush=True)
        try:
            runner.run()
        except Stopped as stop:
            print(f'policy: stopped the robot: {stop}', file=sys.stderr)
            return 1
    print(f'policy: done, {runner.actions} actions in {runner.elapsed:.1f} s', flush=True)
    return 0


def specified(network: Network, known: robot.Robot, named: str, motion: str) -> spec.Spec:
    """The specification of a network; a tracking policy gets the motion that the command line names."""
    found = find.find(network, known, named)
    if motion and found.follows:
        found.motion = motion
    return found


def look_at_motion(motion: str, *specifications: spec.Spec) -> None:
    """Refuses a motion that none of them follows."""
    if motion and not any(one.follows for one in specifications):
        raise PolicyError(f'--motion {motion}: {specifications[-1].source} follows no motion')


def network_fits(specification: spec.Spec, network: Network) -> bool:
    """Whether the network was opened with the input and output that the specification names."""
    return specification.input in ('', network.input) and specification.output in ('', network.output)


def propose(words: argparse.Namespace) -> int:
    """Writes what was found as SPEC.yaml, or begins one."""
    network, known = Network(words.model), robot_of(words)
    try:
        found = specified(network, known, words.spec, words.motion)
    except Refused:
        raise
    except PolicyError as error:
        print(as_typed(f'policy: {error}'), file=sys.stderr)
        print('policy: so this is a guess; look at everything under `assumed`', file=sys.stderr)
        found = begin.propose(network, known)
    look_at_motion(words.motion, found)
    text = spec.to_text(found)
    if words.output == '-':
        print(text, end='')
        return 0
    target = pathlib.Path(words.output) if words.output else words.model.with_name(words.model.stem + '.spec.yaml')
    if target.exists():
        raise PolicyError(f'{target} is there already; --output says another file, --output - prints it')
    target.write_text(text)
    print(as_typed(f'policy: written: {target} (from {found.source}); next: ./twinbus policy {words.model} --spec {target} --check '
                   f'--robot {words.robot}'))
    return 0


def policy_of(words: argparse.Namespace) -> tuple[Network, robot.Robot, spec.Spec]:
    """The network, the robot that runs it, and the contract between them."""
    network, known = Network(words.model), robot_of(words)
    found = specified(network, known, words.spec, words.motion)
    look_at_motion(words.motion, found)
    if not network_fits(found, network):
        network = Network(words.model, found.input, found.output)
    return network, known, found


def check_it(words: argparse.Namespace) -> int:
    """Contract by its numbers, then a trial in a simulator; where it falls, the single change that lets it walk."""
    network, known, found = policy_of(words)
    print(f'policy: {found.source}: {len(found.joints)} joints, {len(found.observations)} observations, an action every '
          f'{1e3 * found.period:g} ms', flush=True)
    faults = check.in_words(check.check(found, known, network), lambda line: print(line, flush=True))
    pose = trial.posture_of(found, known)
    if pose is None:
        print('note  start: no pose of the SRDF is its default posture, so it goes there for 0.3 s; with this pose it '
              'can begin at once (--start-pose policy):')
        print('      <group_state name="policy" group="all">' + ''.join(f'<joint name="{joint.name}" value="{joint.default:g}"/>'
                                                                         for joint in found.joints) + '</group_state>')
    if faults or words.no_trial:
        print(f'policy: {faults} faults' + ('; no trial before they are mended' if faults and not words.no_trial else ''))
        return 1 if faults else 0
    if found.follows:
        return check_motion(words, network, known, found)
    fast = tuple(words.command) if any(words.command) else (min(0.5, found.commands.get('vx', (0.0, 0.5))[1]), 0.0, 0.0)

    obeys = any(term.term in COMMANDED for term in found.observations)
    asked = ((0.0, 0.0, 0.0), fast) if obeys else ((0.0, 0.0, 0.0),)
    if not obeys:
        print('note  commands: it reads no velocity, so it is not asked to walk')

    def walks(candidate: spec.Spec) -> list[trial.Outcome]:
        return trial.run_all([trial.Case(network, candidate, known, words.robot, command, seconds_of(words), words.seed, words.engine)
                              for command in asked], words.jobs)
    outcomes = walks(found)
    for outcome in outcomes:
        print(f'trial {trial.in_words(outcome)}', flush=True)
    if all(trial.is_good(outcome) for outcome in outcomes):
        print(f'policy: no faults; it stands{" and walks" if obeys else ""} in the simulator')
        return 0
    print('policy: it does not walk in the simulator; which single change lets it?', flush=True)
    cases = list(suspects.suspects(found, known))
    results = trial.run_all([trial.Case(network, changed, known, words.robot, asked[-1], seconds_of(words), words.seed, words.engine)
                             for _, _, changed in cases], words.jobs)
    good = sorted((trial.error_of(outcome), number) for number, outcome in enumerate(results) if trial.is_good(outcome))
    for _, number in good[:3]:
        about, sentence, _ = cases[number]
        print(f'FAULT {about}: it walks {sentence} ({trial.in_words(results[number])})')
    if not good:
        fell = any(outcome.fell for outcome in outcomes)
        print(f'FAULT trial: it {"falls" if fell else "stands and does not walk as asked"}, and none of {len(cases)} single changes lets it walk')
    return 1


def seconds_of(words: argparse.Namespace) -> float:
    return 4.0 if words.seconds is None else float(words.seconds)


def check_motion(words: argparse.Namespace, network: Network, known: robot.Robot, found: spec.Spec) -> int:
    """A tracking policy plays its motion in the simulator."""
    follower = Controller(found, known, network).follower
    assert follower is not None
    length = len(follower.motion) * found.period
    seconds = length + STANDS + 0.5 if words.seconds is None else float(words.seconds)
    outcome = trial.run(network, found, known, words.robot, (0.0, 0.0, 0.0), seconds, words.seed, words.engine)
    end = f'fell after {outcome.seconds:.1f} s' if outcome.fell else f'stopped: {outcome.stopped}' if outcome.stopped else 'did not fall'
    end += '' if outcome.ended else ', not to its end'
    print(f'trial motion of {length:.1f} s, {outcome.seconds:.1f} s with its start: {end}, joints {outcome.apart:.3f} rad rms from the motion, tilt '
          f'{math.degrees(outcome.largest_tilt):.0f} degrees')
    good, sentence = trial.tracks(outcome, follower.motion.spread, words.seconds is None or words.seconds > length + STANDS + 0.5)
    print(f'policy: no faults; {sentence}' if good else f'FAULT trial: {sentence}')
    return 0 if good else 1


def map_it(words: argparse.Namespace) -> int:
    """The answer to velocities, over seeds."""
    network, known, found = policy_of(words)
    if found.follows:
        raise Refused(f'{found.source}: a policy that follows a motion obeys no velocity, so there is nothing to map; --check plays it')
    axes = [answer_map.AXES.index(axis) for axis in words.axes]
    asked = [tuple(words.command)] if any(words.command) else answer_map.commands(found, axes, words.steps)
    cases = [trial.Case(network, found, known, words.robot, command, seconds_of(words), words.seed + number, words.engine)
             for command in asked for number in range(words.seeds)]
    outcomes = trial.run_all(cases, words.jobs)
    answer_map.in_words(outcomes, axes, lambda line: print(line, flush=True))
    if words.output:
        pathlib.Path(words.output).write_text(answer_map.svg(outcomes, axes, f'{found.name} on {known.name}: {words.seeds} seeds, '
                                                             f'{seconds_of(words):g} s each'))
        print(f'policy: written: {words.output}')
    return 1 if any(outcome.fell or outcome.stopped for outcome in outcomes) else 0


def robot_of(words: argparse.Namespace) -> robot.Robot:
    if not words.robot:
        raise PolicyError('--propose, --check and --map need --robot: a name under config/robots, or a folder')
    return robot.from_folder(words.robot)


def main(words: argparse.Namespace) -> int:
    """Exit status: 0 done, 1 failed."""
    try:
        return propose(words) if words.propose else check_it(words) if words.check else map_it(words) if words.map else run(words)
    except PolicyError as error:
        print(as_typed(f'policy: {error}'), file=sys.stderr)
        return 1
    except OSError as error:
        print(as_typed(f'policy: {error}'), file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 0
