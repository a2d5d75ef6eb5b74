"""When the machine itself stood still: tells its stalls from faults of ours (see test/tools/stall_watch.cpp)."""

import subprocess
import threading

from harness import BIN


class Stalls:
    """(from, to) on the steady clock [ns] of every instant at which a bare FIFO timer was more than 1 ms late."""

    def __init__(self):
        self.seen = []
        program = BIN / "stall_watch"
        self._process = None
        if program.exists():
            self._process = subprocess.Popen([program], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
            threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        for line in self._process.stdout:
            words = line.split()
            if len(words) == 3:
                self.seen.append((int(words[1]), int(words[2])))

    def between(self, begin_ns, end_ns):
        return [(a, b) for a, b in self.seen if b >= begin_ns and a <= end_ns]

    def longest_ms(self, begin_ns, end_ns):
        return max(((b - a) * 1e-6 for a, b in self.between(begin_ns, end_ns)), default=0.0)

    def close(self):
        if self._process is not None:
            self._process.terminate()
            self._process.wait()
