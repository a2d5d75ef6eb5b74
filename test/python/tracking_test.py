#!/usr/bin/env python3
"""Policies that follow a motion: what is read of their specification, where the motion comes from, how it is followed, and how a robot that
walks plays one and walks again.  No bus, no simulator.  Needs what policy_test.py needs, whose quadruped moves here."""
import contextlib
import io
import json
import math
import pathlib
import tempfile
import time
import unittest
import zipfile

from policy_test import DEPLOY, RUNS, FakeNetwork, Running, quadruped, still, trot  # skips, and takes the Python that has numpy

import numpy as np
import tiny_onnx
from twinbus import messages
from twinbus.policy import arguments, command_line, controller, deploy_yaml, followed, metadata, repertoire, runner, spec, trial
from twinbus.policy.errors import PolicyError, Refused
from twinbus.policy.follower import Followed, Follower, about_z
from twinbus.policy.observation import Observation
from twinbus.policy.rotation import rotation_of
from twinbus.policy.yaml_file import Field, parse

NAMES = trot().names()
FRAMES, STANDS = 30, 50  # of the motion; ticks of the policy in which its first frame is held


def tracker(motion=''):
    """A policy of the quadruped that reads its motion."""
    one = trot()
    one.observations = [spec.Term('motion_joints'), spec.Term('motion_orientation'), spec.Term('joint_position')]
    one.anchor, one.motion, one.name = 'FR_hip', motion, 'dance'
    return one


def motion(turned=0.0):
    q = np.outer(np.linspace(0.0, 0.29, FRAMES), np.ones(12)) + np.array([joint.default for joint in trot().joints])
    return Followed(q, np.gradient(q, 0.02, axis=0), np.array([about_z(turned + 0.01 * k) for k in range(FRAMES)]), 'here')


class Readers(unittest.TestCase):
    def test_own_specification_round_trip(self):
        with tempfile.TemporaryDirectory() as folder:
            one = tracker(str(pathlib.Path(folder) / 'dance.csv'))
            again = spec.from_text(spec.to_text(one))
            self.assertEqual((again.anchor, again.motion, again.follows), (one.anchor, one.motion, True))
            self.assertEqual(again.observation_size(), 24 + 6 + 12)
        with self.assertRaisesRegex(PolicyError, 'needs `motion'):
            one = tracker()
            one.anchor = ''
            one.validate()

    def test_deploy_yaml(self):
        text = DEPLOY.replace('velocity_commands', 'motion_command').replace('gait_phase', 'motion_anchor_ori_b')
        body = robot_with_torso()
        one = deploy_yaml.read(Field(parse(text, 'f.yaml'), 'f.yaml', ''), body)
        self.assertEqual((one.anchor, [term.term for term in one.observations][2]), ('torso_link', 'motion_joints'))
        text = DEPLOY.replace('velocity_commands: {params: {command_name: base_velocity}', 'generated_commands: {params: {command_name: motion}')
        one = deploy_yaml.read(Field(parse(text, 'f.yaml'), 'f.yaml', ''), body)
        self.assertEqual(one.observations[2].term, 'motion_joints')

    def test_metadata_of_mjlab(self):
        words = {'joint_names': ','.join(NAMES), 'anchor_body_name': 'trunk', 'observation_names': 'command,motion_anchor_ori_b,joint_pos'}
        words.update({key: ','.join(['1'] * 12) for key in ('joint_stiffness', 'joint_damping', 'default_joint_pos', 'action_scale')})
        one = metadata.read(words, 'm.onnx', 42)
        self.assertEqual((one.anchor, [term.term for term in one.observations]), ('trunk', ['motion_joints', 'motion_orientation', 'joint_position']))

    def test_metadata_of_holosoma(self):
        names = ['left_hip_pitch_joint', 'left_knee_joint', 'waist_yaw_joint']
        urdf = '<robot name="g1">' + ''.join(f'<joint name="{name}"><limit effort="{80 + 10 * k}"/></joint>' for k, name in enumerate(names)) + '</robot>'
        words = {'dof_names': json.dumps(names), 'kp': '[40, 90, 50]', 'kd': '[2, 6, 3]', 'command_ranges': 'null', 'robot_urdf': json.dumps(urdf)}
        one = metadata.read(words, 'm.onnx', 5 * 3 + 9)
        self.assertEqual([joint.scale for joint in one.joints], [0.5, 0.25, 0.5])
        self.assertEqual((one.follows, one.observation_size(), one.observations[0].term), (True, 24, 'last_action'))
        with self.assertRaisesRegex(PolicyError, 'neither action_scale nor an effort limit of left_hip_pitch_joint'):
            metadata.read({**words, 'robot_urdf': '""'}, 'm.onnx', 24)
        for text in ('5', '{"a": 1}', '["x"]', 'true', '"<robot>"', '"' + '<', '[' * 100000):
            with self.subTest(text[:9]), self.assertRaisesRegex(PolicyError, 'robot_urdf is no URDF'):
                metadata.read({**words, 'robot_urdf': text}, 'm.onnx', 24)
        for key, value, said in (('command_ranges', '{', 'command_ranges is no JSON'), ('kp', '[]', 'kp is empty'), ('kd', '[1e999]', 'kd'),
                                 ('kp', '[-4, 90, 50]', 'kp of left_hip_pitch_joint is below zero')):
            with self.subTest(key), self.assertRaisesRegex(PolicyError, said):
                metadata.read({**words, key: value, 'action_scale': '0.5'}, 'm.onnx', 24)
        for effort in ('1e999', 'nan', '-5'):
            with self.assertRaisesRegex(PolicyError, 'neither action_scale nor an effort limit of left_hip_pitch_joint'):
                metadata.read({**words, 'robot_urdf': json.dumps(urdf.replace('"80"', f'"{effort}"'))}, 'm.onnx', 24)
        one = metadata.read({**words, 'robot_urdf': json.dumps(urdf.replace('"80"', '"inf"')), 'action_scale': '0.5'}, 'm.onnx', 24)
        self.assertEqual([joint.effort for joint in one.joints], [None, 90.0, 100.0])


