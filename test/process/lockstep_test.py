#!/usr/bin/env python3
"""The same ticks whichever way they are run: `run` twice, and lock-step over LCM twice, give one state_hash (row j)."""

import json
import os
import re
import tempfile

import harness
from harness import Checks, cli

SECONDS = 3


def hash_of_up(checks, *more):
    status, out, err = cli("up", "sway", "--lockstep", "--for", SECONDS, "--no-viewer", *more, timeout=120)
    checks.that(status == 0, f"up sway --lockstep ends with 0, not {status}: {out[-800:]}{err}")
    found = re.search(r"state_hash ([0-9a-f]{16})", out)
    checks.that(found is not None, "up --lockstep prints a state_hash")
    return found.group(1) if found else None


def hash_of_run(checks, *more):
    report = os.path.join(tempfile.mkdtemp(), "report.json")
    status, out, err = cli("run", "sway", "--for", SECONDS, "--report", report, *more, timeout=120)
    checks.that(status == 0, f"run sway ends with 0, not {status}: {out[-800:]}{err}")
    try:
        with open(report, encoding="utf-8") as file:
            return json.load(file)["state_hash"]
    except (OSError, KeyError, ValueError) as error:
        checks.that(False, f"run writes a report with state_hash: {error}")
        return None


def main():
    harness.require(*harness.STACK)
    checks = Checks()
    ups = [hash_of_up(checks) for _ in range(2)]
    runs = [hash_of_run(checks) for _ in range(2)]
    print("lock-step over LCM", ups, "in one process", runs)
    checks.that(ups[0] == ups[1], f"two lock-step runs agree: {ups}")
    checks.that(runs[0] == runs[1], f"two runs in one process agree: {runs}")
    checks.that(ups[0] == runs[0], f"over LCM as in one process: {ups[0]} {runs[0]}")
    asked = ("--accuracy", "0.05mm")
    finer = [hash_of_run(checks, *asked), hash_of_up(checks, *asked)]
    print("with an accuracy asked for, in one process and over LCM", finer)
    checks.that(finer[0] == finer[1], f"up chooses the order and step of run: {finer}")
    checks.that(finer[0] != runs[0], f"which are not the scene's own: {finer[0]}")
    checks.exit()


if __name__ == "__main__":
    main()
