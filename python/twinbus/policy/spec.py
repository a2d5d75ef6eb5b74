"""What a policy was trained to read and to move: the specification, and SPEC.yaml, the form in which it is ours.

    spec: 1
    name: g1_walk
    period: 0.02                      # between two actions [s]
    joints:                           # in the order of the network; target = offset + scale * action
      - {name: left_hip_pitch_joint, default: -0.312, scale: 0.5, kp: 75, kd: 2}
    observations:                     # in the order of the network
      - {term: base_angular_velocity, frame: base, scale: 0.25, clip: [-100, 100]}

Everything is bound to the robot by joint names, so neither order nor number of its joints matters.  All keys: doc/policy.md."""
from __future__ import annotations

import math
import pathlib
from dataclasses import dataclass, field

from .errors import PolicyError, Refused
from .yaml_file import Field, load_map, parse

VERSION = 1
# name: size; -1 as many as the policy has joints, -2 as many as phases, -3 twice the joints, 0 said by `size`
TERMS = {'base_linear_velocity': 3, 'base_angular_velocity': 3, 'projected_gravity': 3, 'velocity_command': 3, 'command_linear_velocity': 2,
         'command_angular_velocity': 1, 'joint_position': -1, 'joint_velocity': -1, 'last_action': -1, 'phase_sin': -2, 'phase_cos': -2,
         'gait_phase': 2, 'motion_joints': -3, 'motion_orientation': 6, 'constant': 0}
FRAMED = ('base_linear_velocity', 'base_angular_velocity', 'projected_gravity')
# terms that need what no channel has
UNAVAILABLE = {'motion:': 'more of a motion than its joints and the orientation of its anchor: where the robot is beside it no robot measures',
               'height_scan': 'heights of the ground around it',
               'image': 'a picture of a camera'}
TERM_KEYS = ('term', 'frame', 'scale', 'clip', 'history', 'size', 'values', 'relative', 'period', 'joints')
JOINT_KEYS = ('name', 'default', 'scale', 'kp', 'kd', 'offset', 'clip', 'lower', 'upper', 'effort', 'velocity', 'armature',
              'friction')


@dataclass
class Joint:
    """A joint of the policy.  None: not said."""
    name: str
    default: float        # where joint_position is zero [rad or m]
    scale: float          # of the action [rad]
    kp: float             # [N m/rad]
    kd: float             # [N m s/rad]
    offset: float | None = None             # of the target [rad]; None: default
    clip: tuple[float, float] | None = None  # of the target [rad]
    lower: float | None = None              # limits of the robot of the training [rad]
    upper: float | None = None
    effort: float | None = None             # [N m]
    velocity: float | None = None           # [rad/s]
    armature: float | None = None           # [kg m^2]
    friction: float | None = None           # Coulomb, of the joint [N m]


@dataclass
class Term:
    """Numbers of the observation.  First clip, then scale."""
    term: str
    frame: str = 'base'                     # of FRAMED: base, imu, or a link of the URDF
    scale: list[float] = field(default_factory=lambda: [1.0])
    clip: tuple[float, float] | None = None
    history: int = 1                        # newest and those before it
    size: int = 0                           # of one; 0: as TERMS say
    values: list[float] = field(default_factory=list)  # of `constant`
    relative: bool = True                   # of joint_position: minus default
    period: float = 0.0                     # of gait_phase [s]
    joints: list[str] = field(default_factory=list)  # of joint terms, where they are not all joints of the policy


@dataclass
class Phase:
    """Angles that advance with time: gait clocks of phase_sin and phase_cos."""
    frequency: float                        # [Hz]
    start: list[float]                      # [rad]
    advance: str = 'after'                  # before or after the first inference
    rest: float | None = None               # value while the command is zero [rad]; None: they advance then too


