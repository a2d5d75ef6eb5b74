#!/usr/bin/env python3
"""Policies: the readers of their specifications, their observations, what checks find, and who commands them; no bus, no simulator.

Needs numpy and PyYAML, and onnxruntime for the parts that run a network ($TWINBUS_POLICY_PYTHON names a Python that has them)."""
import contextlib
import copy
import io
import math
import os
import pathlib
import sys
import tempfile
import threading
import time
import unittest
from types import SimpleNamespace
from unittest import mock

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parents[1] / 'python'), str(HERE)]
other = os.environ.get('TWINBUS_POLICY_PYTHON')
if other and sys.executable != other and not os.environ.get('TWINBUS_POLICY_RUNS'):
    os.execve(other, [other, *sys.argv], dict(os.environ, TWINBUS_POLICY_RUNS='1'))
try:
    import numpy as np
    import yaml  # noqa: F401
except ImportError as error:
    print(f'skipped: {error.name} is missing; set TWINBUS_POLICY_PYTHON to a Python that has numpy, pyyaml and onnxruntime')
    sys.exit(77)
try:
    import onnxruntime  # noqa: F401
    RUNS = True
except ImportError:
    RUNS = False

import tiny_onnx  # noqa: E402
import twinbus  # noqa: E402
from twinbus import messages  # noqa: E402
from twinbus.policy import (answer_map, check, command_line, controller, deploy_yaml, env_yaml, find, metadata, mirror, model_text, robot,  # noqa: E402
                            runner, spec, suspects, trial)
from twinbus.policy.errors import PolicyError, Refused  # noqa: E402
from twinbus.policy.observation import Measured, Observation  # noqa: E402
from twinbus.policy.operator import Operator  # noqa: E402
from twinbus.policy.yaml_file import Field, parse  # noqa: E402

LEGS = ('FR', 'FL', 'RR', 'RL')


def quadruped(imu='imu'):
    """A trunk with an IMU turned by 90 degrees about z, four legs of three joints, in Unitree's order."""
    parts = ['<robot name="dog"><link name="trunk"/><link name="imu"/>',
             '<joint name="imu_joint" type="fixed"><origin xyz="0.1 0 0" rpy="0 0 1.5707963267948966"/><parent link="trunk"/>'
             '<child link="imu"/></joint>']
    for leg in LEGS:
        parent = 'trunk'
        for part, axis, low, high in (('hip', '1 0 0', -0.9, 0.9), ('thigh', '0 1 0', -0.7, 4.5), ('calf', '0 1 0', -2.8, -0.9)):
            parts.append(f'<link name="{leg}_{part}"/><joint name="{leg}_{part}_joint" type="revolute"><parent link="{parent}"/>'
                         f'<child link="{leg}_{part}"/><axis xyz="{axis}"/><limit lower="{low}" upper="{high}" effort="24" velocity="30"/></joint>')
            parent = f'{leg}_{part}'
    servos = [{'joints': [f'{leg}_{part}_joint' for leg in LEGS for part in ('hip', 'thigh', 'calf')], 'kp': 100, 'kd': 4, 'rotor_inertia': 0.005}]
    return robot.from_texts(''.join(parts) + '</robot>', '', {'imu': imu, 'period': 0.002, 'servos': servos})


def trot():
    """A specification for it without a fault."""
    joints = []
    for leg in LEGS:
        side = -1.0 if leg[1] == 'L' else 1.0
        for part, default in (('hip', 0.1 * side), ('thigh', 0.9), ('calf', -1.8)):
            low, high = {'hip': (-0.9, 0.9), 'thigh': (-0.7, 4.5), 'calf': (-2.8, -0.9)}[part]
            joints.append(spec.Joint(f'{leg}_{part}_joint', default, 0.25, 35.0, 0.5, lower=low, upper=high, effort=24.0, armature=0.005))
    terms = [spec.Term('base_angular_velocity', 'base', [0.25]), spec.Term('projected_gravity', 'base'), spec.Term('velocity_command'),
             spec.Term('joint_position'), spec.Term('joint_velocity', scale=[0.05]), spec.Term('last_action')]
    return spec.Spec('trot', 0.02, joints, terms, commands={'vx': (-1.0, 1.0), 'vy': (-0.5, 0.5), 'wz': (-1.0, 1.0)})


def sizes(reads=45, moves=12):
    return SimpleNamespace(observation_size=reads, action_size=moves)


def still(count=12, **other):
    values = dict(q=np.zeros(count), qd=np.zeros(count), attitude=np.array([1.0, 0, 0, 0]), gyro=np.zeros(3), base_velocity=None)
    return Measured(**{**values, **other})


DEPLOY = '''
joint_ids_map: [3, 4, 5, 0, 1, 2, 9, 10, 11, 6, 7, 8]
step_dt: 0.02
stiffness: [25, 26, 27, 25, 26, 27, 25, 26, 27, 25, 26, 27]
damping: [0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5]
default_joint_pos: [-0.1, 0.8, -1.5, 0.1, 0.8, -1.5, -0.1, 1.0, -1.5, 0.1, 1.0, -1.5]
commands: {base_velocity: {ranges: {lin_vel_x: [-0.5, 1.0], lin_vel_y: [-0.3, 0.3], ang_vel_z: [-0.2, 0.2], heading: null}}}
actions:
  JointPositionAction: {clip: null, joint_names: [.*], scale: 0.25, offset: null, joint_ids: !!python/object/apply:builtins.slice [null, null, null]}
observations:
  base_ang_vel: {params: {}, clip: [-100, 100], scale: [0.2, 0.2, 0.2], history_length: 5}
  projected_gravity: {params: {}, clip: null, scale: [1.0, 1.0, 1.0], history_length: 5}
  velocity_commands: {params: {command_name: base_velocity}, clip: null, scale: [1.0, 1.0, 1.0], history_length: 5}
  joint_pos_rel: {params: {}, clip: null, scale: null, history_length: 5}
  joint_vel_rel: {params: {}, clip: null, scale: 0.05, history_length: 5}
  last_action: {params: {}, clip: null, scale: 1.0, history_length: 5}
  gait_phase: {params: {period: 0.8}, clip: null, scale: 1.0, history_length: 5}
'''
ENV = '''
sim: {dt: 0.005, gravity: !!python/tuple [0.0, 0.0, -9.81]}
decimation: 4
scene:
  robot:
    init_state: {joint_pos: {.*L_hip_joint: -0.1, .*R_hip_joint: 0.1, ".*_thigh_joint": 0.8, ".*_calf_joint": -1.5}}
    actuators:
      legs: {joint_names_expr: [".*_hip_joint", ".*_thigh_joint", ".*_calf_joint"], effort_limit: 23.5, velocity_limit: 30.0,
             stiffness: {.*_hip_joint: 20.0, ".*_(thigh|calf)_joint": 25.0}, damping: 0.5, armature: 0.005, friction: null}
actions:
  joint_pos: {class_type: "@MDP.actions.joint_actions:JointPositionAction", clip: null, joint_names: [".*"],
              scale: {".*_hip_joint": 0.125, ".*_(thigh|calf)_joint": 0.25}, offset: 0.0, preserve_order: false, use_default_offset: true}
observations:
  policy:
    concatenate_terms: true
    history_length: null
    base_lin_vel: {func: "@MDP.observations:base_lin_vel", params: {}, noise: null, clip: null, scale: null, history_length: 0}
    velocity: {func: "@MDP.observations:generated_commands", params: {command_name: base_velocity}, clip: null, scale: null}
    joints: {func: "@MDP.observations:joint_pos_rel", params: {}, clip: !!python/tuple [-3.0, 3.0], scale: null}
commands: {base_velocity: {ranges: {lin_vel_x: !!python/tuple [-1.0, 2.0], lin_vel_y: [-0.5, 0.5], ang_vel_z: [-1.0, 1.0]}}}
'''.replace('@MDP', '.'.join(('isaaclab', 'envs', 'mdp')))