def robot_with_torso():
    dog = quadruped()
    fixed = next(joint for joint in dog.joints if joint.child == 'imu')
    fixed.child = 'torso_link'
    return dog


class Followers(unittest.TestCase):
    def test_first_frame_is_held_and_the_last_one_too(self):
        one = Follower(motion(), 0.02)
        seen = []
        for _ in range(STANDS + FRAMES + 20):
            seen.append(one.frame)
            self.assertEqual(one.ended, len(seen) > STANDS + FRAMES)
            one.advance()
        self.assertEqual(seen, [0] * STANDS + list(range(FRAMES)) + [FRAMES - 1] * 20)
        one.reset()
        self.assertEqual((one.frame, one.ended), (0, False))

    def test_heading_is_that_of_the_robot_at_the_start(self):
        one = Follower(motion(turned=2.0), 0.02)
        robot = about_z(-1.0)
        self.assertTrue(np.allclose(one.orientation(robot), [1, 0, 0, 1, 0, 0]))
        for _ in range(STANDS + 10):
            one.advance()
        expected = about_z(0.1)[:, :2].reshape(-1)  # the motion has turned by 0.1 rad, the robot not
        self.assertTrue(np.allclose(one.orientation(robot), expected))

    def test_observation_sees_the_anchor_through_joints(self):
        dog, one = quadruped(), tracker()
        seen = Observation(one, dog)
        with self.assertRaisesRegex(PolicyError, 'none was given'):
            seen.build(still(), np.zeros(3))
        seen.follower = Follower(motion(), 0.02)
        q = np.zeros(12)
        q[dog.names().index('FR_hip_joint')] = 0.3  # the anchor is behind this joint, about x
        value = seen.build(still(q=q, attitude=np.array([math.cos(math.pi / 4), 0, 0, math.sin(math.pi / 4)])), np.zeros(3))
        self.assertTrue(np.allclose(value[:12], motion().q[0]))
        down = np.array([[1, 0, 0], [0, math.cos(0.3), -math.sin(0.3)], [0, math.sin(0.3), math.cos(0.3)]])
        self.assertTrue(np.allclose(value[24:30], down.T[:, :2].reshape(-1), atol=1e-7), value[24:30])


