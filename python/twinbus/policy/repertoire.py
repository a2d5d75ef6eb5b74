"""Two policies on one robot: one that walks, and one that follows a motion when it is asked to, and gives the robot back after it.

To the process it is one controller.  The change comes between two actions: from walking when the robot stands, back at the end of the motion
or when something else is asked."""
from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .controller import Controller
from .errors import PolicyError
from .observation import Measured, Observation
from .robot import Robot
from .spec import Spec

Array = NDArray[np.float64]
SLOW = 0.15          # of the base, before a motion begins [m/s]
PATIENCE = 2.0       # for that [s]


def pair_up(walks: Spec, plays: Spec) -> None:
    """PolicyError when plays cannot be played beside walks."""
    if not plays.follows:
        raise PolicyError(f'{plays.source or plays.name}: it follows no motion, so it cannot be played; --play wants a tracking policy '
                          '(doc/policy.md)')
    if abs(plays.period - walks.period) > 1e-6:
        raise PolicyError(f'{plays.source or plays.name}: an action every {1e3 * plays.period:g} ms, the policy that walks has one every '
                          f'{1e3 * walks.period:g} ms; --play wants the same period')


class Repertoire:
    """walks, plays: of one robot.  PolicyError when they are no pair."""

    def __init__(self, walks: Controller, plays: Controller) -> None:
        pair_up(walks.spec, plays.spec)
        self._walks, self._plays, self._now = walks, plays, walks
        self._asked, self._waited = False, 0.0

    @property
    def spec(self) -> Spec:
        return self._now.spec

    @property
    def robot(self) -> Robot:
        return self._walks.robot

    @property
    def observation(self) -> Observation:
        return self._now.observation

    @property
    def needs_velocity(self) -> bool:
        return True  # to know when it stands

    @property
    def kp(self) -> Array:
        return self._now.kp

    @property
    def kd(self) -> Array:
        return self._now.kd

    @property
    def playing(self) -> bool:
        return self._now is self._plays

    @property
    def ended(self) -> bool:
        return self.playing and self._plays.ended

    def reset(self) -> None:
        self._now, self._asked = self._walks, False
        self._walks.reset()

    def limited(self, command: Array) -> Array:
        return self._walks.limited(command)

    def posture(self, q: Array) -> Array:
        return self._walks.posture(q)

    @property
    def has_motion_beside(self) -> bool:
        return True

    def play(self, asked: bool) -> None:
        if asked and not self._asked:
            self._waited = 0.0
        self._asked = asked

    def step(self, measured: Measured, command: Array) -> Array:
        if self.playing and not self._asked:
            self._now = self._walks
            self._now.reset()
        elif self._asked and not self.playing:
            self._waited += self._walks.spec.period
            command = np.zeros(3)
            velocity = measured.base_velocity
            if self._waited > PATIENCE or self._waited > 0.2 and velocity is not None and float(np.linalg.norm(velocity)) < SLOW:
                self._now = self._plays
                self._now.reset()
        return self._now.step(measured, command)