class Readers(unittest.TestCase):
    def field(self, text, name='f.yaml'):
        return Field(parse(text, name), name, '')

    def test_deploy_yaml(self):
        found = deploy_yaml.read(self.field(DEPLOY), quadruped())
        self.assertEqual(found.names()[:3], ['FL_hip_joint', 'FL_thigh_joint', 'FL_calf_joint'])
        self.assertEqual((found.joints[2].kp, found.joints[2].default, found.joints[2].scale), (27.0, -1.5, 0.25))
        self.assertEqual(found.observation_size(), 5 * (3 + 3 + 3 + 12 + 12 + 12 + 2))
        self.assertEqual((found.period, found.commands['vx']), (0.02, (-0.5, 1.0)))
        self.assertEqual((found.observations[0].clip, found.observations[0].scale, found.observations[-1].period), ((-100.0, 100.0), [0.2], 0.8))

    def test_deploy_yaml_says_what_is_wrong(self):
        for old, new, said in (('step_dt: 0.02', 'step_dt: fast', 'step_dt'), ('[3, 4, 5,', '[3, 4, 77,', 'motors'),
                               ('stiffness: [25, 26, 27, 25, 26, 27, 25, 26, 27, 25, 26, 27]', 'stiffness: [25]', 'stiffness has 1'),
                               ('JointPositionAction:', 'JointEffortAction:', 'only JointPositionAction'),
                               ('projected_gravity:', 'foot_heights:', "no observation 'foot_heights'"),
                               ('default_joint_pos: [-0.1,', 'default_joint_pos: [.nan,', 'default_joint_pos'),
                               ('scale: 0.25', 'scale: [1, 2]', 'scale: 2 numbers')):
            self.assertIn(old, DEPLOY)
            with self.assertRaisesRegex(PolicyError, said):
                deploy_yaml.read(self.field(DEPLOY.replace(old, new)), quadruped())

    def test_deploy_yaml_of_a_motion_without_an_anchor(self):
        with self.assertRaisesRegex(PolicyError, 'which link is its anchor'):
            deploy_yaml.read(self.field(DEPLOY.replace('velocity_commands', 'motion_command')), quadruped())

    def test_deploy_yaml_that_reads_where_its_robot_is_beside_a_motion_is_refused(self):
        with self.assertRaisesRegex(Refused, 'no robot measures'):
            deploy_yaml.read(self.field(DEPLOY.replace('velocity_commands', 'motion_anchor_pos_b')), quadruped())

    def test_env_yaml(self):
        found = env_yaml.read(self.field(ENV), quadruped())
        self.assertEqual(found.names()[:5], ['FR_hip_joint', 'FL_hip_joint', 'RR_hip_joint', 'RL_hip_joint', 'FR_thigh_joint'])
        by_name = {joint.name: joint for joint in found.joints}
        self.assertEqual((by_name['FL_hip_joint'].default, by_name['FL_hip_joint'].scale, by_name['FL_hip_joint'].kp), (-0.1, 0.125, 20.0))
        self.assertEqual((by_name['RR_calf_joint'].default, by_name['RR_calf_joint'].effort), (-1.5, 23.5))
        self.assertEqual((found.period, found.observation_size(), found.observations[2].clip), (0.02, 18, (-3.0, 3.0)))
        self.assertEqual(found.commands['vx'], (-1.0, 2.0))

    def test_env_yaml_of_another_robot(self):
        with self.assertRaisesRegex(PolicyError, 'no actuator moves a joint of dog'):
            env_yaml.read(self.field(ENV.replace('_hip_joint"', '_hop"').replace('_thigh_joint"', '_t"').replace('_calf_joint"', '_c"')), quadruped())

    def test_metadata_of_mjlab(self):
        names = [f'{leg}_{part}_joint' for leg in LEGS for part in ('hip', 'thigh', 'calf')]
        keys = {'joint_names': ','.join(names), 'joint_stiffness': ','.join(['20.000'] * 12), 'joint_damping': ','.join(['1.000'] * 12),
                'default_joint_pos': ','.join(['0.100', '0.900', '-1.800'] * 4), 'action_scale': '0.5', 'command_names': 'twist',
                'observation_names': 'base_lin_vel,base_ang_vel,projected_gravity,joint_pos,joint_vel,actions,command'}
        found = metadata.read(keys, 'm.onnx', 48)
        self.assertEqual((found.observation_size(), found.joints[1].default, found.joints[1].scale), (48, 0.9, 0.5))
        self.assertTrue(any('0.02 s' in sentence for sentence in found.assumed))
        with self.assertRaisesRegex(PolicyError, '11 numbers, 12 are needed'):
            metadata.read(dict(keys, joint_damping=','.join(['1'] * 11)), 'm.onnx', 48)

    def test_metadata_of_holosoma(self):
        names = [f'{side}_{part}_joint' for side in ('left', 'right') for part in ('hip_pitch', 'knee', 'ankle_pitch', 'shoulder_roll')]
        keys = {'dof_names': str(names).replace("'", '"'), 'kp': str([40.0] * 8), 'kd': str([2.0] * 8),
                'command_ranges': '{"lin_vel_x": [-1.0, 1.0], "heading": [-3.14, 3.14]}'}
        found = metadata.read(keys, 'm.onnx', 37)
        self.assertEqual([joint.default for joint in found.joints], [-0.312, 0.669, -0.363, 0.2, -0.312, 0.669, -0.363, -0.2])
        self.assertEqual([term.term for term in found.observations][:4], ['last_action', 'base_angular_velocity', 'command_angular_velocity',
                                                                         'command_linear_velocity'])
        self.assertEqual((found.phase.rest, found.commands), (math.pi, {'vx': (-1.0, 1.0)}))
        with self.assertRaisesRegex(PolicyError, 'reads 37 numbers'):
            metadata.read(keys, 'm.onnx', 38)
        with self.assertRaisesRegex(PolicyError, 'known for G1 and T1 only'):
            metadata.read(dict(keys, dof_names='["a","b","c","d","e","f","g","h"]'), 'm.onnx', 37)
        self.assertIsNone(metadata.read({'producer': 'x'}, 'm.onnx', 3))

    def test_own_specification_round_trip(self):
        one = trot()
        one.phase = spec.Phase(1.5, [0.0, math.pi], 'before', math.pi)
        one.observations += [spec.Term('phase_cos', history=2), spec.Term('constant', values=[0.3]), spec.Term('gait_phase', period=0.8),
                             spec.Term('joint_position', joints=['FR_hip_joint'], relative=False, clip=(-1.0, 1.0))]
        one.joints[0].offset, one.joints[0].clip, one.action_clip = 0.2, (-0.5, 0.5), (-10.0, 10.0)
        text = spec.to_text(one)
        again = spec.from_text(text)
        self.assertEqual(spec.to_text(again), text)
        again.source = one.source
        self.assertEqual(again.joints, one.joints)
        self.assertEqual(again.observations, one.observations)

    def test_specifications_of_the_two_policies_of_others_are_read(self):
        for name, reads, moves in (('g1_playground', 103, 29), ('go1_playground', 48, 12)):
            found = spec.load(HERE / f'policies/{name}.spec.yaml')
            self.assertEqual((found.observation_size(), len(found.joints)), (reads, moves))

    def test_own_specification_says_what_is_wrong(self):
        text = spec.to_text(trot())
        for old, new, said in (('spec: 1', 'spec: 7', 'spec 7 is not read'), ('period: 0.02', 'period: 0', 'period'),
                               ('kp: 35', 'kp: .inf', r'joints\[0\].kp'), ('kp: 35', 'stiffness: 35', 'no key .stiffness. is known'),
                               ('scale: 0.05', 'scale: [1, 2]', '2 scales for 12'), ('FL_hip_joint', 'FR_hip_joint', 'stands there twice'),
                               ('term: last_action', 'term: height_scan', 'heights of the ground'),
                               ('term: last_action', 'term: phase_sin', 'needs `phase`')):
            self.assertIn(old, text)
            with self.assertRaisesRegex(PolicyError, said):
                spec.from_text(text.replace(old, new, 1))

    def test_numbers_that_are_none_are_no_specification(self):
        for key, value, said in (('default', math.nan, 'default of FR_thigh_joint is not'), ('scale', math.inf, 'scale of FR_thigh_joint is not'),
                                 ('kp', math.nan, 'kp of FR_thigh_joint is not'), ('kd', math.inf, 'kd of FR_thigh_joint is not'),
                                 ('offset', -math.inf, 'offset of FR_thigh_joint is not'), ('kd', -0.5, 'kd of FR_thigh_joint is below zero')):
            one = trot()
            setattr(one.joints[1], key, value)
            with self.assertRaisesRegex(PolicyError, said):
                one.validate()

    def test_hostile_yaml(self):
        for text, said in (('a: &x [1]\nb: *x', 'references'), ('[1, 2]', 'not a map'), ('a: [', 'no YAML'), ('a: ' + '[' * 3000, 'no YAML'),
                           ('', 'not a map')):
            with self.assertRaisesRegex(PolicyError, said):
                parse(text, 'f.yaml')
        with tempfile.TemporaryDirectory() as folder:  # tags of Python objects construct nothing
            mark = pathlib.Path(folder) / 'made'
            found = parse(f'a: !!python/object/apply:os.mkdir ["{mark}"]', 'f.yaml')
            self.assertEqual(found, {'a': [str(mark)]})
            self.assertFalse(mark.exists())


