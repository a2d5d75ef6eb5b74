"""Specifications that an ONNX file carries in its metadata: exports of mjlab, and of holosoma.

mjlab writes joint_names, joint_stiffness, joint_damping, default_joint_pos, action_scale and observation_names (separated by commas).
holosoma writes dof_names, kp, kd and command_ranges (JSON); what it does not write is the convention of its locomotion policies."""
from __future__ import annotations

import json
import math
import xml.etree.ElementTree as xml
from typing import Any, Mapping

from .errors import PolicyError
from .names import term_of
from .spec import Joint, Phase, Spec, Term
from .yaml_file import Field

# Of holosoma's locomotion policies: postures [rad] by what a joint's name holds, scales of observations; G1 and T1 differ in both.
HOLOSOMA = {
    'left_hip_pitch_joint': ({'hip_pitch': -0.312, 'knee': 0.669, 'ankle_pitch': -0.363, 'shoulder_pitch': 0.2, 'left_shoulder_roll': 0.2,
                              'right_shoulder_roll': -0.2, 'elbow': 0.6}, {'base_ang_vel': 0.25, 'dof_vel': 0.05}),
    'Left_Hip_Pitch': ({'Hip_Pitch': -0.2, 'Knee_Pitch': 0.4, 'Ankle_Pitch': -0.25, 'Shoulder_Pitch': 0.2, 'Left_Shoulder_Roll': -1.35,
                        'Right_Shoulder_Roll': 1.35, 'Left_Elbow_Yaw': -0.5, 'Right_Elbow_Yaw': 0.5}, {'dof_vel': 0.1})}
HOLOSOMA_ANCHOR = 'torso_link'  # of its tracking policies
HOLOSOMA_TRACKING = ('actions', 'base_ang_vel', 'dof_pos', 'dof_vel', 'motion_command', 'motion_ref_ori_b')
# of one age, sorted by name as holosoma sorts them
HOLOSOMA_TERMS = ('actions', 'base_ang_vel', 'command_ang_vel', 'command_lin_vel', 'cos_phase', 'dof_pos', 'dof_vel', 'projected_gravity',
                  'sin_phase')


def _list(metadata: Mapping[str, str], key: str, where: str) -> list[str]:
    if key not in metadata:
        raise PolicyError(f'{where}: its metadata has no {key}')
    text = metadata[key].strip()
    if text.startswith('['):
        try:
            found = json.loads(text)
        except (ValueError, RecursionError):
            raise PolicyError(f'{where}: metadata {key} is no list') from None
        return [str(entry) for entry in found]
    return [entry.strip() for entry in text.split(',')]


def _numbers(metadata: Mapping[str, str], key: str, count: int, where: str) -> list[float]:
    words: list[Any] = _list(metadata, key, where)
    if not words:
        raise PolicyError(f'{where}: metadata {key} is empty')
    return Field(words if len(words) > 1 else words[0], where, f'metadata {key}').numbers(count)


def read(metadata: Mapping[str, str], where: str, observations: int) -> Spec | None:
    """None when the metadata is none of these.  observations: size of the network's input."""
    if 'joint_names' in metadata and 'joint_stiffness' in metadata:
        return _mjlab(metadata, where)
    if 'dof_names' in metadata and 'kp' in metadata:
        return _holosoma(metadata, where, observations)
    return None


def _mjlab(metadata: Mapping[str, str], where: str) -> Spec:
    names = _list(metadata, 'joint_names', where)
    kp, kd = _numbers(metadata, 'joint_stiffness', len(names), where), _numbers(metadata, 'joint_damping', len(names), where)
    defaults, scales = _numbers(metadata, 'default_joint_pos', len(names), where), _numbers(metadata, 'action_scale', len(names), where)
    joints = [Joint(name, defaults[k], scales[k], kp[k], kd[k]) for k, name in enumerate(names)]
    # `command` of a tracking policy, which says its anchor, is the motion.
    anchor = metadata.get('anchor_body_name', '').strip()
    terms = [Term('motion_joints') if anchor and name == 'command' else term_of(name) for name in _list(metadata, 'observation_names', where)]
    spec = Spec(where, 0.02, joints, terms, source=f'{where} (metadata of mjlab)', anchor=anchor)
    spec.assumed = ['a new action every 0.02 s: mjlab does not write its period', 'observations are not scaled: mjlab does not write scales']
    spec.validate()
    return spec


