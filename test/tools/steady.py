#!/usr/bin/env python3
"""Runs a test of real-time processes again when it failed while the machine itself stood still.

    steady.py WATCH SECONDS COMMAND [ARGUMENT...]

WATCH is the program stall_watch, SECONDS the time a run may take.  A host that takes a processor away for 15 ms
rightly stops a robot; nothing can be learnt from such a run.  A run that fails on a machine that kept still has failed.
"""

import os
import signal
import subprocess
import sys
import threading

RUNS = 4
SPOILS_MS = 10.0
SKIPPED = 77
TIMED_OUT = 124


class Watch:
    """How long the machine stood still at the longest while the test ran [ms]."""

    def __init__(self, program):
        self.longest_ms = 0.0
        self.process = subprocess.Popen([program], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.reader = threading.Thread(target=self.read)
        self.reader.start()

    def read(self):
        for line in self.process.stdout:
            words = line.split()
            if len(words) == 3:
                self.longest_ms = max(self.longest_ms, 1e-6 * (int(words[2]) - int(words[1])))

    def end(self):
        self.process.terminate()
        self.process.wait()
        self.reader.join()
        return self.longest_ms


def run(command, seconds):
    child = subprocess.Popen(command, start_new_session=True)
    try:
        return child.wait(seconds)
    except subprocess.TimeoutExpired:
        print(f"FAILED: not ended after {seconds:g} s", flush=True)
        return TIMED_OUT
    finally:
        # What a test leaves behind would disturb the next one.
        try:
            os.killpg(child.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        child.wait()


def main():
    if len(sys.argv) < 4:
        print(__doc__, file=sys.stderr)
        return 2
    watcher, seconds, command = sys.argv[1], float(sys.argv[2]), sys.argv[3:]
    signal.signal(signal.SIGTERM, lambda *unused: sys.exit(1))
    for count in range(1, RUNS + 1):
        watch = Watch(watcher)
        try:
            status = run(command, seconds)
        finally:
            stood_ms = watch.end()
        if status in (0, SKIPPED):
            return status
        print(f"run {count} ended with {status}; the machine stood still for {stood_ms:.1f} ms at the longest", flush=True)
        if stood_ms < SPOILS_MS or count == RUNS:
            return status
    return 1


if __name__ == "__main__":
    sys.exit(main())
