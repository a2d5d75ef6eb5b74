#!/usr/bin/env python3
"""biped12 with parallel ankles (test/parallel/parallel_ankles.yaml): it is checked, walks in the simulator with its motors as the limit
on every engine of ours, and stands behind the bridge on a robot whose driver speaks of the motors, to which it is switched live and back."""

import json
import math
import pathlib
import shutil
import tempfile
import time

import harness
from harness import Bus, Checks, Stack, cli


def write_robot(folder):
    """biped12 with the key."""
    shutil.copytree(harness.ROOT / "config/robots/biped12", folder)
    with open(folder / "robot.yaml", "a", encoding="utf-8") as file:
        file.write((harness.ROOT / "test/parallel/parallel_ankles.yaml").read_text(encoding="utf-8"))


def is_checked(checks, robot):
    status, out, err = cli("check", robot, timeout=120)
    checks.that(status == 0 and "are turned by motors RLEG_ROD_IN and RLEG_ROD_OUT" in out, f"check names the pair: {out[-600:]}{err}")
    checks.that("both at once" in out and "nearest to singular" in out, "with torque and distance from singular")
    status, out, err = cli("check", robot, "--json", timeout=120)
    pairs = json.loads(out)["parallel_joints"] if status == 0 else []
    checks.that(len(pairs) == 2 and pairs[0]["motors"][0]["torque"] == 90.0, f"as JSON too: {err}")
    for pair in pairs:
        for joint, both in zip(pair["joints"], pair["torque_both_at_once"]):
            checks.at_most(both / joint["torque_alone"], 0.75, f"{joint['name']}: both at once have less than it alone, share")


def walks(checks, robot):
    for engine in ("articulated", "ode"):
        status, out, err = cli("run", "walk_forward", "--robot", robot, "--engine", engine, timeout=300)
        checks.that(status == 0 and "passed" in out, f"walk_forward, {engine}: {out[-800:]}{err}")


def tilt(state):
    w, x, y, z = state.attitude
    return math.degrees(math.acos(max(-1.0, min(1.0, 1.0 - 2.0 * (x * x + y * y)))))


def is_switched(checks, robot):
    with Stack("stand", "--robot", robot, "--stack", "both", "--no-viewer") as stack:
        bus = Bus()
        time.sleep(2.0)
        simulated = bus.newest("STATE")[1]
        for word in ("bridge", "sim"):
            old = bus.newest("STATE")[1].run_id
            status, out, err = cli("switch", word, "--policy", "now" if word == "bridge" else "when-safe", timeout=40)
            checks.that(status == 0, f"switch {word}: {out}{err}")
            time.sleep(3.0)
            state = bus.newest("STATE")[1]
            checks.that(state.run_id != old and state.stop_kind == 0, f"{word} is active, nobody stopped it")
            checks.at_most(tilt(state), 2.0, f"{word}: tilt after three seconds [degrees]")
            # The bus has joints, whatever the driver speaks of.
            apart = max(abs(a - b) for a, b in zip(state.q[:state.joint_count], simulated.q[:state.joint_count]))
            checks.at_most(apart, 0.05, f"{word}: joints on the bus, as in the simulator [rad]")
        checks.that(not any("started again" in line for line in stack.lines), "no process was started again")
        bus.close()


def main():
    harness.require(*harness.STACK, "twinbus_bridge", "emulated_robot")
    checks = Checks()
    with tempfile.TemporaryDirectory() as scratch:
        robot = pathlib.Path(scratch) / "biped12_rods"
        write_robot(robot)
        is_checked(checks, robot)
        walks(checks, robot)
        is_switched(checks, robot)
    checks.exit()


if __name__ == "__main__":
    main()
