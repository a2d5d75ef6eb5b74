"""Gymnasium environments of any scene and robot, alone or many side by side (Worlds).

    import gymnasium, twinbus.gym                   # makes the names known
    env = gymnasium.make('twinbus/Stand-v0')
    envs = gymnasium.make_vec('twinbus/Walk-v0', num_envs=64, robot='hrp2p')
    env = gymnasium.make('twinbus/Scene-v0', scene='walk_rough')

| name | what is asked | reward of a step, at most 1 |
| --- | --- | --- |
| twinbus/Stand-v0 | stay upright and still while pushed | upright, slow base, small actions |
| twinbus/Walk-v0 | follow a velocity drawn at the start | base velocity and turning as asked, smooth actions |
| twinbus/Reach-v0 | bring the left hand to a place drawn at the start | nearness of the hand, upright |
| twinbus/Scene-v0 | stand in any scene, without pushes; a reward of your own: reward=function | as Stand |

Action, float32 [joints], -1 to 1: offset of the joints' set-points from the posture at the start, in action_scale [rad or m]; the
joints' servos (the robot's own gains) follow it for `decimation` ticks.  Observation, float32 [15 + 3 joints]: direction of gravity in the
frame of the IMU (3), angular velocity (3, rad/s), velocity of the base in its own axes (3, m/s), task (3), offset of the hand from its goal
in base axes (3, m; Reach only), joints: position from that at the start [rad], speed [rad/s] / 20, last action.  An episode ends when the
robot falls, and is cut off after 500 steps.
"""
from __future__ import annotations

import dataclasses
from typing import Any, Callable

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from .simulation import Worlds

Array = NDArray[np.float32]
Floats = NDArray[np.float64]
Reward = Callable[['Many', NDArray[np.float32]], Floats]

EPISODE = 500  # steps


@dataclasses.dataclass(frozen=True)
class Task:
    """What is asked: name, and how hard the robot is pushed."""
    name: str
    push: float = 0.0  # change of velocity of the whole robot by a push, at most [m/s]
    push_every: float = 2.0  # [s]


TASKS = {'Stand': Task('Stand', push=0.25), 'Walk': Task('Walk'), 'Reach': Task('Reach'), 'Scene': Task('Scene')}
PUSH_TIME = 0.1  # [s]
FASTEST = np.array([0.5, 0.2, 0.5])  # of Walk: forward, left [m/s], turning [rad/s]
REACH = 0.2  # how far goals of Reach are from where the hand begins, at most [m]


def rotate_back(attitude: NDArray[Any], vector: NDArray[Any]) -> Floats:
    """Vectors [n, 3] of the world in the axes of frames with these attitudes [n, 4] (w x y z)."""
    w, v = attitude[:, :1].astype(np.float64), -attitude[:, 1:].astype(np.float64)
    twice = 2.0 * np.cross(v, vector)
    return np.asarray(vector + w * twice + np.cross(v, twice))


