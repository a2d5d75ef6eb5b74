"""A motion frame by frame, and where in it a policy is: what the observations of a tracking policy are made of."""
from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
STANDS = 1.0            # the first frame is held so long before the motion goes on [s]


@dataclass
class Followed:
    """A frame for each action of the policy."""
    q: Array        # [frames, joints of the policy], rad
    qd: Array       # [frames, joints of the policy], rad/s
    anchor: Array   # [frames, 3, 3], rotation of the anchor link in the world of the motion
    source: str

    def __len__(self) -> int:
        return len(self.q)

    @property
    def spread(self) -> float:
        """Rms of its joints from their means: so far from it is a robot that only stands there [rad]."""
        return float(np.sqrt(np.mean((self.q - self.q.mean(axis=0))**2)))


def yaw_of(rotation: Array) -> float:
    """Heading of the x axis [rad]."""
    return math.atan2(rotation[1, 0], rotation[0, 0])


def about_z(angle: float) -> Array:
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


class Follower:
    """Where in its motion a policy is.  The first frame is held for a second, the last one for good; its heading is turned to that of the robot."""

    def __init__(self, motion: Followed, period: float) -> None:
        self.motion = motion
        self._stands = round(STANDS / period)
        self.reset()

    def reset(self) -> None:
        """At the first frame again."""
        self._ticks = 0
        self._turn: Array | None = None

    @property
    def frame(self) -> int:
        return min(max(0, self._ticks - self._stands), len(self.motion) - 1)

    @property
    def begun(self) -> bool:
        """Whether it goes on from the first frame."""
        return self._ticks >= self._stands

    @property
    def ended(self) -> bool:
        return self._ticks - self._stands >= len(self.motion)

    def advance(self) -> None:
        """After an action."""
        self._ticks += 1

    def joints(self) -> Array:
        """Positions and speeds that the motion has now [2 x joints]."""
        return np.concatenate([self.motion.q[self.frame], self.motion.qd[self.frame]])

    def orientation(self, anchor: Array) -> Array:
        """Of the motion's anchor seen from the robot's: first two columns of the rotation, row by row [6].  anchor: of the robot in the world."""
        if self._turn is None:
            self._turn = about_z(yaw_of(anchor) - yaw_of(self.motion.anchor[self.frame]))
        seen = anchor.T @ self._turn @ self.motion.anchor[self.frame]
        return np.asarray(seen[:, :2].reshape(-1))
