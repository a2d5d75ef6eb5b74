"""How far a campaign is: one line that is written over on a terminal, a line every ten seconds elsewhere."""

import sys
import time


def hours(seconds):
    seconds = int(seconds)
    return f"{seconds // 3600}:{seconds // 60 % 60:02}:{seconds % 60:02}"


class Progress:
    def __init__(self, total, done):
        self.total, self.done, self.bad = total, done, 0
        self.start = self.shown = time.monotonic()
        self.begun = done
        self.terminal = sys.stderr.isatty()

    def add(self, result):
        self.done += 1
        self.bad += result["status"] != "passed"
        now = time.monotonic()
        if now - self.shown >= (0.2 if self.terminal else 10.0):
            self.shown = now
            self.show(now)

    def show(self, now):
        rate = (self.done - self.begun) / max(now - self.start, 1e-9)
        left = (self.total - self.done) / rate if rate > 0 else 0
        end = time.strftime("%H:%M:%S", time.localtime(time.time() + left))
        line = f"{self.done} of {self.total}, {self.bad} did not pass, {rate:.1f}/s, {hours(left)} left, ends {end}"
        sys.stderr.write(f"\r{line}\033[K" if self.terminal else line + "\n")
        sys.stderr.flush()

    def end(self):
        if self.terminal:
            sys.stderr.write("\r\033[K")