class Many:
    """Episodes in many worlds: what the environments below are made of.  All arrays have the axis of the worlds in front."""

    def __init__(self, task: str, scene: str = 'stand', robot: str | None = None, count: int = 1, *, threads: int = 0, decimation: int = 10,
                 action_scale: float = 0.3, push: float | None = None, reward: Reward | None = None, engine: str | None = None,
                 settings: dict[str, object] | None = None) -> None:
        if task not in TASKS:
            raise ValueError(f'task: one of {", ".join(TASKS)}, not {task!r}')
        if decimation < 1:
            raise ValueError('decimation: at least 1 tick')
        self.task, self.decimation, self.action_scale = TASKS[task], decimation, action_scale
        self.push = self.task.push if push is None else push
        self.reward_of = reward
        self.worlds = Worlds(scene, robot, count, threads=threads, engine=engine, settings=settings)
        self.robot = self.worlds.robot
        joints = len(self.robot.joints)
        self.action_space = spaces.Box(-1.0, 1.0, (joints,), np.float32)
        self.observation_space = spaces.Box(-np.inf, np.inf, (15 + 3 * joints,), np.float32)
        self.start: Floats = np.array(self.worlds.state.q)
        self.action: Array = np.zeros((count, joints), np.float32)
        self.asked: Floats = np.zeros((count, 3))
        """Task: of Walk the velocity asked for; of Reach the goal of the left hand, world [m]."""
        self.steps: NDArray[np.int64] = np.zeros(count, np.int64)
        """Of the episodes."""
        self.luck = [np.random.default_rng(world) for world in range(count)]
        self.next_push: NDArray[np.int64] = np.zeros(count, np.int64)

    @property
    def dt(self) -> float:
        """Of a step [s]."""
        return self.decimation * self.robot.period

    def reset(self, which: NDArray[np.int64], luck: dict[int, np.random.Generator]) -> None:
        """Episodes of these worlds begin; luck: the generators of those that get a new one."""
        for world in which:
            self.luck[world] = luck.get(int(world), self.luck[world])
        self.worlds.reset(which, [int(self.luck[world].integers(1, 1 << 31)) for world in which])
        self.start[which] = self.worlds.state.q[which]
        self.action[which], self.steps[which] = 0.0, 0
        for world in which:
            if self.task.name == 'Walk':
                self.asked[world] = self.luck[world].uniform([0.0, -FASTEST[1], -FASTEST[2]], FASTEST)
            elif self.task.name == 'Reach':
                self.asked[world] = self.worlds.hand_position[world, 0] + self.luck[world].uniform([0.0, -REACH / 2, 0.0], [REACH, REACH, REACH])
            self._plan_push(int(world))

    def _plan_push(self, world: int) -> None:
        wait = self.luck[world].uniform(0.25, 1.0) * self.task.push_every
        self.next_push[world] = self.steps[world] + max(1, round(wait / self.dt))

    def _pushes(self) -> None:
        for world in np.flatnonzero(self.steps >= self.next_push):
            angle, share = self.luck[world].uniform([0.0, 0.0], [2.0 * np.pi, 1.0])
            force = share * self.push * self.robot.mass / PUSH_TIME
            self.worlds.push(int(world), self.robot.links[0], (force * np.cos(angle), force * np.sin(angle), 0.0), PUSH_TIME)
            self._plan_push(int(world))

    def step(self, action: NDArray[Any]) -> tuple[Floats, NDArray[np.bool_]]:
        """Reward and whether the robot fell, of all worlds."""
        action = np.clip(np.asarray(action, np.float32), -1.0, 1.0)
        if action.shape != self.action.shape:
            raise ValueError(f'action: shape {action.shape}, must be {self.action.shape}')
        if not np.isfinite(action).all():
            raise ValueError('action: not finite')
        if self.push > 0.0:
            self._pushes()
        self.worlds.command.q[:] = np.clip(self.start + self.action_scale * action, self.robot.lower, self.robot.upper)
        self.worlds.step(self.decimation)
        self.steps += 1
        reward = (self.reward_of or type(self).reward)(self, action)
        self.action[:] = action
        return reward, self.worlds.truth.fallen | self.worlds.failed

    def velocity(self) -> Floats:
        """Of the base in its own axes [worlds, 3], m/s."""
        return rotate_back(self.worlds.truth.base_attitude, self.worlds.truth.base_velocity)

    def gravity(self) -> Floats:
        """Direction of gravity in the frame of the IMU [worlds, 3]."""
        down = np.zeros((self.worlds.count, 3))
        down[:, 2] = -1.0
        return rotate_back(self.worlds.state.attitude, down)

    def to_goal(self) -> Floats:
        """From the left hand to its goal, base axes [worlds, 3], m; zero unless the task is Reach."""
        if self.task.name != 'Reach':
            return np.zeros((self.worlds.count, 3))
        return rotate_back(self.worlds.truth.base_attitude, self.asked - self.worlds.hand_position[:, 0])

    def reward(self, action: NDArray[np.float32]) -> Floats:
        """Of the step just made [worlds], at most 1; action: the one that was taken."""
        smooth = np.exp(-0.5 * np.mean((action - self.action) ** 2, axis=1))
        upright = np.exp(-10.0 * np.sum(self.gravity()[:, :2] ** 2, axis=1))
        if self.task.name == 'Walk':
            miss = self.velocity()[:, :2] - self.asked[:, :2]
            turn = self.worlds.truth.base_angular_velocity[:, 2] - self.asked[:, 2]
            return np.asarray(0.6 * np.exp(-np.sum(miss**2, axis=1) / 0.04) + 0.2 * np.exp(-(turn**2) / 0.1) + 0.1 * upright + 0.1 * smooth)
        if self.task.name == 'Reach':
            far = np.linalg.norm(self.to_goal(), axis=1)
            return np.asarray(0.7 * np.exp(-far / 0.1) + 0.2 * upright + 0.1 * smooth)
        still = np.exp(-np.sum(self.velocity() ** 2, axis=1) / 0.04)
        small = np.exp(-np.mean(action**2, axis=1))
        return np.asarray(0.4 * upright + 0.4 * still + 0.1 * small + 0.1 * smooth)

    def observation(self) -> Array:
        """Of all worlds."""
        state = self.worlds.state
        task = self.asked if self.task.name == 'Walk' else np.zeros_like(self.asked)
        parts: list[NDArray[Any]] = [self.gravity(), state.gyro, self.velocity(), task, self.to_goal(), state.q - self.start, 0.05 * state.qd,
                                     self.action]
        return np.nan_to_num(np.concatenate(parts, axis=1).astype(np.float32), posinf=0.0, neginf=0.0)


