#!/usr/bin/env python3
"""The compiled part of the package twinbus: simulations, worlds, questions to a robot, environments.  Of the package that Python finds
first (wheel_test.py installs one), else of this tree's build.

Skipped where there is no compiled part for this Python.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import unittest

SKIPPED = 77
try:
    import twinbus
except ImportError:
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))
    import twinbus
try:
    import numpy as np
    twinbus.home.native()
except ImportError as problem:
    print(f"skipped: {problem}")
    sys.exit(SKIPPED)
try:
    import gymnasium
    from gymnasium.utils.env_checker import check_env
    import twinbus.gym
except ImportError:
    gymnasium = None


def write_arms(folder):
    """A post with two arms in the plane, north along x and south against it, with a jaw on the south."""
    def link(name, x, size, mass):
        return (f"<link name='{name}'><inertial><origin xyz='{x} 0 0'/><mass value='{mass}'/><inertia ixx='0.01' iyy='0.01' izz='0.01' ixy='0' ixz='0' "
                f"iyz='0'/></inertial><collision><origin xyz='{x} 0 0'/><geometry><box size='{size} 0.04 0.04'/></geometry></collision></link>")

    def joint(name, kind, parent, child, x, z, axis, lower, upper):
        return (f"<joint name='{name}' type='{kind}'><origin xyz='{x} 0 {z}'/><parent link='{parent}'/><child link='{child}'/><axis xyz='{axis}'/>"
                f"<limit lower='{lower}' upper='{upper}' effort='50' velocity='2'/></joint>")

    text, hands = "<robot name='arms'>" + link("post", 0.0, 0.06, 20.0), ""
    for name, s in (("north", 1), ("south", -1)):
        text += link(f"{name}_upper", 0.16 * s, 0.2, 0.5) + link(f"{name}_lower", 0.14 * s, 0.16, 0.5)
        text += joint(f"{name}_turn", "revolute", "post", f"{name}_upper", 0.06 * s, 0.5, "0 0 1", -2, 2)
        text += joint(f"{name}_elbow", "revolute", f"{name}_upper", f"{name}_lower", 0.28 * s, 0, "0 0 1", -2, 2)
        hands += f"  {name}: {{frame: {name}_lower, at: [{0.2 * s}, 0, 0], joints: [{name}_turn, {name}_elbow]}}\n"
    text += link("south_jaw", 0.0, 0.02, 0.05) + joint("south_slide", "prismatic", "south_lower", "south_jaw", -0.26, 0, "-1 0 0", 0, 0.05)
    (folder / "arms.urdf").write_text(text + "</robot>")
    (folder / "robot.yaml").write_text(f"urdf: arms.urdf\nbase: fixed\nhands:\n{hands}grippers:\n  south: {{joints: [south_slide], open: [0.04], closed: [0.01]}}\n")
    return folder


class Simulations(unittest.TestCase):
    def test_looks_without_copies(self):
        simulation = twinbus.Simulation("stand", control=None)
        state, command, truth = simulation.state, simulation.command, simulation.truth
        q = state.q
        self.assertEqual((q.shape, q.dtype, state.wrench.shape, truth.foot_force.shape), ((29,), np.float64, (8, 6), (6, 3)))
        self.assertFalse(q.flags.owndata)
        knee = simulation.robot.joints.index("RLEG_KNEE")
        before = q[knee]
        for k in range(250):
            command.q[knee] = before + 0.1 * np.sin(0.02 * k)
            self.assertIs(simulation.step(), state)
        self.assertGreater(abs(q[knee] - before), 0.01)
        self.assertEqual(state.tick, int(state.ticks[0]))
        self.assertAlmostEqual(simulation.time, 0.5)
        simulation.reset()
        self.assertAlmostEqual(q[knee], before, 9)
        del simulation
        self.assertAlmostEqual(q[knee], before, 9)  # the view keeps what it looks at
        self.assertFalse(truth.fell)

    def test_builtin_control_is_that_of_run(self):
        simulation = twinbus.Simulation("sway", seed=3)
        simulation.step(499)
        said = subprocess.run([twinbus.home.program(), "run", "sway", "--for", "1", "--seed", "3"], capture_output=True, text=True)
        self.assertEqual(re.search(r"state_hash (\w+)", said.stdout)[1], simulation.state_hash, said.stdout + said.stderr)

    def test_walks_when_asked(self):
        simulation = twinbus.Simulation("stand")
        simulation.step(100)
        simulation.say("MODE_REQUEST", twinbus.mode_request_t(mode=5))
        simulation.step(500)
        start = np.array(simulation.truth.base_position)
        for _ in range(20):
            simulation.walk(0.2, 0.0, 0.0)
            simulation.step(100)
        self.assertGreater(simulation.truth.base_position[0] - start[0], 0.3)
        self.assertFalse(simulation.truth.fell)
        with self.assertRaisesRegex(ValueError, "STATE: one of MODE_REQUEST"):
            simulation.say("STATE", twinbus.robot_state_t())
        with self.assertRaisesRegex(ValueError, "another type"):
            simulation.say("WALK", twinbus.stop_t())

    def test_is_pushed(self):
        simulation = twinbus.Simulation("stand", control=None)
        simulation.push("CHEST", (0, 300, 0), 0.1)
        simulation.step(40)
        self.assertGreater(abs(simulation.truth.com_velocity[1]), 0.02)
        with self.assertRaisesRegex(ValueError, "no moving link 'CHES'"):
            simulation.push("CHES", (0, 1, 0), 0.1)

    def test_what_is_wrong_is_said(self):
        for call, said in ((lambda: twinbus.Simulation("stnd"), "stand"), (lambda: twinbus.Simulation("stand", "hrp9"), "hrp"),
                           (lambda: twinbus.Simulation(control="mine"), "'builtin' or None"), (lambda: twinbus.Simulation(engine="bullet"), "articulated, ode or mujoco"),
                           (lambda: twinbus.Worlds(count=0), "worlds: 1 to"), (lambda: twinbus.Robot("hrp9"), "hrp")):
            with self.assertRaisesRegex(ValueError, said):
                call()
        simulation = twinbus.Simulation("stand", control=None)
        simulation.command.q[3] = np.nan
        with self.assertRaisesRegex(ValueError, "RLEG_KNEE: a number that is not finite"):
            simulation.step()
        with self.assertRaises(ValueError):
            simulation.command.q[:] = np.zeros(30)

    def test_a_second_thread_is_refused_or_waits_its_turn(self):
        simulation, problems = twinbus.Simulation("stand", control=None), []

        def steps():
            for _ in range(200):
                try:
                    simulation.step(5)
                except RuntimeError as error:
                    problems.append(str(error))
        threads = [threading.Thread(target=steps) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertLessEqual(set(problems), {"this simulation is at work in another thread"})
        self.assertEqual(round(simulation.time / simulation.robot.period), 5 * (400 - len(problems)))

    def test_questions_to_a_robot(self):
        robot = twinbus.Robot("hrp1s")
        q = robot.info.poses["half_sitting"]
        self.assertEqual((robot.link_pose(q, "CHEST").shape, robot.jacobian(q, "CHEST").shape, robot.com(q).shape), ((4, 4), (6, 29), (3,)))
        self.assertGreater(robot.nearest(q, 3)[0][2], 0.0)
        path = robot.plan(q, "left", (0.35, 0.25, 0.1))
        self.assertTrue(path.found, path.text)
        np.testing.assert_allclose(path.at(0.0), path.q[0])
        np.testing.assert_allclose(path.at(99.0), path.q[-1])
        speed = (path.at(path.time[3] + 1e-6) - path.at(path.time[3] - 1e-6)) / 2e-6
        np.testing.assert_allclose(speed, path.qd[3], atol=1e-4)
        with self.assertRaisesRegex(ValueError, "28 numbers, the robot has 29"):
            robot.com(q[1:])

    def test_a_hand_is_placed_and_turned(self):
        robot, side, turn = twinbus.Robot("hrp1s"), "left", (0.7071068, 0.0, -0.7071068, 0.0)
        q = robot.info.poses["half_sitting"]
        found = robot.inverse(q, side, (0.35, 0.25, 0.15), turn)
        self.assertTrue(found.reached, found)
        self.assertLess(found.position_error, 1e-5)
        there = robot.inverse(found.q, side, (0.35, 0.25, 0.15), turn)
        np.testing.assert_allclose(there.q, found.q, atol=1e-4)
        self.assertTrue(np.all(found.q >= robot.info.lower) and np.all(found.q <= robot.info.upper))
        far = robot.inverse(q, side, (3.0, 0.0, 0.4))
        self.assertFalse(far.reached)
        self.assertGreater(far.position_error, 1.0)
        path = robot.plan(q, side, (0.35, 0.25, 0.15), orientation=turn)
        self.assertTrue(path.found, path.text)
        end = np.array(q)
        end[[robot.info.joints.index(name) for name in path.joints]] = path.at(99.0)
        hand = robot.inverse(end, side, (0.35, 0.25, 0.15), turn)
        np.testing.assert_allclose(hand.q, end, atol=2e-3)
        with self.assertRaisesRegex(ValueError, "no left hand"):
            twinbus.Robot("pendulum").inverse([0.0], "left", (0.4, 0.0, 0.4))
        with self.assertRaisesRegex(ValueError, "quaternion"):
            robot.inverse(q, side, (0.4, 0.0, 0.4), (0.0, 0.0, 0.0, 0.0))
        with self.assertRaisesRegex(ValueError, "four numbers"):
            robot.plan(q, side, (0.4, 0.0, 0.4), orientation=(1.0, 0.0, 0.0))

    def test_arms_have_the_names_of_robot_yaml(self):
        robot = twinbus.Robot("hrp1s")
        self.assertEqual((robot.info.hands, robot.info.grippers), ({"left": 1, "right": 2}, {}))
        with tempfile.TemporaryDirectory() as folder:
            robot = twinbus.Robot(write_arms(pathlib.Path(folder)))
        self.assertEqual(robot.info.hands, {"north": 3, "south": 4})
        self.assertEqual(robot.info.grippers, {"south": {"south_slide": (0.01, 0.04)}})
        q = np.zeros(len(robot.info.joints))
        for name, x in (("north", 0.35), ("south", -0.35)):
            found = robot.inverse(q, name, (x, 0.15, 0.5))
            self.assertTrue(found.reached, found)
            moved = {robot.info.joints[k] for k in np.nonzero(found.q)[0]}
            self.assertEqual({joint.split("_")[0] for joint in moved}, {name})
            path = robot.plan(q, name, (x, 0.15, 0.5))
            self.assertTrue(path.found, path.text)
            self.assertEqual(path.joints, (f"{name}_turn", f"{name}_elbow"))
        for ask in (robot.inverse, robot.plan):
            with self.assertRaisesRegex(ValueError, "no east hand; say one of: north, south"):
                ask(q, "east", (0.3, 0.0, 0.5))

    def test_a_way_goes_round_what_is_in_it(self):
        robot = twinbus.Robot("hrp1s")
        q, goal = robot.info.poses["half_sitting"], (0.35, 0.25, 0.1)
        self.assertTrue(robot.plan(q, "left", goal).found)
        beside = robot.plan(q, "left", goal, obstacles=[twinbus.Obstacle("sphere", (0.05,), (0.35, 0.25, 0.3))])
        self.assertTrue(beside.found, beside.text)
        inside = robot.plan(q, "left", goal, obstacles=[twinbus.Obstacle("box", (0.1, 0.1, 0.1), goal)])
        self.assertFalse(inside.found)
        self.assertIn("obstacle", inside.text)
        self.assertTrue(robot.plan(q, "left", goal).found)  # the next question knows nothing of it
        for obstacle, said in ((twinbus.Obstacle("cone", (0.1,), goal), "'box', 'sphere' or 'cylinder'"),
                               (twinbus.Obstacle("box", (0.1,), goal), "3 numbers, not 1"),
                               (twinbus.Obstacle("sphere", (-0.1,), goal), "obstacle 1: its size must be positive"),
                               (twinbus.Obstacle("sphere", (0.1,), (np.nan, 0.0, 0.0)), "obstacle 1")):
            with self.assertRaisesRegex(ValueError, said):
                robot.plan(q, "left", goal, obstacles=[obstacle])


@unittest.skipIf(gymnasium is None, "no gymnasium")
class Environments(unittest.TestCase):
    def test_pass_the_checker(self):
        for name in ("Stand", "Walk", "Reach", "Scene"):
            env = gymnasium.make(f"twinbus/{name}-v0")
            check_env(env.unwrapped, skip_render_check=True)

    def test_of_any_scene_and_robot(self):
        env = gymnasium.make("twinbus/Scene-v0", scene="walk_rough", robot="hrp2p")
        env.reset(seed=1)
        self.assertEqual(env.unwrapped.many.robot.name, "hrp2p")
        self.assertEqual(len(env.step(env.action_space.sample())[0]), 15 + 3 * len(env.unwrapped.many.robot.joints))

    def test_worlds_side_by_side_are_those_alone(self):
        envs = gymnasium.make_vec("twinbus/Stand-v0", num_envs=3, push=0.1)
        alone = gymnasium.make("twinbus/Stand-v0", push=0.1)
        many, _ = envs.reset(seed=[5, 6, 7])
        one, _ = alone.reset(seed=6)
        np.testing.assert_array_equal(many[1], one)
        luck = np.random.default_rng(1)
        for _ in range(20):
            actions = luck.uniform(-0.3, 0.3, envs.action_space.shape).astype(np.float32)
            many, rewards, _, _, _ = envs.step(actions)
            one, reward, _, _, _ = alone.step(actions[1])
            np.testing.assert_array_equal(many[1], one)
            self.assertEqual(rewards[1], reward)

    def test_episodes_begin_again_by_themselves(self):
        envs = gymnasium.make_vec("twinbus/Stand-v0", num_envs=2, max_episode_steps=5, push=0.0)
        first, _ = envs.reset(seed=1)
        for step in range(1, 13):
            seen, reward, fell, cut, _ = envs.step(np.zeros(envs.action_space.shape, np.float32))
            self.assertEqual((bool(cut.all()), bool(fell.any())), (step % 6 == 5, False), step)
            if step % 6 == 0:
                np.testing.assert_allclose(seen, first, atol=1e-6)
                self.assertEqual(reward.tolist(), [0.0, 0.0])
        with self.assertRaisesRegex(ValueError, "shape"):
            envs.step(np.zeros((2, 3), np.float32))

    def test_a_fall_ends_an_episode(self):
        env = gymnasium.make("twinbus/Stand-v0", action_scale=1.5)
        env.reset(seed=1)
        action = np.zeros(env.action_space.shape, np.float32)
        action[[1, 14]] = 1.0, 1.0  # both hips to one side
        steps = 0
        while not env.step(action)[2]:
            steps += 1
            self.assertLess(steps, 200)


if __name__ == "__main__":
    print("twinbus of", os.path.dirname(twinbus.__file__))
    unittest.main()
