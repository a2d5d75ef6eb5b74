"""What the process drives a robot with: one policy (controller.py), or two that take turns (repertoire.py)."""
from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from .observation import Measured, Observation
from .robot import Robot
from .spec import Spec

Array = NDArray[np.float64]


class Acting(Protocol):
    """spec, observation, kp, kd: of the policy in force, which changes between two actions only."""

    @property
    def spec(self) -> Spec: ...

    @property
    def robot(self) -> Robot: ...

    @property
    def observation(self) -> Observation: ...

    @property
    def needs_velocity(self) -> bool:
        """Whether it reads the velocity of the base."""

    @property
    def kp(self) -> Array:
        """Per joint on the bus [N m/rad]."""

    @property
    def kd(self) -> Array:
        """Per joint on the bus [N m s/rad]."""

    @property
    def playing(self) -> bool:
        """Whether it follows a motion now."""

    @property
    def ended(self) -> bool:
        """Whether that has come to its last frame, which is held."""

    @property
    def has_motion_beside(self) -> bool:
        """Whether play() changes anything."""

    def play(self, asked: bool) -> None:
        """A motion is wanted, or none; of one policy alone nothing changes."""

    def reset(self) -> None:
        """As at the first tick."""

    def limited(self, command: Array) -> Array:
        """A velocity that the policy was trained for; zero stays zero."""

    def posture(self, q: Array) -> Array:
        """The posture in which it begins; joints that it does not have stay as in q [joints on the bus]."""

    def step(self, measured: Measured, command: Array) -> Array:
        """Targets of its joints [joints of spec]."""
