"""Questions to a robot's description: kinematics, distances between its links, arm motions.  Needs the compiled part."""
from __future__ import annotations

import dataclasses
import os
from typing import TYPE_CHECKING, Any, Sequence

import numpy as np
from numpy.typing import NDArray

from . import home
from .simulation import RobotInfo

if TYPE_CHECKING:
    from . import _native

Floats = NDArray[np.float64]


@dataclasses.dataclass(frozen=True)
class ArmPath:
    """A planned motion of an arm; cubic Hermite between knots.  Without a path time is empty and text says why."""
    text: str
    """What the planner says of it."""
    joints: tuple[str, ...]
    time: Floats
    """[knots], s from the start."""
    q: Floats
    """[knots, joints], rad."""
    qd: Floats
    """[knots, joints], rad/s."""

    @property
    def found(self) -> bool:
        """Whether there is a path."""
        return len(self.time) > 0

    def at(self, time: float) -> Floats:
        """The posture at a time from the start [s], [joints]; before it the first, behind the end the last."""
        if not self.found:
            raise ValueError(self.text)
        t = float(np.clip(time, self.time[0], self.time[-1]))
        k = min(max(int(np.searchsorted(self.time, t, side='right')) - 1, 0), len(self.time) - 2)
        h = self.time[k + 1] - self.time[k]
        s = (t - self.time[k]) / h
        return np.asarray((2 * s**3 - 3 * s**2 + 1) * self.q[k] + (s**3 - 2 * s**2 + s) * h * self.qd[k]
                          + (3 * s**2 - 2 * s**3) * self.q[k + 1] + (s**3 - s**2) * h * self.qd[k + 1])


@dataclasses.dataclass(frozen=True)
class Reached:
    """What inverse kinematics found."""
    reached: bool
    """Whether the hand is where it is wanted, within 1 um and 1 urad."""
    q: Floats
    """The nearest posture that was found [joints]; only joints of the arm differ from the start's."""
    position_error: float
    """[m]"""
    rotation_error: float
    """[rad]; 0 without an orientation."""


@dataclasses.dataclass(frozen=True)
class Obstacle:
    """Something in the way of an arm, in the base frame."""
    shape: str
    """'box', 'sphere' or 'cylinder' (along its z axis)."""
    size: tuple[float, ...]
    """Of a box its edges [3], of a sphere its radius [1], of a cylinder radius and length [2], m."""
    position: tuple[float, float, float]
    """Of its middle, m."""
    attitude: tuple[float, float, float, float] = (1.0, 0.0, 0.0, 0.0)
    """w x y z."""

    def _said(self) -> tuple[int, list[float], list[float], list[float]]:
        numbers = {'box': 3, 'sphere': 1, 'cylinder': 2}
        if self.shape not in numbers:
            raise ValueError(f"shape: 'box', 'sphere' or 'cylinder', not {self.shape!r}")
        if len(self.size) != numbers[self.shape]:
            raise ValueError(f"size of a {self.shape}: {numbers[self.shape]} numbers, not {len(self.size)}")
        size = [float(x) for x in self.size] + [0.0] * (3 - len(self.size))
        return list(numbers).index(self.shape) + 1, size, [float(x) for x in self.position], [float(x) for x in self.attitude]


class Robot:
    """A robot of config/robots or of a folder; its base is at the origin.

    q of all calls: [joints] in the order of STATE (info.joints), rad or m.  ValueError for another length, a number that is not finite or
    a name that is not there."""

    def __init__(self, robot: str | os.PathLike[str] = 'hrp1s') -> None:
        native: Any = home.native()
        self._native: _native.Robot = native.Robot(os.fspath(robot))
        self.info = RobotInfo.of(self._native.describe())

    def link_pose(self, q: Sequence[float] | Floats, link: str) -> Floats:
        """Pose of a link of the URDF in the base frame [4, 4], m."""
        return np.array(self._native.link_pose(_joints(q), link))

    def com(self, q: Sequence[float] | Floats) -> Floats:
        """Centre of mass in the base frame [3], m."""
        return np.array(self._native.com(_joints(q)))

    def jacobian(self, q: Sequence[float] | Floats, link: str) -> Floats:
        """[6, joints]: linear [m/s], then angular velocity [rad/s] of the link's origin, base axes, for a unit speed of each joint."""
        return np.array(self._native.jacobian(_joints(q), link))

    def nearest(self, q: Sequence[float] | Floats, most: int = 10) -> list[tuple[str, str, float]]:
        """The nearest pairs of links that are checked against each other and nearer than 1 m: names and distance [m] (below zero: depth)."""
        return [(pair.link_a, pair.link_b, pair.distance) for pair in self._native.nearest(_joints(q), most)]

    def inverse(self, q: Sequence[float] | Floats, hand: str, position: Sequence[float] | Floats,
                orientation: Sequence[float] | Floats | None = None) -> Reached:
        """Inverse kinematics: a posture in which a hand (a name of info.hands) is at a place of the base frame [3], m, with an orientation [4],
        w x y z, if one is given.  Found from posture q on, within the joints' limits; nothing looks at what touches (nearest, plan)."""
        said = self._native.inverse(_joints(q), hand, [float(x) for x in position], _turn(orientation))
        return Reached(said.reached, np.array(said.q), said.position_error, said.rotation_error)

    def plan(self, q: Sequence[float] | Floats, hand: str, position: Sequence[float] | Floats, speed: float = 0.4, seed: int = 1, *,
             orientation: Sequence[float] | Floats | None = None, obstacles: Sequence[Obstacle] = ()) -> ArmPath:
        """A motion from posture q that keeps clear of the body and of the obstacles, and brings a hand (a name of info.hands) to a place of the
        base frame [3], m, with an orientation [4], w x y z, if one is given.
        speed: share of the joints' velocity limits, up to 1.  Equal arguments, equal paths."""
        said = self._native.plan(_joints(q), hand, [float(x) for x in position], _turn(orientation),
                                 [obstacle._said() for obstacle in obstacles], speed, seed)
        columns = len(said.joints)
        return ArmPath(said.text, tuple(said.joints), np.array(said.time), np.array(said.q).reshape(-1, columns),
                       np.array(said.qd).reshape(-1, columns))


def _turn(orientation: Sequence[float] | Floats | None) -> list[float]:
    return [] if orientation is None else [float(x) for x in orientation]


def _joints(q: Sequence[float] | Floats) -> Floats:
    return np.ascontiguousarray(q, dtype=np.float64)