class Observations(unittest.TestCase):
    def test_order_clip_scale(self):
        one = trot()
        one.observations = [spec.Term('joint_position', clip=(-0.5, 0.5), scale=[2.0]), spec.Term('velocity_command', scale=[1.0, 2.0, 3.0])]
        q = np.array([joint.default for joint in one.joints])
        q[3] += 0.2
        q[4] -= 5.0
        found = Observation(one, quadruped()).build(still(q=q), np.array([0.1, 0.2, 0.3]))
        self.assertTrue(np.allclose(found[3:5], [0.4, -1.0]))
        self.assertTrue(np.allclose(found[12:], [0.1, 0.4, 0.9]))

    def test_joints_are_bound_by_name(self):
        one, dog = trot(), quadruped()
        one.joints.reverse()
        one.observations = [spec.Term('joint_velocity')]
        self.assertTrue(np.allclose(Observation(one, dog).build(still(qd=np.arange(12.0)), np.zeros(3)), np.arange(12.0)[::-1]))
        one.joints[0].name = 'tail'
        with self.assertRaisesRegex(PolicyError, 'no joint tail'):
            Observation(one, dog)

    def test_frames(self):
        one, dog = trot(), quadruped()  # the IMU is turned by 90 degrees about z, 0.1 m before the base
        pitch = 0.3
        attitude = np.array([math.cos(0.15), 0.0, math.sin(0.15), 0.0])  # of the IMU: about its own y, which is -x of the base
        one.observations = [spec.Term('projected_gravity', 'imu'), spec.Term('projected_gravity', 'base'),
                            spec.Term('base_angular_velocity', 'base'), spec.Term('base_linear_velocity', 'imu')]
        found = Observation(one, dog).build(still(attitude=attitude, gyro=np.array([0.0, 0.0, 2.0]), base_velocity=np.array([1.0, 0.0, 0.0])),
                                            np.zeros(3))
        self.assertTrue(np.allclose(found[:3], [math.sin(pitch), 0.0, -math.cos(pitch)]))
        self.assertTrue(np.allclose(found[3:6], [0.0, math.sin(pitch), -math.cos(pitch)]))
        self.assertTrue(np.allclose(found[6:9], [0.0, 0.0, 2.0]))
        self.assertTrue(np.allclose(found[9:], [0.2, -1.0, 0.0]))  # 1 m/s forward is -y of the IMU; turning adds 2 * 0.1 along its x

    def test_imu_at_a_place_in_a_link(self):
        named, placed = quadruped(), quadruped({'frame': 'trunk', 'at': [0.1, 0, 0], 'rpy': [0, 0, math.pi / 2]})
        zero = np.zeros(12)
        one, other = named.motion(named.imu, zero, zero), placed.motion(placed.imu, zero, zero)
        self.assertTrue(np.allclose(one.rotation, other.rotation) and np.allclose(one.place, other.place))
        self.assertEqual(named.names(), placed.names())

    def test_frame_behind_a_moving_joint(self):
        dog = quadruped()
        q, qd = np.zeros(12), np.zeros(12)
        q[0], qd[0] = 0.5, 3.0
        there = dog.motion('FR_hip', q, qd)
        self.assertTrue(np.allclose(there.rotation, robot.about(np.array([1.0, 0, 0]), 0.5)))
        self.assertTrue(np.allclose(there.turning, [3.0, 0.0, 0.0]))

    def test_history(self):
        one = trot()
        one.observations = [spec.Term('velocity_command', history=3), spec.Term('joint_velocity', history=3)]
        for by, order, begin, expected in (('term', 'oldest_first', 'repeat', [1, 1, 2]), ('term', 'newest_first', 'repeat', [2, 1, 1]),
                                           ('term', 'oldest_first', 'zero', [0, 1, 2])):
            one.history_by, one.history_order, one.history_begin = by, order, begin
            made = Observation(one, quadruped())
            made.build(still(), np.array([1.0, 0, 0]))
            self.assertEqual(list(made.build(still(), np.array([2.0, 0, 0]))[0:9:3]), expected)
        one.history_by = 'age'
        made = Observation(one, quadruped())
        made.build(still(), np.array([1.0, 0, 0]))
        self.assertEqual(list(made.build(still(), np.array([2.0, 0, 0]))[0::15]), [0, 1, 2])

    def test_phase(self):
        one = trot()
        one.observations = [spec.Term('phase_cos'), spec.Term('phase_sin')]
        for advance, first in (('after', 0.0), ('before', 2.0 * math.pi * 1.5 * 0.02)):
            one.phase = spec.Phase(1.5, [0.0, math.pi], advance)
            made, walk = Observation(one, quadruped()), np.array([0.5, 0.0, 0.0])
            for step in range(100):
                angle = first + step * 2.0 * math.pi * 1.5 * 0.02
                found = made.build(still(), walk)
                self.assertTrue(np.allclose(found, [math.cos(angle), -math.cos(angle), math.sin(angle), -math.sin(angle)], atol=1e-9))
                made.done(np.zeros(12), walk)
        one.phase = spec.Phase(1.0, [0.0, math.pi], 'before', math.pi)
        made = Observation(one, quadruped())
        self.assertTrue(np.allclose(made.build(still(), np.zeros(3)), [-1, -1, 0, 0], atol=1e-9))

    def test_velocity_of_the_base_that_nobody_says(self):
        one = trot()
        one.observations = [spec.Term('base_linear_velocity')]
        with self.assertRaisesRegex(PolicyError, 'neither ESTIMATE nor TRUTH'):
            Observation(one, quadruped()).build(still(), np.zeros(3))