def _holosoma(metadata: Mapping[str, str], where: str, observations: int) -> Spec:
    names = _list(metadata, 'dof_names', where)
    kp, kd = _numbers(metadata, 'kp', len(names), where), _numbers(metadata, 'kd', len(names), where)
    posture, scales = next((entry for name, entry in HOLOSOMA.items() if name in names), (None, None))
    if posture is None or scales is None:
        raise PolicyError(f'{where}: holosoma writes no default angles into its metadata, and its convention is known for G1 and T1 only; '
                          f'write a SPEC.yaml (./twinbus policy {where} --propose --robot ROBOT begins one)')

    def default(name: str) -> float:
        return next((angle for part, angle in posture.items() if part in name), 0.0)
    joints = [Joint(name, default(name), 0.25, kp[k], kd[k]) for k, name in enumerate(names)]
    terms = []
    for name in HOLOSOMA_TERMS:
        term = term_of(name)
        term.scale = [scales.get(name, 1.0)]
        terms.append(term)
    spec = Spec(where, 0.02, joints, terms, action_clip=(-100.0, 100.0), history_begin='zero',
                phase=Phase(1.0, [0.0, math.pi], 'before', math.pi), source=f'{where} (metadata of holosoma)')
    spec.assumed = ['default angles, scales (action 0.25), order of observations, gait of 1 Hz and 50 actions a second are those of '
                    'holosoma\'s locomotion policies: the metadata does not have them']
    if observations != spec.observation_size():
        if observations == 5 * len(names) + 9:  # tracking
            _tracks(metadata, spec, where)
        else:
            raise PolicyError(f'{where}: a locomotion policy of holosoma with {len(names)} joints reads {spec.observation_size()} numbers, '
                              f'this one {observations}: what they are is not in its metadata; write a SPEC.yaml (doc/policy.md)')
    try:
        ranges = json.loads(metadata.get('command_ranges', 'null') or 'null')
    except (ValueError, RecursionError):
        raise PolicyError(f'{where}: metadata command_ranges is no JSON; write a SPEC.yaml (doc/policy.md)') from None
    if isinstance(ranges, dict):
        field = Field(ranges, where, 'metadata command_ranges')
        for ours, theirs in (('vx', 'lin_vel_x'), ('vy', 'lin_vel_y'), ('wz', 'ang_vel_yaw')):
            if (entry := field.get(theirs)) is not None:
                spec.commands[ours] = entry.range()
    spec.validate()
    return spec


def _tracks(metadata: Mapping[str, str], spec: Spec, where: str) -> None:
    """A tracking policy of holosoma: an action of 1 is a quarter of the effort limit over kp, of the URDF in the metadata."""
    spec.observations, spec.phase, spec.anchor = [term_of(name) for name in HOLOSOMA_TRACKING], None, HOLOSOMA_ANCHOR
    scales = [] if 'action_scale' not in metadata else _numbers(metadata, 'action_scale', len(spec.joints), where)
    try:
        text = json.loads(metadata.get('robot_urdf', '""'))
        urdf = xml.fromstring((text or '<none/>') if isinstance(text, str) else '')
        efforts = {joint.get('name', ''): float(limit.get('effort', 'nan')) for joint in urdf.iter('joint') for limit in joint.findall('limit')}
    except (ValueError, RecursionError, xml.ParseError):
        raise PolicyError(f'{where}: metadata robot_urdf is no URDF; write a SPEC.yaml (doc/policy.md)') from None
    for number, joint in enumerate(spec.joints):
        effort = efforts.get(joint.name, math.nan)
        joint.effort = effort if math.isfinite(effort) else None
        if not scales and (joint.effort is None or not joint.effort > 0.0 or joint.kp == 0.0):
            raise PolicyError(f'{where}: its metadata has neither action_scale nor an effort limit of {joint.name}')
        joint.scale = scales[number] if scales else 0.25 * (joint.effort or 0.0) / joint.kp
    spec.assumed = ['default angles, order of observations, anchor torso_link and 50 actions a second are those of holosoma\'s tracking policies: '
                    'the metadata does not have them']
