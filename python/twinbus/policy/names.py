"""What others call the observations, and in which order Unitree numbers the motors of its robots.

Terms of Isaac Lab, unitree_rl_lab, mjlab and holosoma; motor orders as in Unitree's SDK (G1 29, H1 20, Go1, Go2, A1 and B2 12 motors)."""
from __future__ import annotations

from .errors import PolicyError
from .robot import Robot
from .spec import TERMS, UNAVAILABLE, Term

ALIASES = {
    'base_lin_vel': 'base_linear_velocity', 'base_ang_vel': 'base_angular_velocity', 'projected_gravity': 'projected_gravity',
    'velocity_commands': 'velocity_command', 'generated_commands': 'velocity_command', 'command': 'velocity_command',
    'joint_pos': 'joint_position', 'joint_pos_rel': 'joint_position', 'dof_pos': 'joint_position', 'joint_vel': 'joint_velocity',
    'joint_vel_rel': 'joint_velocity', 'dof_vel': 'joint_velocity', 'last_action': 'last_action', 'actions': 'last_action',
    'action': 'last_action', 'gait_phase': 'gait_phase', 'sin_phase': 'phase_sin', 'cos_phase': 'phase_cos',
    'motion_command': 'motion_joints', 'motion_anchor_ori_b': 'motion_orientation', 'motion_ref_ori_b': 'motion_orientation',
    'command_lin_vel': 'command_linear_velocity', 'command_ang_vel': 'command_angular_velocity'}
MOTION_WORDS = ('motion', 'ref_', 'robot_body', 'anchor')
ANCHORS = ('torso_link', 'torso', 'Trunk', 'trunk')  # of tracking policies whose specification does not say theirs

_LEG = ('hip_pitch', 'hip_roll', 'hip_yaw', 'knee', 'ankle_pitch', 'ankle_roll')
_ARM = ('shoulder_pitch', 'shoulder_roll', 'shoulder_yaw', 'elbow', 'wrist_roll', 'wrist_pitch', 'wrist_yaw')
MOTORS = {
    'G1': [f'{side}_{part}_joint' for side in ('left', 'right') for part in _LEG] + [f'waist_{part}_joint' for part in ('yaw', 'roll', 'pitch')]
          + [f'{side}_{part}_joint' for side in ('left', 'right') for part in _ARM],
    'Go1, Go2': [f'{leg}_{part}_joint' for leg in ('FR', 'FL', 'RR', 'RL') for part in ('hip', 'thigh', 'calf')],
    'H1': ['right_hip_roll_joint', 'right_hip_pitch_joint', 'right_knee_joint', 'left_hip_roll_joint', 'left_hip_pitch_joint',
           'left_knee_joint', 'torso_joint', 'left_hip_yaw_joint', 'right_hip_yaw_joint', '', 'left_ankle_joint', 'right_ankle_joint',
           'right_shoulder_pitch_joint', 'right_shoulder_roll_joint', 'right_shoulder_yaw_joint', 'right_elbow_joint',
           'left_shoulder_pitch_joint', 'left_shoulder_roll_joint', 'left_shoulder_yaw_joint', 'left_elbow_joint']}


def term_of(name: str, function: str = '') -> Term:
    """Our term for somebody's: by its function where one is said, else by its name.  Unknown ones keep their name, and are refused later."""
    known = function.rsplit(':', 1)[-1].rsplit('.', 1)[-1] if function else name
    for word in (known, name):
        if word in ALIASES:
            return Term(ALIASES[word], relative=word != 'joint_pos' or not function)
    for word in (known, name):
        if word.startswith(MOTION_WORDS) and word not in TERMS:
            return Term('motion:' + word)
        if word.startswith(('height_scan', *UNAVAILABLE)):
            return Term(word)
    return Term(known)


def anchor_of(robot: Robot, where: str) -> str:
    """The link that tracking policies compare, where nothing says it."""
    links = {joint.child for joint in robot.joints}
    found = next((name for name in ANCHORS if name in links), '')
    if not found:
        raise PolicyError(f'{where}: a policy that follows a motion, and nothing says which link is its anchor; write a SPEC.yaml with '
                          '`motion: {anchor: LINK}` (doc/policy.md)')
    return found


def motors_of(robot: Robot, numbers: list[int], where: str) -> list[str]:
    """Joint names of motor numbers: by the table whose joints this robot has."""
    problems = []
    for model, table in MOTORS.items():
        if max(numbers, default=0) >= len(table):
            problems.append(f'{model} has {len(table)} motors')
            continue
        names = [table[number] for number in numbers]
        missing = [name for name in names if name not in robot.by_name]
        if not missing:
            return names
        problems.append(f'{robot.name} has no joint {missing[0] or "of motor 9"!r} of {model}')
    raise PolicyError(f'{where}: joint_ids_map numbers motors, and no table of motors fits the robot: {"; ".join(problems)}; '
                      'write a SPEC.yaml with names (doc/policy.md)')
