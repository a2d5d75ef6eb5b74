"""The robot on the bus and the policy bound to it, made in a thread: reading the texts takes longer than a command may be late.

While the thread works, the robot is known before its policy is: with its gains its posture can be held."""
from __future__ import annotations

import sys
import threading
from typing import Any, Callable

from .acting import Acting
from .errors import PolicyError
from .model_text import ModelText
from .robot import Robot

SWITCH = 0.0005  # threads of Python take turns so often while a robot is read, so that the loop answers in time [s]


class Binding:
    """Starts by itself as soon as the texts of a robot are whole, before the first STATE when they come before it."""

    def __init__(self, bind: Callable[[Robot], Acting]) -> None:
        self._bind, self._texts = bind, ModelText()
        self._thread: threading.Thread | None = None
        self._error: Exception | None = None
        self._hash = 0
        self._robot: Robot | None = None
        self._controller: Acting | None = None

    def hear(self, piece: Any) -> None:
        """A message of MODEL_TEXT."""
        self._texts.hear(piece)
        if self._thread is None and self._texts.whole(piece.model_hash):
            self._begin(piece.model_hash)

    def look(self, model_hash: int) -> tuple[Robot | None, Acting | None]:
        """What is known by now of the robot with that hash.  What went wrong in the thread is thrown here."""
        if self._error is not None:
            raise self._error
        if self._hash != model_hash:  # texts of another robot were on the bus
            if self._texts.whole(model_hash) and not self.working:
                self._begin(model_hash)
            return None, None
        return self._robot, self._controller

    @property
    def working(self) -> bool:
        return self._thread is not None and self._thread.is_alive()

    def join(self, timeout: float) -> None:
        """Waits for the thread, at most timeout [s]."""
        if self._thread is not None:
            self._thread.join(timeout)

    def _begin(self, model_hash: int) -> None:
        self._hash, self._robot, self._controller = model_hash, None, None
        self._thread = threading.Thread(target=self._work, args=(model_hash,), daemon=True, name='binding')
        self._thread.start()

    def _work(self, model_hash: int) -> None:
        before = sys.getswitchinterval()
        sys.setswitchinterval(SWITCH)
        try:
            self._robot = self._texts.robot(model_hash)
            if self._robot is None:
                raise PolicyError('the robot on the bus cannot be read')
            self._controller = self._bind(self._robot)
        except Exception as error:  # noqa: BLE001  (thrown again by look)
            self._error = error
        finally:
            sys.setswitchinterval(before)