class Files(unittest.TestCase):
    def load(self, file):
        return followed.load(tracker(str(file)), quadruped(), None)

    def test_npz_and_csv(self):
        count, rate = 11, 25.0
        q = np.outer(np.arange(count) / rate, np.ones(12))
        root = np.array([[math.cos(0.5 * t), 0, 0, math.sin(0.5 * t)] for t in np.arange(count) / rate])
        with tempfile.TemporaryDirectory() as folder:
            here = pathlib.Path(folder)
            np.savez(here / 'a.npz', joint_pos=q, body_quat_w=np.repeat(root[:, None], 3, axis=1), fps=np.array([rate]))
            np.savez(here / 'b.npz', dof_pos=q[:, ::-1], dof_names=np.array(NAMES[::-1]), root_rot=root[:, [1, 2, 3, 0]], rate=rate)
            head = ','.join(['time', 'root_qw', 'root_qx', 'root_qy', 'root_qz', *NAMES])
            np.savetxt(here / 'c.csv', np.column_stack([np.arange(count) / rate, root, q]), delimiter=',', header=head, comments='')
            for name in ('a.npz', 'b.npz', 'c.csv'):
                found = self.load(here / name)
                self.assertEqual(len(found), 21, name)  # 0.4 s, 50 a second
                self.assertTrue(np.allclose(found.q[1], 0.02) and np.allclose(found.qd, 1.0), name)
                angle = found.q[20][0]
                there = about_z(0.4) @ rotation_of(np.array([math.cos(angle / 2), math.sin(angle / 2), 0, 0]))
                self.assertTrue(np.allclose(found.anchor[20], there, atol=1e-6), name)
            np.savez(here / 'd.npz', joint_pos=q[:, :5], body_quat_w=root, fps=rate)
            np.savez(here / 'e.npz', joint_pos=q)
            np.savez(here / 'f.npz', joint_pos=np.where(q > 0.1, math.nan, q), body_quat_w=root, fps=rate)
            (here / 'g.npz').write_bytes(b'junk')
            (here / 'h.csv').write_text('time,a\n0,x\n')
            (here / 'i.csv').write_text('1,2,3\n4,5,6\n')
            for name, said in (('d.npz', '5 joints without names'), ('e.npz', 'has joint_pos'), ('f.npz', 'not finite'), ('g.npz', 'no NPZ'),
                               ('h.csv', 'no table'), ('i.csv', '3 columns without names'), ('none.csv', 'no such file')):
                with self.assertRaisesRegex(PolicyError, said):
                    self.load(here / name)

    def test_hostile_files_are_refused_with_their_name(self):
        q, root = np.zeros((11, 12)), np.tile([1.0, 0.0, 0.0, 0.0], (11, 1))
        head = ','.join(['time', 'root_qw', 'root_qx', 'root_qy', 'root_qz', *NAMES])

        def npz(**changed):
            return lambda file: np.savez(file, **{'joint_pos': q, 'body_quat_w': root, 'fps': 50.0, **changed})

        def data(content):
            return lambda file: file.write_bytes(content)

        def cut(file):
            npz()(file)
            file.write_bytes(file.read_bytes()[:-200])

        def bare(file):
            with file.open('wb') as out:
                np.save(out, q)

        def large(file):  # 1 GB of zeros, packed
            with zipfile.ZipFile(file, 'w', zipfile.ZIP_DEFLATED) as packed, packed.open('joint_pos.npy', 'w') as out:
                for _ in range(1024):
                    out.write(bytes(1 << 20))

        def rows(times):
            return data('\n'.join([head, *(f'{time},1,0,0,0' + ',0' * 12 for time in times)]).encode())
        table = [
            ('cut.npz', cut, 'no NPZ'), ('empty.npz', data(b''), 'no NPZ'), ('bare.npz', bare, 'no NPZ'), ('junk.npz', data(b'PK' * 99), 'no NPZ'),
            ('large.npz', large, '1024 MB'), ('pickled.npz', npz(joint_pos=np.array([{}], dtype=object)), 'no NPZ'),
            ('words.npz', npz(joint_pos=np.array([['a'] * 12] * 11)), 'no NPZ'), ('rate_words.npz', npz(fps='fast'), 'no NPZ'),
            ('short.npz', npz(joint_pos=q[:2], body_quat_w=root[:2], fps=200.0), '2 frames at 200 a second are 1 of the policy'),
            ('slow.npz', npz(fps=1e-12), '1e-12 frames a second'), ('fast.npz', npz(fps=1e12), '1e.12 frames a second'),
            ('inf.npz', npz(fps=math.inf), 'inf frames a second'), ('nan.npz', npz(fps=math.nan), 'and fps'),
            ('no_rate.npz', npz(fps=np.array([])), 'and fps'), ('one.npz', npz(joint_pos=q[:1], body_quat_w=root[:1]), '1 frames'),
            ('none.npz', npz(joint_pos=q[:0], body_quat_w=root[:0]), '0 frames'), ('flat.npz', npz(joint_pos=np.zeros(12)), 'a row for each frame'),
            ('long.npz', npz(joint_pos=np.zeros((100001, 12)), body_quat_w=np.tile(root[0], (100001, 1))), '100001 frames'),
            ('hours.npz', npz(joint_pos=np.zeros((9999, 12)), body_quat_w=np.tile(root[0], (9999, 1)), fps=1.0), 'a motion has 2 to 100000'),
            ('no_bodies.npz', npz(body_quat_w=np.zeros((11, 0, 4))), 'no NPZ'), ('lies.npz', npz(body_quat_w=0.0 * root), 'no rotation'),
            ('names.npz', npz(joint_names=np.array([*NAMES, 'tail'])), '13 names for 12 joints'),
            ('names.csv', data(head.encode()), 'no table'), ('empty.csv', data(b''), 'no table'), ('latin.csv', data(b'time,\xff\n0,1\n'), 'no table'),
            ('ragged.csv', data(b'time,a\n0,1\n0,1,2\n'), 'no table'), ('zero.csv', data(b'time,a\n0,1\0\n1,1\n'), 'no table'),
            ('still.csv', rows([0, 0, 0]), 'go on evenly'), ('endless.csv', rows([0, math.inf]), 'go on evenly'),
            ('slow.csv', rows([0, 1e12]), 'frames a second')]
        with tempfile.TemporaryDirectory() as folder:
            for name, write, said in table:
                file = pathlib.Path(folder) / name
                write(file)
                with self.subTest(name), self.assertRaisesRegex(PolicyError, f'{name}: .*{said}'):
                    self.load(file)

    @unittest.skipUnless(RUNS, 'onnxruntime is missing')
    def test_a_motion_inside_that_comes_back_to_its_last_frame_is_whole(self):
        from twinbus.policy.network import Network
        wave = [0.3 * math.sin(math.pi * k / 80) for k in range(1, 80)]
        with tempfile.TemporaryDirectory() as folder:
            for held, moving, last in ((110, wave, 20), (2900, wave, 20), (3, wave[:7], 2), (110, [], 20)):
                angles = [0.0] * held + moving + [0.0] * last
                count = len(angles)
                tables = {'joint_pos': [[angle] * 12 for angle in angles], 'joint_vel': [[0.0] * 12] * count, 'ref_quat_xyzw': [[0, 0, 0, 1]] * count}
                found = followed.load(tracker(), quadruped(), Network(tiny_onnx.linear(pathlib.Path(folder) / 'm.onnx', 42, 12, tables=tables)))
                self.assertEqual(len(found), held + len(moving) + 1 if moving else 1)  # with the first of the last ones
                self.assertTrue(np.allclose(found.q[:, 0], angles[:len(found)]))

    @unittest.skipUnless(RUNS, 'onnxruntime is missing')
    def test_a_motion_inside_that_does_not_fit_is_refused(self):
        from twinbus.policy.network import Network
        joints, turned = [[0.0] * 12] * 3, [[0.0, 0.0, 0.0, 1.0]] * 3
        with tempfile.TemporaryDirectory() as folder:
            for tables, said in (({'joint_pos': joints, 'joint_vel': [[0.0] * 11] * 3, 'ref_quat_xyzw': turned}, 'joint_vel of its motion has 11'),
                                 ({'joint_pos': [[0.0] * 13] * 3, 'joint_vel': joints, 'ref_quat_xyzw': turned}, 'joint_pos of its motion has 13'),
                                 ({'joint_pos': joints, 'joint_vel': joints, 'ref_quat_xyzw': [[0.0] * 3] * 3}, 'cannot be read'),
                                 ({'joint_pos': joints, 'joint_vel': joints, 'ref_quat_xyzw': [[0.0] * 4] * 3}, 'no rotation'),
                                 ({'joint_pos': [[math.nan] * 12] * 3, 'joint_vel': joints, 'ref_quat_xyzw': turned}, 'not finite')):
                network = Network(tiny_onnx.linear(pathlib.Path(folder) / 'm.onnx', 42, 12, tables=tables))
                with self.subTest(said), self.assertRaisesRegex(PolicyError, f'm.onnx: .*{said}'):
                    followed.load(tracker(), quadruped(), network)

    @unittest.skipUnless(RUNS, 'onnxruntime is missing')
    def test_inside_of_the_network(self):
        from twinbus.policy.network import Network
        there = motion()
        turned = [[0.0, 0.0, math.sin(0.005 * k), math.cos(0.005 * k)] for k in range(FRAMES)]
        with tempfile.TemporaryDirectory() as folder:
            here = pathlib.Path(folder)
            tables = {'joint_pos': there.q.tolist(), 'joint_vel': there.qd.tolist(), 'ref_quat_xyzw': turned}
            network = Network(tiny_onnx.linear(here / 'm.onnx', 42, 12, 0.5, tables=tables))
            found = followed.load(tracker(), quadruped(), network)
            self.assertEqual(len(found), FRAMES)
            self.assertTrue(np.allclose(found.q, there.q, atol=1e-6) and np.allclose(found.anchor, there.anchor, atol=1e-6))
            made = controller.Controller(tracker(), quadruped(), network)
            made.step(still(), np.zeros(3))
            self.assertEqual((made.playing, network.time_step), (True, 0))
            bodies = [[*([1.0, 0, 0, 0]), row[3], *row[:3]] for row in turned]
            tables = {'joint_pos': there.q.tolist(), 'joint_vel': there.qd.tolist(), 'body_quat_w': bodies}
            network = Network(tiny_onnx.linear(here / 'n.onnx', 42, 12, tables=tables, metadata=[('body_names', 'trunk,FR_hip'), ('anchor_body_name', 'FR_hip')]))
            self.assertTrue(np.allclose(followed.load(tracker(), quadruped(), network).anchor, there.anchor, atol=1e-6))
            with self.assertRaisesRegex(Refused, '--motion'):
                followed.load(tracker(), quadruped(), Network(tiny_onnx.linear(here / 'o.onnx', 42, 12)))


