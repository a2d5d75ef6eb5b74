#!/usr/bin/env python3
"""A controller of one's own that is started after the stack is obeyed all the same; one that copies a wrong field is told which."""

import subprocess
import sys
import time

import harness
from harness import Bus, Checks


def run_up(*words):
    return subprocess.Popen([harness.BIN / "twinbus", "up", "stand_python", "--stack", "client", "--no-viewer", *words], stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, stdin=subprocess.DEVNULL)


def comes_late(checks):
    up = run_up("--for", "2")
    time.sleep(3.0)
    client = subprocess.Popen([sys.executable, "examples/02_command_joints.py"], cwd=harness.ROOT, stdout=subprocess.DEVNULL)
    said = up.communicate(timeout=60)[0]
    client.terminate()
    client.wait(10)
    checks.that("waits up to 60 s for a controller of your own" in said, f"up waits for it: {said}")
    checks.that("the stop that waiting for your controller had caused is cleared" in said, f"and takes it on: {said}")
    checks.that("obeys a controller" in said and "up: no fall" in said and "by missing commands" not in said, f"which holds the robot: {said}")


def says_what_is_wrong(checks):
    up = run_up("--for", "2")
    wrong = {"model_hash": 7, "term": 99, "joint_count": 3}
    bus, begin, last = Bus(), time.monotonic(), -1
    while up.poll() is None and time.monotonic() - begin < 40:
        newest = bus.newest("STATE")
        if newest[1] is None or newest[1].tick == last:
            time.sleep(0.001)
            continue
        state = newest[1]
        last = state.tick
        field = list(wrong)[int(2.0 * (time.monotonic() - begin)) % 3]
        command = harness.type_of("COMMAND")()
        for same in ("run_id", "term", "model_hash", "tick", "joint_count", "q"):
            setattr(command, same, getattr(state, same))
        command.controller_id = 12345
        command.kp = [10.0] * 48
        setattr(command, field, wrong[field])
        bus.send("COMMAND", command)
    said = up.communicate(timeout=60)[0]
    checks.that(up.returncode != 0, f"up does not pass: {said}")
    for field, value in wrong.items():
        checks.that(f"COMMAND is refused, 20 in a row: its {field} is {value}, " in said, f"a wrong {field} is named: {said}")


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_guard", "twinbus_recorder")
    checks = Checks()
    comes_late(checks)
    says_what_is_wrong(checks)
    checks.exit()


if __name__ == "__main__":
    sys.exit(main())
