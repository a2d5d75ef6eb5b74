#!/usr/bin/env python3
"""The real robot driven by the keyboard, through a pseudo terminal: every key does what the cheat sheet says, and
letting go, dying or falling silent brings the robot back to where it stood.

A part that failed while the machine itself stood still (stalls.py) is printed and repeated on a fresh stack.
"""

import contextlib
import os
import pty
import re
import select
import signal
import struct
import fcntl
import subprocess
import termios
import time

import harness
from harness import BIN, Bus, Checks, Stack
from stalls import Stalls

BALANCE, WALK, HOLD = 4, 5, 2  # modes of controller_status_t
SWAY, SQUAT = 1, 2    # motions
SPOILS_MS = 8.0       # so long a stall of the machine may cost a tick or a stop
TRIES = 4


class Keyboard:
    """`twinbus gamepad --keyboard` in a terminal of its own."""

    def __init__(self, *options):
        self.master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 40, 120, 0, 0))
        self.child = subprocess.Popen([BIN / "twinbus", "gamepad", "--keyboard", *options], stdin=slave, stdout=slave, stderr=slave,
                                      start_new_session=True)
        os.close(slave)
        self.text = ""
        end = time.monotonic() + 10
        while "ready" not in self.text and time.monotonic() < end:
            self.read(0.1)

    def read(self, seconds):
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0 and select.select([self.master], [], [], left)[0]:
            try:
                self.text += os.read(self.master, 65536).decode("utf-8", "replace")
            except OSError:
                return

    def press(self, keys):
        os.write(self.master, keys.encode())
        self.read(0.05)

    def press_for(self, keys, bus, channel, accept, seconds=3.0):
        """The first message after the keys that accept() likes, or None: what lasts a few ticks only is seen too."""
        start = len(bus.records)
        self.press(keys)
        return bus.wait_for(channel, accept, seconds, start)[1]

    def close(self):
        with contextlib.suppress(OSError):
            os.close(self.master)


def status(bus):
    return bus.newest("CONTROLLER_STATUS")[1]


def com(bus, seconds=0.4):
    """Mean centre of mass over the last while, by TRUTH [m]."""
    time.sleep(seconds)
    rows = [t.com for _, t in bus.messages("TRUTH", time.monotonic_ns() - int(1e9 * seconds))]
    return [sum(row[k] for row in rows) / len(rows) for k in range(3)]


def modes(checks, bus, keys):
    for key, name, accept in (("2", "sway", lambda s: s.motion == SWAY), ("3", "squat", lambda s: s.motion == SQUAT),
                              ("4", "hold", lambda s: s.mode == HOLD),
                              ("1", "balance", lambda s: s.mode == BALANCE and s.motion == 0)):
        checks.that(keys.press_for(key, bus, "CONTROLLER_STATUS", accept) is not None, f"key {key}: {name}")
        time.sleep(0.7)


def leaning(checks, bus, keys):
    home = com(bus)
    # Axis of the centre of mass, its sign, and how far at least it goes for ten steps.
    for key, back, axis, sign, least in (("w", "x", 0, 1, 0.01), ("s", "0", 0, -1, 0.01), ("a", "x", 1, 1, 0.01),
                                         ("d", "x", 1, -1, 0.01), ("k", "x", 2, -1, 0.01)):
        keys.press(10 * key)
        time.sleep(1.6)
        moved = sign * (com(bus)[axis] - home[axis])
        checks.at_least(moved, least, f"ten times {key}: the centre of mass moves [m]")
        keys.press(back)
        time.sleep(1.8)
        off = max(abs(a - b) for a, b in zip(com(bus), home))
        checks.at_most(off, 0.004, f"{back}: back where it was [m]")
    pad = keys.press_for("\x1b[A\x1b[A\x1b[A", bus, "GAMEPAD", lambda g: abs(g.left_y - 0.3) < 1e-3)
    checks.that(pad is not None, "arrow keys do the same")
    pad = keys.press_for("sss", bus, "GAMEPAD", lambda g: g.left_y == 0.0)
    checks.that(pad is not None, "as many steps back give exactly zero")


