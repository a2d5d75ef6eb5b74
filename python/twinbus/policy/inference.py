"""Inference beside the loop: a thread that computes one action at a time, so that a network that takes too long keeps nobody waiting."""
from __future__ import annotations

import threading
from typing import Any, Callable


class Inference:
    """submit() a call, then wait() for what it gives; one at a time."""

    def __init__(self) -> None:
        self._ready, self._done = threading.Event(), threading.Event()
        self._call: Callable[[], Any] | None = None
        self._result: Any = None
        self._error: BaseException | None = None
        self._ended = False
        self._thread = threading.Thread(target=self._work, daemon=True, name='inference')
        self._thread.start()

    @property
    def running(self) -> bool:
        """Whether something was submitted that nobody has taken yet."""
        return self._call is not None

    def submit(self, call: Callable[[], Any]) -> None:
        assert self._call is None
        self._result = self._error = None
        self._done.clear()
        self._call = call
        self._ready.set()

    def close(self) -> None:
        """Ends the thread after what it computes now: Python must not end under a call into a library."""
        self._ended = True
        self._ready.set()
        self._thread.join(1.0)

    def wait(self, timeout: float) -> bool:
        """True when it is done; timeout [s]."""
        return self._done.wait(timeout)

    def take(self) -> Any:
        """What it gave.  What it threw is thrown here."""
        assert self._done.is_set()
        self._call = None
        if self._error is not None:
            raise self._error
        return self._result

    def _work(self) -> None:
        while True:
            self._ready.wait()
            self._ready.clear()
            if self._ended:
                return
            call = self._call
            try:
                self._result = call() if call is not None else None
            except BaseException as error:  # noqa: BLE001  (thrown again by take)
                self._error = error
            self._done.set()
