"""What of a policy's contract cannot be right, before anything moves: names, sizes, signs, units, gains, rate, limits.

Nothing here runs the network.  What only shows in motion (a sign that both sides share, an order of observations) trial.py finds."""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Callable

import numpy as np

from .errors import PolicyError
from .mirror import pairs
from .network import Network
from .observation import Observation
from .robot import Robot
from .spec import FRAMED, Joint, Spec

KP_SPREAD = (0.08, 1.2)      # kp * scale / effort limit, median over joints: torque of an action of 1 as a share of the limit
KP_OWN = (0.04, 4.0)         # the same where kp is the robot's own, which is stiffer than what policies are trained with
KD_TIME = (0.003, 0.6)       # kd / kp [s]
PERIODS = (0.004, 0.05)      # between two actions [s]
SCALES = {'joint_velocity': (0.005, 1.0), 'base_angular_velocity': (0.05, 4.0), 'base_linear_velocity': (0.2, 5.0),
          'projected_gravity': (0.2, 5.0), 'joint_position': (0.1, 10.0), 'last_action': (0.1, 10.0), 'velocity_command': (0.1, 10.0),
          'command_linear_velocity': (0.1, 10.0), 'command_angular_velocity': (0.1, 10.0)}
GATE_GAIN = 10.0             # the gate lets through gains of robot.yaml times this
LIMIT_APART = 0.05           # [rad] between limits of the training and of the robot
ARMATURE_APART = 2.0         # factor
EFFORT_LEAST = 0.5           # of the training's that the robot must have


@dataclass
class Finding:
    """fault: False is a note, for people to look at."""
    about: str
    sentence: str
    fault: bool = True

    def __str__(self) -> str:
        return f'{"FAULT" if self.fault else "note "} {self.about}: {self.sentence}'


def check(spec: Spec, robot: Robot, network: Network) -> list[Finding]:
    """Everything that is wrong with the contract of these three."""
    found: list[Finding] = []
    known = set(robot.names())
    missing = [name for name in spec.names() if name not in known]
    if missing:
        near = ', '.join(robot.names()[:4])
        found.append(Finding('joint order', f'{robot.name} has no joint {", ".join(missing)}; it has {near}, ...'))
    _check_sizes(spec, network, found)
    _check_rate(spec, robot, found)
    joints = [joint for joint in spec.joints if joint.name in known]
    for joint in joints:
        _check_joint(joint, robot, found)
    _check_gains(joints, robot, found)
    _check_mirror(joints, robot, found)
    _check_terms(spec, robot, found)
    _check_phase(spec, found)
    if not missing:
        try:
            Observation(spec, robot)
        except PolicyError as error:
            found.append(Finding('observations', str(error)))
    absent = [name for name in robot.names() if name not in set(spec.names())]
    if absent:
        found.append(Finding('joints', f'{", ".join(absent)}: not moved by the policy; they hold their posture with the gains of robot.yaml',
                             False))
    for sentence in spec.assumed:
        found.append(Finding('assumed', sentence, False))
    return found


def _check_sizes(spec: Spec, network: Network, found: list[Finding]) -> None:
    size = spec.observation_size()
    if size != network.observation_size:
        once = sum(spec.term_size(term) for term in spec.observations)
        hint = ''
        if once and network.observation_size % once == 0 and network.observation_size != once:
            hint = f'; with a history of {network.observation_size // once} of every term they would fit'
        elif once == network.observation_size:
            hint = '; without history they would fit'
        found.append(Finding('history length' if hint else 'observations',
                             f'they are {size} numbers, the network reads {network.observation_size}{hint}'))
    if network.action_size != len(spec.joints):
        found.append(Finding('joint order', f'{len(spec.joints)} joints are named, the network moves {network.action_size}'))


def _check_rate(spec: Spec, robot: Robot, found: list[Finding]) -> None:
    ticks = spec.period / robot.period
    if abs(ticks - round(ticks)) > 0.01 or round(ticks) < 1:
        found.append(Finding('rate', f'an action every {1e3 * spec.period:g} ms is no whole number of ticks of the robot '
                             f'({1e3 * robot.period:g} ms)'))
    if not PERIODS[0] <= spec.period <= PERIODS[1]:
        found.append(Finding('rate', f'an action every {1e3 * spec.period:g} ms ({1.0 / spec.period:.0f} a second); policies of legged robots '
                             f'have {1.0 / PERIODS[1]:.0f} to {1.0 / PERIODS[0]:.0f} a second'))