class Env(gymnasium.Env[Array, Array]):
    """One world.  Arguments as of Many; metadata has no renderer: `./twinbus run SCENE --log`, then `./twinbus log view` shows one."""

    metadata: dict[str, Any] = {'render_modes': []}
    render_mode = None

    def __init__(self, task: str, render_mode: str | None = None, **options: Any) -> None:
        self.many = Many(task, **options)
        self.observation_space, self.action_space = self.many.observation_space, self.many.action_space

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Array, dict[str, Any]]:
        """Begins an episode."""
        super().reset(seed=seed)
        self.many.reset(np.zeros(1, np.int64), {0: self.np_random})
        return self.many.observation()[0], {}

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """The joints follow the action for decimation ticks."""
        reward, fell = self.many.step(np.asarray(action)[None])
        return self.many.observation()[0], float(reward[0]), bool(fell[0]), False, {}


class VectorEnv(gymnasium.vector.VectorEnv[Array, Array, NDArray[Any]]):
    """Many worlds, stepped by `threads` threads (0: one per processor).  The step after the end of an episode begins the next one; its
    action is not used and its reward is 0."""

    metadata: dict[str, Any] = {'render_modes': [], 'autoreset_mode': gymnasium.vector.AutoresetMode.NEXT_STEP}

    def __init__(self, task: str, num_envs: int = 1, max_episode_steps: int = EPISODE, render_mode: str | None = None, **options: Any) -> None:
        self.num_envs, self.max_episode_steps = num_envs, max_episode_steps
        self.many = Many(task, count=num_envs, **options)
        self.single_observation_space, self.single_action_space = self.many.observation_space, self.many.action_space
        self.observation_space = gymnasium.vector.utils.batch_space(self.single_observation_space, num_envs)
        self.action_space = gymnasium.vector.utils.batch_space(self.single_action_space, num_envs)
        self.done: NDArray[np.bool_] = np.zeros(num_envs, np.bool_)

    def reset(self, *, seed: int | list[int | None] | None = None, options: dict[str, Any] | None = None) -> tuple[Array, dict[str, Any]]:
        """All begin an episode.  seed: of the first world, the others count up; or one for each."""
        seeds = [None if seed is None else seed + i for i in range(self.num_envs)] if not isinstance(seed, list) else seed
        if len(seeds) != self.num_envs:
            raise ValueError(f'seed: {len(seeds)}, there are {self.num_envs} worlds')
        luck = {world: np.random.default_rng(one) for world, one in enumerate(seeds) if one is not None}
        self.many.reset(np.arange(self.num_envs), luck)
        self.done[:] = False
        return self.many.observation(), {}

    def step(self, actions: Array) -> tuple[Array, NDArray[Any], NDArray[Any], NDArray[Any], dict[str, Any]]:
        """Of all worlds: observation, reward, fallen, cut off, {}."""
        ended = np.flatnonzero(self.done)
        reward, fell = self.many.step(np.where(self.done[:, None], 0.0, actions))
        if len(ended):
            self.many.reset(ended, {})
            reward[ended], fell[ended] = 0.0, False
        cut = (self.many.steps >= self.max_episode_steps) & ~fell
        self.done = fell | cut
        return self.many.observation(), reward, fell.copy(), cut, {}


def register() -> None:
    """Makes the names known to gymnasium, as an import of this module does (and up to Gymnasium 1.3 the installed package by itself)."""
    for task in TASKS:
        name = f'twinbus/{task}-v0'
        if name not in gymnasium.registry:
            gymnasium.register(name, entry_point='twinbus.gym:Env', vector_entry_point='twinbus.gym:VectorEnv', max_episode_steps=EPISODE,
                               kwargs={'task': task})


register()
