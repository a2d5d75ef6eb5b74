"""Unitree's deploy.yaml (unitree_rl_lab, unitree_rl_mjlab): gains per motor, defaults, actions and observations per joint of the policy.

stiffness and damping are numbered as motors, default_joint_pos, scale and offset as the network; joint_ids_map ties them together."""
from __future__ import annotations

from .names import anchor_of, motors_of, term_of
from .robot import Robot
from .spec import Joint, Spec
from .yaml_file import Field

RANGES = {'vx': 'lin_vel_x', 'vy': 'lin_vel_y', 'wz': 'ang_vel_z'}


def ranges_of(commands: Field | None) -> dict[str, tuple[float, float]]:
    """vx, vy, wz of the ranges of `base_velocity` (or `twist`), as deploy.yaml and env.yaml write them."""
    found: dict[str, tuple[float, float]] = {}
    for name in ('base_velocity', 'twist'):
        command = commands.get(name) if commands is not None and commands.value else None
        ranges = None if command is None else command.get('limit_ranges') or command.get('ranges')
        for ours, theirs in RANGES.items():
            if ranges is not None and (entry := ranges.get(theirs)) is not None:
                found[ours] = entry.range()
    return found


def read(root: Field, robot: Robot) -> Spec:
    """PolicyError names the field that is missing or does not fit the robot."""
    numbers = [entry.whole(0, 255) for entry in root.need('joint_ids_map').entries()]
    names = motors_of(robot, numbers, root.file)
    motors = max(numbers) + 1
    stiffness, damping = root.need('stiffness').numbers(), root.need('damping').numbers()
    for key, values in (('stiffness', stiffness), ('damping', damping)):
        if len(values) < motors:
            raise root.error(f'{key} has {len(values)} numbers, joint_ids_map goes up to motor {motors - 1}')
    defaults = root.need('default_joint_pos').numbers(len(names))
    actions = root.need('actions').items()
    if len(actions) != 1:
        raise root.error(f'actions: {len(actions)} of them; policies of one JointPositionAction run')
    kind, action = actions[0]
    if kind != 'JointPositionAction':
        raise action.error('only JointPositionAction runs: targets of position')
    scales = action.need('scale').numbers(len(names))
    offset = action.get('offset')
    offsets = defaults if offset is None else offset.numbers(len(names))
    clip = action.get('clip')
    clips = None if clip is None else [entry.range() for entry in clip.entries()]
    if clips is not None and len(clips) != len(names):
        raise action.error(f'clip has {len(clips)} entries, {len(names)} joints are moved')
    joints = [Joint(name, defaults[k], scales[k], stiffness[numbers[k]], damping[numbers[k]],
                    None if offsets[k] == defaults[k] else offsets[k], None if clips is None else clips[k])
              for k, name in enumerate(names)]
    spec = Spec(root.file, root.need('step_dt').number(5e-4, 1.0), joints, [], commands=ranges_of(root.get('commands')), source=root.file)
    observations = root.need('observations')
    gym = observations.get('use_gym_history')
    if gym is not None and gym.flag():
        spec.history_by = 'age'
    scale_first = observations.get('scale_first')
    for name, entry in observations.items():
        if name in ('use_gym_history', 'scale_first'):
            continue
        if 'params' not in entry.mapping() and 'scale' not in entry.mapping():
            raise entry.error('groups of observations are not read; policies of one group run')
        term = term_of(name)
        if (scale := entry.get('scale')) is not None:
            term.scale = scale.numbers()
        if (bounds := entry.get('clip')) is not None:
            term.clip = bounds.range()
            if scale_first is not None and scale_first.flag():
                if len(set(term.scale)) != 1 or term.scale[0] <= 0.0:
                    raise entry.error('scale_first with clip needs one positive scale for all numbers')
                term.clip = (term.clip[0] / term.scale[0], term.clip[1] / term.scale[0])
        if (history := entry.get('history_length')) is not None:
            term.history = max(1, history.whole(0, 1000))
        params = entry.get('params')
        if name == 'joint_pos':
            term.relative = False
        if params is not None and params.value:
            if name == 'generated_commands' and (command := params.get('command_name')) is not None and command.value == 'motion':
                term.term = 'motion_joints'
            if (period := params.get('period')) is not None:
                term.period = period.number(1e-3, 1e3)
            asset = params.get('asset_cfg')
            ids = asset.get('joint_ids') if asset is not None else None
            if ids is not None and isinstance(ids.value, (list, tuple)) and all(isinstance(entry.value, int) for entry in ids.entries()):
                chosen = [entry.whole(0, len(names) - 1) for entry in ids.entries()]
                term.joints = [names[number] for number in chosen]
        if len(set(term.scale)) == 1:
            term.scale = term.scale[:1]
        spec.observations.append(term)
    if spec.follows:
        spec.anchor = anchor_of(robot, root.file)
        spec.assumed.append(f'the anchor of its motion is {spec.anchor}: deploy.yaml does not say it')
    spec.validate()
    return spec