@dataclass
class Spec:
    name: str
    period: float                           # [s]
    joints: list[Joint]
    observations: list[Term]
    input: str = ''                         # of the network; empty: its first
    output: str = ''
    action_clip: tuple[float, float] | None = None
    history_by: str = 'term'                # all ages of a term, or all terms of an age
    history_order: str = 'oldest_first'
    history_begin: str = 'repeat'           # before there is a past: the first observation again, or zero
    phase: Phase | None = None
    commands: dict[str, tuple[float, float]] = field(default_factory=dict)  # vx, vy [m/s], wz [rad/s]
    anchor: str = ''                        # link whose orientation a tracking policy compares with its motion's
    motion: str = ''                        # file of that motion; empty: inside of the network
    source: str = ''                        # where it was read
    assumed: list[str] = field(default_factory=list)  # sentences: what the source does not say

    def names(self) -> list[str]:
        return [joint.name for joint in self.joints]

    @property
    def follows(self) -> bool:
        """Whether it is a tracking policy."""
        return any(term.term.startswith('motion_') for term in self.observations)

    def term_size(self, term: Term) -> int:
        """Of one age of a term."""
        size = TERMS.get(term.term, 0)
        if size == -1:
            return len(term.joints) if term.joints else len(self.joints)
        if size == -3:
            return 2 * len(self.joints)
        if size == -2:
            return len(self.phase.start) if self.phase is not None else 0
        return size or term.size or len(term.values)

    def observation_size(self) -> int:
        return sum(self.term_size(term) * term.history for term in self.observations)

    def validate(self) -> None:
        """PolicyError for what no policy can be, Refused for what this stack does not have."""
        where = self.source or self.name
        if not self.joints or not self.observations:
            raise PolicyError(f'{where}: no joints or no observations')
        seen = set[str]()
        for joint in self.joints:
            if joint.name in seen:
                raise PolicyError(f'{where}: joint {joint.name} stands there twice')
            seen.add(joint.name)
            for what in ('default', 'scale', 'kp', 'kd', 'offset'):
                value = getattr(joint, what)
                if value is not None and not math.isfinite(value):
                    raise PolicyError(f'{where}: {what} of {joint.name} is not a finite number')
            for what in ('kp', 'kd'):
                if getattr(joint, what) < 0.0:
                    raise PolicyError(f'{where}: {what} of {joint.name} is below zero')
        for term in self.observations:
            for word, needs in UNAVAILABLE.items():
                if term.term.startswith(word):
                    raise Refused(f'{where}: the policy reads {term.term}, which needs {needs}; no channel of the bus has that')
            if term.term not in TERMS:
                raise PolicyError(f'{where}: no observation {term.term!r} is known; there are: {", ".join(TERMS)}')
            if term.term.startswith('phase_') and self.phase is None:
                raise PolicyError(f'{where}: {term.term} needs `phase`')
            if term.term.startswith('motion_') and not self.anchor:
                raise PolicyError(f'{where}: {term.term} needs `motion: {{anchor: LINK}}`')
            if term.term == 'gait_phase' and not term.period > 0.0:
                raise PolicyError(f'{where}: gait_phase needs its period [s]')
            for name in term.joints:
                if name not in seen:
                    raise PolicyError(f'{where}: {term.term} reads joint {name}, which the policy does not have')
            if len(term.scale) not in (1, self.term_size(term)):
                raise PolicyError(f'{where}: {term.term} has {len(term.scale)} scales for {self.term_size(term)} numbers')
        if self.history_by == 'age' and len({term.history for term in self.observations}) > 1:
            raise PolicyError(f'{where}: history by age needs the same history of every term')


def _joint(entry: Field) -> Joint:
    entry.only(JOINT_KEYS)

    def number(key: str, low: float = -1e4, high: float = 1e4) -> float | None:
        found = entry.get(key)
        return None if found is None else found.number(low, high)
    clip = entry.get('clip')
    return Joint(entry.need('name').word(), entry.need('default').number(-1e3, 1e3), entry.need('scale').number(-1e3, 1e3),
                 entry.need('kp').number(0.0, 1e6), entry.need('kd').number(0.0, 1e5), number('offset'),
                 clip.range() if clip is not None else None, number('lower'), number('upper'), number('effort', 0.0, 1e5),
                 number('velocity', 0.0, 1e4), number('armature', 0.0, 1e3), number('friction', 0.0, 1e4))


def _term(entry: Field) -> Term:
    entry.only(TERM_KEYS)
    term = Term(entry.need('term').word())
    if (frame := entry.get('frame')) is not None:
        term.frame = frame.word()
    if (scale := entry.get('scale')) is not None:
        term.scale = scale.numbers()
    if (clip := entry.get('clip')) is not None:
        term.clip = clip.range()
    if (history := entry.get('history')) is not None:
        term.history = history.whole(1, 1000)
    if (size := entry.get('size')) is not None:
        term.size = size.whole(1, 100000)
    if (values := entry.get('values')) is not None:
        term.values = values.numbers()
    if (relative := entry.get('relative')) is not None:
        term.relative = relative.flag()
    if (period := entry.get('period')) is not None:
        term.period = period.number(1e-3, 1e3)
    if (joints := entry.get('joints')) is not None:
        term.joints = [joint.word() for joint in joints.entries()]
    return term


def from_map(root: Field) -> Spec:
    """Of SPEC.yaml.  PolicyError names the field."""
    root.only(('spec', 'name', 'period', 'input', 'output', 'joints', 'observations', 'action_clip', 'history', 'phase', 'commands', 'motion',
               'source', 'assumed'))
    if root.need('spec').whole(0, 1000) != VERSION:
        raise root.error(f'spec {root.need("spec").value} is not read, {VERSION} is')
    spec = Spec(root.need('name').word(), root.need('period').number(5e-4, 1.0), [_joint(entry) for entry in root.need('joints').entries()],
                [_term(entry) for entry in root.need('observations').entries()], source=root.file)
    for key in ('input', 'output'):
        if (word := root.get(key)) is not None:
            setattr(spec, key, word.word())
    if (clip := root.get('action_clip')) is not None:
        spec.action_clip = clip.range()
    if (history := root.get('history')) is not None:
        history.only(('by', 'order', 'begin'))
        for key, choices in (('by', ('term', 'age')), ('order', ('oldest_first', 'newest_first')), ('begin', ('repeat', 'zero'))):
            if (word := history.get(key)) is not None:
                setattr(spec, f'history_{key}', word.word(choices))
    if (phase := root.get('phase')) is not None:
        phase.only(('frequency', 'start', 'advance', 'rest'))
        advance, rest = phase.get('advance'), phase.get('rest')
        spec.phase = Phase(phase.need('frequency').number(0.0, 100.0), phase.need('start').numbers(),
                           'after' if advance is None else advance.word(('before', 'after')),
                           None if rest is None else rest.number(-10.0, 10.0))
    if (commands := root.get('commands')) is not None:
        commands.only(('vx', 'vy', 'wz'))
        spec.commands = {key: entry.range() for key, entry in commands.items()}
    if (motion := root.get('motion')) is not None:
        motion.only(('anchor', 'file'))
        spec.anchor = motion.need('anchor').word()
        if (named := motion.get('file')) is not None:
            spec.motion = str(pathlib.Path(root.file).parent / named.word())
    if (assumed := root.get('assumed')) is not None:
        spec.assumed = [entry.word() for entry in assumed.entries()]
    spec.validate()
    return spec