def faults_of(one, network=None, dog=None):
    return [finding for finding in check.check(one, dog or quadruped(), network or sizes()) if finding.fault]


class Checks(unittest.TestCase):
    def test_a_clean_contract_has_no_fault(self):
        self.assertEqual([str(fault) for fault in faults_of(trot())], [])

    def test_the_servos_of_the_robot_itself_are_no_fault(self):
        one = trot()
        for joint in one.joints:
            joint.kp, joint.scale = 100.0, 0.4  # 167 % of the effort limit for an action of 1
        self.assertEqual(faults_of(one), [])
        for scale, share in ((math.degrees(0.4), '9.55e.03'), (0.4 / 57.3, '2.91')):
            for joint in one.joints:
                joint.scale = scale
            found = faults_of(one)
            self.assertEqual([finding.about for finding in found], ['gains or scale'])
            self.assertRegex(found[0].sentence, f'{share} % of .* with the kp of robot.yaml.*4 to 400 %')
        for joint in one.joints:
            joint.kp, joint.scale = 80.0, 0.4
        self.assertEqual([finding.about for finding in check.check(one, quadruped(), sizes()) if finding.fault], ['gains or scale'])

    def test_mirror_images(self):
        found = {pair.left: (pair.right, pair.sign) for pair in mirror.pairs(quadruped())}
        self.assertEqual(found['FL_hip_joint'], ('FR_hip_joint', -1.0))
        self.assertEqual(found['RL_calf_joint'], ('RR_calf_joint', 1.0))

    def test_twenty_planted_faults(self):
        def joint(name, **values):
            def change(one):
                for entry in one.joints:
                    if name in entry.name:
                        for key, value in values.items():
                            setattr(entry, key, value(getattr(entry, key)) if callable(value) else value)
            return change

        def term(name, **values):
            def change(one):
                for entry in one.observations:
                    if entry.term == name:
                        for key, value in values.items():
                            setattr(entry, key, value)
            return change

        def names(order):
            def change(one):
                for entry, name in zip(one.joints, order([entry.name for entry in one.joints])):
                    entry.name = name
            return change

        def period(value):
            return lambda one: setattr(one, 'period', value)

        def swapped(all_names):
            return [*all_names[:1], all_names[2], all_names[1], *all_names[3:]]
        plants = [
            ('joint order', names(lambda every: ['tail', *every[1:]])), ('joint order', names(swapped)),
            ('joint order', names(lambda every: sorted(every, key=lambda name: name.split('_')[1]))),
            ('joint order', lambda one: one.joints.pop()), ('sign', joint('FL_hip', default=lambda q: -q)),
            ('sign', joint('RR_thigh', scale=lambda s: -s)), ('default angles', joint('calf', default=lambda q: math.degrees(q))),
            ('default angles', joint('calf', default=0.0)), ('scale', term('base_angular_velocity', scale=[math.degrees(1.0)])),
            ('scale', term('joint_velocity', scale=[20.0])), ('gains or scale', joint('', scale=lambda s: math.degrees(s))),
            ('gravity frame', term('projected_gravity', scale=[-1.0])), ('gravity frame', term('projected_gravity', frame='camera')),
            ('gains', joint('', kp=0.5, kd=35.0)), ('gains', joint('', kd=0.0)), ('gains or scale', joint('', kp=1000.0, kd=20.0)),
            ('rate', period(0.2)), ('rate', period(0.0213)),
            ('history length', lambda one: [setattr(entry, 'history', 3) for entry in one.observations]),
            ('limits', joint('thigh', upper=1.5)), ('armature', joint('', armature=0.1)), ('limits', joint('', effort=80.0))]
        missed = []
        for about, plant in plants:
            one = copy.deepcopy(trot())
            plant(one)
            found = faults_of(one)
            if about not in {fault.about for fault in found}:
                missed.append((about, [str(fault) for fault in found]))
        self.assertGreaterEqual(len(plants), 20)
        self.assertEqual(missed, [])

    def test_history_that_would_fit_is_named(self):
        found = faults_of(trot(), sizes(reads=225))
        self.assertIn('history of 5', found[0].sentence)

    def test_suspects_change_one_thing(self):
        one = trot()
        text = spec.to_text(one)
        found = list(suspects.suspects(one, quadruped()))
        self.assertGreater(len(found), 20)
        self.assertEqual(spec.to_text(one), text)
        for _, sentence, changed in found:
            self.assertNotEqual(spec.to_text(changed), text, sentence)


