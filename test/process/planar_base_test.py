#!/usr/bin/env python3
"""An arm on a base that moves on the plane, proposed: its base is held, posed and jogged, and drives to what the arm does not reach,
beside an obstacle, guarded.  The robot is the arm of arm_test.py."""

import pathlib
import tempfile
import time

import harness
from arm_test import arm
from gamepad_test import Keyboard
from harness import Bus, Checks, Stack, cli

BASE_X, BASE_Y, BASE_YAW = 7, 8, 9  # on the bus, behind the joints of the file
BENT = "shoulder=0.5,elbow=1.0,wrist_tip=0.7"
SCENE = """about: an arm beside a post
duration: 200
start_pose: half_sitting
obstacles:
  - {shape: box, size: [0.1, 0.5, 1.0], position: [0.9, 0.0, 0.5]}
modes:
  - {at: 0, mode: hold}
"""


def place(bus):
    q = bus.newest("STATE")[1].q
    return [q[k] for k in (BASE_X, BASE_Y, BASE_YAW)]


def is_posed_and_held(checks, bus, where):
    status, _, err = cli("pose", BENT, *where)
    checks.that(status == 0, f"pose of the arm: {err}")
    checks.at_most(max(map(abs, place(bus))), 0.01, "the base stays where it began [m, rad]")
    status, out, err = cli("pose", "base_x=-0.4,base_yaw=0.6", *where)
    checks.that(status == 0, f"pose of the base: {out}{err}")
    time.sleep(1.0)
    checks.at_most(max(abs(a - b) for a, b in zip(place(bus), (-0.4, 0.0, 0.6))), 0.01, "and is where it was sent [m, rad]")
    begin = time.monotonic_ns()
    time.sleep(1.0)
    checks.at_most(max(abs(s.q[BASE_X] + 0.4) for _, s in bus.messages("STATE", begin)), 0.01, "it holds its place [m]")
    status, _, err = cli("pose", "base_x=9", *where)
    checks.that(status != 0 and "base_x" in err, f"beyond its area: {err}")


def is_jogged(checks, bus, keys):
    keys.press("[[")  # from the first joint of the file backwards
    before = place(bus)[1]
    for _ in range(45):
        keys.press("+")
    time.sleep(1.2)
    keys.read(0.2)
    checks.that("base_y" in keys.text, f"its name is shown: {keys.text[-200:]}")
    checks.at_least(place(bus)[1] - before, 0.05, "+ held: the base moves sideways [m]")


def drives(checks, bus, where):
    cli("pose", "base_x=0,base_y=0,base_yaw=0", *where)
    status, out, err = cli("reach", "right", "0.35", "0.1", "0.35", *where, timeout=60)
    checks.that(status == 0 and "mm from the goal" in out, f"near: {out}{err}")
    checks.at_most(max(map(abs, place(bus))), 0.005, "to what the arm reaches it goes without the base [m, rad]")
    status, out, err = cli("reach", "right", "1.6", "0.1", "0.4", *where, timeout=120)
    checks.that(status == 0 and "mm from the goal" in out, f"behind the post: {out}{err}")
    x, y, _ = place(bus)
    checks.at_least((x * x + y * y) ** 0.5, 0.9, "the base went there [m]")
    status, out, err = cli("reach", "right", "0.35", "0.0", "0.35", "--frame", "base", *where, timeout=60)
    checks.that(status == 0 and "in base" in out, f"in the frame of the base that moved: {out}{err}")
    status, out, err = cli("reach", "right", "4.9", "0.0", "0.35", *where, timeout=60)
    checks.that(status != 0, f"beyond its area: {out}{err}")
    touched = [g for _, g in bus.messages("GUARD") if g.verdict == 3]
    checks.that(not touched, f"nothing touched in {len(touched)} ticks")


def main():
    harness.require(*harness.STACK, "twinbus_gamepad", "twinbus_planner")
    checks = Checks()
    with tempfile.TemporaryDirectory() as scratch:
        urdf, robot, scene = (pathlib.Path(scratch) / name for name in ("made_arm.urdf", "robot", "post.yaml"))
        urdf.write_text(arm())
        scene.write_text(SCENE)
        status, out, err = cli("check", urdf, "--propose", robot, "--base", "planar", timeout=120)
        checks.that(status == 0 and "carried by base_x, base_y, base_yaw" in out, f"proposed: {out[-800:]}{err}")
        for name in ("arm_hold", "arm_reach"):
            status, out, err = cli("run", name, "--robot", robot, timeout=120)
            checks.that(status == 0 and "passed" in out, f"run {name}: {out[-500:]}{err}")
        where = ("--robot", robot)
        with Stack(str(scene), *where, "--no-viewer", "--for", 180):
            bus = Bus()
            time.sleep(1.0)
            is_posed_and_held(checks, bus, where)
            keys = Keyboard(*where)
            is_jogged(checks, bus, keys)
            keys.press("q")
            keys.close()
            drives(checks, bus, where)
            bus.close()
    checks.exit()


if __name__ == "__main__":
    main()