class Trials(unittest.TestCase):
    """What --check says of a motion that was played."""

    def outcome(self, **values):
        return trial.Outcome((0.0, 0.0, 0.0), 1, **values)

    def test_only_what_follows_its_motion_to_the_end_is_good(self):
        spread = motion().spread
        self.assertAlmostEqual(spread, 0.29 * math.sqrt((FRAMES + 1) / (12 * (FRAMES - 1))))
        for values, whole, good, said in (({'apart': 0.14, 'ended': True}, True, True, 'plays its motion in the simulator$'),
                                          ({'apart': 0.14}, True, False, 'not come to the end'), ({'apart': 0.14}, False, True, 'not to its end'),
                                          ({'apart': 0.4, 'ended': True}, True, False, '0.400 rad rms from the motion, over 0.280'),
                                          ({'apart': 0.3}, False, False, 'does not follow'), ({'apart': math.nan}, False, False, 'did not begin'),
                                          ({'fell': True, 'ended': True}, True, False, 'end'), ({'stopped': 'by x', 'ended': True}, True, False, 'end')):
            found, sentence = trial.tracks(self.outcome(**values), 0.4, whole)
            self.assertEqual(found, good, values)
            self.assertRegex(sentence, said)
        self.assertTrue(trial.tracks(self.outcome(apart=0.09, ended=True), 0.0, True)[0])  # a motion that only stands
        self.assertFalse(trial.tracks(self.outcome(apart=0.11, ended=True), 0.0, True)[0])

    def test_the_standing_second_does_not_count(self):
        network = FakeNetwork(0.0)
        network.observation_size, network.carries_motion = 42, False
        load, followed.load = followed.load, lambda *_: motion()
        try:
            made = controller.Controller(tracker(), quadruped(), network)
        finally:
            followed.load = load
        beside = trial.Beside()
        self.assertTrue(math.isnan(beside.apart))
        for tick in range(STANDS + FRAMES + 5):
            q = made.follower.joints()[:12] + (0.2 if tick >= STANDS else 0.0)
            beside.see(made, q)
            self.assertEqual((beside.count, beside.ended), (max(0, tick - STANDS + 1), tick >= STANDS + FRAMES))
            made.step(still(), np.zeros(3))
        self.assertAlmostEqual(beside.apart, 0.2)