class Trials(unittest.TestCase):
    def test_every_trial_of_check_runs_in_the_engine_that_is_asked_for(self):
        words = SimpleNamespace(no_trial=False, command=(0.0, 0.0, 0.0), seconds=1.0, seed=4, engine='mujoco', jobs=1, robot='dog')
        ran = []

        def run_all(cases, jobs):
            ran.extend(cases)
            return [trial.Outcome(case.command, case.seed, fell=True) for case in cases]
        with mock.patch.object(command_line, 'policy_of', return_value=(None, quadruped(), trot())), \
                mock.patch.object(trial, 'run_all', run_all), mock.patch.object(command_line.check, 'in_words', return_value=0), \
                mock.patch.object(command_line.check, 'check', return_value=[]), contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(command_line.check_it(words), 1)
        self.assertGreater(len(ran), 2)  # two trials, and those with single changes
        self.assertEqual({(case.engine, case.seed) for case in ran}, {('mujoco', 4)})


class Operators(unittest.TestCase):
    def walk(self, sequence, **values):
        return SimpleNamespace(**{**dict(run_id=7, sender_id=1, sequence=sequence, vx=0.3, vy=0.0, wz=0.1, timeout=0.3), **values})

    def pad(self, **values):
        axes = dict(left_y=0.5, left_x=-1.0, right_x=0.0, connected=1, deadman=1)
        return SimpleNamespace(**{**dict(run_id=7, sender_id=2, sequence=1), **axes, **values})

    def operator(self):
        return Operator(np.array([0.2, 0.0, 0.0]), np.array([-0.5, -0.4, -1.0]), np.array([1.0, 0.4, 1.0]))

    def test_walk(self):
        one = self.operator()
        self.assertEqual(list(one.command()), [0.2, 0.0, 0.0])
        for bad in (self.walk(1, run_id=8), self.walk(1, vx=math.nan), self.walk(1, timeout=-1.0)):
            one.hear('WALK', bad, 7)
            self.assertEqual(list(one.command()), [0.2, 0.0, 0.0])
        one.hear('WALK', self.walk(3), 7)
        one.hear('WALK', self.walk(2, vx=9.0), 7)  # old
        self.assertEqual(list(one.command()), [0.3, 0.0, 0.1])

    def test_pad(self):
        one = self.operator()
        one.hear('GAMEPAD', self.pad(), 7)
        self.assertEqual(list(one.command()), [0.5, -0.4, 0.0])
        one.hear('GAMEPAD', self.pad(deadman=0), 7)
        self.assertEqual(list(one.command()), [0.2, 0.0, 0.0])

    def test_modes(self):
        one = self.operator()
        one.hear('MODE_REQUEST', SimpleNamespace(run_id=7, sender_id=3, sequence=5, mode=4, motion=0), 7)
        self.assertEqual((one.mode_sequence, list(one.command())), (5, [0.0, 0.0, 0.0]))
        one.hear('MODE_REQUEST', SimpleNamespace(run_id=7, sender_id=3, sequence=6, mode=3, motion=0), 7)
        self.assertEqual((one.mode, one.mode_sequence), (4, 6))
        self.assertIn('walk and balance', one.complaint)


class FakeBus:
    """Gives the runner what a test says; keeps what it sends.  states: so many at once are never given."""

    def __init__(self):
        self.script, self.sent = [], []

    def listen(self, *channels):
        self.channels = channels

    def receive(self, timeout):
        if not self.script:
            time.sleep(timeout)
        return [self.script.pop(0)] if self.script else []

    def send(self, channel, message):
        self.sent.append((channel, message))

    def say(self, channel, message):
        self.script.append((channel, message.encode()))

    def of(self, channel):
        return [message for name, message in self.sent if name == channel]


class FakeNetwork:
    observation_size, action_size = 45, 12

    def __init__(self, answer=0.0):
        self.answer, self.seen, self.resets = answer, [], 0

    def reset(self):
        self.resets += 1

    def run(self, observation):
        self.seen.append(np.array(observation))
        return self.answer() if callable(self.answer) else np.full(self.action_size, self.answer)


