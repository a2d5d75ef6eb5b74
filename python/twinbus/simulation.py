"""A scene in this process, as fast as it goes: the nodes of `./twinbus run`, stepped from Python, looked at without copies.

    import twinbus
    simulation = twinbus.Simulation('stand', controller=None)
    while simulation.time < 5.0 and not simulation.truth.fell:
        state, command = simulation.state, simulation.command
        command.q[3] = posture[3] + 0.1 * np.sin(simulation.time)
        simulation.step()

Joint arrays are in the order of STATE, `simulation.robot.joints`.  Needs the compiled part: pip install ./python.
"""
from __future__ import annotations

import dataclasses
import functools
import os
from typing import TYPE_CHECKING, Any, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from . import home
from .lcm_types import Message
from .messages import walk_command_t

if TYPE_CHECKING:
    from . import _native

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]


class State:
    """What the robot measures now: views into the simulation, which change with each step.  Of many worlds there is one more axis in
    front, that of the worlds."""

    q: Floats
    """Positions [joints], rad or m."""
    qd: Singles
    """Speeds [joints], rad/s or m/s."""
    tau: Singles
    """Torques [joints], N m or N."""
    attitude: Singles
    """Of the IMU link in the world [4], w x y z; the heading is arbitrary."""
    gyro: Singles
    """Angular velocity in the frame of the IMU [3], rad/s."""
    accel: Singles
    """Specific force in the frame of the IMU [3], m/s^2."""
    wrench: Singles
    """[8, 6]: six feet (left, right, then the others), left hand, right hand; force [N] and torque [N m] on the robot, sensor frame."""
    ticks: NDArray[np.int64]
    """[1] or [worlds]: number of this state."""
    stop_kinds: NDArray[np.int8]
    """[1] or [worlds]: 0 no stop, 1 balanced, 2 hold, 3 off (of a fallen robot)."""

    def __init__(self, views: Mapping[str, NDArray[Any]]) -> None:
        self.__dict__.update(views)
        self.ticks, self.stop_kinds = views['tick'], views['stop_kind']

    @property
    def tick(self) -> int:
        """Number of this state (of the first world)."""
        return int(self.ticks[0])

    @property
    def stop_kind(self) -> int:
        """0 no stop, 1 balanced, 2 hold, 3 off (of the first world)."""
        return int(self.stop_kinds[0])


class Command:
    """What is asked of the joints: views that are written.  A joint's torque is tau + kp (q - q_measured) + kd (qd - qd_measured), within
    its limits.  After reset() it holds the posture with the robot's own gains."""

    q: Floats
    """[joints], rad or m."""
    qd: Singles
    """[joints], rad/s or m/s."""
    tau: Singles
    """Feed-forward [joints], N m or N."""
    kp: Singles
    """[joints], N m/rad or N/m; not below zero."""
    kd: Singles
    """[joints], N m s/rad or N s/m; not below zero."""

    def __init__(self, views: Mapping[str, NDArray[Any]]) -> None:
        self.__dict__.update(views)


class Truth:
    """What only a simulator knows: views, in the world's frame (z up)."""

    base_position: Floats
    """Origin of the base link [3], m."""
    base_attitude: Floats
    """Of the base link [4], w x y z."""
    base_velocity: Floats
    """Of the base link's origin [3], m/s."""
    base_angular_velocity: Floats
    """[3], rad/s."""
    com: Singles
    """Centre of mass [3], m."""
    com_velocity: Singles
    """[3], m/s."""
    zmp: Singles
    """Zero-moment point on the ground [2], m."""
    foot_position: Singles
    """Of the feet [6, 3]: left and right sole, then the others; what there is not is zero; m."""
    foot_force: Singles
    """Of the ground on the feet [6, 3], N."""
    fallen: NDArray[np.bool_]
    """[1] or [worlds]: the base is below half of its height at the start, or tilted by 60 degrees."""

    def __init__(self, views: Mapping[str, NDArray[Any]]) -> None:
        self.__dict__.update(views)
        self.fallen = views['fell']

    @property
    def fell(self) -> bool:
        """Whether the robot has fallen (that of the first world)."""
        return bool(self.fallen[0])


