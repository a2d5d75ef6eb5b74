"""How the loop of a running stack does while something else is done to it: time from STATE to COMMAND, tick by tick."""

import bisect
import subprocess
import threading
import time

from harness import BIN, percentile


MARGIN = 4_000_000  # ticks so near to a stall felt it [ns]


def covered(instant, ends):
    """Lies it in one of these (end, begin), sorted?"""
    at = bisect.bisect_left(ends, (instant, 0))
    return any(begin <= instant for _, begin in ends[at:at + 4])


class Loop:
    """Listens from now on; `ticks` are (steady clock [ns], tick, microseconds to its command or -1)."""

    def __init__(self):
        self.ticks = []
        self._process = subprocess.Popen([BIN / "loop_watch"], stdout=subprocess.PIPE, text=True)
        self._process.stdout.readline()
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        for line in self._process.stdout:
            at, tick, took = line.split()
            self.ticks.append((int(at), int(tick), int(took)))

    def close(self):
        self._process.terminate()
        self._process.wait()


class Figures:
    """Of the ticks in some spans of time."""

    def __init__(self, ticks, spans, stalls=()):
        """Ticks in which the machine itself stood still, by a bare timer, are left out of the times (never out of `unanswered`)."""
        inside = [t for t in ticks if any(a <= t[0] <= b for a, b in spans)]
        self.ticks = len(inside)
        # Two stalls never overlap on one processor; where they do on two, the later one decides, and both are short.
        ends = sorted((b + MARGIN, a - MARGIN) for a, b in stalls)
        clean = [t for t in inside if not covered(t[0], ends)]
        self.left_out = len(inside) - len(clean)
        self.unanswered = sum(took < 0 for _, _, took in inside)
        times = [took for _, _, took in clean if took >= 0]
        self.median, self.p99, self.p999 = (percentile(times, share) for share in (0.5, 0.99, 0.999))

    def line(self, name):
        return (f"{name:28} {self.ticks:8} ticks ({self.left_out} in stalls of the machine), {self.unanswered} unanswered, "
                f"STATE to COMMAND {self.median:.0f} us median, {self.p99:.0f} p99, {self.p999:.0f} p99.9")


def settle():
    """What was printed so far has come."""
    time.sleep(0.8)
