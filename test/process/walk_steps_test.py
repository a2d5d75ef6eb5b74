#!/usr/bin/env python3
"""./twinbus walk --steps FILE: footsteps of a file are walked, and what the legs cannot do is refused before anything moves."""

import pathlib
import tempfile
import time

import harness
from harness import Bus, Checks, Stack, cli

GOOD = [("left", 0.15, 0.2, 0.0), ("right", 0.3, -0.2, 0.0), ("left", 0.2, 0.22, 0.2), ("right", 0.0, -0.2, 0.0)]
BAD = {
    "farther than the legs reach": [("left", 0.15, 0.2, 0.0), ("right", 0.9, -0.2, 0.0)],
    "one sole on the other": [("left", 0.1, 0.05, 0.0)],
    "turns farther": [("left", 0.1, 0.3, 1.5)],
    "take turns": [("left", 0.1, 0.2, 0.0), ("left", 0.1, 0.2, 0.0)],
    "there is none": [],
}


def write(folder, name, steps):
    file = folder / f"{name}.yaml"
    rows = [f"  - {{foot: {foot}, x: {x}, y: {y}, yaw: {yaw}}}" for foot, x, y, yaw in steps]
    file.write_text("\n".join(["steps:" + ("" if rows else " []")] + rows) + "\n")
    return file


def mode_now(bus):
    _, status = bus.newest("CONTROLLER_STATUS")
    return status.mode


def main():
    harness.require("twinbus", "twinbus_simulator", "twinbus_controller")
    checks = Checks()
    folder = pathlib.Path(tempfile.mkdtemp())
    with Stack("stand", "--no-viewer"):
        bus = Bus()
        bus.wait_for("CONTROLLER_STATUS", lambda s: s.mode == 4)
        for why, steps in BAD.items():
            status, out, err = cli("walk", "--steps", write(folder, "bad", steps), timeout=20)
            checks.that(status == 1 and why in err, f"refused, {why}: exit {status} {out}{err}")
            checks.that(len(err.strip().splitlines()) == 1, f"one sentence: {err}")
        time.sleep(0.3)
        checks.that(mode_now(bus) == 4, "nothing moved: still in balance")
        status, out, err = cli("walk", "--steps", write(folder, "good", GOOD), timeout=60)
        checks.that(status == 0 and "4 steps" in out, f"walked: exit {status} {out}{err}")
        _, truth = bus.newest("TRUTH")
        checks.that(truth is not None and not truth.fell, "it stands")
        checks.at_least(truth.base_position[0], 0.35, "forward [m]")
        status, out, err = cli("walk", "0.1", "0", timeout=20)
        checks.that(status == 2, f"two numbers are no velocity: exit {status} {err}")
        bus.close()
    checks.exit()


if __name__ == "__main__":
    main()