@dataclasses.dataclass(frozen=True)
class RobotInfo:
    """What the robot's description says; joint arrays in the order of STATE."""
    name: str
    folder: str
    joints: tuple[str, ...]
    links: tuple[str, ...]
    """Those that a joint moves, and the base."""
    lower: Floats
    """[joints], rad or m; -inf for a joint that turns on and on."""
    upper: Floats
    velocity: Floats
    """Limits [joints], rad/s or m/s."""
    effort: Floats
    """Limits [joints], N m or N."""
    kp: Floats
    """The robot's own gains [joints], N m/rad or N/m."""
    kd: Floats
    poses: dict[str, Floats]
    """Named poses of the SRDF, each [joints]."""
    hands: dict[str, int]
    """Its arms by name: the number of each in arm_goal_t."""
    grippers: dict[str, dict[str, tuple[float, float]]]
    """Of an arm that has one: its joints, each with where it is closed and open [rad or m]."""
    period: float
    """Of a tick [s]."""
    mass: float
    """[kg]"""

    @staticmethod
    def of(said: Mapping[str, Any]) -> RobotInfo:
        """From the compiled module's words."""
        arrays = {key: np.array(said[key], dtype=np.float64) for key in ('lower', 'upper', 'velocity', 'effort', 'kp', 'kd')}
        return RobotInfo(name=said['name'], folder=said['folder'], joints=tuple(said['joints']), links=tuple(said['links']),
                         poses={name: np.array(q, dtype=np.float64) for name, q in said['poses'].items()},
                         hands=dict(said['hands']), grippers={name: dict(joints) for name, joints in said['grippers'].items()}, period=said['period'],
                         mass=said['mass'], **arrays)


def _settings(settings: Mapping[str, object] | None) -> list[tuple[str, str]]:
    return [(key, str(value)) for key, value in (settings or {}).items()]


class _OfOneRobot:
    _native: Any

    @functools.cached_property
    def robot(self) -> RobotInfo:
        """The robot's description."""
        return RobotInfo.of(self._native.robot())


