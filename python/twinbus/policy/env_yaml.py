"""Isaac Lab's env.yaml: the configuration of the training.  Names are patterns; joints are numbered level by level from the base."""
from __future__ import annotations

import re

from .deploy_yaml import ranges_of
from .names import anchor_of, term_of
from .robot import Robot
from .spec import Joint, Spec
from .yaml_file import Field

NOT_A_TERM = ('concatenate_terms', 'concatenate_dim', 'enable_corruption', 'history_length', 'flatten_history_dim', 'nan_policy',
              'nan_check_per_term')
JOINT_VALUES = {'stiffness': 'kp', 'damping': 'kd', 'effort_limit_sim': 'effort', 'effort_limit': 'effort', 'velocity_limit_sim': 'velocity',
                'velocity_limit': 'velocity', 'armature': 'armature'}


def by_pattern(field: Field | None, name: str) -> float | None:
    """A value for a joint: one number for all, or a map from patterns.  None: not said."""
    if field is None:
        return None
    if not isinstance(field.value, dict):
        return field.number()
    for pattern, entry in field.items():
        try:
            if re.fullmatch(pattern, name):
                return entry.number()
        except re.error:
            raise field.error(f'{pattern!r} is no pattern') from None
    return None


def _matches(patterns: list[str], name: str) -> bool:
    return any(re.fullmatch(pattern, name) for pattern in patterns)


def read(root: Field, robot: Robot) -> Spec:
    """PolicyError names the field that is missing or does not fit the robot."""
    scene = root.need('scene').need('robot')
    values: dict[str, dict[str, float]] = {}
    for _, actuator in scene.need('actuators').items():
        patterns = [entry.word() for entry in actuator.need('joint_names_expr').entries()]
        for name in robot.names():
            if not _matches(patterns, name):
                continue
            found = values.setdefault(name, {})
            for theirs, ours in JOINT_VALUES.items():
                value = by_pattern(actuator.get(theirs), name)
                if value is not None:
                    found.setdefault(ours, value)
    if (sdk := scene.get('joint_sdk_names')) is not None:  # of unitree_rl_lab: the joints that the trained robot has
        there = {str(entry.value) for entry in sdk.entries()}
        values = {name: value for name, value in values.items() if name in there}
    order = robot.breadth_first(set(values))
    if not order:
        raise scene.error(f'no actuator moves a joint of {robot.name} ({", ".join(robot.names()[:3])}, ...)')
    actions = root.need('actions').items()
    if len(actions) != 1:
        raise root.error(f'actions: {len(actions)} of them; policies of one action on positions run')
    _, action = actions[0]
    if 'JointPositionAction' not in str(action.mapping().get('class_type')):
        raise action.error(f'{action.mapping().get("class_type")}: only JointPositionAction runs: targets of position')
    patterns = [entry.word() for entry in action.need('joint_names').entries()]
    preserve = action.get('preserve_order')
    if preserve is not None and preserve.flag():
        moved = [name for pattern in patterns for name in order if re.fullmatch(pattern, name)]
    else:
        moved = [name for name in order if _matches(patterns, name)]
    if set(moved) != set(order):
        raise action.error(f'it moves {len(moved)} of {len(order)} joints; policies that move all of their joints run')
    init, use_default = scene.need('init_state').need('joint_pos'), action.get('use_default_offset')
    joints, clip = [], action.get('clip')
    for name in moved:
        found, default = values[name], by_pattern(init, name) or 0.0
        if 'kp' not in found or 'kd' not in found:
            raise scene.error(f'actuators: no stiffness or damping of {name}')
        scale, offset = by_pattern(action.need('scale'), name), by_pattern(action.get('offset'), name)
        ends = None
        if clip is not None:
            ends = next((entry.range() for pattern, entry in clip.items() if re.fullmatch(pattern, name)), None)
        joints.append(Joint(name, default, 1.0 if scale is None else scale, found['kp'], found['kd'],
                            None if use_default is None or use_default.flag() else offset or 0.0, ends, effort=found.get('effort'),
                            velocity=found.get('velocity'), armature=found.get('armature')))
    period = root.need('sim').need('dt').number(1e-5, 0.1) * root.need('decimation').whole(1, 1000)
    spec = Spec(root.file, period, joints, [], commands=ranges_of(root.get('commands')), source=root.file)
    spec.assumed.append('joints are numbered level by level from the base, children in the order of our URDF; Isaac Lab takes that of its USD')
    groups = root.need('observations')
    group = groups.get('policy') or groups.get('actor')
    if group is None:
        raise groups.error('no group `policy`')
    common = group.get('history_length')
    for name, entry in group.items():
        if name in NOT_A_TERM or not isinstance(entry.value, dict):
            continue
        function = entry.need('func').word()
        term = term_of(name, function)
        if (scales := entry.get('scale')) is not None:
            term.scale = scales.numbers()
        if (bounds := entry.get('clip')) is not None:
            term.clip = bounds.range()
        history = entry.get('history_length')
        term.history = max(1, (history.whole(0, 1000) if history is not None else 0) or (common.whole(0, 1000) if common is not None else 0))
        params = entry.get('params')
        if params is not None and params.value and (clock := params.get('period')) is not None:
            term.period = clock.number(1e-3, 1e3)
        if params is not None and params.value and term.term == 'velocity_command' and (command := params.get('command_name')) is not None \
                and command.value == 'motion':
            term.term = 'motion_joints'
        spec.observations.append(term)
    if spec.follows:
        motion = root.need('commands').get('motion')
        said = None if motion is None else motion.get('anchor_body_name') or motion.get('anchor_body')
        spec.anchor = anchor_of(robot, root.file) if said is None else said.word()
    spec.validate()
    return spec
