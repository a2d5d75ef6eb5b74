#!/usr/bin/env python3
"""Controllers, guards and estimators of many logs computed again: bit for bit the same.

Quick: scenes run in one process, and a live stack whose controller stalls.  TWINBUS_FULL=1: twenty logs, with live stacks that sway, reach, switch, stop and lose a
process; in each a bit of an input is flipped, found and named.
"""

import os
import pathlib
import random
import re
import signal
import sys
import tempfile
import time

import harness
from harness import Checks, Stack, cli
from record_test import events_of

os.environ["TWINBUS_RECORD"] = "1"
SCENES = [("stand", 1), ("sway", 2), ("reach", 3), ("push_left", 4)]
MORE = [("squat", 5), ("push_forward", 6), ("push_back", 7), ("push_right", 8), ("sway", 9), ("reach", 10), ("squat", 11)]


def in_one_process(folder, scene, seed):
    log = folder / f"{scene}{seed}.log"
    cli("run", scene, "--for", "2.5", "--seed", seed, "--log", log, timeout=120)
    return log


def live(folder, name):
    """A stack in which something happens; its log."""
    stack = "both" if name.startswith("switch") else "sim"
    with Stack("stand", "--stack", stack, "--no-viewer") as running:
        time.sleep(0.5)
        if name.startswith("switch"):
            cli("switch", "bridge", "--policy", "now")
            time.sleep(0.7)
            cli("switch", "sim", "--policy", "now")
        elif name == "stop":
            cli("stop", "balanced")
            time.sleep(0.5)
            cli("clear")
        elif name == "hold":
            cli("stop", "hold")
            cli("clear")
        elif name == "reach":
            cli("reach", "left", "0.35", "0.25", "0.75")
        elif name == "controller dies":
            os.kill(running.pid("twinbus_controller"), signal.SIGKILL)
            time.sleep(1.0)
            cli("clear")
        elif name == "guard dies":
            os.kill(running.pid("twinbus_guard"), signal.SIGKILL)
        elif name == "controller stalls":
            pid = running.pid("twinbus_controller")
            os.kill(pid, signal.SIGSTOP)
            time.sleep(0.2)
            os.kill(pid, signal.SIGCONT)
            time.sleep(0.3)
            cli("clear")
        else:
            cli(name)
        time.sleep(1.0)
    return harness.newest_run_folder() / "run.log"


LIVE = ["sway", "squat", "reach", "switch", "stop", "hold", "controller dies", "guard dies", "controller stalls"]


def rerun(log, name, checks):
    status, said, problems = cli("log", "rerun", log, timeout=300)
    answers = sum(int(number) for number in re.findall(r"(\d+) answers", said))
    checks.that(status == 0 and answers > 500, f"{name}: rerun: {problems}{said[-1500:]}")
    print(f"{name}: {answers} answers, exit status {status}", flush=True)


def flip(log, folder, name, checks, rng):
    """One bit of one state, somewhere in its numbers, is found and named."""
    data = bytearray(log.read_bytes())
    offset, body = rng.choice(list(events_of(bytes(data), "STATE"))[50:-50])
    joint = rng.randrange(29)
    at = offset + 8 + 9 * 8 + 5 * 4 + 2 + 3 + 8 + 8 * joint + rng.randrange(1, 8)
    data[at] ^= 1 << rng.randrange(8)
    damaged = folder / "flipped.log"
    damaged.write_bytes(data)
    status, said, _ = cli("log", "rerun", damaged, timeout=300)
    tick = int.from_bytes(body[8:16], "big")
    checks.that(status == 1 and f"tick {tick}" in said and f"q[{joint}]" in said and "flipped bit" in said,
                f"{name}: the flipped bit of q[{joint}] at tick {tick} is named: {said[-700:]}")


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_controller", "twinbus_guard", "twinbus_recorder")
    checks = Checks()
    rng = random.Random(1)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for scene, seed in SCENES + (MORE if harness.FULL else []):
            log = in_one_process(folder, scene, seed)
            rerun(log, f"{scene}, seed {seed}", checks)
            if harness.FULL:
                flip(log, folder, scene, checks, rng)
            log.unlink()
        for what in LIVE if harness.FULL else ["controller stalls"]:
            log = live(folder, what)
            rerun(log, what, checks)
            if harness.FULL:
                flip(log, folder, what, checks, rng)
    checks.exit()


if __name__ == "__main__":
    sys.exit(main())