def lean_then_walk(checks, bus, keys):
    """A lean is no walk: the robot walks on the spot until a key says where to, and 1 stands without a lean."""
    home = com(bus)
    keys.press(5 * "w")
    time.sleep(1.6)
    walks = keys.press_for("5", bus, "CONTROLLER_STATUS", lambda s: s.mode == WALK)
    checks.that(walks is not None, "5: mode walk")
    time.sleep(3.0)
    checks.at_most(abs(com(bus)[0] - home[0]), 0.05, "5 after a lean: the robot stays where it was [m]")
    keys.press(5 * "w")
    time.sleep(3.0)
    checks.at_least(com(bus)[0] - home[0], 0.1, "w: now it walks [m]")
    pad = keys.press_for("1", bus, "GAMEPAD", lambda g: g.left_y == 0.0)
    checks.that(pad is not None, "1: stands without a lean")
    bus.wait_for("CONTROLLER_STATUS", lambda s: s.mode == BALANCE, 6)


def stopping(checks, bus, keys):
    start = len(bus.records)
    state = keys.press_for("www ", bus, "STATE", lambda s: s.stop_kind == 1)
    checks.that(state is not None, "space: the robot stops in balance")
    _, pad = bus.wait_for("GAMEPAD", lambda g: g.stop, 2, start)
    checks.that(pad is not None and not pad.deadman and pad.left_y == 0.0, "and the set points are zero")
    bus.wait_for("STATE", lambda s: s.stop_kind >= 2, 4, start)
    keys.press("www")
    time.sleep(0.3)
    _, pad = bus.newest("GAMEPAD")
    checks.that(pad.left_y == 0.0 and not pad.deadman, "keys do nothing while it is stopped")
    state = keys.press_for("c", bus, "STATE", lambda s: s.stop_kind == 0)
    checks.that(state is not None, "c: the stop is cleared")
    status = keys.press_for("1", bus, "CONTROLLER_STATUS", lambda s: s.mode == BALANCE and s.stopping == 0)
    checks.that(status is not None, "1: balance again")
    time.sleep(0.8)


def hands(checks, bus, keys):
    """Capitals move a hand along ways of the planner; x stops it; the body stands where it stood."""
    def reach(keys_, side):
        start = len(bus.records)
        keys.press(keys_)
        _, goal = bus.wait_for("ARM_GOAL", lambda g: g.kind == 2 and g.side == side, 3, start)
        if not checks.that(goal is not None, f"{keys_}: a goal goes out"):
            return None
        _, path = bus.wait_for("ARM_PATH", lambda p: p.goal_id == goal.goal_id, 5, start)
        checks.that(path is not None and path.status == 0, f"{keys_}: the planner finds a way")
        _, moving = bus.wait_for("CONTROLLER_STATUS", lambda s: s.arm_path_id != 0, 3, start)
        checks.that(moving is not None, f"{keys_}: the arm follows it")
        return goal

    home = com(bus)
    first = reach("W", 1)
    _, done = bus.wait_for("CONTROLLER_STATUS", lambda s: s.arm_path_id == 0, 5)
    checks.that(done is not None, "W: the hand arrives")
    second = reach("WWI", 1)
    if first and second:
        checks.that(0.01 < second.position[0] - first.position[0] < 0.05, f"W, then W again: further forward by a step or two: "
                    f"{first.position} {second.position}")
    bus.wait_for("CONTROLLER_STATUS", lambda s: s.arm_path_id == 0, 5)
    keys.press("h")
    reach("IIIIII", 2)
    start = len(bus.records)
    keys.press("x")
    _, cancelled = bus.wait_for("ARM_GOAL", lambda g: g.kind == 0, 2, start)
    checks.that(cancelled is not None, "x: the way is cancelled")
    _, rests = bus.wait_for("CONTROLLER_STATUS", lambda s: s.arm_path_id == 0, 1.5, start)
    checks.that(rests is not None, "x: the arm stops at once")
    time.sleep(1.5)
    checks.at_most(max(abs(a - b) for a, b in zip(com(bus), home)), 0.015, "the body stands where it stood [m]")