def load(path: pathlib.Path) -> Spec:
    """SPEC.yaml."""
    return from_map(Field(load_map(path), str(path), ''))


def from_text(text: str, name: str = 'SPEC.yaml') -> Spec:
    return from_map(Field(parse(text, name), name, ''))


def _number(value: float) -> str:
    return f'{value:.9g}'


def _list(values: list[float] | tuple[float, ...]) -> str:
    return '[' + ', '.join(_number(value) for value in values) + ']'


def _word(text: str) -> str:
    return "'" + text.replace("'", "''") + "'" if not text.replace('_', '').replace('-', '').isalnum() else text


def to_text(spec: Spec) -> str:
    """SPEC.yaml.  from_text() of it gives the same specification."""
    lines = [f'# How the policy {spec.name} reads and moves its robot; every key: doc/policy.md', f'spec: {VERSION}',
             f'name: {_word(spec.name)}', f'period: {_number(spec.period)}  # between two actions [s]']
    lines += [f'{key}: {_word(getattr(spec, key))}' for key in ('input', 'output') if getattr(spec, key)]
    if spec.assumed:
        lines += ['assumed:  # what the source does not say: look at these'] + [f'  - {_word(sentence)}' for sentence in spec.assumed]
    if spec.action_clip is not None:
        lines.append(f'action_clip: {_list(spec.action_clip)}')
    if any(term.history > 1 for term in spec.observations):
        lines.append(f'history: {{by: {spec.history_by}, order: {spec.history_order}, begin: {spec.history_begin}}}')
    if spec.phase is not None:
        rest = '' if spec.phase.rest is None else f', rest: {_number(spec.phase.rest)}'
        lines.append(f'phase: {{frequency: {_number(spec.phase.frequency)}, start: {_list(spec.phase.start)}, '
                     f'advance: {spec.phase.advance}{rest}}}')
    if spec.anchor:
        named = f', file: {_word(str(pathlib.Path(spec.motion).resolve()))}' if spec.motion else ''
        lines.append(f'motion: {{anchor: {_word(spec.anchor)}{named}}}')
    if spec.commands:
        lines.append('commands:  # that it was trained for: vx, vy [m/s], wz [rad/s]')
        lines += [f'  {key}: {_list(ends)}' for key, ends in spec.commands.items()]
    lines.append('joints:  # in the order of the network; target = offset (default) + scale * action; SI units')
    for joint in spec.joints:
        parts = [f'name: {_word(joint.name)}'] + [f'{key}: {_number(getattr(joint, key))}' for key in ('default', 'scale', 'kp', 'kd')]
        parts += [f'{key}: {_number(getattr(joint, key))}' for key in ('offset', 'lower', 'upper', 'effort', 'velocity', 'armature', 'friction')
                  if getattr(joint, key) is not None]
        lines.append('  - {' + ', '.join(parts + ([f'clip: {_list(joint.clip)}'] if joint.clip is not None else [])) + '}')
    lines.append('observations:  # in the order of the network')
    for term in spec.observations:
        parts = [f'term: {_word(term.term)}'] + ([f'frame: {_word(term.frame)}'] if term.term in FRAMED else [])
        if any(scale != 1.0 for scale in term.scale):
            parts.append(f'scale: {_number(term.scale[0]) if len(set(term.scale)) == 1 else _list(term.scale)}')
        parts += [f'clip: {_list(term.clip)}'] if term.clip is not None else []
        parts += [f'history: {term.history}'] if term.history > 1 else []
        parts += [f'size: {term.size}'] if term.size else []
        parts += [f'values: {_list(term.values)}'] if term.values else []
        parts += [] if term.relative else ['relative: false']
        parts += [f'period: {_number(term.period)}'] if term.period else []
        parts += [f'joints: [{", ".join(_word(name) for name in term.joints)}]'] if term.joints else []
        lines.append('  - {' + ', '.join(parts) + '}')
    return '\n'.join(lines) + '\n'


def finite_range(low: float, high: float) -> tuple[float, float] | None:
    """None where an end is no number: then nothing is clipped."""
    return (low, high) if math.isfinite(low) and math.isfinite(high) else None