class Running(unittest.TestCase):
    """The loop on a bus of its own imagination: STATE by STATE, by the robot's time."""

    def start(self, network=None, pace=runner.LOCK_STEP, one=None, **options):
        self.bus, self.network, self.said = FakeBus(), network or FakeNetwork(), []
        one = one or trot()
        self.network.observation_size = one.observation_size()
        self.made = runner.Runner(self.bus, lambda dog: controller.Controller(one, dog, self.network),
                                  runner.Options(say=self.said.append, **options), quadruped())
        self.tick, self.pace, self.period_ns = 100, pace, 2_000_000
        self.time_ns = 0

    def state(self, **values):
        state = messages.robot_state_t()
        self.tick += 1
        self.time_ns += self.period_ns
        state.tick, state.time_ns, state.run_id, state.term, state.model_hash = self.tick, self.time_ns, 7, 3, 99
        state.period_ns, state.joint_count, state.role, state.source = self.period_ns, 12, 2, 1
        state.attitude[0] = 1.0
        for key, value in values.items():
            setattr(state, key, value)
        return state

    def go(self, count, sleep=0.0, **values):
        """So many ticks; gives the commands that they brought."""
        before = len(self.bus.of('COMMAND'))
        for _ in range(count):
            if self.made._state is not None:
                status = messages.source_status_t()
                status.run_id, status.pace = 7, self.pace
                self.bus.say('SOURCE_STATUS', status)
                self.made.receive(0.0)
            self.bus.say('STATE', self.state(**values))
            self.made.receive(0.0)
            time.sleep(sleep)
        return self.bus.of('COMMAND')[before:]

    def test_it_answers_every_state_and_acts_every_period(self):
        self.start(FakeNetwork(1.0), wait=0.1)
        commands = self.go(100)
        self.assertEqual([command.tick for command in commands], list(range(101, 201)))
        one = commands[0]
        self.assertEqual((one.run_id, one.term, one.model_hash, one.joint_count, one.flags), (7, 3, 99, 12, 0))
        default = [joint.default for joint in trot().joints]
        self.assertTrue(np.allclose(commands[49].q[:12], default))              # 0.1 s in the default posture
        self.assertTrue(np.allclose(commands[50].q[:12], np.array(default) + 0.25))
        self.assertTrue(np.allclose([one.kp[0], one.kd[0], one.kp[12]], [35.0, 0.5, 0.0]))
        self.assertEqual(len(self.network.seen), 5)                             # every 10 ticks

    def test_with_a_guard_a_state_is_answered_once_it_has_been_judged(self):
        self.start(wait=0.0, guarded=True)
        self.assertIn('GUARD', self.bus.channels)
        judged = trial._Judged()
        self.made.on_guard = judged.see
        for tick, (mask, stop) in enumerate(((0, 0), (6, 0), (0, 1), (0, 1), (0, 0), (0, 1)), 101):
            report = messages.guard_report_t()
            report.tick, report.run_id, report.hold_mask, report.stop_asked = tick, 7, mask, stop
            before = len(self.bus.of('COMMAND'))
            self.bus.say('STATE', self.state())
            self.bus.say('GUARD', report)
            self.made.receive(0.0)
            self.assertEqual([command.tick for command in self.bus.of('COMMAND')[before:]], [tick])
        self.assertEqual((judged.ticks, judged.held, judged.stops), (6, 1, 2))
        self.bus.say('STATE', self.state())  # what it says of another run or tick is no judgement of this one
        self.bus.say('GUARD', report)
        with mock.patch.object(runner, 'GUARD', 0.05), self.assertRaisesRegex(runner.Stopped, 'no guard judged tick 107'):
            self.made.receive(0.0)
        self.assertEqual(self.bus.of('COMMAND')[-1].tick, 106)

    def test_not_faded_in(self):
        self.start(wait=0.0, fade=False)
        self.assertEqual({command.flags for command in self.go(10)}, {runner.NOT_FADED})

    def test_faded_in_only_where_a_joint_is_far_from_its_posture(self):
        default = np.array([joint.default for joint in trot().joints])
        for off, fade, flags in ((0.9, None, runner.NOT_FADED), (1.1, None, 0), (0.9, True, 0), (1.1, False, runner.NOT_FADED)):
            self.start(wait=0.3, fade=fade)
            found = default + [off, *[0.0] * 11]
            self.assertEqual({command.flags for command in self.go(10, q=[*found, *[0.0] * (len(messages.robot_state_t().q) - 12)])}, {flags}, off)

    def test_a_joint_that_slides_is_far_in_metres(self):
        default = np.array([joint.default for joint in trot().joints])
        for off, flags in ((0.2, runner.NOT_FADED), (0.4, 0)):
            self.start(wait=0.3)
            self.go(1)
            self.made.controller.robot.bus[0].kind = 'prismatic'
            self.made._fresh = True
            self.made._begin(self.state(q=[*(default + [off, *[0.0] * 11]), *[0.0] * (len(messages.robot_state_t().q) - 12)]))
            self.assertEqual(self.made._unfaded is not None, flags == runner.NOT_FADED, off)

    def test_what_comes_after_the_start_fades_as_with_every_client(self):
        def flags(count, **values):
            return {command.flags for command in self.go(count, q=[*default, *[0.0] * (len(messages.robot_state_t().q) - 12)], **values)}
        default = [joint.default for joint in trot().joints]
        self.start(wait=0.1)
        self.assertEqual(flags(20), {runner.NOT_FADED})
        self.assertEqual(flags(5, term=4), {0})            # another source
        self.assertEqual(flags(5), {runner.NOT_FADED})
        flags(200)
        self.assertEqual(flags(20), {0})                   # it began long ago
        self.assertEqual(flags(5, stop_kind=2), set())
        self.assertEqual(flags(20), {0})                   # cleared

    def test_walk_is_obeyed(self):
        self.start(wait=0.0)
        self.go(1)
        walk = messages.walk_command_t()
        walk.run_id, walk.sender_id, walk.sequence, walk.vx, walk.wz, walk.timeout = 7, 5, 1, 0.5, -9.0, 10.0
        self.bus.say('WALK', walk)
        self.made.receive(0.0)
        self.go(10)
        self.assertTrue(np.allclose(self.network.seen[-1][6:9], [0.5, 0.0, -1.0]))  # cut to what it was trained for

    def test_a_balanced_stop_and_what_follows(self):
        self.start(wait=0.0, command=(0.5, 0.0, 0.0))
        self.period_ns = 20_000_000
        self.go(10)
        commands = self.go(120, stop_kind=1)
        self.assertTrue(all(command.flags & runner.STOPPING for command in commands))
        self.assertTrue(np.allclose(self.network.seen[-1][6:9], 0.0))
        self.assertTrue(93 <= len(commands) <= 98, len(commands))  # 1.9 s, for nobody says that it rests
        self.assertEqual(self.go(20, stop_kind=2), [])
        resets = self.network.resets
        self.assertEqual(len(self.go(10)), 10)  # cleared
        self.assertEqual(self.network.resets, resets + 1)

    def test_a_balanced_stop_ends_when_it_rests(self):
        self.start(wait=0.0)
        self.period_ns = 20_000_000
        self.go(10)
        estimate = messages.estimate_t()
        estimate.run_id, estimate.velocity_from, estimate.foot_count = 7, 1, 2
        estimate.foot_stands[:2] = [1, 1]
        estimate.tick = self.tick + 1000
        self.bus.say('ESTIMATE', estimate)
        self.made.receive(0.0)
        commands = self.go(40, stop_kind=1)
        self.assertTrue(14 <= len(commands) <= 18, len(commands))  # 0.3 s

    def fails(self, said, network, pace=runner.LOCK_STEP, ticks=30, sleep=0.0, kinds=(2,), one=None):
        self.start(network, pace, one, wait=0.0)
        with self.assertRaisesRegex(runner.Stopped, said):
            self.go(ticks, sleep)
        stops, events = self.bus.of('STOP'), self.bus.of('EVENT')
        self.assertEqual({(stop.kind, stop.reason, stop.sequence) for stop in stops}, {(kind, 6, kind) for kind in kinds})
        self.assertRegex(twinbus.text(events[-1].text), said)
        self.assertEqual((events[-1].severity, events[-1].run_id), (2, 7))

    def test_an_action_that_is_no_number_stops_the_robot(self):
        self.fails('the action of FR_hip_joint is not a finite number', FakeNetwork(math.nan))

    def test_a_target_that_is_no_number_stops_the_robot(self):
        one = trot()
        one.joints[3].scale = 1e308  # the action is a number, and so is the scale
        self.fails('the target of FL_hip_joint is not a finite number', FakeNetwork(100.0), one=one)

    def test_a_wrong_number_of_actions_stops_the_robot(self):
        self.fails('gave 11 numbers, 12 joints', FakeNetwork(lambda: np.zeros(11)))

    def test_an_inference_that_fails_stops_the_robot(self):
        def fail():
            raise PolicyError('the inference failed: no memory')
        self.fails('no memory', FakeNetwork(fail))

    def test_a_late_inference_stops_the_robot(self):
        first, released = iter([True]), threading.Event()

        def late():  # the second one does not come out before the test ends
            if not next(first, False):
                released.wait(60.0)
            return np.zeros(12)
        try:
            self.fails('a new action every 20 ms', FakeNetwork(late), pace=1, ticks=80, kinds=(1, 2))
        finally:
            released.set()
        self.assertEqual(len(self.bus.of('COMMAND')), 60)  # they went on for 0.1 s after it was submitted
        self.assertEqual([twinbus.text(event.text)[-8:] for event in self.bus.of('EVENT')], ['ced stop', 'ms: stop'])

    def test_an_inference_that_is_late_by_less_makes_a_balanced_stop(self):
        calls, released = iter(range(1000)), threading.Event()

        def late():
            if next(calls) >= 2:
                released.wait(20.0)
                released.clear()
            return np.zeros(12)

        def slowly(ticks, **values):
            commands = []
            for tick in range(ticks):
                commands += self.go(1, **values)
                if tick % 15 == 14:  # 30 ms
                    released.set()
                    time.sleep(0.02)
            return commands
        network = FakeNetwork(late)
        self.start(network, pace=1, wait=0.0, command=(0.5, 0.0, 0.0))
        slowly(75)
        self.assertEqual({(stop.kind, stop.reason) for stop in self.bus.of('STOP')}, {(1, 6)})
        self.assertEqual(len(self.bus.of('EVENT')), 1)
        commands = slowly(60, stop_kind=1)
        self.assertTrue(len(commands) == 60 and all(command.flags & runner.STOPPING for command in commands))
        self.assertTrue(np.allclose(network.seen[-1][6:9], 0.0))
        released.set()
        with self.assertRaisesRegex(runner.Stopped, 'a new action every 20 ms'):
            self.go(1, stop_kind=2)

    def test_a_run_ends_with_a_balanced_stop(self):
        self.start(wait=0.0, duration=0.02, command=(0.5, 0.0, 0.0))
        for _ in range(20):
            self.bus.say('STATE', self.state())
        for _ in range(5):
            self.bus.say('STATE', self.state(stop_kind=1))
        self.bus.say('STATE', self.state(stop_kind=2))
        self.made.run()
        self.assertEqual({(stop.kind, stop.reason) for stop in self.bus.of('STOP')}, {(1, 6)})
        self.assertTrue(all(command.flags & runner.STOPPING for command in self.bus.of('COMMAND')[-5:]))

    def plans(self, **joints):
        one = trot()
        for joint in one.joints:
            for key, value in joints.items():
                setattr(joint, key, value)
        self.start(FakeNetwork(1.0), wait=0.0, one=one)
        self.go(100)
        return self.bus.of('STOP_PLAN')

    def test_beside_commands_goes_a_stop_plan_to_its_posture(self):
        plans = self.plans()
        self.assertEqual([plan.number for plan in plans], list(range(1, len(plans) + 1)))
        self.assertTrue(4 <= len(plans) <= 5, len(plans))  # every 40 ms of 0.2 s
        plan = plans[-1]
        self.assertEqual((plan.run_id, plan.term, plan.model_hash, plan.joints, plan.walks), (7, 3, 99, 0xFFF, 0))
        self.assertEqual((plan.piece, plan.pieces, plan.knot_count, plan.controller_id), (0, 1, 2, self.bus.of('COMMAND')[0].controller_id))
        for knot in range(2):
            self.assertTrue(np.allclose(2e-4 * np.array(plan.q[knot][:12]), [joint.default for joint in trot().joints], atol=1e-4))

    def test_a_stiff_policy_has_a_stop_plan_only_near_its_posture(self):
        self.assertEqual(self.plans(kp=100.0), [])  # its targets are 0.25 rad away
        self.assertEqual(len(self.plans(kp=100.0, scale=0.1)), 5)

    def test_a_robot_that_is_not_known_yet_is_held(self):
        released, one = threading.Event(), trot()
        self.start(wait=0.0)
        self.made = runner.Runner(self.bus, lambda dog: (released.wait(20.0), controller.Controller(one, dog, self.network))[1],
                                  runner.Options(say=self.said.append, wait=0.0))
        q = np.zeros(48)
        q[:12] = 0.3
        self.assertEqual(self.go(3, q=q), [])  # nothing is known
        urdf = ''.join(f'<joint name="{leg}_{part}_joint" type="revolute"><parent link="{"trunk" if part == "hip" else leg}"/><child link="{leg}'
                       f'{"" if part == "hip" else part}"/></joint>' for leg in LEGS for part in ('hip', 'thigh', 'calf'))
        names = ', '.join(f'{leg}_{part}_joint' for leg in LEGS for part in ('hip', 'thigh', 'calf'))
        for kind, text in ((1, f'<robot name="dog"><link name="trunk"/>{urdf}</robot>'), (3, f'servos: [{{joints: [{names}], kp: 100, kd: 4}}]')):
            data = text.encode()
            for number in range(0, len(data), 1000):
                piece = messages.model_text_t()
                part = data[number:number + 1000]
                piece.model_hash, piece.kind, piece.size, piece.count = 99, kind, len(data), len(part)
                piece.piece, piece.pieces = number // 1000, (len(data) + 999) // 1000
                piece.text[:len(part)] = np.frombuffer(part, dtype=np.int8)
                self.bus.say('MODEL_TEXT', piece)
                self.made.receive(0.0)
        end = time.monotonic() + 10.0
        while not (held := self.go(1, q=q)) and time.monotonic() < end:
            time.sleep(0.01)
        self.assertTrue(np.allclose(held[0].q[:12], 0.3))
        self.assertTrue(np.allclose([held[0].kp[0], held[0].kd[11], held[0].kp[12]], [100.0, 4.0, 0.0]))
        self.assertEqual((self.network.seen, self.bus.of('STOP_PLAN')), ([], []))
        released.set()
        self.made._binding.join(10.0)
        commands = self.go(200)  # 0.4 s
        self.assertTrue(np.allclose([commands[0].q[0], commands[0].kp[0]], [0.3, 100.0]))  # from there it goes to its own in 0.3 s
        self.assertTrue(99.0 > commands[75].kp[0] > 36.0)
        self.assertTrue(np.allclose([commands[160].q[1], commands[160].kp[0]], [0.9, 35.0]))
        self.assertLess(max(abs(float(b.q[1] - a.q[1])) for a, b in zip(commands, commands[1:])), 0.01)

    def test_a_stop_that_was_there_before_is_told(self):
        self.start(wait=0.0)
        self.assertEqual(self.go(3, stop_kind=2), [])
        for _ in range(2):
            status = messages.source_status_t()
            status.run_id, status.stop_kind, status.stop_reason = 7, 2, 7
            self.bus.say('SOURCE_STATUS', status)
            self.made.receive(0.0)
        self.assertEqual(len(self.said), 1)
        self.assertIn('clear lets the policy begin', self.said[0])

    def test_in_lock_step_the_world_waits_for_an_inference(self):
        def slow():
            time.sleep(0.03)
            return np.ones(12)
        self.start(FakeNetwork(slow), wait=0.0)
        commands = self.go(25)
        self.assertAlmostEqual(commands[0].q[1], 0.9 + 0.25)
        self.assertEqual(self.made.actions, 3)

    def test_velocity_is_that_of_estimate_and_only_else_of_truth(self):
        one = trot()
        one.observations.insert(0, spec.Term('base_linear_velocity'))
        self.start(FakeNetwork(), wait=0.0, one=one)
        self.go(1)
        self.assertEqual(self.network.seen, [])  # nobody has said it yet
        truth = messages.sim_truth_t()
        truth.run_id, truth.tick, truth.base_attitude[0], truth.base_velocity[0] = 7, self.tick, 1.0, 0.25
        self.bus.say('TRUTH', truth)
        self.made.receive(0.0)
        self.go(10)
        self.assertAlmostEqual(self.network.seen[-1][0], 0.25)
        self.assertTrue(any('TRUTH' in sentence for sentence in self.said))
        estimate = messages.estimate_t()
        estimate.run_id, estimate.velocity_from, estimate.velocity_in_base[0], estimate.tick = 7, 1, 0.5, self.tick + 20
        self.bus.say('ESTIMATE', estimate)
        self.made.receive(0.0)
        self.go(10)
        self.assertAlmostEqual(self.network.seen[-1][0], 0.5)
        self.go(10, run_id=8, term=4)  # another source took over, and its first estimate is still to come
        self.assertAlmostEqual(self.network.seen[-1][0], 0.5)

    def test_without_any_velocity_the_robot_is_stopped(self):
        one = trot()
        one.observations.insert(0, spec.Term('base_linear_velocity'))
        self.start(FakeNetwork(), wait=0.0, one=one)
        with self.assertRaisesRegex(runner.Stopped, 'neither ESTIMATE nor TRUTH'):
            self.go(60)

    def test_another_robot(self):
        self.start(wait=0.0)
        with self.assertRaisesRegex(runner.Stopped, 'STATE has 11 joints'):
            self.go(1, joint_count=11)