def _check_joint(joint: Joint, robot: Robot, found: list[Finding]) -> None:
    there, name = robot.by_name[joint.name], joint.name
    angles = [('default', joint.default)] + ([('offset', joint.offset)] if joint.offset is not None else [])
    for what, angle in angles:
        if not there.lower - 1e-3 <= angle <= there.upper + 1e-3:
            degrees = there.lower <= math.radians(angle) <= there.upper and abs(angle) > 2.0 * math.pi
            found.append(Finding('default angles', f'{name}: {what} {angle:g} rad is outside of {there.lower:g} to {there.upper:g}'
                                 f'{"; it looks like degrees" if degrees else ""}'))
    if joint.scale == 0.0:
        found.append(Finding('scale', f'{name}: an action scale of 0 moves nothing'))
    elif joint.scale < 0.0:
        found.append(Finding('sign', f'{name}: an action scale of {joint.scale:g} turns its direction round'))
    for what, ours, theirs in (('lower', there.lower, joint.lower), ('upper', there.upper, joint.upper)):
        if theirs is not None and math.isfinite(ours) and abs(ours - theirs) > LIMIT_APART:
            found.append(Finding('limits', f'{name}: {what} limit {ours:g} rad on this robot, {theirs:g} in the training'))
    if joint.effort and there.effort < EFFORT_LEAST * joint.effort:
        found.append(Finding('limits', f'{name}: effort limit {there.effort:g} N m on this robot, {joint.effort:g} in the training'))
    elif joint.effort and there.effort < 0.99 * joint.effort:
        found.append(Finding('limits', f'{name}: effort limit {there.effort:g} N m on this robot, {joint.effort:g} in the training', False))
    if joint.armature is not None and there.armature > 0.0:
        apart = max(joint.armature, 1e-9) / there.armature
        if not 1.0 / ARMATURE_APART <= apart <= ARMATURE_APART:
            found.append(Finding('armature', f'{name}: {there.armature:g} kg m^2 on this robot (rotor_inertia), {joint.armature:g} in the training'))
    elif joint.armature:
        found.append(Finding('armature', f'{name}: none on this robot (rotor_inertia in robot.yaml), {joint.armature:g} kg m^2 in the training; '
                             'check --propose --spec takes them over', False))


def _check_gains(joints: list[Joint], robot: Robot, found: list[Finding]) -> None:
    shares, servos, times, cut = list[float](), list[float](), list[float](), list[str]()
    for joint in joints:
        there = robot.by_name[joint.name]
        if joint.kp == 0.0 and joint.scale != 0.0:
            found.append(Finding('gains', f'{joint.name}: kp is 0, so its target moves nothing'))
        if joint.kd == 0.0:
            found.append(Finding('gains', f'{joint.name}: kd is 0, so nothing damps it'))
        for what, gain, most in (('kp', joint.kp, GATE_GAIN * there.kp), ('kd', joint.kd, GATE_GAIN * there.kd)):
            if most > 0.0 and gain > most:
                cut.append(f'{joint.name}: {what} {gain:g} is cut by the gate to {most:g}, ten times that of robot.yaml')
        if joint.kp > 0.0 and joint.kd > 0.0:
            times.append(joint.kd / joint.kp)
        own = there.kp > 0.0 and abs(joint.kp / there.kp - 1.0) < 0.05  # the robot's own servo: as stiff as it is
        if math.isfinite(there.effort) and there.effort > 0.0 and joint.kp > 0.0:
            (servos if own else shares).append(abs(joint.kp * joint.scale) / there.effort)
    for sentence in cut:
        found.append(Finding('gains', sentence, len(cut) > 0.25 * len(joints)))
    if times and not KD_TIME[0] <= float(np.median(times)) <= KD_TIME[1]:
        found.append(Finding('gains', f'kd / kp is {float(np.median(times)):.3g} s (median); servos of robots have {KD_TIME[0]} to {KD_TIME[1]} s: '
                             'kp and kd exchanged, or a wrong unit?'))
    for there_are, (low, high), which in ((shares, KP_SPREAD, ''), (servos, KP_OWN, ' of joints with the kp of robot.yaml')):
        if there_are and not low <= float(np.median(there_are)) <= high:
            found.append(Finding('gains or scale', f'an action of 1 asks for {100.0 * float(np.median(there_are)):.3g} % of a joint\'s effort limit '
                                 f'(kp * scale, median{which}); policies have {100 * low:.0f} to {100 * high:.0f} %'))


