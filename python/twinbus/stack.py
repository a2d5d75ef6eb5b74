"""A stack (simulator, controller, guard, planner ...) started and ended from Python."""
from __future__ import annotations

import os
import pathlib
import re
import signal
import subprocess
import threading
import time
from types import TracebackType

from . import home

READY = 'FIFO priority'  # in the line that `up` prints when everything runs


class Stack:
    """`twinbus up SCENE OPTIONS`, started at once and running until stop(), the end of a with block, or the end of Python.

        stack = twinbus.Stack('stand', '--stack', 'both', viewer=True)
        stack.page                             # address of the viewer
        bus = twinbus.Bus(); bus.listen('STATE'); bus.wait('STATE').q
        stack.stop()

    words: as behind `./twinbus up` (see `./twinbus up --help`).  viewer: False starts none.  environment: added to that of Python.
    FileNotFoundError when the program is not there, RuntimeError with what it said when it does not run within timeout [s]."""

    def __init__(self, *words: str, viewer: bool = False, timeout: float = 60.0, environment: dict[str, str] | None = None) -> None:
        self.lines: list[str] = []
        """What the stack has said, one line each."""
        command = [str(home.program()), 'up', *map(str, words)] + ([] if viewer else ['--no-viewer'])
        self._process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, text=True,
                                         env=dict(os.environ, **(environment or {})))
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        end = time.monotonic() + timeout
        while not any(READY in line for line in self.lines):
            if self._process.poll() is not None or time.monotonic() > end:
                self.stop()
                raise RuntimeError(f'twinbus up {" ".join(words)} does not run:\n' + '\n'.join(self.lines[-30:]))
            time.sleep(0.02)

    def _read(self) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            self.lines.append(line.rstrip('\n'))

    @property
    def running(self) -> bool:
        """Whether it has not ended."""
        return self._process.poll() is None

    @property
    def page(self) -> str | None:
        """The address of the viewer's page, or None without one."""
        for line in self.lines:
            if found := re.search(r'https?://\S+', line):
                return found[0]
        return None

    @property
    def log(self) -> pathlib.Path | None:
        """The log that it writes, or None when it records none."""
        for line in self.lines:
            for word in line.split():
                folder = pathlib.Path(word.rstrip('.,:'))
                if folder.is_absolute() and (folder / 'run.log').is_file():
                    return folder / 'run.log'
        return None

    def stop(self, timeout: float = 20.0) -> int:
        """Ends the stack in order, as Ctrl-C does, and gives its exit status (0: it kept its rates and the robot did not fall)."""
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGINT)
            try:
                self._process.wait(timeout)
            except subprocess.TimeoutExpired:
                self._process.kill()
        status = self._process.wait()
        self._reader.join(1.0)
        return status

    def __enter__(self) -> Stack:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self.stop()

    def __del__(self) -> None:
        if getattr(self, '_process', None) is not None and self._process.poll() is None:
            self._process.send_signal(signal.SIGINT)
