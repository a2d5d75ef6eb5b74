"""Who says how fast to walk: WALK, GAMEPAD, or the velocity of the command line.  MODE_REQUEST chooses walk or balance."""
from __future__ import annotations

import math
import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
BALANCE, WALK = 4, 5     # modes of mode_request_t
PLAYED = 3               # its motion
PAD_SILENCE = 0.25       # [s] after which a pad counts as let go


class Operator:
    """command: vx, vy [m/s], wz [rad/s], while nobody else says one.  most: the largest of each, for a stick pressed to its end."""

    def __init__(self, command: Array, least: Array, most: Array) -> None:
        self.fixed, self.least, self.most = command, least, most
        self.mode, self.mode_sequence, self.walk_sequence = WALK, 0, 0
        self.plays = False     # a motion is wanted
        self.complaint = ''    # a sentence about the last request, until it is taken
        self._walk, self._walk_until = np.zeros(3), -math.inf
        self._pad, self._pad_until = np.zeros(3), -math.inf
        self._asked: dict[int, int] = {}  # newest sequence per sender

    def hear(self, channel: str, message: Any, run_id: int) -> None:
        """A message for the run that is active; what is for another run, old or no number changes nothing."""
        if message.run_id != run_id:
            return
        if channel == 'GAMEPAD':
            self._hear_pad(message)
        elif channel == 'WALK':
            self._hear_walk(message)
        elif self._newer(message):
            self.mode_sequence = message.sequence
            if message.mode in (BALANCE, WALK):
                self.mode, self.plays = message.mode, message.mode == BALANCE and message.motion == PLAYED
            else:
                self.complaint = f'controller: a policy knows the modes walk and balance, not mode {message.mode}'

    def _newer(self, message: Any) -> bool:
        last = self._asked.get(message.sender_id, -1)
        if message.sequence <= last:
            return False
        self._asked[message.sender_id] = message.sequence
        while len(self._asked) > 64:
            self._asked.pop(next(iter(self._asked)))
        return True

    def _hear_walk(self, message: Any) -> None:
        asked = np.array([message.vx, message.vy, message.wz], dtype=np.float64)
        if not np.all(np.isfinite(asked)) or not 0.0 < message.timeout <= 10.0 or not self._newer(message):
            return
        self._walk, self._walk_until = asked, time.monotonic() + message.timeout
        self.walk_sequence = message.sequence

    def _hear_pad(self, message: Any) -> None:
        axes = np.array([message.left_y, message.left_x, message.right_x], dtype=np.float64)
        if not np.all(np.isfinite(axes)) or not message.connected or not message.deadman:
            self._pad_until = -math.inf
            return
        axes = np.clip(axes, -1.0, 1.0)
        self._pad = np.where(axes >= 0.0, axes * self.most, -axes * self.least)
        self._pad_until = time.monotonic() + PAD_SILENCE

    def command(self) -> Array:
        """The velocity in force now."""
        now = time.monotonic()
        if self.mode == BALANCE:
            return np.zeros(3)
        if now < self._pad_until:
            return self._pad
        return self._walk if now < self._walk_until else self.fixed