class Simulation(_OfOneRobot):
    """A scene with its robot, beginning at once.

    scene: a name in config/scenes or a file.  robot: a name in config/robots or a folder; None: the scene's.  seed: of everything
    random.  control: 'builtin': our controller in C++ balances, walks and reaches, and the scene's own requests are said to it;
    None: `command` is obeyed through the gate that every robot has (limits, a fallen robot is let go).  engine: 'articulated' or
    'ode'.  start_pose: of the robot's SRDF.  guard: of self-collision, in our controller.  fade: the first command is faded in over
    0.3 s, as it is on a bus.  settings: as --set of `./twinbus run`.

    ValueError with one sentence for what cannot be loaded.  Equal arguments, equal states to the last bit."""

    def __init__(self, scene: str | os.PathLike[str] = 'stand', robot: str | os.PathLike[str] | None = None, seed: int = 1, *,
                 control: str | None = 'builtin', engine: str | None = None, start_pose: str | None = None, guard: bool = True,
                 fade: bool = False, settings: Mapping[str, object] | None = None) -> None:
        if control not in ('builtin', None):
            raise ValueError(f"control: 'builtin' or None, not {control!r}")
        native: Any = home.native()
        self._native: _native.Simulation = native.Simulation(
            os.fspath(scene), os.fspath(robot or ''), engine or '', start_pose or '', seed, control == 'builtin', guard, fade,
            _settings(settings))
        state, command, truth = self._native.views()
        self.state, self.command, self.truth = State(state), Command(command), Truth(truth)

    @property
    def time(self) -> float:
        """Simulated since reset() [s]."""
        return self._native.time()

    @property
    def seed(self) -> int:
        """Of the present run."""
        return self._native.seed()

    @property
    def state_hash(self) -> str:
        """Of all states so far, as `./twinbus run` prints it."""
        return self._native.state_hash()

    def reset(self, seed: int | None = None) -> State:
        """Begins anew, with another seed if one is given; the views stay valid."""
        self._native.reset(self.seed if seed is None else seed)
        return self.state

    def step(self, ticks: int = 1) -> State:
        """Lets `ticks` periods of robot.period pass: the present state is answered (by our controller, or by `command`), physics goes on,
        the robot is measured.  ValueError names a joint whose command is not finite; RuntimeError: the simulation gave up."""
        self._native.step(ticks)
        return self.state

    def say(self, channel: str, message: Message) -> None:
        """A request to our controller, as on the bus: MODE_REQUEST, WALK, ARM_GOAL or STOP; ids, time and sequence are filled in.  The
        later request wins: what the scene itself asks at its start is said again for 0.2 s."""
        self._native.say(channel, message.encode())

    def walk(self, vx: float, vy: float, wz: float, timeout: float = 1.0) -> None:
        """A velocity to walk at, forward, left [m/s], turning left [rad/s]; counts for timeout [s], in mode walk (MODE_REQUEST 5)."""
        self.say('WALK', walk_command_t(vx=vx, vy=vy, wz=wz, timeout=timeout))

    def push(self, link: str, force: Sequence[float], seconds: float, point: Sequence[float] = (0.0, 0.0, 0.0)) -> None:
        """A force on a link [3], world, N, for so long [s] from now on, at a point of the link's frame [3], m."""
        self._native.push(link, [float(f) for f in force], [float(p) for p in point], seconds)

    def sentences(self) -> list[str]:
        """What controller and planner had to say since the last call."""
        return self._native.sentences()


class Worlds(_OfOneRobot):
    """Many worlds of one scene and robot side by side, stepped by `threads` threads (0: one per processor): for learning.  There is no
    gate, controller, guard or bus between command and robot; torques are within the joints' limits all the same.

    state, command, truth: as of Simulation, with the axis of the worlds in front, still without copies; command.q is [worlds, joints].
    World i begins with seed + i."""

    def __init__(self, scene: str | os.PathLike[str] = 'stand', robot: str | os.PathLike[str] | None = None, count: int = 1, seed: int = 1, *,
                 threads: int = 0, engine: str | None = None, start_pose: str | None = None,
                 settings: Mapping[str, object] | None = None) -> None:
        native: Any = home.native()
        self._native: _native.Worlds = native.Worlds(
            os.fspath(scene), os.fspath(robot or ''), engine or '', start_pose or '', seed, _settings(settings), count, threads)
        state, command, truth = self._native.views()
        self.state, self.command, self.truth = State(state), Command(command), Truth(truth)
        self.count = count
        self.hand_position: Floats = truth['hand_position']
        """Origins of the hand frames [worlds, 2, 3], left and right, world, m."""
        self.failed: NDArray[np.bool_] = truth['failed']
        """[worlds]: the simulation of this world gave up; it stands still until reset()."""

    @property
    def threads(self) -> int:
        """That work."""
        return self._native.threads()

    def reset(self, worlds: Sequence[int] | NDArray[np.int64], seeds: Sequence[int] | NDArray[np.int64]) -> None:
        """These worlds begin anew, each with its seed."""
        self._native.reset([int(world) for world in worlds], [int(seed) for seed in seeds])

    def step(self, ticks: int = 1) -> None:
        """All worlds obey their command for so many ticks.  ValueError names world and joint of a command that is not finite."""
        self._native.step(ticks)

    def push(self, world: int, link: str, force: Sequence[float], seconds: float, point: Sequence[float] = (0.0, 0.0, 0.0)) -> None:
        """As Simulation.push, in one world."""
        self._native.push(world, link, [float(f) for f in force], [float(p) for p in point], seconds)