class Others(unittest.TestCase):
    def test_model_text(self):
        texts, urdf = model_text.ModelText(), b'<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="revolute">' \
            b'<parent link="a"/><child link="b"/><limit lower="-1" upper="1" effort="5" velocity="2"/></joint></robot>'

        def send(kind, data, size=1300):
            pieces = [data[k:k + size] for k in range(0, len(data), size)]
            for number, piece in reversed(list(enumerate(pieces))):
                texts.hear(SimpleNamespace(model_hash=5, kind=kind, piece=number, pieces=len(pieces), size=len(data), count=len(piece), text=piece))
        send(1, urdf, 50)
        self.assertIsNone(texts.robot(5))
        send(3, b'period: 0.004\nimu: b\n')
        found = texts.robot(5)
        self.assertEqual((found.names(), found.period, found.imu), (['j'], 0.004, 'b'))
        texts.hear(SimpleNamespace(model_hash=5, kind=1, piece=9, pieces=2, size=3, count=400, text=b''))  # hostile: left out

    def test_answer_map(self):
        def walked(command, vx, fell=False):
            return trial.Outcome(command, 1, 4.0, np.array([vx, 0.0, 0.0]), 0.1, fell)
        outcomes = [walked((0.0, 0.0, 0.0), 0.02), walked((0.1, 0.0, 0.0), 0.03), walked((0.5, 0.0, 0.0), 0.45),
                    walked((1.0, 0.0, 0.0), 0.8), walked((2.0, 0.0, 0.0), 0.1, True)]
        found = answer_map.figures(outcomes, 0)
        self.assertEqual((found.dead_zone, found.largest, found.falls, found.drift[0]), (0.1, 0.8, 1, 0.02))
        self.assertIn('<svg', answer_map.svg(outcomes, [0], 'a < b'))
        self.assertIn((0.0, 0.0, 0.0), answer_map.commands(trot(), [0, 2], 2))

    @unittest.skipUnless(RUNS, 'onnxruntime is missing')
    def test_network(self):
        from twinbus.policy.network import Network
        with tempfile.TemporaryDirectory() as folder:
            here = pathlib.Path(folder)
            made = Network(tiny_onnx.linear(here / 'm.onnx', 45, 12, 0.5))
            whole = controller.Controller(trot(), quadruped(), made)
            target = whole.step(still(), np.zeros(3))
            self.assertTrue(np.allclose(target, [joint.default + 0.125 for joint in trot().joints]))
            with self.assertRaisesRegex(PolicyError, 'the action of FR_hip_joint is not a finite number'):
                controller.Controller(trot(), quadruped(), Network(tiny_onnx.linear(here / 'nan.onnx', 45, 12, math.nan))).step(still(), np.zeros(3))
            with self.assertRaisesRegex(PolicyError, 'observation is not finite'):
                whole.step(still(q=np.full(12, math.nan)), np.zeros(3))
            for reads, moves, said in ((46, 12, 'are 45 numbers'), (45, 11, 'the network moves 11')):
                with self.assertRaisesRegex(PolicyError, said):
                    controller.Controller(trot(), quadruped(), Network(tiny_onnx.linear(here / 'other.onnx', reads, moves)))
            with self.assertRaisesRegex(Refused, 'time_step'):
                Network(tiny_onnx.linear(here / 'motion.onnx', 45, 12, inputs=[('time_step', [1, 1])]))
            (here / 'junk.onnx').write_bytes(b'\x08junk' * 20)
            with self.assertRaisesRegex(PolicyError, 'cannot load'):
                Network(here / 'junk.onnx')
            with self.assertRaisesRegex(PolicyError, 'nothing says what it reads'):
                find.find(made, quadruped())
            (here / 'params').mkdir()
            (here / 'params/deploy.yaml').write_text(DEPLOY)
            self.assertEqual(find.find(made, quadruped()).observation_size(), 235)
            (here / 'm.spec.yaml').write_text(spec.to_text(trot()))
            self.assertEqual(find.find(made, quadruped()).observation_size(), 45)


if __name__ == '__main__':
    if not RUNS:
        print('onnxruntime is missing: the network itself is not tested')
    unittest.main()