class Plays(unittest.TestCase):
    """Walks, is asked for its motion, stands, plays, walks again."""
    start, state, go = Running.start, Running.state, Running.go

    def both(self, walked=12):
        """walked: joints that walking moves, the first."""
        self.start()
        walk, play, one = FakeNetwork(0.0), FakeNetwork(1.0), trot()
        one.joints = one.joints[:walked]
        walk.observation_size, walk.action_size = one.observation_size(), walked
        play.observation_size, play.carries_motion = 42, False
        walks = controller.Controller(one, quadruped(), walk)
        load, followed.load = followed.load, lambda *_: motion()
        try:
            plays = controller.Controller(tracker(), quadruped(), play)
        finally:
            followed.load = load
        self.made = runner.Runner(self.bus, lambda _: repertoire.Repertoire(walks, plays), runner.Options(say=self.said.append, wait=0.0), quadruped())
        return walks, plays

    def ask(self, mode, motion_kind):
        request = messages.mode_request_t()
        request.run_id, request.sender_id, request.sequence, request.mode, request.motion = 7, 5, self.tick, mode, motion_kind
        self.bus.say('MODE_REQUEST', request)

    def moving(self, speed):
        estimate = messages.estimate_t()
        estimate.run_id, estimate.tick, estimate.velocity_from, estimate.velocity_in_base = 7, self.tick, 1, [speed, 0.0, 0.0]
        self.bus.say('ESTIMATE', estimate)

    def action(self, commands):
        """Of the last command: 0 where it walks, 1 where it plays."""
        return (commands[-1].q[0] - trot().joints[0].default) / 0.25

    def test_from_walking_to_the_motion_and_back(self):
        self.both()
        self.moving(0.5)
        self.assertAlmostEqual(self.action(self.go(20)), 0.0)
        self.ask(4, 3)
        self.moving(0.5)
        self.assertAlmostEqual(self.action(self.go(150)), 0.0)     # 0.3 s: it still moves
        self.moving(0.05)
        commands = self.go(30)
        self.assertAlmostEqual(self.action(commands), 1.0)
        self.assertEqual(self.bus.of('CONTROLLER_STATUS')[-1].motion, 3)
        self.go(10 * STANDS + 10 * FRAMES)
        commands = self.go(60)
        self.assertAlmostEqual(self.action(commands), 0.0)         # the motion is over
        self.assertEqual((self.bus.of('CONTROLLER_STATUS')[-1].motion, self.bus.of('CONTROLLER_STATUS')[-1].mode), (0, 4))

    def test_only_a_tracking_policy_of_the_same_period_is_played(self):
        walks, plays = self.both()
        with self.assertRaisesRegex(PolicyError, 'trot: it follows no motion, so it cannot be played'):
            repertoire.Repertoire(walks, walks)
        plays.spec.period = 0.01
        with self.assertRaisesRegex(PolicyError, 'dance: an action every 10 ms, the policy that walks has one every 20 ms'):
            repertoire.Repertoire(walks, plays)

    def test_walk_ends_a_motion(self):
        self.both()
        self.go(5)
        self.ask(4, 3)
        self.go(120)
        self.moving(0.0)
        self.assertAlmostEqual(self.action(self.go(30)), 1.0)
        self.ask(5, 0)
        self.assertAlmostEqual(self.action(self.go(25)), 0.0)

    def plays(self):
        self.ask(4, 3)
        self.go(120)
        self.moving(0.0)
        self.assertAlmostEqual(self.action(self.go(30)), 1.0)

    def test_a_stop_ends_a_motion_for_good(self):
        for kind in (1, 2):
            self.both()
            self.go(5)
            self.plays()
            self.go(60, stop_kind=kind)
            for _ in range(6):
                self.moving(0.0)
                self.assertAlmostEqual(self.action(self.go(30)), 0.0, msg=f'stop {kind}, cleared')

    def test_gains_change_with_the_targets_that_they_are_of(self):
        walks, plays = self.both()
        plays.kp = 5.0 * plays.kp
        self.pace = 1
        step = plays.step
        plays.step = lambda *measured: (time.sleep(0.012), step(*measured))[1]
        self.go(5)
        self.ask(4, 3)
        seen = []
        for _ in range(400):
            self.moving(0.0)
            seen += self.go(1, sleep=0.001)
        stiff = [command for command in seen if command.kp[0] > 2.0 * walks.kp[0]]
        self.assertGreater(len(stiff), 5)
        self.assertTrue(all(abs(self.action([command]) - 1.0) < 1e-6 for command in stiff))

    def test_no_stop_plan_leads_away_from_a_stiff_motion(self):
        for stiffer, plans in ((1.0, True), (5.0, False)):
            _, plays = self.both()
            plays.kp = stiffer * plays.kp
            self.go(5)
            self.plays()
            before = len(self.bus.of('STOP_PLAN'))
            self.go(60)
            self.assertEqual(len(self.bus.of('STOP_PLAN')) > before, plans)

    def test_a_joint_that_only_the_motion_moves_goes_back(self):
        self.both(11)
        rest = self.go(5)[-1].q[11]
        self.plays()
        self.ask(5, 0)
        self.period_ns = 10_000_000
        q = [command.q[11] for command in self.go(320)]
        self.assertGreater(max(abs(x - rest) for x in q), 0.2)
        self.assertAlmostEqual(q[-1], rest)
        self.assertLess(max(abs(b - a) for a, b in zip(q, q[1:])), 0.0051)  # 0.5 rad/s

    def test_a_policy_without_a_motion_says_so(self):
        self.start(wait=0.0)
        self.go(3)
        self.ask(4, 3)
        self.go(3)
        said = [bytes(np.array(event.text, dtype=np.int8).tobytes()).split(b'\0')[0].decode() for event in self.bus.of('EVENT')]
        self.assertTrue(any('no motion to play' in line for line in said), said)