def _check_mirror(joints: list[Joint], robot: Robot, found: list[Finding]) -> None:
    own = {joint.name: joint for joint in joints}
    for pair in pairs(robot):
        if pair.left not in own or pair.right not in own:
            continue
        left, right = own[pair.left], own[pair.right]
        if abs(right.default - pair.sign * left.default) > 0.02:
            sign = abs(right.default + pair.sign * left.default) < 0.02
            found.append(Finding('sign' if sign else 'joint order' if left.default != 0.0 or right.default != 0.0 else 'default angles',
                                 f'default of {left.name} is {left.default:g}, of {right.name} {right.default:g} rad; left and right are not '
                                 f'mirror images{": a sign is turned round" if sign else ", so names and numbers may not belong together"}'))
        for what in ('kp', 'kd', 'scale', 'armature', 'effort'):
            a, b = getattr(left, what), getattr(right, what)
            if a is not None and b is not None and abs(abs(a) - abs(b)) > 0.02 * max(abs(a), abs(b)):
                found.append(Finding('joint order', f'{what} of {left.name} is {a:g}, of {right.name} {b:g}: names and numbers may not belong '
                                     'together'))


def _check_terms(spec: Spec, robot: Robot, found: list[Finding]) -> None:
    zero = np.zeros(len(robot.bus))
    imu = robot.motion(robot.imu, zero, zero)
    for term in spec.observations:
        scales = np.array(term.scale)
        if np.any(scales == 0.0):
            found.append(Finding('scale', f'{term.term}: a scale of 0 hides it'))
        if np.any(scales < 0.0):
            what = ('gravity frame', 'projected_gravity points down; turned round it points up') if term.term == 'projected_gravity' else \
                ('sign', f'{term.term}: a scale of {float(scales.min()):g} turns it round')
            found.append(Finding(what[0], what[1]))
        ends = SCALES.get(term.term)
        size = float(np.median(np.abs(scales)))
        if ends is not None and size > 0.0 and not ends[0] <= size <= ends[1]:
            degrees = abs(size / math.degrees(1.0) - 1.0) < 0.05
            found.append(Finding('scale', f'{term.term}: a scale of {size:g}; policies have {ends[0]:g} to {ends[1]:g}'
                                 f'{"; it looks like degrees" if degrees else ""}'))
        if term.clip is not None and not term.clip[0] < 0.0 < term.clip[1] and term.term != 'constant':
            found.append(Finding('scale', f'{term.term}: clipped to {term.clip[0]:g} to {term.clip[1]:g}, which leaves zero out'))
        if term.term not in FRAMED:
            continue
        frame = robot.imu if term.frame == 'imu' else robot.base if term.frame == 'base' else term.frame
        try:
            there = robot.motion(frame, zero, zero)
            moving = [joint.name for joint in robot.chain(frame) if joint.bus >= 0]
        except PolicyError as error:
            found.append(Finding('gravity frame', str(error)))
            continue
        tilt = math.degrees(math.acos(max(-1.0, min(1.0, float(there.rotation[2, 2])))))
        if tilt > 20.0:
            found.append(Finding('gravity frame', f'{term.term} is seen from {frame}, whose z axis is {tilt:.0f} degrees off upright; '
                                 'that of a trunk is not'))
        elif moving and frame != robot.imu and not np.allclose(imu.rotation, there.rotation, atol=1e-6):
            found.append(Finding('gravity frame', f'{term.term} is seen from {frame}, behind {", ".join(moving[:2])}', False))
        elif len(moving) > 3:
            found.append(Finding('gravity frame', f'{term.term} is seen from {frame}, behind {len(moving)} joints ({", ".join(moving[:2])}, ...); '
                                 'that is a limb, not the trunk'))
    if 'projected_gravity' not in {term.term for term in spec.observations}:
        found.append(Finding('gravity frame', 'no observation says where down is', False))


def _check_phase(spec: Spec, found: list[Finding]) -> None:
    clocks = [1.0 / term.period for term in spec.observations if term.term == 'gait_phase'] + \
             ([spec.phase.frequency] if spec.phase is not None else [])
    for frequency in clocks:
        if not 0.3 <= frequency <= 5.0:
            found.append(Finding('rate', f'a gait of {frequency:g} steps of each leg a second; robots have 0.3 to 5'))
    for key, (low, high) in spec.commands.items():
        if not low <= 0.0 <= high:
            found.append(Finding('commands', f'{key} of {low:g} to {high:g} leaves out standing', False))


def in_words(findings: list[Finding], report: Callable[[str], None]) -> int:
    """Says them, faults first, and gives how many faults there are; notes of one kind about many joints are said once."""
    faults = [finding for finding in findings if finding.fault]
    for finding in faults:
        report(str(finding))
    notes: dict[str, list[Finding]] = {}
    for finding in findings:
        if not finding.fault:
            notes.setdefault(finding.about, []).append(finding)
    for same in notes.values():
        report(str(same[0]) + (f' (and {len(same) - 1} more of this kind)' if len(same) > 1 else ''))
    return len(faults)