def letting_go(checks, bus, keys):
    """The consumer's own time-out: a keyboard that is frozen in the middle of a lean is not obeyed any longer."""
    home = com(bus)
    keys.press(10 * "w")
    time.sleep(1.6)
    checks.at_least(com(bus)[0] - home[0], 0.01, "before: the robot leans [m]")
    pads = [int(p) for p in subprocess.run(["pgrep", "-x", "twinbus_gamepad"], capture_output=True, text=True,
                                           check=False).stdout.split()]
    mine = [pid for pid in pads if os.stat(f"/proc/{pid}/ns/net").st_ino == os.stat("/proc/self/ns/net").st_ino]
    if checks.that(len(mine) == 1, f"one keyboard runs: {mine}"):
        os.kill(mine[0], signal.SIGSTOP)
        time.sleep(2.2)
        checks.at_most(abs(com(bus)[0] - home[0]), 0.004, "frozen keyboard: the robot comes back upright [m]")
        os.kill(mine[0], signal.SIGCONT)
        time.sleep(1.8)
        keys.press("x")
        time.sleep(1.5)
    keys.press(10 * "w")
    time.sleep(1.6)
    pad = keys.press_for("q", bus, "GAMEPAD", lambda g: not g.connected)
    checks.that(pad is not None and pad.left_y == 0.0 and not pad.deadman, "q: zeros, and gone")
    checks.that(keys.child.wait(5) == 0, "q: exit 0")
    time.sleep(2.0)
    checks.at_most(abs(com(bus)[0] - home[0]), 0.004, "q: the robot comes back upright [m]")


def cheat_sheet(checks, bus, keys):
    keys.press_for("1", bus, "CONTROLLER_STATUS", lambda s: s.mode == BALANCE)
    keys.read(1.0)
    checks.that(re.search(r"SIMULATOR\s+term 1", keys.text) is not None, "the line shows source and term")
    for row in ("STOP, at any time", "sway from side to side", "lean forward", "hand 20 mm up", "let go and quit"):
        checks.that(row in keys.text, f"the cheat sheet says \"{row}\"")


def one_try(checks, part):
    """On a stack of its own; what is claimed goes to checks."""
    with Stack("stand", "--no-viewer", "--for", 60):
        bus = Bus()
        time.sleep(2.0)
        keys = Keyboard()
        part(checks, bus, keys)
        checks.that(not any(t.fell for _, t in bus.messages("TRUTH")), "no fall")
        keys.close()
        if checks.failed:
            print("\n".join(harness.story_of_a_stop(bus, 60.0)), flush=True)
        bus.close()


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_controller", "twinbus_guard", "twinbus_gamepad")
    harness.CHANNEL_TYPES.setdefault("GAMEPAD", "gamepad_t")
    checks, stalls = Checks(), Stalls()
    for part in (cheat_sheet, modes, leaning, lean_then_walk, hands, stopping, letting_go):
        for tries in range(1, TRIES + 1):
            since, attempt = time.monotonic_ns(), checks.tentative()
            one_try(attempt, part)
            stall = stalls.longest_ms(since, time.monotonic_ns())
            if not attempt.failed or stall < SPOILS_MS or tries == TRIES:
                break
            print(f"{part.__name__}: repeated, the machine stood still for {stall:.1f} ms", flush=True)
            for sentence in (sentence for good, sentence in attempt.claims if not good):
                print(f"  not judged: {sentence}", flush=True)
        checks.adopt(attempt)
    stalls.close()
    checks.exit()


if __name__ == "__main__":
    main()