class Words(unittest.TestCase):
    """What is said before anything runs."""

    def test_words_that_do_not_go_together(self):
        for words, said in ((['--play-spec', 'a.yaml'], '--play-spec is of'), (['--play', 't.onnx', '--check'], '--check looks at one policy'),
                            (['--play', 't.onnx', '--map'], '--map looks at one policy'), (['--fade', '--wait', '0'], '--wait 0 begins at once'),
                            (['--fade', '--no-fade'], 'contradict')):
            told = io.StringIO()
            with self.subTest(words), self.assertRaises(SystemExit) as end, contextlib.redirect_stderr(told):
                arguments.parse(['m.onnx', *words])
            self.assertEqual(end.exception.code, 2)
            self.assertIn(said, told.getvalue())
        for words in (['--play', 't.onnx', '--play-spec', 'a.yaml'], ['--fade'], ['--no-fade', '--wait', '0'], ['--check', '--motion', 'a.csv']):
            self.assertEqual(arguments.parse(['m.onnx', *words]).model.name, 'm.onnx')

    @unittest.skipUnless(RUNS, 'onnxruntime is missing')
    def test_what_cannot_play_is_refused_before_it_is_ready(self):
        def running(*words):
            told, said = io.StringIO(), io.StringIO()
            with contextlib.redirect_stderr(told), contextlib.redirect_stdout(said):
                status = command_line.main(arguments.parse(['--no-fifo', *map(str, words)]))
            self.assertNotIn('ready', said.getvalue())
            return status, told.getvalue()
        with tempfile.TemporaryDirectory() as folder:
            here = pathlib.Path(folder)
            walks, plays = tiny_onnx.linear(here / 'walk.onnx', 45, 12), tiny_onnx.linear(here / 'track.onnx', 42, 12)
            (here / 'walk.spec.yaml').write_text(spec.to_text(trot()))
            slow = tracker()
            slow.period = 0.04
            (here / 'track.spec.yaml').write_text(spec.to_text(slow))
            for words, said in (((walks, '--play', walks), 'it follows no motion, so it cannot be played'), ((walks, '--motion', 'a.csv'), 'follows no motion'),
                                ((walks, '--play', walks, '--motion', 'a.csv'), 'follows no motion'), ((walks, '--play', plays), 'the same period'),
                                ((walks, '--play', here / 'none.onnx'), 'no such file')):
                status, told = running(*words)
                self.assertEqual(status, 1)
                self.assertIn(said, told)


del Running  # its own tests run in policy_test.py

if __name__ == '__main__':
    unittest.main()
